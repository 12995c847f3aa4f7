//! Ctrl-C, and the signals by which a system asks a program to end.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the run is to stop.
#[derive(Clone, Default)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Notes SIGINT, SIGTERM and SIGHUP, or Ctrl-C, from now on. To be called before any file is made that would have to
    /// be removed: whoever comes first is told of signals.
    pub fn listen() -> Self {
        let interrupt = Self::default();
        let noted = interrupt.clone();
        // Fails where a signal is ignored already, as `nohup` does with SIGHUP: then it is to stay so.
        let _ = ctrlc::try_set_handler(move || noted.0.store(true, Ordering::Relaxed));
        interrupt
    }

    /// Whether a signal came.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
