//! `planform plugins info`.

use super::{Listed, all, json_of};
use crate::cli::outside::OutsideArgs;
use crate::cli::{Failure, failure::print};
use crate::host::Registry;
use clap::Args;
use planform_sdk::OptionSpec;

/// Show one plugin with its options
#[derive(Args)]
#[command(after_help = "Example:\n  planform plugins info svg")]
pub struct InfoArgs {
    /// The plugin
    #[arg(value_name = "NAME")]
    name: String,
    /// Print as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    outside: OutsideArgs,
}

pub fn run(args: &InfoArgs) -> Result<(), Failure> {
    let registry = args.outside.registry(false)?;
    let chosen: Vec<_> = all(&registry).filter(|l| args.name.eq_ignore_ascii_case(&l.info.name)).collect();
    if chosen.is_empty() {
        return Err(no_such(&args.name, &registry));
    }
    let text = if args.json { json_of(chosen) } else { chosen.into_iter().map(details).collect() };
    print(text.as_bytes())
}

fn no_such(name: &str, registry: &Registry) -> Failure {
    let mut names: Vec<_> = all(registry).map(|l| l.info.name.as_str()).collect();
    names.dedup();
    let names = names.join(", ");
    Failure::Usage(format!("there is no plugin `{name}`; there are {names}{}", registry.refused()))
}

fn details(listed: Listed<'_>) -> String {
    let (Listed { kind, info, origin: _ }, from) = (&listed, listed.from());
    let options: String = info.options.iter().map(option).collect();
    let heading = if options.is_empty() { "no options" } else { "options, given as --set NAME=VALUE" };
    format!(
        "{} {} ({kind}s {})\n{}\n\nfrom         {from}\nlicence      {}\nmedia types  {}\n\n{heading}\n{options}",
        info.name,
        info.version,
        info.extensions.join(", "),
        info.description,
        info.licence,
        if info.media_types.is_empty() { "none".into() } else { info.media_types.join(", ") },
    )
}

fn option(spec: &OptionSpec) -> String {
    let default = spec.default.as_ref().map(|v| format!("; default {v}")).unwrap_or_default();
    format!("  {}\n      {}\n      {}{default}\n", spec.name, spec.help, spec.kind)
}
