//! A bar on the terminal: how far, how fast, how much longer, what failed and what is in work.

use super::super::record::{Record, State};
use super::{Teller, line};
use crate::cli::failure::safe;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::Duration;

const TEMPLATE: &str = "{bar:24} {pos}/{len}  {per_sec}  {eta} left  {wide_msg}";

/// How often the bar is drawn.
const REFRESH: Duration = Duration::from_millis(200);

/// Tells with a bar.
pub struct Bar {
    bar: ProgressBar,
    failed: usize,
    in_work: Vec<String>,
    works: bool,
}

impl Bar {
    /// A bar that is not shown yet.
    pub fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self { bar, failed: 0, in_work: vec![], works: false }
    }

    fn show(&self) {
        let failed = if self.failed > 0 { format!("{} failed  ", self.failed) } else { String::new() };
        self.bar.set_message(format!("{failed}{}", self.in_work.join(", ")));
    }

    fn say(&self, line: &str) {
        // The bar is drawn below the line.
        self.bar.suspend(|| crate::cli::failure::say(line));
    }
}

impl Teller for Bar {
    fn start(&mut self, todo: usize) {
        let style = ProgressStyle::with_template(TEMPLATE).unwrap_or_else(|_| ProgressStyle::default_bar());
        self.bar = ProgressBar::with_draw_target(Some(todo as u64), ProgressDrawTarget::stderr());
        self.bar.set_style(style);
        self.bar.enable_steady_tick(REFRESH);
        self.works = true;
        self.show();
    }

    fn settled(&mut self, record: &Record) {
        if record.state == State::Failed {
            self.say(&line(record));
        }
    }

    fn again(&mut self, name: &str, reason: &str) {
        self.say(&format!("again: {name}: {reason}"));
    }

    fn begin(&mut self, name: &str) {
        self.in_work.push(safe(name));
        self.show();
    }

    fn retry(&mut self, name: &str, reason: &str) {
        self.in_work.retain(|n| *n != safe(name));
        self.say(&format!("trying again: {reason}"));
        self.show();
    }

    fn done(&mut self, record: &Record) {
        self.in_work.retain(|n| *n != safe(&record.name));
        if record.state == State::Failed {
            self.failed += 1;
            self.say(&line(record));
        }
        if self.works {
            self.bar.inc(1);
        }
        self.show();
    }

    fn tick(&mut self) {}

    fn end(&mut self) {
        self.works = false;
        self.bar.finish_and_clear();
    }
}
