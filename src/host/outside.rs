//! Plugins from outside the program: found and loaded when a run first needs one.

use super::isolated::{Limits, Process};
use super::{library, search};
use planform_sdk::abi::host::{Log, logged};
use planform_sdk::{
    Confidence, Document, ErrorKind, Exporter, InputAdapter, Options, Output, PluginError, PluginInfo, Probe,
    ReadWatcher, Scene, Source,
};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Where plugins from outside are looked for, and how they are run.
#[derive(Debug, Clone)]
pub struct OutsideSettings {
    /// Folders to search before all others.
    pub folders: Vec<PathBuf>,
    /// The limits of the processes they run in; none has them run in this one.
    pub isolation: Option<Limits>,
}

/// A message that a plugin logged, and its name.
pub type Message = (String, Log);

/// What was logged by plugins from outside and nobody has asked for yet.
static MESSAGES: Mutex<Vec<Message>> = Mutex::new(Vec::new());

/// Takes what plugins from outside logged since this was last called.
pub fn messages() -> Vec<Message> {
    std::mem::take(&mut MESSAGES.lock().unwrap_or_else(PoisonError::into_inner))
}

/// An adapter or exporter from outside, and its library.
pub struct Outsider<T: ?Sized> {
    plugin: Box<T>,
    /// The library's file.
    pub library: PathBuf,
}

/// A library or folder that is not used, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The library; none for what is wrong with the settings.
    pub library: Option<PathBuf>,
    /// What is wrong with it.
    pub reason: String,
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.library {
            Some(library) => write!(f, "`{}` is not used: {}", library.display(), self.reason),
            None => f.write_str(&self.reason),
        }
    }
}

/// The plugins from outside.
#[derive(Default)]
pub struct Loaded {
    /// Their input adapters, in the order of the search.
    pub adapters: Vec<Outsider<dyn InputAdapter>>,
    /// Their exporters, in the order of the search.
    pub exporters: Vec<Outsider<dyn Exporter>>,
    /// What was found and cannot be used.
    pub refusals: Vec<Refusal>,
    /// What was found and is not used because a plugin before it has the same name.
    pub shadowed: Vec<Refusal>,
}

/// The names of the built-in input adapters and exporters.
#[derive(Default)]
pub struct Taken {
    /// Those of the input adapters.
    pub adapters: Vec<String>,
    /// Those of the exporters.
    pub exporters: Vec<String>,
}

/// The plugins from outside, loaded or not.
pub struct Outside {
    /// None for a program without plugins from outside.
    settings: Option<(OutsideSettings, Taken)>,
    loaded: OnceLock<Loaded>,
}

impl Outside {
    /// Those that the settings lead to, but for the names that are taken; without settings there are none.
    pub fn new(settings: Option<(OutsideSettings, Taken)>) -> Self {
        Self { settings, loaded: OnceLock::new() }
    }

    /// All of them: this loads them.
    pub fn loaded(&self) -> &Loaded {
        let load = |(settings, taken): &(OutsideSettings, Taken)| Loaded::by(settings, taken);
        self.loaded.get_or_init(|| self.settings.as_ref().map(load).unwrap_or_default())
    }

    /// What was found and is not used, as far as anything was loaded.
    pub fn refusals(&self) -> &[Refusal] {
        self.loaded.get().map(|loaded| loaded.refusals.as_slice()).unwrap_or_default()
    }
}

/// The adapters and exporters of one library.
pub type Contents = (Vec<Box<dyn InputAdapter>>, Vec<Box<dyn Exporter>>);

impl Loaded {
    fn by(settings: &OutsideSettings, taken: &Taken) -> Self {
        let (folders, faults) = search::folders(&settings.folders);
        let refusals = faults.into_iter().map(|reason| Refusal { library: None, reason }).collect();
        let mut loaded = Self { refusals, ..Self::default() };
        for library in search::libraries_in(&folders) {
            match load(&library, settings.isolation.as_ref()) {
                Ok(contents) => loaded.add(&library, contents, taken),
                Err(reason) => loaded.refusals.push(Refusal { library: Some(library), reason }),
            }
        }
        loaded
    }

    fn add(&mut self, library: &Path, (adapters, exporters): Contents, taken: &Taken) {
        let Self { adapters: read, exporters: write, shadowed, .. } = self;
        for plugin in adapters {
            shadowed.extend(admit(read, plugin, library, "input adapter", &taken.adapters, |a| a.info()));
        }
        for plugin in exporters {
            shadowed.extend(admit(write, plugin, library, "exporter", &taken.exporters, |e| e.info()));
        }
    }
}

/// Puts a plugin behind those of its kind, unless one of them or a built-in one has its name.
fn admit<T: ?Sized>(
    before: &mut Vec<Outsider<T>>,
    plugin: Box<T>,
    library: &Path,
    kind: &str,
    taken: &[String],
    info: fn(&T) -> &PluginInfo,
) -> Option<Refusal> {
    let name = &info(&plugin).name;
    let twin = before.iter().find(|b| info(&b.plugin).name == *name).map(|b| b.library.as_path());
    let reason = shadow(kind, name, taken, twin);
    if reason.is_none() {
        before.push(Outsider { plugin, library: library.into() });
    }
    reason.map(|reason| Refusal { library: Some(library.into()), reason })
}

/// What shadows a plugin of this name, if anything does.
fn shadow(kind: &str, name: &str, taken: &[String], before: Option<&Path>) -> Option<String> {
    let by = if taken.iter().any(|t| t == name) {
        "the built-in one".into()
    } else {
        format!("that of `{}`", before?.display())
    };
    Some(format!("its {kind} `{name}` is shadowed by {by}"))
}

/// Loads one library by itself, whatever the names of its plugins: into a process with these limits, or into this one.
/// Fails with what is wrong with it, as a sentence that goes on after the library's name.
pub fn load(library: &Path, isolation: Option<&Limits>) -> Result<Contents, String> {
    let Some(limits) = isolation else {
        let plugin = library::load(library)?;
        return Ok(boxed(plugin.adapters, plugin.exporters));
    };
    let (adapters, exporters) = Arc::new(Process::new(library, limits)).describe()?;
    Ok(boxed(adapters, exporters))
}

fn boxed<A: InputAdapter + 'static, E: Exporter + 'static>(adapters: Vec<A>, exporters: Vec<E>) -> Contents {
    let adapters = adapters.into_iter().map(|a| Box::new(a) as Box<dyn InputAdapter>).collect();
    (adapters, exporters.into_iter().map(|e| Box::new(e) as Box<dyn Exporter>).collect())
}

/// Names the plugin in its own faults, and keeps what it logged.
fn named<T>(name: &str, result: Result<T, PluginError>) -> Result<T, PluginError> {
    let mut messages = MESSAGES.lock().unwrap_or_else(PoisonError::into_inner);
    messages.extend(logged().into_iter().map(|log| (name.to_owned(), log)));
    result.map_err(|e| match e.kind {
        ErrorKind::Plugin => PluginError { message: format!("plugin `{name}` failed: {}", e.message), ..e },
        _ => e,
    })
}

impl InputAdapter for Outsider<dyn InputAdapter> {
    fn info(&self) -> &PluginInfo {
        self.plugin.info()
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        let confidence = Ok(self.plugin.probe(probe));
        named(&self.info().name, confidence).unwrap_or_else(|_: PluginError| Confidence::no())
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        named(&self.info().name, self.plugin.read(source, options))
    }

    fn read_watched(
        &self,
        source: &Source,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        named(&self.info().name, self.plugin.read_watched(source, options, watcher))
    }
}

impl Exporter for Outsider<dyn Exporter> {
    fn info(&self) -> &PluginInfo {
        self.plugin.info()
    }

    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError> {
        named(&self.info().name, self.plugin.write(document, options, out))
    }

    fn companions(&self) -> &[String] {
        self.plugin.companions()
    }

    fn write_files(
        &self,
        document: &Document<'_>,
        options: &Options,
        output: Output<'_>,
    ) -> Result<(), PluginError> {
        named(&self.info().name, self.plugin.write_files(document, options, output))
    }
}
