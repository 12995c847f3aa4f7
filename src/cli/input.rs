//! The document that a verb reads, and the flags that say how.

use super::Failure;
use super::failure::shown;
use crate::host::{Choice, Claim, Registry, Setting, run_options};
use clap::Args;
use planform_sdk::{ErrorKind, InputAdapter, Options, PluginError, PluginInfo, ReadWatcher, Scene, Source};
use std::io::Read;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct InputArgs {
    /// The document, such as the YAML file of a robot's map; `-` reads standard input
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Read the document with this input adapter, whatever it looks like
    #[arg(long, value_name = "ADAPTER")]
    from: Option<String>,
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

impl InputArgs {
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
}

impl<'a> Opened<'a> {
    /// Opens the document and finds its adapter. A setting that one of the `others` takes may be meant for that alone.
    pub fn open(
        args: &'a InputArgs,
        registry: &'a Registry,
        others: &[&PluginInfo],
    ) -> Result<Self, Failure> {
        let path = args.input.as_path();
        let source = source(path).map_err(|e| Failure::of_plugin(shown(path), e))?;
        let settings = args.settings();
        let settings: Vec<_> = settings.iter().filter(|s| !others.iter().any(|o| s.is_for(o))).collect();
        let Choice { adapter, claims } = registry
            .choose(&source, args.from.as_deref(), &settings)
            .map_err(|e| Failure::of_plugin(shown(path), e))?;
        Ok(Self { path, source, adapter, claims })
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
        // Each alone, to name the one at fault.
        let wrong =
            settings.iter().find_map(|s| Some((s, run_options(std::slice::from_ref(s), &plugins).err()?)));
        match wrong {
            Some((setting, e)) => Err(Failure::Usage(format!("{}: {e}", typed(setting)))),
            None => run_options(settings, &plugins).map_err(|e| Failure::of_plugin(self.shown(), e)),
        }
    }

    /// Reads the document.
    pub fn read(&self, options: &Options, watcher: &mut dyn ReadWatcher) -> Result<Scene, Failure> {
        let scene = self.adapter.read_watched(&self.source, options, watcher);
        scene.map_err(|e| Failure::of_plugin(self.shown(), e))
    }
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

fn source(path: &Path) -> Result<Source, PluginError> {
    let source =
        if path == Path::new("-") { standard_input()? } else { Source::open(path, Source::BYTE_LIMIT)? };
    if source.bytes.is_empty() {
        return Err(PluginError::new(ErrorKind::BadInput, "is empty").advise("was it saved to the end?"));
    }
    Ok(source)
}

fn standard_input() -> Result<Source, PluginError> {
    let byte_limit = Source::BYTE_LIMIT;
    let mut bytes = Vec::new();
    std::io::stdin().lock().take(byte_limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > byte_limit {
        let message = format!("is larger than the limit of {byte_limit} bytes");
        return Err(PluginError::new(ErrorKind::Limit, message));
    }
    Ok(Source { path: PathBuf::new(), bytes, byte_limit })
}
