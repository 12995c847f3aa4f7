//! Keeps decoders of other people's at a distance.
//!
//! The renderers of PDF and SVG, and the parser of DXF, cannot be stopped from outside and make no promise for hostile
//! documents. So they run in a thread of their own, with a large stack: a panic ends that thread alone, and after a time
//! it is no longer waited for.

use planform_sdk::{ErrorKind, PluginError};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread::Builder;
use std::time::Duration;

/// The longest that a page may take.
pub const PATIENCE: Duration = Duration::from_secs(60);
/// Bytes of stack; the system gives only what is used of it.
const STACK: usize = 256 << 20;

/// Does the work in a thread of its own, waiting this long. `what` names the document in messages: "the PDF".
pub fn guarded<T: Send + 'static>(
    what: &str,
    patience: Duration,
    work: impl FnOnce() -> Result<T, PluginError> + Send + 'static,
) -> Result<T, PluginError> {
    let (sender, receiver) = channel();
    Builder::new().stack_size(STACK).spawn(move || sender.send(work()))?;
    match receiver.recv_timeout(patience) {
        Ok(result) => result,
        Err(RecvTimeoutError::Timeout) => {
            let message = format!("{what} is not drawn after {} seconds", patience.as_secs());
            Err(PluginError::new(ErrorKind::Limit, message)
                .advise("simplify it, or save the page as a picture"))
        }
        Err(RecvTimeoutError::Disconnected) => {
            let message = format!("{what} is damaged in a way that its reader cannot handle");
            Err(PluginError::new(ErrorKind::BadInput, message).advise("save it again, or as a picture"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread::sleep;

    #[test]
    fn panics_and_loops_become_sentences() {
        let long = Duration::from_secs(10);
        assert_eq!(guarded("it", long, || Ok(3)).unwrap(), 3);
        let panicked = guarded::<()>("the PDF", long, || panic!("on purpose")).unwrap_err();
        assert!(panicked.to_string().starts_with("the PDF is damaged in a way"), "{panicked}");
        let late = guarded("the PDF", Duration::ZERO, || {
            sleep(Duration::from_millis(200));
            Ok(())
        });
        assert!(late.unwrap_err().to_string().starts_with("the PDF is not drawn after 0 seconds"));
    }
}
