//! `planform plugins`.

use super::{Failure, failure::print};
use crate::host::Registry;
use clap::Args;
use clap::builder::PossibleValuesParser;
use planform_sdk::{OptionSpec, PluginInfo};
use serde_json::{Value, json};

const EXAMPLES: &str = "\
Examples:
  planform plugins            every format that can be read or written
  planform plugins svg        one plugin and its options
  planform plugins --json     the same for programs";

/// List what can be read and written, and the options of each plugin
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct PluginsArgs {
    /// Show this plugin with its options
    #[arg(value_name = "NAME", value_parser = names(), ignore_case = true)]
    name: Option<String>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

/// A plugin and what it does: `read` or `write`.
type Listed<'a> = (&'static str, &'a PluginInfo);

pub fn run(args: &PluginsArgs) -> Result<(), Failure> {
    let registry = Registry::builtin();
    let plugins = chosen(&registry, args.name.as_deref());
    let text = match (args.json, &args.name) {
        (true, _) => format!("{:#}\n", plugins.iter().map(json_of).collect::<Value>()),
        (false, Some(_)) => plugins.iter().map(details).collect(),
        (false, None) => table(&plugins),
    };
    print(text.as_bytes())
}

fn names() -> PossibleValuesParser {
    let registry = Registry::builtin();
    PossibleValuesParser::new(all(&registry).map(|(_, info)| info.name.clone()).collect::<Vec<_>>())
}

fn all(registry: &Registry) -> impl Iterator<Item = Listed<'_>> {
    let adapters = registry.adapters().map(|(a, _)| ("read", a.info()));
    adapters.chain(registry.exporters().map(|(e, _)| ("write", e.info())))
}

/// The plugin of this name, in whatever case, or all.
fn chosen<'a>(registry: &'a Registry, name: Option<&str>) -> Vec<Listed<'a>> {
    all(registry).filter(|(_, info)| name.is_none_or(|n| n.eq_ignore_ascii_case(&info.name))).collect()
}

fn table(plugins: &[Listed<'_>]) -> String {
    let header = ["NAME", "KIND", "VERSION", "EXTENSIONS", "DESCRIPTION"].map(String::from);
    let rows: Vec<_> = std::iter::once(header).chain(plugins.iter().map(row)).collect();
    let widths: Vec<_> = (0..4).map(|i| rows.iter().map(|r| r[i].len()).max().unwrap_or(0)).collect();
    rows.iter().map(|r| line(r, &widths)).collect()
}

fn row((kind, info): &Listed<'_>) -> [String; 5] {
    [&info.name, *kind, &info.version, &info.extensions.join(" "), &info.description].map(String::from)
}

fn line(row: &[String; 5], widths: &[usize]) -> String {
    let cells: String = row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}  ")).collect();
    format!("{cells}{}\n", row[4])
}

fn details((kind, info): &Listed<'_>) -> String {
    let options: String = info.options.iter().map(option).collect();
    let heading = if options.is_empty() { "no options" } else { "options, given as --set NAME=VALUE" };
    format!(
        "{} {} ({kind}s {})\n{}\n\nlicence      {}\nmedia types  {}\n\n{heading}\n{options}",
        info.name,
        info.version,
        info.extensions.join(", "),
        info.description,
        info.licence,
        info.media_types.join(", "),
    )
}

fn option(spec: &OptionSpec) -> String {
    let default = spec.default.as_ref().map(|v| format!("; default {v}")).unwrap_or_default();
    format!("  {}\n      {}\n      {}{default}\n", spec.name, spec.help, spec.kind)
}

fn json_of((kind, info): &Listed<'_>) -> Value {
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
