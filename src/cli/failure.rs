//! How a verb fails: one sentence on standard error, and an exit status.

use planform_sdk::{ErrorKind, PluginError};
use std::borrow::Cow;
use std::ffi::OsString;
use std::io::{self, Write};
use std::panic;
use std::path::Path;
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};

/// Why a verb did not do its work.
#[derive(Debug, PartialEq, Eq)]
pub enum Failure {
    /// The work failed: exit status 1.
    Failed(String),
    /// The command line asks for something that makes no sense: exit status 2.
    Usage(String),
    /// The user or the system broke the work off: exit status 130, as shells tell it.
    Interrupted(String),
    /// The reader of standard output went away, as `head` does: nothing to complain about.
    ReaderGone,
}

impl Failure {
    /// A failure over this file.
    pub fn over(file: impl AsRef<Path>, reason: impl std::fmt::Display) -> Self {
        Self::Failed(format!("{}: {reason}", shown(file.as_ref())))
    }

    /// A failure of a plugin, or of reading a file, over this file.
    pub fn of_plugin(file: impl AsRef<Path>, error: PluginError) -> Self {
        match (error.kind, Self::over(file, &error)) {
            (ErrorKind::BadOption, Self::Failed(sentence)) => Self::Usage(sentence),
            (_, failure) => failure,
        }
    }

    /// The system's refusal to read or write this file.
    pub fn of_io(file: impl AsRef<Path>, error: io::Error) -> Self {
        Self::of_plugin(file, error.into())
    }

    /// What went wrong.
    pub fn sentence(self) -> String {
        match self {
            Self::Failed(sentence) | Self::Usage(sentence) | Self::Interrupted(sentence) => sentence,
            Self::ReaderGone => "nobody reads the output any more".into(),
        }
    }

    /// Says what went wrong on standard error.
    pub fn report(self) -> ExitCode {
        let (sentence, code) = match self {
            Self::Failed(sentence) => (sentence, 1),
            Self::Usage(sentence) => (sentence, 2),
            Self::Interrupted(sentence) => (sentence, INTERRUPTED),
            Self::ReaderGone => return ExitCode::SUCCESS,
        };
        say(&format!("error: {sentence}"));
        ExitCode::from(code)
    }
}

/// The exit status after Ctrl-C, as shells tell it.
pub const INTERRUPTED: u8 = 130;

/// A path as the user knows it: `-` is standard input.
pub fn shown(path: &Path) -> String {
    if path == Path::new("-") { "standard input".into() } else { path.display().to_string() }
}

/// Prints a line on standard error. What a document says must not steer the terminal, so control characters are
/// written out.
pub fn say(line: &str) {
    // Nobody is left to be told when standard error is closed.
    let _ = writeln!(io::stderr(), "{}", safe(&cut(line)));
}

/// The line with its control characters written out.
pub fn safe(line: &str) -> String {
    line.chars().flat_map(|c| if c.is_control() { c.escape_default().collect() } else { vec![c] }).collect()
}

/// The longest line that is printed on standard error, characters: a document can make a message as long as itself.
const LONGEST: usize = 2000;

/// The line up to that length.
fn cut(line: &str) -> Cow<'_, str> {
    match line.char_indices().nth(LONGEST) {
        None => line.into(),
        Some((end, _)) => format!("{}... ({} more bytes)", &line[..end], line.len() - end).into(),
    }
}

/// Prints on standard output.
pub fn print(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(e) if e.kind() == io::ErrorKind::BrokenPipe => Err(Failure::ReaderGone),
        result => result.map_err(|e| Failure::of_io("standard output", e)),
    }
}

/// Runs `work`; a panic in it becomes a sentence that says where the bug is and by what command it shows.
/// With `RUST_BACKTRACE` set, the panic also prints what it always does.
pub fn catch_bugs<T>(args: &[OsString], work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    let place = Arc::new(Mutex::new(String::new()));
    let noted = Arc::clone(&place);
    let usual = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        *noted.lock().unwrap_or_else(PoisonError::into_inner) =
            info.location().map(ToString::to_string).unwrap_or_default();
        if std::env::var_os("RUST_BACKTRACE").is_some() {
            usual(info);
        }
    }));
    panic::catch_unwind(panic::AssertUnwindSafe(work)).unwrap_or_else(|_| {
        let place = place.lock().unwrap_or_else(PoisonError::into_inner);
        Err(Failure::Failed(bug_sentence(&place, args)))
    })
}

fn bug_sentence(place: &str, args: &[OsString]) -> String {
    let words: Vec<_> = args.iter().skip(1).map(|a| a.to_string_lossy()).collect();
    format!(
        "this is a bug in planform {} at {place}; please report it with the input of `planform {}`",
        env!("CARGO_PKG_VERSION"),
        words.join(" ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_a_sentence() {
        let args = ["planform", "convert", "map.yaml"].map(OsString::from);
        let Err(Failure::Failed(sentence)) = catch_bugs::<()>(&args, || panic!("boom")) else {
            panic!("no failure")
        };
        assert!(
            sentence.contains("failure.rs") && sentence.contains("`planform convert map.yaml`"),
            "{sentence}"
        );
    }

    #[test]
    fn long_lines_are_cut() {
        assert_eq!(cut(&"ä".repeat(LONGEST)).chars().count(), LONGEST);
        let long = cut(&"ä".repeat(LONGEST + 3)).into_owned();
        assert!(long.ends_with("ä... (6 more bytes)"), "{long}");
    }

    #[test]
    fn bad_options_are_the_users_fault() {
        let bad = |kind| Failure::of_plugin("a.pgm", PluginError::new(kind, "no"));
        assert_eq!(bad(ErrorKind::BadOption), Failure::Usage("a.pgm: no".into()));
        assert_eq!(bad(ErrorKind::Limit), Failure::Failed("a.pgm: no".into()));
    }
}
