//! `planform plugins check`.

use crate::cli::failure::{print, safe, shown};
use crate::cli::{Failure, outside};
use crate::host::conformance::{Finding, Outcome, try_library};
use clap::Args;
use planform_sdk::Source;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  planform plugins check libmy_format.so
      try an exporter
  planform plugins check my-plan.so --sample flat.my-plan
      try an input adapter, with a document that it reads";

/// Try what every plugin must stand: garbage, documents that are cut short or lie, wrong options, a full disk, several
/// threads
///
/// Each check runs in a process of its own. The exit status is 1 if any of them fails.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct CheckArgs {
    /// The plugin's library
    #[arg(value_name = "FILE")]
    library: PathBuf,
    /// A document that the library's input adapter reads; checks that damage it are left out without one
    #[arg(long, value_name = "FILE")]
    sample: Option<PathBuf>,
    /// Show what the plugin prints, and what is tried at the time
    #[arg(short, long)]
    verbose: bool,
    #[command(flatten)]
    limits: outside::LimitArgs,
}

pub fn run(args: &CheckArgs) -> Result<(), Failure> {
    let library = shown(&args.library);
    let open = |path: &PathBuf| {
        Source::open(path, Source::BYTE_LIMIT).map_err(|e| Failure::of_plugin(shown(path), e))
    };
    let sample = args.sample.as_ref().map(open).transpose()?;
    let mut told = Ok(());
    let findings =
        try_library(&args.library, sample.as_ref(), &args.limits.limits(args.verbose), |finding| {
            if told.is_ok() {
                told = print(line(finding).as_bytes());
            }
        });
    let findings = findings.map_err(|reason| Failure::over(&args.library, reason))?;
    told?;
    let failed = findings.iter().filter(|f| matches!(f.outcome, Outcome::Failed(_))).count();
    if failed > 0 {
        return Err(Failure::Failed(format!("{library}: {failed} of {} checks failed", findings.len())));
    }
    Ok(())
}

/// Faults may quote what steers a terminal.
fn line(finding: &Finding) -> String {
    match &finding.outcome {
        Outcome::Passed => format!("ok       it {}\n", finding.title),
        Outcome::Failed(fault) => {
            format!("FAILED   it {}\n         {}\n", finding.title, safe(fault))
        }
        Outcome::NotRun(reason) => format!("not run  it {}: {reason}\n", finding.title),
    }
}
