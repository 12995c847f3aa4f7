//! Attends to the process of one document: starts it, tells it what to do, and ends it when it takes too much.

use super::interrupt::Interrupt;
use super::task::{Answer, Cause, Fault, Outcome, Task, Thumbnails, VERB};
use crate::cli::memory::{MIB, held_by};
use crate::host::isolated::{Group, ended, overhear, receive, says_out_of_memory, send};
use planform_sdk::PluginError;
use planform_sdk::parallel::VARIABLE;
use std::io::{self, BufReader};
use std::path::Path;
use std::process::{ChildStdout, Command, ExitStatus};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// How often a process is looked at.
const LOOK: Duration = Duration::from_millis(10);

/// The longest answer, bytes.
const LONGEST: u64 = 1 << 26;

/// The least memory that a process can do anything with, MiB.
pub const LEAST_MEMORY: u64 = 64;

/// How long to wait for what a process printed before it ended.
const LAST_WAIT: Duration = Duration::from_millis(200);

/// How much is quoted of what a process said last, characters.
const QUOTED: usize = 200;

/// What came of a document, and what it took.
pub struct Attended {
    /// None if the run was broken off.
    pub answer: Option<Answer>,
    /// How long it took.
    pub time: Duration,
    /// The most memory that it was seen with, bytes.
    pub memory: u64,
}

/// Has a process of its own do the task, within this time and the task's memory.
pub fn attend(task: &Task, time: Duration, interrupt: &Interrupt) -> Attended {
    let start = Instant::now();
    match Patient::start(task) {
        Ok(mut patient) => {
            let end = patient.attend(start + time, task.memory.saturating_mul(MIB), interrupt);
            let answer = match end {
                End::Answered(answer) => {
                    patient.most = patient.most.max(answer.memory);
                    Some(*answer)
                }
                End::Interrupted => None,
                End::Died(death) => Some(failed(death.fault(task, time))),
            };
            Attended { answer, time: start.elapsed(), memory: patient.most }
        }
        Err(e) => {
            let reason = format!("no process can be started for it: {}", PluginError::from(e));
            let fault = Fault::new(Cause::System, over(task, &reason));
            Attended { answer: Some(failed(fault)), time: start.elapsed(), memory: 0 }
        }
    }
}

fn failed(fault: Fault) -> Answer {
    Answer { seen: None, thumbnails: Thumbnails::default(), memory: 0, outcome: Outcome::Failed(fault) }
}

fn over(task: &Task, reason: &str) -> String {
    format!("{}: {reason}", Path::new(&task.input).display())
}

/// A process at work on a document.
struct Patient {
    group: Group,
    /// Open as long as somebody is interested.
    _input: std::process::ChildStdin,
    answers: Receiver<Answer>,
    errors: Receiver<()>,
    last_words: Arc<Mutex<Vec<u8>>>,
    /// The most memory that it was seen with, bytes.
    most: u64,
}

/// How the attendance ended.
enum End {
    Answered(Box<Answer>),
    Interrupted,
    Died(Death),
}

impl Patient {
    fn start(task: &Task) -> io::Result<Self> {
        let mut command = Command::new(std::env::current_exe()?);
        command.arg(VERB);
        // Documents are worked on side by side: threads of its own would only stand in the way of others.
        if std::env::var_os("OMP_THREAD_LIMIT").is_none() {
            command.env("OMP_THREAD_LIMIT", "1");
        }
        if std::env::var_os(VARIABLE).is_none() {
            command.env(VARIABLE, "1");
        }
        let (group, (mut input, output, errors)) = Group::start(command)?;
        // A process that is gone takes no task, and gives no answer either.
        let _ = send(&mut input, task, &[]);
        let last_words = Arc::default();
        Ok(Self {
            group,
            _input: input,
            answers: hear(output),
            errors: overhear(errors, Arc::clone(&last_words), false),
            last_words,
            most: 0,
        })
    }

    fn attend(&mut self, deadline: Instant, memory: u64, interrupt: &Interrupt) -> End {
        loop {
            match self.answers.recv_timeout(LOOK) {
                Ok(answer) => return End::Answered(Box::new(answer)),
                // Not every process that gets no more memory says so before it crashes.
                Err(RecvTimeoutError::Disconnected) => {
                    return End::Died(self.death(false, self.most >= memory / 10 * 9));
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
            self.most = self.most.max(held_by(self.group.id()));
            if interrupt.is_set() {
                self.group.end();
                return End::Interrupted;
            }
            let (late, greedy) = (Instant::now() >= deadline, self.most > memory);
            if late || greedy {
                return End::Died(self.death(late, greedy));
            }
        }
    }

    /// Ends the process, if it has not ended by itself.
    fn death(&mut self, late: bool, greedy: bool) -> Death {
        if !late && !greedy {
            self.wait();
        }
        let by_itself = self.group.has_ended();
        let status = self.group.end().filter(|_| by_itself);
        let words = self.last_words.lock().unwrap_or_else(PoisonError::into_inner);
        Death { late, greedy, status, last_words: String::from_utf8_lossy(&words).into_owned() }
    }

    /// A process closes its output shortly before it ends, and what it printed arrives shortly after.
    fn wait(&mut self) {
        let end = Instant::now() + LAST_WAIT;
        let _ = self.errors.recv_timeout(LAST_WAIT);
        while !self.group.has_ended() && Instant::now() < end {
            thread::sleep(Duration::from_millis(1));
        }
    }
}

/// Reads the answer when it comes. The channel closes when there is none.
fn hear(output: ChildStdout) -> Receiver<Answer> {
    let (answers, received) = channel();
    thread::spawn(move || {
        if let Ok((answer, _)) = receive(&mut BufReader::new(output), LONGEST) {
            // Nobody listens any more when the process was given up.
            let _ = answers.send(answer);
        }
    });
    received
}

/// What is known of a process that did not answer.
struct Death {
    late: bool,
    greedy: bool,
    /// How it ended, if it did by itself.
    status: Option<ExitStatus>,
    last_words: String,
}

impl Death {
    fn fault(&self, task: &Task, time: Duration) -> Fault {
        let memory = || {
            let advice = "`--document-memory MIB` allows more, up to `--memory`";
            format!("took more than the {} MiB of memory that it may; {advice}", task.memory)
        };
        let (cause, reason) = if self.greedy || says_out_of_memory(&self.last_words) {
            (Cause::Memory, memory())
        } else if self.late {
            let seconds = time.as_secs();
            (
                Cause::Time,
                format!("took longer than the {seconds} s that it may; `--timeout SECONDS` allows more"),
            )
        } else if self.last_words.contains("has overflowed its stack") {
            (Cause::Bug, "its process ran out of stack; please report it with this document".into())
        } else {
            (Cause::Crash, self.crash())
        };
        Fault::new(cause, over(task, &reason))
    }

    fn crash(&self) -> String {
        let end = self.status.map_or_else(|| "it broke off its talk with planform".into(), ended);
        let last = self.last_words.lines().rfind(|line| !line.trim().is_empty());
        let last = last
            .map(|line| format!(", after saying `{}`", line.trim().chars().take(QUOTED).collect::<String>()));
        format!("its process failed: {end}{}", last.unwrap_or_default())
    }
}
