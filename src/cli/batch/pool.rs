//! Documents at work side by side, as many as there are workers, and as fit into the memory.

use super::attendant::{Attended, attend};
use super::estimate::need;
use super::interrupt::Interrupt;
use super::jobs::Job;
use super::task::{Answer, Fault, Outcome, Task, Thumbnails};
use super::worker::unwritable;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// What documents may take.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Documents at a time.
    pub workers: usize,
    /// Memory for all that are at work, MiB.
    pub memory: u64,
    /// Memory for one, MiB.
    pub document_memory: u64,
    /// Time for one.
    pub time: Duration,
    /// How often one is tried again where that may help.
    pub retries: u32,
}

impl Bounds {
    /// The most memory that one document can have, MiB.
    pub fn most(&self) -> u64 {
        self.document_memory.min(self.memory)
    }

    /// The memory that a document begins with, MiB: what it seems to need, and no less than its share.
    fn first(&self, job: &Job) -> u64 {
        need(&job.files).max(self.memory / self.workers as u64).min(self.most())
    }
}

/// A document that waits for its turn.
pub struct Waiting {
    /// What is to be done.
    pub job: Arc<Job>,
    /// How often it was tried.
    pub attempts: u32,
    /// The memory that is set apart for it, MiB.
    pub memory: u64,
    /// Not before.
    pub due: Instant,
}

/// A document that was worked on.
pub struct Finished {
    /// What was to be done.
    pub job: Arc<Job>,
    /// How often it was tried, this time included.
    pub attempts: u32,
    /// The memory that was set apart for it, MiB.
    pub memory: u64,
    /// What came of it.
    pub attended: Attended,
    /// Where its outputs wait; removed when dropped.
    pub _staging: Option<TempDir>,
}

/// The documents at work and those that wait.
pub struct Pool {
    bounds: Bounds,
    staging: PathBuf,
    interrupt: Interrupt,
    waiting: VecDeque<Waiting>,
    at_work: usize,
    /// The memory that is set apart, MiB.
    reserved: u64,
    sender: Sender<Finished>,
    finished: Receiver<Finished>,
}

impl Pool {
    /// A pool that stages outputs in this folder.
    pub fn new(bounds: Bounds, staging: &Path, interrupt: &Interrupt) -> Self {
        let (sender, finished) = channel();
        Self {
            bounds,
            staging: staging.into(),
            interrupt: interrupt.clone(),
            waiting: VecDeque::new(),
            at_work: 0,
            reserved: 0,
            sender,
            finished,
        }
    }

    /// Puts a document at the end of the queue.
    pub fn add(&mut self, job: Job) {
        let memory = self.bounds.first(&job);
        self.waiting.push_back(Waiting { job: Arc::new(job), attempts: 0, memory, due: Instant::now() });
    }

    /// Puts a document that is to be tried again at the end of the queue.
    pub fn add_again(&mut self, waiting: Waiting) {
        self.waiting.push_back(waiting);
    }

    /// Forgets those that wait.
    pub fn forget_waiting(&mut self) {
        self.waiting.clear();
    }

    /// Whether there is nothing left to wait for.
    pub fn is_done(&self) -> bool {
        self.waiting.is_empty() && self.at_work == 0
    }

    /// Starts work on the next document, if there is a worker and the memory for it.
    pub fn start_next(&mut self) -> Option<Arc<Job>> {
        let fits = |w: &Waiting| self.at_work == 0 || self.reserved + w.memory <= self.bounds.memory;
        // The first that is due and no other: a large document that is always overtaken would never come.
        let next = self.waiting.iter().position(|w| w.due <= Instant::now())?;
        if self.at_work >= self.bounds.workers || !fits(&self.waiting[next]) {
            return None;
        }
        let waiting = self.waiting.remove(next)?;
        let job = Arc::clone(&waiting.job);
        self.at_work += 1;
        self.reserved += waiting.memory;
        self.start(waiting);
        Some(job)
    }

    fn start(&self, waiting: Waiting) {
        let (staging, time) = (self.staging.clone(), self.bounds.time);
        let (interrupt, sender) = (self.interrupt.clone(), self.sender.clone());
        let Waiting { job, attempts, memory, .. } = waiting;
        let attempts = attempts + 1;
        let refused = Arc::clone(&job);
        let work = move || {
            let (attended, staging) = work_on(&job, memory, &staging, time, &interrupt);
            // Fails only if the pool is gone, and then nobody wants to know.
            let _ = sender.send(Finished { job, attempts, memory, attended, _staging: staging });
        };
        if let Err(e) = thread::Builder::new().spawn(work) {
            let attended = failed(unwritable(refused.input(), e));
            let finished = Finished { job: refused, attempts, memory, attended, _staging: None };
            let _ = self.sender.send(finished);
        }
    }

    /// The next document that is done with, if there is one before so much time is over.
    pub fn next(&mut self, patience: Duration) -> Option<Finished> {
        let finished = self.finished.recv_timeout(patience).ok()?;
        self.at_work -= 1;
        self.reserved -= finished.memory;
        Some(finished)
    }
}

fn work_on(
    job: &Job,
    memory: u64,
    staging: &Path,
    time: Duration,
    interrupt: &Interrupt,
) -> (Attended, Option<TempDir>) {
    let folder = match tempfile::Builder::new().prefix("document-").tempdir_in(staging) {
        Ok(folder) => folder,
        Err(e) => return (failed(unwritable(staging, e)), None),
    };
    let task = Task {
        input: job.input().into(),
        siblings: job.files.iter().skip(1).map(Into::into).collect(),
        named: job.named,
        outputs: job.outputs.iter().map(|(path, format)| (path.into(), format.clone())).collect(),
        staging: folder.path().into(),
        how: job.how.clone(),
        memory,
    };
    (attend(&task, time, interrupt), Some(folder))
}

fn failed(fault: Fault) -> Attended {
    let answer =
        Answer { seen: None, thumbnails: Thumbnails::default(), memory: 0, outcome: Outcome::Failed(fault) };
    Attended { answer: Some(answer), time: Duration::ZERO, memory: 0 }
}
