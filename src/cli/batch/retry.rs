//! Which failures may pass, and which cannot.

use super::task::Cause;
use std::time::Duration;

/// How long the system is given to recover before a document is tried again.
const PAUSE: Duration = Duration::from_secs(1);

/// What follows from a failure.
#[derive(Debug, PartialEq, Eq)]
pub enum Next {
    /// The document failed.
    GiveUp,
    /// It is tried again after a pause, with this much memory, MiB.
    Again(Duration, u64),
    /// No document can be worked on as things are.
    Halt,
}

/// What follows when a document failed for this cause after so many attempts, with so much memory; it may be tried again
/// `retries` times, and may have `most` memory, MiB.
pub fn next(cause: Cause, attempts: u32, retries: u32, memory: u64, most: u64) -> Next {
    match cause {
        Cause::Disk | Cause::Gone => Next::Halt,
        // More memory is the one thing that helps, and then all of it at once.
        Cause::Memory if memory < most => Next::Again(Duration::ZERO, most),
        Cause::Changed | Cause::System if attempts <= retries => Next::Again(PAUSE, memory),
        Cause::Crash | Cause::Time if attempts <= retries => Next::Again(Duration::ZERO, memory),
        _ => Next::GiveUp,
    }
}

/// Whether a document that failed for this cause would fail again as long as it is the same: then another run need not
/// try.
pub fn is_lasting(cause: Cause) -> bool {
    matches!(cause, Cause::Document | Cause::Plugin | Cause::Bug)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_may_pass_is_tried_again() {
        assert_eq!(next(Cause::Document, 1, 5, 100, 200), Next::GiveUp);
        assert_eq!(next(Cause::Plugin, 1, 5, 100, 200), Next::GiveUp);
        assert_eq!(next(Cause::Crash, 1, 1, 100, 200), Next::Again(Duration::ZERO, 100));
        assert_eq!(next(Cause::Crash, 2, 1, 100, 200), Next::GiveUp);
        assert_eq!(next(Cause::Changed, 1, 0, 100, 200), Next::GiveUp);
        assert_eq!(next(Cause::Memory, 1, 0, 100, 200), Next::Again(Duration::ZERO, 200));
        assert_eq!(next(Cause::Memory, 2, 5, 200, 200), Next::GiveUp);
        assert_eq!(next(Cause::Disk, 1, 5, 100, 200), Next::Halt);
    }
}
