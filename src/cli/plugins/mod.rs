//! `planform plugins`: one file for each of its verbs.

mod info;
mod list;
mod new;

use super::Failure;
use crate::host::Registry;
use clap::{Args, Subcommand};
use planform_sdk::{OptionSpec, PluginInfo};
use serde_json::{Value, json};

const EXAMPLES: &str = "\
Examples:
  planform plugins                  every format that can be read or written
  planform plugins --json           the same for programs
  planform plugins info svg         one plugin and its options
  planform plugins new my-format --kind exporter --lang rust
                                    start a plugin of your own";

/// List what can be read and written, the options of each plugin, and start new ones
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
    New(new::NewArgs),
}

pub fn run(args: &PluginsArgs) -> Result<(), Failure> {
    match &args.verb {
        None => list::run(&args.list),
        Some(Verb::List(args)) => list::run(args),
        Some(Verb::Info(args)) => info::run(args),
        Some(Verb::New(args)) => new::run(args),
    }
}

/// A plugin and what it does: `read` or `write`.
type Listed<'a> = (&'static str, &'a PluginInfo);

fn all(registry: &Registry) -> impl Iterator<Item = Listed<'_>> {
    let adapters = registry.adapters().map(|(a, _)| ("read", a.info()));
    adapters.chain(registry.exporters().map(|(e, _)| ("write", e.info())))
}

/// The plugins, for programs.
fn json_of<'a>(plugins: impl IntoIterator<Item = Listed<'a>>) -> String {
    format!("{:#}\n", plugins.into_iter().map(one_as_json).collect::<Value>())
}

fn one_as_json((kind, info): Listed<'_>) -> Value {
    let option = |o: &OptionSpec| {
        json!({
            "name": o.name, "help": o.help, "takes": o.kind.to_string(),
            "default": o.default.as_ref().map(ToString::to_string),
        })
    };
    json!({
        "name": info.name, "kind": kind, "version": info.version, "licence": info.licence,
        "description": info.description, "extensions": info.extensions, "media_types": info.media_types,
        "options": info.options.iter().map(option).collect::<Vec<_>>(),
    })
}
