//! `planform batch`: many documents, each in a process of its own.
//!
//! The way of one batch: `documents` finds what there is, `jobs` says what is to become of it and asks the `journal` what
//! is done already, `pass` has the `pool` work on the rest, publishes what came of it and notes it, and `report` tells it
//! all. What runs in a document's own process is in `worker`.

mod args;
mod attendant;
mod digest;
mod documents;
mod estimate;
mod formats;
mod interrupt;
mod jobs;
mod journal;
mod names;
mod pass;
mod pool;
mod preview;
mod publish;
mod record;
mod report;
mod retry;
mod shard;
mod task;
mod tell;
mod thumbnail;
mod watch;
mod worker;

pub use args::BatchArgs;
pub use task::{Outside, VERB};
pub use worker::serve;

use super::Failure;
use super::failure::say;
use super::input::culprit;
use crate::host::Registry;
use documents::{Listed, Sources};
use formats::Format;
use interrupt::Interrupt;
use jobs::{Common, Job};
use journal::{Journal, Start};
use pass::{Halt, Pass};
use planform_sdk::{PluginInfo, Source};
use publish::Places;
use report::{Report, Totals};
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use task::How;
use tell::{Manner, Teller};
use watch::Handled;

/// The folder in the output folder that holds what is no output.
const FOLDER: &str = "planform-batch";

pub fn run(args: &BatchArgs) -> Result<(), Failure> {
    let registry = args.outside.registry(false)?;
    let batch = Batch::plan(args, &registry)?;
    if args.dry_run {
        return preview::show(&batch, args.json);
    }
    let documents = batch.documents()?;
    if documents.is_empty() && !args.watch && args.shard.is_none() {
        let input = args.inputs.first().or(args.manifest.as_ref()).cloned().unwrap_or_default();
        return Err(Failure::over(&input, "there are no files in it"));
    }
    // What makes no sense is refused before anything is written.
    batch.all_jobs(&documents)?;
    let interrupt = Interrupt::listen();
    let mut journal = Journal::open(&batch.folder, batch.start())?;
    let mut teller = tell::teller(Manner { json: args.json, quiet: args.quiet });
    let (documents, halt) = batch.work(documents, &mut journal, teller.as_mut(), &interrupt)?;
    batch.end(&documents, &journal, halt)
}

/// What there is when documents have come.
struct Arrivals {
    /// All documents.
    all: Vec<Listed>,
    /// Those that are new or changed.
    fresh: Vec<Listed>,
}

/// All that is said of a batch before it begins.
struct Batch<'a> {
    args: &'a BatchArgs,
    registry: &'a Registry,
    formats: Vec<Format>,
    how: How,
    /// Where the journal and the reports are.
    folder: PathBuf,
}

impl<'a> Batch<'a> {
    fn plan(args: &'a BatchArgs, registry: &'a Registry) -> Result<Self, Failure> {
        let formats = formats::named(&args.to, registry)?;
        let mut params = args.method.params()?;
        args.caps.limit(&mut params)?;
        let how = How {
            from: args.reading.from.clone(),
            settings: args.reading.settings(),
            own_settings: vec![],
            params,
            caps: args.caps.caps(),
            outside: args.outside.task(),
        };
        check_adapter(&how, registry)?;
        check_settings(&how, &formats, registry)?;
        let folder = args.output.join(FOLDER);
        let folder = args.shard.map_or_else(|| folder.clone(), |shard| folder.join(shard.folder()));
        Ok(Self { args, registry, formats, how, folder })
    }

    fn start(&self) -> Start {
        match (self.args.resume, self.args.force) {
            (true, _) => Start::Resume,
            (false, true) => Start::Anew,
            (false, false) => Start::New,
        }
    }

    fn documents(&self) -> Result<Vec<Listed>, Failure> {
        let args = self.args;
        let sources = Sources {
            inputs: &args.inputs,
            manifest: args.manifest.as_deref(),
            output: &args.output,
            patient: args.watch,
        };
        let mut documents = documents::find(&sources, self.registry)?;
        documents.retain(|d| args.shard.is_none_or(|shard| shard.takes(&d.name())));
        Ok(documents)
    }

    /// The jobs of those documents that are fresh, checked against those of all.
    fn jobs(&self, documents: &[Listed], fresh: &[Listed]) -> Result<Vec<Job>, Failure> {
        let fresh: HashSet<_> = fresh.iter().map(Listed::name).collect();
        let all = self.all_jobs(documents)?;
        Ok(all.into_iter().filter(|job| fresh.contains(&job.name)).collect())
    }

    fn all_jobs(&self, documents: &[Listed]) -> Result<Vec<Job>, Failure> {
        let (output, formats, how, registry) = (&self.args.output, &self.formats, &self.how, self.registry);
        let sound: Vec<_> = documents.iter().filter(|d| d.trouble.is_none()).cloned().collect();
        if let Some(d) = sound.iter().find(|d| d.row.outputs.is_empty() && formats.is_empty()) {
            let message = "the list names no outputs for it; `--to FORMAT` says which to write";
            return Err(Failure::Usage(format!("{}: {message}", d.input.display())));
        }
        jobs::of(&sound, &Common { output, formats, how, registry })
    }

    /// Works on all documents, and on those that come if that is asked for. All documents that there are in the end.
    fn work(
        &self,
        mut documents: Vec<Listed>,
        journal: &mut Journal,
        teller: &mut dyn Teller,
        interrupt: &Interrupt,
    ) -> Result<(Vec<Listed>, Option<Halt>), Failure> {
        let staging = self.staging()?;
        let mut handled = Handled::default();
        let mut fresh = documents.clone();
        loop {
            handled.add(&fresh);
            let mut pass = self.pass(&staging, journal, teller, interrupt);
            let halt = pass.run(&fresh, self.jobs(&documents, &fresh)?)?;
            if halt.is_some() || !self.args.watch {
                // Outputs that were not published are of no use.
                let _ = fs::remove_dir_all(&staging);
                return Ok((documents, halt));
            }
            self.report(&documents, journal).write(&self.folder)?;
            self.say("waiting for documents; Ctrl-C ends it");
            match self.wait(&mut handled, interrupt)? {
                Some(arrivals) => Arrivals { all: documents, fresh } = arrivals,
                None => return Ok((documents, Some(Halt::Interrupted))),
            }
        }
    }

    fn pass<'b>(
        &'b self,
        staging: &'b Path,
        journal: &'b mut Journal,
        teller: &'b mut dyn Teller,
        interrupt: &'b Interrupt,
    ) -> Pass<'b> {
        let Self { args, .. } = self;
        let places = Places { output: &args.output, force: args.force };
        let (bounds, retry_failed) = (args.limits.bounds(), args.retry_failed);
        Pass { journal, places, staging, bounds, retry_failed, teller, interrupt }
    }

    /// Waits for documents that were not handled as they are now. None if the user wants to stop.
    fn wait(&self, handled: &mut Handled, interrupt: &Interrupt) -> Result<Option<Arrivals>, Failure> {
        loop {
            watch::wait(interrupt);
            if interrupt.is_set() {
                return Ok(None);
            }
            let documents = self.documents()?;
            let fresh = handled.fresh(&documents);
            if !fresh.is_empty() {
                return Ok(Some(Arrivals { all: documents, fresh }));
            }
        }
    }

    /// An empty folder for outputs that are not in their places yet. It is in the output folder, so that they need only be
    /// renamed.
    fn staging(&self) -> Result<PathBuf, Failure> {
        let staging = self.folder.join("staging");
        match fs::remove_dir_all(&staging) {
            Err(e) if e.kind() != std::io::ErrorKind::NotFound => return Err(Failure::of_io(&staging, e)),
            _ => {}
        }
        fs::create_dir(&staging).map_err(|e| Failure::of_io(&staging, e))?;
        Ok(staging)
    }

    fn report<'b>(&self, documents: &'b [Listed], journal: &'b Journal) -> Report<'b> {
        Report { documents, journal }
    }

    /// Writes the reports and says how it went.
    fn end(&self, documents: &[Listed], journal: &Journal, halt: Option<Halt>) -> Result<(), Failure> {
        let report = self.report(documents, journal);
        let written = report.write(&self.folder);
        let totals = report.totals()?;
        match halt {
            // The reports may be stuck for the same reason, and this is the sentence that helps.
            Some(Halt::Stuck(failure)) => Err(failure),
            Some(Halt::Interrupted) => {
                Err(Failure::Interrupted(format!("interrupted; {}; `--resume` carries on", totals.words())))
            }
            None => self.end_well(&totals, &written?),
        }
    }

    fn end_well(&self, totals: &Totals, page: &Path) -> Result<(), Failure> {
        if self.args.json {
            let values = serde_json::json!({ "totals": totals, "report": names::text_of(page) });
            tell::events::event("summary", values);
        }
        self.say(&format!("{}; the report is {}", totals.words(), page.display()));
        match totals.failed {
            0 => Ok(()),
            n => {
                let of = totals.documents;
                Err(Failure::Failed(format!("{n} of {of} files failed; {} says why", page.display())))
            }
        }
    }

    fn say(&self, line: &str) {
        if !self.args.json && !self.args.quiet {
            say(line);
        }
    }
}

/// Fails if there is no adapter of the name that is given.
fn check_adapter(how: &How, registry: &Registry) -> Result<(), Failure> {
    let empty = Source { path: PathBuf::new(), bytes: vec![], byte_limit: 0 };
    let named = how.from.as_deref().map(|name| registry.choose(&empty, Some(name), &[]));
    named.transpose().map(drop).map_err(|e| Failure::Usage(format!("--from: {e}")))
}

/// Fails if one of the settings is for no plugin that may take part, or for none in this way.
fn check_settings(how: &How, formats: &[Format], registry: &Registry) -> Result<(), Failure> {
    let exporters: Vec<_> =
        formats.iter().filter_map(|f| registry.exporter(&f.exporter)).map(|e| e.info()).collect();
    let builtin = || registry.builtin_adapters().map(|a| a.info());
    for setting in &how.settings {
        let setting = std::slice::from_ref(setting);
        let fits = |plugin: &PluginInfo| culprit(setting, &[plugin]).is_none();
        if builtin().chain(exporters.iter().copied()).any(fits)
            || registry.adapters().any(|(a, _)| fits(a.info()))
        {
            continue;
        }
        let plugins: Vec<_> = builtin().chain(exporters.iter().copied()).collect();
        return culprit(setting, &plugins).map_or(Ok(()), |sentence| Err(Failure::Usage(sentence)));
    }
    Ok(())
}
