//! `planform plugins list`, which `planform plugins` is short for.

use super::{Listed, all, json_of};
use crate::cli::Failure;
use crate::cli::failure::{print, say};
use crate::cli::outside::{OutsideArgs, tell_refusals};
use crate::cli::progress::Voice;
use clap::Args;

/// List every format that can be read or written
#[derive(Args)]
#[command(after_help = "Example:\n  planform plugins list --json")]
pub struct ListArgs {
    /// Print as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    outside: OutsideArgs,
}

pub fn run(args: &ListArgs) -> Result<(), Failure> {
    let registry = args.outside.registry(false)?;
    let text = if args.json { json_of(all(&registry)) } else { table(all(&registry)) };
    print(text.as_bytes())?;
    registry.outside().shadowed.iter().for_each(|shadowed| say(&format!("note: {shadowed}")));
    tell_refusals(&registry, Voice::Normal);
    Ok(())
}

const COLUMNS: usize = 6;

fn table<'a>(plugins: impl Iterator<Item = Listed<'a>>) -> String {
    let header = ["NAME", "KIND", "VERSION", "EXTENSIONS", "FROM", "DESCRIPTION"].map(String::from);
    let rows: Vec<_> = std::iter::once(header).chain(plugins.map(row)).collect();
    let widths: Vec<_> =
        (0..COLUMNS - 1).map(|i| rows.iter().map(|r| r[i].len()).max().unwrap_or(0)).collect();
    rows.iter().map(|r| line(r, &widths)).collect()
}

fn row(listed: Listed<'_>) -> [String; COLUMNS] {
    let Listed { kind, info, origin: _ } = listed;
    let (extensions, from) = (info.extensions.join(" "), listed.from());
    [&info.name, kind, &info.version, &extensions, &from, &info.description].map(String::from)
}

fn line(row: &[String; COLUMNS], widths: &[usize]) -> String {
    let cells: String = row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}  ")).collect();
    format!("{cells}{}\n", row[COLUMNS - 1])
}
