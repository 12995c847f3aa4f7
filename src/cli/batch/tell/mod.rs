//! Tells what becomes of the documents: a bar on a terminal, plain lines in a pipe, or events for programs.

mod bar;
pub mod events;
mod lines;

use super::record::{Record, State};
use std::io::{self, IsTerminal};

/// Who tells the user what becomes of the documents.
pub trait Teller {
    /// Work begins on so many documents.
    fn start(&mut self, todo: usize);
    /// A document needs no work: this came of it before.
    fn settled(&mut self, record: &Record);
    /// A document that was done is done again, for this reason.
    fn again(&mut self, name: &str, reason: &str);
    /// A document is being worked on.
    fn begin(&mut self, name: &str);
    /// A document failed in a way that may pass, and is tried again.
    fn retry(&mut self, name: &str, reason: &str);
    /// A document is done with.
    fn done(&mut self, record: &Record);
    /// Time goes by.
    fn tick(&mut self);
    /// No document is worked on any more.
    fn end(&mut self);
}

/// How much is told, and to whom.
#[derive(Debug, Clone, Copy)]
pub struct Manner {
    /// To programs.
    pub json: bool,
    /// Nothing but failures.
    pub quiet: bool,
}

/// The teller for this manner and this terminal, if it is one.
pub fn teller(manner: Manner) -> Box<dyn Teller> {
    match manner {
        Manner { json: true, .. } => Box::new(events::Events),
        Manner { quiet: true, .. } => Box::new(lines::Lines::quiet()),
        _ if io::stderr().is_terminal() => Box::new(bar::Bar::new()),
        _ => Box::new(lines::Lines::new()),
    }
}

/// What became of a document, in a line.
fn line(record: &Record) -> String {
    match record.state {
        State::Converted => {
            let outputs: Vec<_> = record.outputs.iter().map(|o| o.path.as_str()).collect();
            format!("{}: {} -> {}", record.input, record.found.summary, outputs.join(", "))
        }
        State::Failed => format!("failed: {}", reason(record)),
        State::Skipped => format!("skipped: {}", reason(record)),
        State::Open => format!("{}: not done yet", record.input),
    }
}

fn reason(record: &Record) -> &str {
    record.reason.as_deref().unwrap_or(&record.input)
}
