//! `planform plugins schema`.

use crate::cli::{Failure, failure::print};
use clap::{Args, ValueEnum};
use planform_sdk::schema;

/// Print a JSON Schema: of layouts, of what else a scene holds, or of what plugins say of their options
#[derive(Args)]
#[command(after_help = "Example:\n  planform plugins schema layout > layout.schema.json")]
pub struct SchemaArgs {
    /// Of what
    #[arg(value_name = "WHAT")]
    what: What,
}

/// What crosses to plugins as JSON.
#[derive(Clone, Copy, ValueEnum)]
enum What {
    /// What exporters write
    Layout,
    /// Texts, symbols and all else of a scene but its grid
    Scene,
    /// The options of a plugin
    Options,
}

pub fn run(args: &SchemaArgs) -> Result<(), Failure> {
    let schema = match args.what {
        What::Layout => schema::layout(),
        What::Scene => schema::scene(),
        What::Options => schema::options(),
    };
    print(format!("{schema:#}\n").as_bytes())
}
