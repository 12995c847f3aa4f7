//! The document that a verb reads, and the flags that say how.

use super::Failure;
use super::caps::Caps;
use super::failure::shown;
use crate::host::{Choice, Claim, Registry, Setting, run_options};
use clap::Args;
use planform_sdk::{
    ErrorKind, InputAdapter, Kept, Options, PluginError, PluginInfo, ReadWatcher, Scene, Source,
};
use std::io::Read;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct InputArgs {
    /// The document, such as the YAML file of a robot's map; `-` reads standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// The flags that say how documents are read.
#[derive(Args)]
pub struct ReadingArgs {
    /// Read the document with this input adapter, whatever it looks like
    #[arg(long, value_name = "ADAPTER")]
    pub from: Option<String>,
    /// Set an option of every plugin that has it, or with PLUGIN.NAME=VALUE of one; `planform plugins info NAME` lists
    /// them
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<Setting>,
    /// Metres per cell of a map or per pixel of a plan, for documents that do not say: short for `--set resolution=M`
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    resolution: Option<String>,
    /// Where the map lies on the Earth: latitude and longitude of its origin in degrees and the direction of its y
    /// axis in degrees clockwise from north; short for `--set anchor=LAT,LON,BEARING`
    #[arg(long, value_name = "LAT,LON,BEARING", allow_hyphen_values = true)]
    anchor: Option<String>,
}

impl ReadingArgs {
    /// All settings, the shortcuts included.
    pub fn settings(&self) -> Vec<Setting> {
        let shortcut = |name, value: &Option<String>| value.as_ref().map(|v| Setting::of(name, v));
        let shortcuts = [shortcut("resolution", &self.resolution), shortcut("anchor", &self.anchor)];
        self.set.iter().cloned().chain(shortcuts.into_iter().flatten()).collect()
    }
}

/// A document and the adapter that reads it.
pub struct Opened<'a> {
    path: &'a Path,
    /// The document.
    pub source: Source,
    adapter: &'a dyn InputAdapter,
    claims: Option<Vec<Claim<'a>>>,
    kept: Kept,
    caps: Caps,
}

impl<'a> Opened<'a> {
    /// Opens the document and finds its adapter. A setting that one of the `others` takes may be meant for that alone.
    pub fn open(
        args: &'a InputArgs,
        caps: Caps,
        registry: &'a Registry,
        others: &[&PluginInfo],
    ) -> Result<Self, Failure> {
        let path = args.input.as_path();
        let source = source(path, caps.bytes).map_err(|e| Failure::of_plugin(shown(path), e))?;
        let Choice { adapter, claims, kept } =
            choose(&source, args.reading.from.as_deref(), &args.reading.settings(), registry, others)
                .map_err(|e| Failure::of_plugin(shown(path), e))?;
        Ok(Self { path, source, adapter, claims, kept, caps })
    }

    /// What each adapter says of the document.
    pub fn claims(&mut self, registry: &'a Registry) -> &[Claim<'a>] {
        self.claims.get_or_insert_with(|| registry.claims(&self.source))
    }

    /// The document's path as the user knows it.
    pub fn shown(&self) -> String {
        shown(self.path)
    }

    /// The options of the adapter, then those of the `others`.
    pub fn options(&self, settings: &[Setting], others: &[&PluginInfo]) -> Result<Vec<Options>, Failure> {
        let plugins: Vec<_> = std::iter::once(self.adapter.info()).chain(others.iter().copied()).collect();
        run_options(settings, &plugins).map_err(|e| match culprit(settings, &plugins) {
            Some(sentence) => Failure::Usage(sentence),
            None => Failure::of_plugin(self.shown(), e),
        })
    }

    /// Reads the document.
    pub fn read(&mut self, options: &Options, watcher: &mut dyn ReadWatcher) -> Result<Scene, Failure> {
        let kept = std::mem::take(&mut self.kept);
        let scene = self.caps.check_source(&self.source, self.adapter).and_then(|()| {
            let scene = self.adapter.read_looked_at(&self.source, kept, options, watcher)?;
            self.caps.check_scene(&scene)?;
            Ok(scene)
        });
        scene.map_err(|e| Failure::of_plugin(self.shown(), e))
    }
}

/// What is wrong with the first of the settings that cannot be used.
pub fn culprit(settings: &[Setting], plugins: &[&PluginInfo]) -> Option<String> {
    settings.iter().find_map(|s| {
        // Each alone, to name the one at fault.
        let e = run_options(std::slice::from_ref(s), plugins).err()?;
        Some(format!("{}: {e}", typed(s)))
    })
}

/// The adapter that reads a document. A setting that one of the `others` takes may be meant for that alone.
pub fn choose<'a>(
    source: &Source,
    from: Option<&str>,
    settings: &[Setting],
    registry: &'a Registry,
    others: &[&PluginInfo],
) -> Result<Choice<'a>, PluginError> {
    let settings: Vec<_> = settings.iter().filter(|s| !others.iter().any(|o| s.is_for(o))).collect();
    registry.choose(source, from, &settings)
}

/// A setting as the user would type it.
fn typed(Setting { plugin, name, value }: &Setting) -> String {
    let plugin = plugin.as_ref().map(|p| format!("{p}.")).unwrap_or_default();
    match (plugin.as_str(), name.as_str()) {
        // They have flags of their own.
        ("", "resolution" | "anchor") => format!("--{name} {value}"),
        _ => format!("--set {plugin}{name}={value}"),
    }
}

fn source(path: &Path, byte_limit: u64) -> Result<Source, PluginError> {
    let source =
        if path == Path::new("-") { standard_input(byte_limit)? } else { Source::open(path, byte_limit)? };
    if source.bytes.is_empty() {
        return Err(PluginError::new(ErrorKind::BadInput, "is empty").advise("was it saved to the end?"));
    }
    Ok(source)
}

fn standard_input(byte_limit: u64) -> Result<Source, PluginError> {
    let mut bytes = Vec::new();
    std::io::stdin().lock().take(byte_limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > byte_limit {
        let message = format!("is larger than the limit of {byte_limit} bytes");
        return Err(PluginError::new(ErrorKind::Limit, message));
    }
    Ok(Source { path: PathBuf::new(), bytes, byte_limit })
}
