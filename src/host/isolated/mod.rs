//! Plugins in a process of their own: one that crashes, hangs or takes all memory costs its own document alone.
//!
//! The process is this very program with the verb [`VERB`]. It is started when a plugin is first needed, serves one
//! library, and is ended with its [`Process`]; it also ends by itself when this program does, however that happens.

mod death;
mod group;
mod process;
mod wire;
mod worker;

pub(crate) use death::{ended, page_size, says_out_of_memory};
pub(crate) use group::{Group, overhear};
pub use process::{Process, Remote};
pub(crate) use wire::{receive, send};
pub use worker::serve;
pub(crate) use worker::{end_at_once, own_output};

use std::path::PathBuf;
use std::time::Duration;

/// The verb by which the program runs a plugin; not for people.
pub const VERB: &str = "plugin-process";

/// What a plugin's process may take, and how it is run.
#[derive(Debug, Clone)]
pub struct Limits {
    /// The program whose verb [`VERB`] runs the plugin; none is this one.
    pub program: Option<PathBuf>,
    /// The longest that one call may take.
    pub time: Duration,
    /// The most memory, in MiB, beyond what the program itself takes.
    pub memory: u64,
    /// Whether what the plugin prints on standard error is shown as it comes.
    pub echo: bool,
}

impl Limits {
    /// The longest call unless the user says otherwise, seconds.
    pub const TIME: u64 = 120;
    /// The most memory unless the user says otherwise, MiB.
    pub const MEMORY: u64 = 4096;

    /// The most bytes of one block of a message.
    fn bytes(&self) -> u64 {
        self.memory.saturating_mul(1 << 20)
    }
}
