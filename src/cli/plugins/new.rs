//! `planform plugins new`: starts a plugin of the user's own.

mod name;
mod next;
mod place;
mod sdk;
mod templates;

use crate::cli::{Failure, failure::print};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  planform plugins new my-plan --kind input --lang rust         reads a format
  planform plugins new my-table --kind exporter --lang c        writes one";

/// Start a plugin of your own: a small project that works right away, to be changed into what you need
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct NewArgs {
    /// Its name, and at first the extension of its files: lower-case letters, digits and hyphens
    #[arg(value_name = "NAME")]
    name: String,
    /// Whether it reads documents or writes layouts
    #[arg(long)]
    kind: Kind,
    /// The language it is written in
    #[arg(long)]
    lang: Language,
    /// The folder to put it in, new or empty; by default one of its name
    #[arg(long, value_name = "DIR")]
    dir: Option<PathBuf>,
}

/// What a plugin does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Kind {
    /// Reads documents
    Input,
    /// Writes layouts
    Exporter,
}

/// What a plugin is written in.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Language {
    /// With the crate planform-sdk, to be built with cargo
    Rust,
    /// With the header planform.h, to be built with make
    C,
}

/// A file of the project: its path and what it holds.
type File = (String, String);

pub fn run(args: &NewArgs) -> Result<(), Failure> {
    name::check(&args.name)?;
    let folder = args.dir.clone().unwrap_or_else(|| PathBuf::from(&args.name));
    let mut files = templates::files(args.kind, args.lang, &args.name);
    if args.lang == Language::Rust {
        files.extend(sdk::files().map_err(|e| Failure::over("planform-sdk", e))?);
    }
    place::write(&folder, &files)?;
    print(next::steps(args, &folder).as_bytes())
}
