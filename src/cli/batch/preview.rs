//! Tells what a batch would do, and does nothing.

use super::documents::{Listed, Trouble};
use super::jobs::{self, Job, Verdict};
use super::journal::{Journal, Start};
use super::publish::{Places, Unpublished};
use super::tell::events::event;
use super::{Batch, names::text_of};
use crate::cli::Failure;
use crate::cli::failure::{print, safe};
use serde_json::json;

/// What would become of a document.
struct Preview {
    input: String,
    /// `convert`, `again`, `keep`, `skip` or `fail`.
    action: &'static str,
    reason: String,
    outputs: Vec<String>,
}

/// Prints what the batch would do, a line for each document.
pub fn show(batch: &Batch<'_>, json: bool) -> Result<(), Failure> {
    let journal = journal(batch)?;
    let documents = batch.documents()?;
    let jobs = batch.all_jobs(&documents)?;
    let mut jobs = jobs.iter().peekable();
    for document in &documents {
        // Jobs come in the order of the documents, and those that are in trouble have none.
        let job = jobs.next_if(|job| job.name == document.name());
        tell(&preview(document, job, batch, journal.as_ref())?, json)?;
    }
    Ok(())
}

/// The journal that the run would carry on, if there is one.
fn journal(batch: &Batch<'_>) -> Result<Option<Journal>, Failure> {
    if !Journal::is_in(&batch.folder) {
        return Ok(None);
    }
    match batch.start() {
        Start::Anew => Ok(None),
        start => Journal::open(&batch.folder, start).map(Some),
    }
}

fn preview(
    document: &Listed,
    job: Option<&Job>,
    batch: &Batch<'_>,
    journal: Option<&Journal>,
) -> Result<Preview, Failure> {
    let preview = |action, reason: &str, outputs| Preview {
        input: text_of(&document.input),
        action,
        reason: reason.into(),
        outputs,
    };
    let Some(job) = job else {
        return Ok(match &document.trouble {
            Some(Trouble::Broken(reason)) => preview("fail", reason, vec![]),
            Some(Trouble::LeftOut(reason)) => preview("skip", reason, vec![]),
            None => preview("skip", "", vec![]),
        });
    };
    let outputs: Vec<_> = job.places.iter().map(|p| text_of(p)).collect();
    let places = Places { output: &batch.args.output, force: batch.args.force };
    let verdict = journal.map(|j| jobs::verdict(job, j, &places, batch.args.retry_failed)).transpose()?;
    if let Some(Verdict::Settled(entry)) = &verdict {
        return Ok(preview("keep", &format!("it is {}", entry.record.state.name()), outputs));
    }
    for place in &job.places {
        match places.check(place, journal) {
            Ok(_) => {}
            Err(Unpublished::Fault(fault)) => return Ok(preview("fail", &fault.sentence, outputs)),
            Err(Unpublished::Journal(failure)) => return Err(failure),
        }
    }
    Ok(match verdict {
        Some(Verdict::Again(reason)) => preview("again", &reason, outputs),
        _ => preview("convert", "", outputs),
    })
}

fn tell(preview: &Preview, json: bool) -> Result<(), Failure> {
    let Preview { input, action, reason, outputs } = preview;
    if json {
        event("would", json!({ "input": input, "action": action, "reason": reason, "outputs": outputs }));
        return Ok(());
    }
    let arrow = if outputs.is_empty() { String::new() } else { format!(" -> {}", outputs.join(", ")) };
    let reason = if reason.is_empty() { String::new() } else { format!(" ({reason})") };
    print(format!("{}\n", safe(&format!("{action:<7} {input}{arrow}{reason}"))).as_bytes())
}
