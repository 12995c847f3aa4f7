//! The report for programs: one JSON object on each line.

use super::{Row, Unwritten};
use crate::cli::Failure;
use std::io::Write;

/// Writes a line for each row.
pub fn write(out: &mut dyn Write, rows: impl Iterator<Item = Result<Row, Failure>>) -> Result<(), Unwritten> {
    for row in rows {
        writeln!(out, "{}", serde_json::json!(row?.record))?;
    }
    Ok(())
}
