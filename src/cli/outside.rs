//! The flags that say which plugins from outside are used, and how.

use super::Failure;
use super::batch::Outside;
use super::failure::say;
use super::progress::Voice;
use crate::host::isolated::Limits;
use crate::host::{OutsideSettings, Registry, messages};
use clap::{Args, value_parser};
use std::path::PathBuf;
use std::time::Duration;

/// Where plugins from outside are looked for, and how they are run.
#[derive(Args)]
#[command(next_help_heading = "Plugins from outside")]
pub struct OutsideArgs {
    /// Also look for plugin libraries in this folder, before all others; may be given several times
    #[arg(long, value_name = "DIR")]
    plugin_dir: Vec<PathBuf>,
    /// Run plugins within planform itself: quicker, but one that crashes or hangs takes planform with it
    #[arg(long)]
    trust_plugins: bool,
    #[command(flatten)]
    limits: LimitArgs,
}

/// What plugins from outside may take.
#[derive(Args)]
#[command(next_help_heading = "Plugins from outside")]
pub struct LimitArgs {
    /// The longest that a plugin may take for one document, in whole seconds
    #[arg(long, value_name = "SECONDS", default_value_t = Limits::TIME, value_parser = value_parser!(u64).range(1..=MAX_TIME))]
    plugin_timeout: u64,
    /// The most memory that a plugin may take
    #[arg(long, value_name = "MIB", default_value_t = Limits::MEMORY, value_parser = value_parser!(u64).range(1..=MAX_MEMORY))]
    plugin_memory: u64,
}

/// Eleven days.
const MAX_TIME: u64 = 1_000_000;
/// A TiB.
const MAX_MEMORY: u64 = 1 << 20;

impl OutsideArgs {
    /// The built-in plugins and those from outside. `echo` shows what these print on standard error.
    pub fn registry(&self, echo: bool) -> Result<Registry, Failure> {
        if let Some(no) = self.plugin_dir.iter().find(|folder| !folder.is_dir()) {
            return Err(Failure::Usage(format!("--plugin-dir {}: is not a folder", no.display())));
        }
        let isolation = (!self.trust_plugins).then(|| self.limits.limits(echo));
        let settings = OutsideSettings { folders: self.plugin_dir.clone(), isolation };
        Ok(Registry::builtin().with_outside(settings))
    }
}

impl OutsideArgs {
    /// The same for the processes of a batch.
    pub fn task(&self) -> Outside {
        let isolation =
            (!self.trust_plugins).then_some((self.limits.plugin_timeout, self.limits.plugin_memory));
        Outside { folders: self.plugin_dir.iter().map(Into::into).collect(), isolation }
    }
}

impl LimitArgs {
    /// The limits of the processes that run plugins.
    pub fn limits(&self, echo: bool) -> Limits {
        let time = Duration::from_secs(self.plugin_timeout);
        Limits { program: None, time, memory: self.plugin_memory, echo }
    }
}

/// Tells what was found outside and is not used, if anything was looked for.
pub fn tell_refusals(registry: &Registry, voice: Voice) {
    if voice != Voice::Quiet {
        registry.refusals().iter().for_each(|refusal| say(&format!("warning: {refusal}")));
    }
}

/// Tells what plugins from outside logged.
pub fn tell_messages(voice: Voice) {
    for (plugin, (warning, message)) in messages() {
        match (warning, voice) {
            (true, Voice::Normal | Voice::Verbose) => say(&format!("warning: plugin {plugin}: {message}")),
            (false, Voice::Verbose) => say(&format!("plugin {plugin}: {message}")),
            _ => {}
        }
    }
}
