//! A line on standard error for every document.

use super::super::record::{Record, State};
use super::{Teller, line};
use crate::cli::failure::say;

/// Tells in plain lines.
pub struct Lines {
    quiet: bool,
    done: usize,
    todo: usize,
}

impl Lines {
    /// Tells of every document.
    pub fn new() -> Self {
        Self { quiet: false, done: 0, todo: 0 }
    }

    /// Tells of those that failed.
    pub fn quiet() -> Self {
        Self { quiet: true, ..Self::new() }
    }

    fn say(&self, line: &str) {
        if !self.quiet {
            say(line);
        }
    }
}

impl Teller for Lines {
    fn start(&mut self, todo: usize) {
        self.todo = todo;
        self.done = 0;
    }

    fn settled(&mut self, record: &Record) {
        if record.state == State::Failed {
            say(&line(record));
        }
    }

    fn again(&mut self, name: &str, reason: &str) {
        self.say(&format!("again: {name}: {reason}"));
    }

    fn begin(&mut self, _: &str) {}

    fn retry(&mut self, _: &str, reason: &str) {
        self.say(&format!("trying again: {reason}"));
    }

    fn done(&mut self, record: &Record) {
        // Before the work begins, documents are only sorted out.
        let count = if self.todo > 0 {
            self.done += 1;
            format!("[{}/{}] ", self.done, self.todo)
        } else {
            String::new()
        };
        if record.state == State::Failed {
            say(&format!("{count}{}", line(record)));
        } else {
            self.say(&format!("{count}{}", line(record)));
        }
    }

    fn tick(&mut self) {}

    fn end(&mut self) {
        self.todo = 0;
    }
}
