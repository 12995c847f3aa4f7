//! No panic crosses.

use std::cell::RefCell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    /// Where the last panic of this thread was.
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Does the work; a panic becomes the sentence that says where it was.
pub fn guard<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    panic::catch_unwind(AssertUnwindSafe(work)).map_err(|payload| {
        let words = payload
            .downcast_ref::<&str>()
            .map(ToString::to_string)
            .or_else(|| payload.downcast_ref::<String>().cloned())
            .unwrap_or_default();
        // To drop it may panic once more.
        if let Err(again) = panic::catch_unwind(AssertUnwindSafe(|| drop(payload))) {
            std::mem::forget(again);
        }
        let place = PLACE.with(|p| p.try_borrow().map(|p| p.clone()).unwrap_or_default());
        format!("it has a bug at {place}: {words}")
    })
}

/// Notes where panics are, in place of printing it: the host tells it in one sentence. With `RUST_BACKTRACE` set they
/// are printed as well. Only for a library that has the Rust runtime for itself.
pub fn note_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let usual = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            let place = info.location().map(ToString::to_string).unwrap_or_default();
            PLACE.with(|p| p.replace(place));
            if std::env::var_os("RUST_BACKTRACE").is_some() {
                usual(info);
            }
        }));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_a_sentence() {
        assert_eq!(guard(|| 1), Ok(1));
        let sentence = guard(|| panic!("no room {}", 7)).unwrap_err();
        assert!(sentence.starts_with("it has a bug at ") && sentence.ends_with(": no room 7"), "{sentence}");
        assert!(guard(|| panic::panic_any(3)).is_err());
    }
}
