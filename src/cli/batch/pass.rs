//! One pass over documents: those that are not done yet are worked on, and what came of each is noted.

use super::digest::{Digest, Seen};
use super::documents::{Listed, Trouble};
use super::interrupt::Interrupt;
use super::jobs::{self, Job, VERSION, Verdict};
use super::journal::{Entry, Journal};
use super::names::text_of;
use super::pool::{Bounds, Finished, Pool, Waiting};
use super::publish::{Places, Unpublished};
use super::record::{Record, State, Written};
use super::retry::{self, Next};
use super::task::{Cause, Converted, Fault, Outcome, Staged, Thumbnails};
use super::tell::Teller;
use crate::cli::Failure;
use crate::cli::memory::MIB;
use std::path::Path;
use std::time::{Duration, Instant};

/// How long to wait for a document before looking up.
const PATIENCE: Duration = Duration::from_millis(50);

/// What a pass works with.
pub struct Pass<'a> {
    /// What came of documents.
    pub journal: &'a mut Journal,
    /// Where outputs go.
    pub places: Places<'a>,
    /// The folder in which outputs wait.
    pub staging: &'a Path,
    /// What documents may take.
    pub bounds: Bounds,
    /// Whether documents that failed for good are tried again.
    pub retry_failed: bool,
    /// Who tells the user.
    pub teller: &'a mut dyn Teller,
    /// Whether the user wants to stop.
    pub interrupt: &'a Interrupt,
}

/// How a pass ended, if it did not come to its end.
pub enum Halt {
    /// The user or the system broke it off.
    Interrupted,
    /// Nothing can be written any more.
    Stuck(Failure),
}

impl Pass<'_> {
    /// Works on what is left to do. A document that was not found before the pass is not in the jobs.
    pub fn run(&mut self, left_out: &[Listed], jobs: Vec<Job>) -> Result<Option<Halt>, Failure> {
        for document in left_out {
            self.note_trouble(document)?;
        }
        let mut pool = Pool::new(self.bounds, self.staging, self.interrupt);
        let todo = self.todo(jobs)?;
        self.teller.start(todo.len());
        todo.into_iter().for_each(|job| pool.add(job));
        let halt = self.work(&mut pool)?;
        self.teller.end();
        Ok(halt)
    }

    /// Those that are left to do. What is the matter with the others is noted.
    fn todo(&mut self, jobs: Vec<Job>) -> Result<Vec<Job>, Failure> {
        let mut todo = vec![];
        for job in jobs {
            if self.interrupt.is_set() {
                break;
            }
            match jobs::verdict(&job, self.journal, &self.places, self.retry_failed)? {
                Verdict::Settled(entry) => {
                    self.teller.settled(&entry.record);
                    continue;
                }
                Verdict::Again(reason) => self.teller.again(&job.name, &reason),
                Verdict::New => {}
            }
            match self.obstacle(&job)? {
                Some(fault) => self.note_obstacle(&job, fault)?,
                None => todo.push(job),
            }
        }
        Ok(todo)
    }

    /// What is in the way of the outputs.
    fn obstacle(&self, job: &Job) -> Result<Option<Fault>, Failure> {
        for place in &job.places {
            match self.places.check(place, Some(self.journal)) {
                Ok(_) => {}
                Err(Unpublished::Fault(fault)) => return Ok(Some(fault)),
                Err(Unpublished::Journal(failure)) => return Err(failure),
            }
        }
        Ok(None)
    }

    fn note_obstacle(&mut self, job: &Job, fault: Fault) -> Result<(), Failure> {
        self.note(job, None, blank(job).failed(fault), Thumbnails::default())
    }

    fn note_trouble(&mut self, document: &Listed) -> Result<(), Failure> {
        let input = text_of(&document.input);
        let blank = Record::open(&document.name(), &input);
        let record = match &document.trouble {
            None => return Ok(()),
            Some(Trouble::LeftOut(reason)) => blank.skipped(format!("{input}: {reason}")),
            Some(Trouble::Broken(reason)) => {
                blank.failed(Fault::new(Cause::Missing, format!("{input}: {reason}")))
            }
        };
        let known = self.journal.entry(&record.name)?.is_some_and(|e| e.record == record);
        if known {
            self.teller.settled(&record);
            return Ok(());
        }
        self.note_entry(entry(Digest::of(b""), None, record, Thumbnails::default()))
    }

    fn work(&mut self, pool: &mut Pool) -> Result<Option<Halt>, Failure> {
        let mut halt = None;
        while !pool.is_done() {
            if halt.is_none() && self.interrupt.is_set() {
                halt = Some(Halt::Interrupted);
            }
            if halt.is_some() {
                pool.forget_waiting();
            }
            while let Some(job) = pool.start_next() {
                self.teller.begin(&job.name);
            }
            match pool.next(PATIENCE) {
                Some(finished) => {
                    let stuck = self.finish(finished, pool);
                    halt = halt.or(stuck.map(Halt::Stuck));
                }
                None => self.teller.tick(),
            }
        }
        // A signal may have come while the last document was finished; then all the same everything is done.
        Ok(halt)
    }

    /// Publishes and notes what came of a document. What is returned keeps any other from being worked on.
    fn finish(&mut self, finished: Finished, pool: &mut Pool) -> Option<Failure> {
        let answer = finished.attended.answer.clone()?;
        let record = Record {
            seconds: finished.attended.time.as_secs_f64(),
            memory_mib: finished.attended.memory.div_ceil(MIB),
            attempts: finished.attempts,
            ..blank(&finished.job)
        };
        let thumbnails = answer.thumbnails;
        let noted = match answer.outcome {
            Outcome::Converted(converted) => match self.publish(&finished.job, &converted) {
                Ok(outputs) => {
                    let record =
                        Record { state: State::Converted, found: converted.found, outputs, ..record };
                    self.note(&finished.job, answer.seen, record, thumbnails)
                }
                Err(Unpublished::Journal(failure)) => Err(failure),
                Err(Unpublished::Fault(fault)) => {
                    self.fail(&finished, fault, record, answer.seen, thumbnails, pool)
                }
            },
            Outcome::LeftOut(reason) => {
                let record = record.clone().skipped(format!("{}: {reason}", record.input));
                self.note(&finished.job, answer.seen, record, thumbnails)
            }
            Outcome::Failed(fault) => self.fail(&finished, fault, record, answer.seen, thumbnails, pool),
        };
        noted.err()
    }

    fn publish(&mut self, job: &Job, converted: &Converted) -> Result<Vec<Written>, Unpublished> {
        self.places.publish(&job.name, &converted.files, self.journal)?;
        let written = |f: &Staged| Written {
            path: self.places.below(Path::new(&f.path)),
            bytes: f.bytes,
            sha256: f.digest.clone(),
        };
        Ok(converted.files.iter().map(written).collect())
    }

    fn fail(
        &mut self,
        finished: &Finished,
        fault: Fault,
        record: Record,
        seen: Option<Seen>,
        thumbnails: Thumbnails,
        pool: &mut Pool,
    ) -> Result<(), Failure> {
        let Bounds { retries, .. } = self.bounds;
        match retry::next(fault.cause, finished.attempts, retries, finished.memory, self.bounds.most()) {
            Next::GiveUp => self.note(&finished.job, seen, record.failed(fault), thumbnails),
            Next::Halt => Err(Failure::Failed(stuck(&fault, self.places.output))),
            Next::Again(pause, memory) => {
                self.teller.retry(&record.name, &fault.sentence);
                let (job, attempts) = (finished.job.clone(), finished.attempts);
                pool.add_again(Waiting { job, attempts, memory, due: Instant::now() + pause });
                Ok(())
            }
        }
    }

    fn note(
        &mut self,
        job: &Job,
        seen: Option<Seen>,
        record: Record,
        thumbnails: Thumbnails,
    ) -> Result<(), Failure> {
        self.note_entry(entry(job.options.clone(), seen, record, thumbnails))
    }

    fn note_entry(&mut self, entry: Entry) -> Result<(), Failure> {
        self.journal.note(&entry)?;
        self.teller.done(&entry.record);
        Ok(())
    }
}

fn blank(job: &Job) -> Record {
    Record::open(&job.name, &text_of(job.input()))
}

fn entry(options: Digest, seen: Option<Seen>, record: Record, thumbnails: Thumbnails) -> Entry {
    Entry { options, version: VERSION.into(), seen, record, thumbnails }
}

/// Why nothing can be written any more.
fn stuck(fault: &Fault, output: &Path) -> String {
    match fault.cause {
        Cause::Gone => {
            let advice = "bring it back and run again with `--resume`, or run again to begin anew";
            format!("{}: the output folder, or a part of it, is gone; {advice}", output.display())
        }
        _ => format!("{}; make room and run again with `--resume`", fault.sentence),
    }
}
