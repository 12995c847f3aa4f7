//! Tells on standard error what the program is doing: a line on a terminal when the work takes long, every step and
//! its time when asked to.

use super::failure::say;
use std::io::{self, IsTerminal, Write};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Work that is done sooner than this needs no progress line.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time between two refreshes of the progress line.
const REFRESH: Duration = Duration::from_millis(200);
/// Back to the line's start, and clear the line.
const CLEAR: &str = "\r\x1b[K";

/// How much is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Voice {
    /// Nothing but errors.
    Quiet,
    /// Warnings, a summary, and a progress line on a terminal.
    Normal,
    /// Every step and its time as well.
    Verbose,
}

/// What is being done. Dropping it ends the last step and clears the progress line.
pub struct Progress {
    voice: Voice,
    step: Option<(&'static str, Instant)>,
    /// When the last stage of the step ended, or else when the step began.
    stage: Instant,
    line: Option<Line>,
}

impl Progress {
    /// No step yet.
    pub fn new(voice: Voice) -> Self {
        let shows_line = voice == Voice::Normal && io::stderr().is_terminal();
        Self { voice, step: None, stage: Instant::now(), line: shows_line.then(Line::start) }
    }

    /// The step before is done, this one begins.
    pub fn step(&mut self, name: &'static str) {
        self.end_step();
        self.stage = Instant::now();
        self.step = Some((name, self.stage));
        if let Some(line) = &self.line {
            // The line's thread ends only after this sender.
            let _ = line.names.send(name);
        }
    }

    /// A part of the step is done.
    pub fn stage(&mut self, name: &str) {
        let start = std::mem::replace(&mut self.stage, Instant::now());
        if self.voice == Voice::Verbose {
            say(&format!("  {name:<10}{:>8.3} s", start.elapsed().as_secs_f64()));
        }
    }

    fn end_step(&mut self) {
        if let (Voice::Verbose, Some((name, start))) = (self.voice, self.step.take()) {
            say(&format!("{name:<12}{:>8.3} s", start.elapsed().as_secs_f64()));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.end_step();
        if let Some(Line { names, thread }) = self.line.take() {
            drop(names);
            let _ = thread.join();
        }
    }
}

/// A thread that keeps the progress line.
struct Line {
    names: Sender<&'static str>,
    thread: JoinHandle<()>,
}

impl Line {
    fn start() -> Self {
        let (names, receiver) = mpsc::channel();
        Self { names, thread: thread::spawn(move || keep_line(&receiver, &mut io::stderr())) }
    }
}

fn keep_line(names: &Receiver<&'static str>, out: &mut dyn Write) {
    let start = Instant::now();
    let mut current = "";
    loop {
        match names.recv_timeout(REFRESH) {
            Ok(name) => current = name,
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => break,
        }
        if start.elapsed() >= PATIENCE {
            // Progress that cannot be shown is no reason to stop the work.
            let _ =
                write!(out, "{CLEAR}{current} ({} s)", start.elapsed().as_secs()).and_then(|()| out.flush());
        }
    }
    if start.elapsed() >= PATIENCE {
        let _ = write!(out, "{CLEAR}").and_then(|()| out.flush());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line_of(work: impl FnOnce(Sender<&'static str>) + Send + 'static) -> String {
        let (names, receiver) = mpsc::channel();
        let worker = thread::spawn(move || work(names));
        let mut out = Vec::new();
        keep_line(&receiver, &mut out);
        worker.join().unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn quick_work_shows_nothing() {
        assert_eq!(line_of(|names| names.send("edges").unwrap()), "");
    }

    #[test]
    fn long_work_shows_its_step_and_clears_it() {
        let line = line_of(|names| {
            names.send("edges").unwrap();
            thread::sleep(PATIENCE + 2 * REFRESH);
        });
        assert!(line.contains("edges (1 s)") && line.ends_with(CLEAR), "{line:?}");
    }
}
