//! `planform plugins`: one file for each of its verbs.

mod check;
mod info;
mod list;
mod new;
mod schema;

use super::Failure;
use crate::host::{Origin, Registry};
use clap::{Args, Subcommand};
use planform_sdk::PluginInfo;
use serde_json::{Value, json};

const EXAMPLES: &str = "\
Examples:
  planform plugins                  every format that can be read or written
  planform plugins --json           the same for programs
  planform plugins info svg         one plugin and its options
  planform plugins check my.so      try what every plugin must stand
  planform plugins new my-format --kind exporter --lang rust
                                    start a plugin of your own";

/// List what can be read and written, the options of each plugin, and start and try plugins of your own
#[derive(Args)]
#[command(after_help = EXAMPLES, args_conflicts_with_subcommands = true)]
pub struct PluginsArgs {
    #[command(subcommand)]
    verb: Option<Verb>,
    #[command(flatten)]
    list: list::ListArgs,
}

#[derive(Subcommand)]
enum Verb {
    List(list::ListArgs),
    Info(info::InfoArgs),
    Check(check::CheckArgs),
    New(new::NewArgs),
    Schema(schema::SchemaArgs),
}

pub fn run(args: &PluginsArgs) -> Result<(), Failure> {
    match &args.verb {
        None => list::run(&args.list),
        Some(Verb::List(args)) => list::run(args),
        Some(Verb::Info(args)) => info::run(args),
        Some(Verb::Check(args)) => check::run(args),
        Some(Verb::New(args)) => new::run(args),
        Some(Verb::Schema(args)) => schema::run(args),
    }
}

/// A plugin, what it does (`read` or `write`), and where it comes from.
struct Listed<'a> {
    kind: &'static str,
    info: &'a PluginInfo,
    origin: Origin<'a>,
}

fn all(registry: &Registry) -> impl Iterator<Item = Listed<'_>> {
    let adapters = registry.adapters().map(|(a, origin)| Listed { kind: "read", info: a.info(), origin });
    let exporters = registry.exporters().map(|(e, origin)| Listed { kind: "write", info: e.info(), origin });
    adapters.chain(exporters)
}

impl Listed<'_> {
    /// Where it comes from, in words.
    fn from(&self) -> String {
        match self.origin {
            Origin::BuiltIn => "built in".into(),
            Origin::Library(path) => path.display().to_string(),
        }
    }
}

/// The plugins, for programs.
fn json_of<'a>(plugins: impl IntoIterator<Item = Listed<'a>>) -> String {
    format!("{:#}\n", plugins.into_iter().map(one_as_json).collect::<Value>())
}

fn one_as_json(Listed { kind, info, origin }: Listed<'_>) -> Value {
    let library = match origin {
        Origin::BuiltIn => None,
        Origin::Library(path) => Some(path.display().to_string()),
    };
    json!({
        "name": info.name, "kind": kind, "version": info.version, "licence": info.licence,
        "description": info.description, "extensions": info.extensions, "media_types": info.media_types,
        "options": planform_sdk::schema::of_options(&info.options), "library": library,
    })
}
