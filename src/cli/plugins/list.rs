//! `planform plugins list`, which `planform plugins` is short for.

use super::{Listed, all, json_of};
use crate::cli::{Failure, failure::print};
use crate::host::Registry;
use clap::Args;

/// List every format that can be read or written
#[derive(Args)]
#[command(after_help = "Example:\n  planform plugins list --json")]
pub struct ListArgs {
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &ListArgs) -> Result<(), Failure> {
    let registry = Registry::builtin();
    let text = if args.json { json_of(all(&registry)) } else { table(all(&registry)) };
    print(text.as_bytes())
}

fn table<'a>(plugins: impl Iterator<Item = Listed<'a>>) -> String {
    let header = ["NAME", "KIND", "VERSION", "EXTENSIONS", "DESCRIPTION"].map(String::from);
    let rows: Vec<_> = std::iter::once(header).chain(plugins.map(row)).collect();
    let widths: Vec<_> = (0..4).map(|i| rows.iter().map(|r| r[i].len()).max().unwrap_or(0)).collect();
    rows.iter().map(|r| line(r, &widths)).collect()
}

fn row((kind, info): Listed<'_>) -> [String; 5] {
    [&info.name, kind, &info.version, &info.extensions.join(" "), &info.description].map(String::from)
}

fn line(row: &[String; 5], widths: &[usize]) -> String {
    let cells: String = row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}  ")).collect();
    format!("{cells}{}\n", row[4])
}
