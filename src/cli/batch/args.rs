//! The command line of `planform batch`.

use super::attendant;
use super::pool::Bounds;
use super::shard::Shard;
use crate::cli::caps::CapArgs;
use crate::cli::input::ReadingArgs;
use crate::cli::memory::{MIB, usual_budget};
use crate::cli::outside::OutsideArgs;
use crate::cli::params::MethodArgs;
use clap::{Args, value_parser};
use std::path::PathBuf;
use std::thread::available_parallelism;
use std::time::Duration;

const EXAMPLES: &str = "\
Examples:
  planform batch plans -o drawings --to dxf
      convert every document in the folder `plans`, and in the folders in it; drawings/a/b.pdf.dxf is from plans/a/b.pdf
  planform batch plans -o drawings --to dxf --resume
      carry on after an end of any kind, and convert what is new or was changed
  planform batch 'maps/**/*.yaml' -o out --to geojson,svg
      the documents that a pattern matches, in two formats
  planform batch --manifest list.csv -o out --to svg
      the documents that a list names, each with its own options and outputs
  planform batch plans -o out --to svg --shard $SLURM_ARRAY_TASK_ID/8
      one of eight shares, for as many machines
  planform batch inbox -o out --to dxf --watch
      convert what is put into the folder `inbox`, until Ctrl-C

A report of all documents, with pictures, is written to planform-batch/report.html in the output folder.

Exit status: 0 all documents are converted, 1 some failed, 2 the command line makes no sense, 130 interrupted.";

/// Convert many documents: those of folders, of a pattern or of a list, side by side, each safe from the others
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct BatchArgs {
    /// Folders, patterns such as 'plans/**/*.pdf', and documents. In folders, files that are no documents are skipped
    #[arg(value_name = "INPUT", required_unless_present = "manifest")]
    pub inputs: Vec<PathBuf>,
    /// Also convert the documents of this list: a CSV file with the columns `input`, `options`, `outputs` and `from`, or a
    /// JSONL file with such objects
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
    /// Write to this folder, which is made if need be. The outputs lie in it as the documents lie in theirs; the output
    /// of `a.png` is called `a.png.svg`
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Write this format: a name that `planform plugins` lists, or an extension; several with commas between them
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', required_unless_present = "manifest")]
    pub to: Vec<String>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    #[command(flatten)]
    pub method: MethodArgs,
    /// Carry on where a former run with this output folder ended, however it did: what is done and unchanged is not done
    /// again
    #[arg(long)]
    pub resume: bool,
    /// With --resume, also try those documents again that failed and would most likely fail again
    #[arg(long, requires = "resume")]
    pub retry_failed: bool,
    /// Overwrite files that are there already and are not from a former run; without --resume, begin anew
    #[arg(long)]
    pub force: bool,
    /// Work on one of several shares only, such as 1/8, 2/8 and so on; every share has a journal and a report of its own
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Only tell what would be done
    #[arg(long, conflicts_with = "watch")]
    pub dry_run: bool,
    /// When all is done, wait for new and changed documents, until Ctrl-C
    #[arg(long)]
    pub watch: bool,
    /// Print what happens as JSON, one event on each line of standard output
    #[arg(long)]
    pub json: bool,
    /// Tell nothing but failures
    #[arg(short, long, conflicts_with = "json")]
    pub quiet: bool,
    #[command(flatten)]
    pub limits: BoundArgs,
    #[command(flatten)]
    pub caps: CapArgs,
    #[command(flatten)]
    pub outside: OutsideArgs,
}

/// What documents may take.
#[derive(Args)]
#[command(next_help_heading = "Limits")]
pub struct BoundArgs {
    /// How many documents are worked on at a time [default: as many as there are cores]
    #[arg(short = 'j', long, value_name = "N", value_parser = value_parser!(u16).range(1..=1024))]
    workers: Option<u16>,
    /// The memory for all documents that are worked on at a time [default: three quarters of what is free]
    #[arg(long, value_name = "MIB", value_parser = value_parser!(u64).range(64..=MAX_MEMORY))]
    memory: Option<u64>,
    /// The most memory for one document
    #[arg(long, value_name = "MIB", default_value_t = 4096, value_parser = value_parser!(u64).range(64..=MAX_MEMORY))]
    document_memory: u64,
    /// The longest that one document may take, in whole seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 600, value_parser = value_parser!(u64).range(1..=MAX_TIME))]
    timeout: u64,
    /// How often a document is tried again that failed for a reason that may pass
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = value_parser!(u32).range(0..=100))]
    retries: u32,
}

/// Eleven days.
const MAX_TIME: u64 = 1_000_000;
/// 16 TiB.
const MAX_MEMORY: u64 = 1 << 24;

impl BoundArgs {
    /// The bounds of this machine and these flags.
    pub fn bounds(&self) -> Bounds {
        let workers = self.workers.map(usize::from);
        Bounds {
            workers: workers.unwrap_or_else(|| available_parallelism().map_or(1, usize::from)),
            memory: self.memory.unwrap_or_else(|| (usual_budget() / MIB).max(attendant::LEAST_MEMORY)),
            document_memory: self.document_memory,
            time: Duration::from_secs(self.timeout),
            retries: self.retries,
        }
    }
}
