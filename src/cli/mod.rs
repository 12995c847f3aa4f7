//! The program `planform`: one file for each verb.

mod batch;
mod caps;
mod completions;
mod convert;
mod evaluate;
mod failure;
mod input;
mod inspect;
mod man;
mod memory;
mod output;
mod outside;
mod params;
mod passing;
mod picture;
mod plugins;
mod progress;
mod watch;

pub use failure::Failure;

use crate::host::isolated;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  planform convert map.yaml -o rooms.svg              draw the rooms of a robot's map
  planform convert map.yaml -o a.dxf -o a.geojson     two formats at once
  planform batch plans -o drawings --to dxf           all documents of a folder
  planform inspect map.yaml                           what is in this file?
  planform plugins                                    what can be read and written?

Exit status: 0 done, 1 failed, 2 the command line makes no sense.";

/// Finds the rooms, walls and doors of a building in a document that shows it, such as the map that a robot made,
/// and writes them as a drawing or as data.
#[derive(Parser)]
#[command(name = "planform", version, after_help = EXAMPLES, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    Convert(convert::ConvertArgs),
    Batch(Box<batch::BatchArgs>),
    Inspect(inspect::InspectArgs),
    Evaluate(evaluate::EvaluateArgs),
    Plugins(plugins::PluginsArgs),
    Params(params::ParamsArgs),
    Completions(completions::CompletionsArgs),
    Man(man::ManArgs),
}

impl Verb {
    fn run(&self) -> Result<(), Failure> {
        match self {
            Self::Convert(args) => convert::run(args),
            Self::Batch(args) => batch::run(args),
            Self::Inspect(args) => inspect::run(args),
            Self::Evaluate(args) => evaluate::run(args),
            Self::Plugins(args) => plugins::run(args),
            Self::Params(args) => params::run(args),
            Self::Completions(args) => completions::run(args),
            Self::Man(args) => man::run(args),
        }
    }
}

/// Runs the program with these arguments, the first being its own name.
pub fn main(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    let args: Vec<_> = args.into_iter().collect();
    if let Some(code) = plugin_process(&args).or_else(|| batch_process(&args)) {
        return code;
    }
    match Cli::try_parse_from(&args) {
        Ok(cli) => {
            failure::catch_bugs(&args, || cli.verb.run()).map_or_else(Failure::report, |()| ExitCode::SUCCESS)
        }
        Err(e) => {
            let code = ExitCode::from(e.exit_code() as u8);
            print_help(&e).map_or_else(Failure::report, |()| code)
        }
    }
}

/// Serves a plugin library to another run of the program, if that is what the arguments ask for.
fn plugin_process(args: &[OsString]) -> Option<ExitCode> {
    let [_, verb, library, memory] = args else { return None };
    let memory = memory.to_str()?.parse().ok()?;
    let served = (verb == isolated::VERB).then(|| isolated::serve(Path::new(library), memory))?;
    Some(served.map_or_else(|e| Failure::of_io(library, e).report(), |()| ExitCode::SUCCESS))
}

/// Works on one document for another run of the program, if that is what the arguments ask for.
fn batch_process(args: &[OsString]) -> Option<ExitCode> {
    let [_, verb] = args else { return None };
    let served = (verb == batch::VERB).then(batch::serve)?;
    Some(served.map_or_else(|e| Failure::of_io("standard input", e).report(), |()| ExitCode::SUCCESS))
}

/// Prints help, or what is wrong with the command line.
fn print_help(e: &clap::Error) -> Result<(), Failure> {
    let printed = e.print().and_then(|()| std::io::stdout().flush());
    match printed {
        // Nobody is left to be told when standard error is closed.
        Err(_) if e.use_stderr() => Ok(()),
        Err(e) if e.kind() == std::io::ErrorKind::BrokenPipe => Err(Failure::ReaderGone),
        printed => printed.map_err(|e| Failure::of_io("standard output", e)),
    }
}

/// The whole command line, for what is made from it.
fn command() -> clap::Command {
    Cli::command()
}
