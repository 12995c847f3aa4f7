//! The report for spreadsheets.

use super::{Row, Unwritten};
use crate::cli::Failure;
use std::io::{self, Write};

const HEAD: [&str; 16] = [
    "name",
    "input",
    "state",
    "reason",
    "adapter",
    "rooms",
    "partial_rooms",
    "area_m2",
    "walls",
    "doors",
    "passages",
    "warnings",
    "seconds",
    "memory_mib",
    "attempts",
    "outputs",
];

/// Writes a line for each row, after one with the columns' names.
pub fn write(out: &mut dyn Write, rows: impl Iterator<Item = Result<Row, Failure>>) -> Result<(), Unwritten> {
    let mut table = ::csv::Writer::from_writer(out);
    table.write_record(HEAD).map_err(io_error)?;
    for row in rows {
        table.write_record(fields(&row?)).map_err(io_error)?;
    }
    Ok(table.flush()?)
}

fn fields(row: &Row) -> [String; 16] {
    let record = &row.record;
    let found = &record.found;
    let outputs: Vec<_> = record.outputs.iter().map(|o| o.path.as_str()).collect();
    [
        plain(&record.name),
        plain(&record.input),
        record.state.name().into(),
        plain(record.reason.as_deref().unwrap_or_default()),
        plain(&found.adapter),
        found.rooms.to_string(),
        found.partial_rooms.to_string(),
        format!("{:.2}", found.area),
        found.walls.to_string(),
        found.doors.to_string(),
        found.passages.to_string(),
        plain(&found.warnings.join("; ")),
        format!("{:.2}", record.seconds),
        record.memory_mib.to_string(),
        record.attempts.to_string(),
        plain(&outputs.join("; ")),
    ]
}

/// A text that no spreadsheet takes for a formula.
fn plain(text: &str) -> String {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r']) { format!("'{text}") } else { text.into() }
}

fn io_error(error: ::csv::Error) -> Unwritten {
    Unwritten::Io(match error.into_kind() {
        ::csv::ErrorKind::Io(e) => e,
        _ => io::ErrorKind::InvalidData.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::batch::record::Record;
    use crate::cli::batch::task::Thumbnails;

    #[test]
    fn rows_are_what_spreadsheets_read() {
        let record = Record::open("a,b.png", "=cmd|' /C calc'!A0").skipped("says \"no\"\nand more".into());
        let row = Row { record, thumbnails: Thumbnails::default() };
        let mut out = vec![];
        assert!(write(&mut out, std::iter::once(Ok(row))).is_ok());
        let mut read = ::csv::Reader::from_reader(out.as_slice());
        assert_eq!(read.headers().unwrap().len(), HEAD.len());
        let row = read.records().next().unwrap().unwrap();
        assert_eq!((&row[0], &row[1], &row[2]), ("a,b.png", "'=cmd|' /C calc'!A0", "skipped"));
        assert_eq!(&row[3], "says \"no\"\nand more");
    }
}
