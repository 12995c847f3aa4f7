//! `planform plugins info`.

use super::{Listed, all, json_of};
use crate::cli::{Failure, failure::print};
use crate::host::Registry;
use clap::Args;
use clap::builder::PossibleValuesParser;
use planform_sdk::OptionSpec;

/// Show one plugin with its options
#[derive(Args)]
#[command(after_help = "Example:\n  planform plugins info svg")]
pub struct InfoArgs {
    /// The plugin
    #[arg(value_name = "NAME", value_parser = names(), ignore_case = true)]
    name: String,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &InfoArgs) -> Result<(), Failure> {
    let registry = Registry::builtin();
    let chosen = all(&registry).filter(|(_, info)| args.name.eq_ignore_ascii_case(&info.name));
    let text = if args.json { json_of(chosen) } else { chosen.map(details).collect() };
    print(text.as_bytes())
}

fn names() -> PossibleValuesParser {
    let registry = Registry::builtin();
    PossibleValuesParser::new(all(&registry).map(|(_, info)| info.name.clone()).collect::<Vec<_>>())
}

fn details((kind, info): Listed<'_>) -> String {
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
