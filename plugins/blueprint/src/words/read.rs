//! Has engines read many lines, in several threads, the results in the lines' order.

use super::context;
use super::crop::{Reading, prepared};
use super::engine::{OcrEngine, OcrEngines, OcrError, OcrWord};
use super::lines::Axis;
use super::plausible;
use image::GrayImage;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A line read with this belief is not turned round to see whether it reads better so.
const SURE: f64 = 0.8;
/// An engine needs time to start: one for so many lines.
const PER_ENGINE: usize = 8;
/// The most engines at a time; each takes some 50 MB.
const MOST_ENGINES: usize = 8;

/// What there is to read.
pub struct Job {
    /// Along which side the line runs.
    pub axis: Axis,
    /// Height of its tall letters, pixels of the sheet.
    pub letter: f64,
    /// How much it looks like text.
    pub likeness: f64,
    /// About how many letters it has.
    pub letters: f64,
}

/// What was read.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The words, from left to right as they read.
    pub words: Vec<OcrWord>,
    /// Which way round.
    pub reading: Reading,
    /// How sure it is that these words are written there.
    pub belief: f64,
    /// Width of the picture that the words' boxes are of, pixels.
    pub width: u32,
}

/// Reads all lines, each one way round if that is surely right, otherwise both ways, the usual one first; `picture` cuts
/// one out.
pub fn read(
    jobs: &[Job],
    picture: &(dyn Fn(usize) -> GrayImage + Sync),
    engines: &dyn OcrEngines,
) -> Result<Vec<Vec<Answer>>, OcrError> {
    let answers: Vec<Mutex<Option<Vec<Answer>>>> = jobs.iter().map(|_| Mutex::new(None)).collect();
    let next = AtomicUsize::new(0);
    let work = || -> Result<(), OcrError> {
        let mut engine = engines.open()?;
        while let Some((i, job)) =
            Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|i| Some((i, jobs.get(i)?)))
        {
            let answer = read_line(job, &picture(i), engine.as_mut())?;
            *answers[i].lock().unwrap_or_else(|e| e.into_inner()) = Some(answer);
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..workers(jobs.len())).map(|_| scope.spawn(work)).collect();
        let failed = || OcrError::Failed("read a line");
        workers.into_iter().try_for_each(|w| w.join().unwrap_or_else(|_| Err(failed())))
    })?;
    let answer = |a: Mutex<Option<Vec<Answer>>>| a.into_inner().unwrap_or_else(|e| e.into_inner());
    answers.into_iter().map(|a| answer(a).ok_or(OcrError::Failed("read a line"))).collect()
}

fn workers(jobs: usize) -> usize {
    planform_sdk::parallel::threads().min(MOST_ENGINES).min(jobs.div_ceil(PER_ENGINE))
}

/// Reads one line the usual way round, and if that is not surely right, the other way as well.
fn read_line(job: &Job, picture: &GrayImage, engine: &mut dyn OcrEngine) -> Result<Vec<Answer>, OcrError> {
    let [usual, other] = Reading::both(job.axis);
    let first = attempt(job, picture, usual, engine)?;
    if first.belief >= SURE && !context::may_be_number(&first) {
        return Ok(vec![first]);
    }
    Ok(vec![first, attempt(job, picture, other, engine)?])
}

fn attempt(
    job: &Job,
    picture: &GrayImage,
    way: Reading,
    engine: &mut dyn OcrEngine,
) -> Result<Answer, OcrError> {
    let upright = prepared(picture, way, job.letter);
    let words = engine.read(&upright)?;
    let (kept, _) = plausible::parted(&words);
    let belief = plausible::belief(&kept, job.likeness, job.letters);
    Ok(Answer { words, reading: way, belief, width: upright.width() })
}
