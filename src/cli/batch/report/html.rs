//! The report for people: one page that needs no other file and no network.

use super::{Row, Unwritten};
use crate::cli::Failure;
use std::io::Write;

/// The page around the rows, which come in the place of [`ROWS`].
const PAGE: &str = include_str!("page.html");

const ROWS: &str = "/*ROWS*/";

/// Writes the page.
pub fn write(out: &mut dyn Write, rows: impl Iterator<Item = Result<Row, Failure>>) -> Result<(), Unwritten> {
    let (before, after) = PAGE.split_once(ROWS).unwrap_or((PAGE, ""));
    out.write_all(before.as_bytes())?;
    out.write_all(b"[")?;
    for (i, row) in rows.enumerate() {
        let comma = if i == 0 { "\n" } else { ",\n" };
        write!(out, "{comma}{}", harmless(&json(&row?)))?;
    }
    out.write_all(b"\n]")?;
    Ok(out.write_all(after.as_bytes())?)
}

fn json(row: &Row) -> String {
    let mut object = serde_json::json!(row.record);
    object["before"] = row.thumbnails.before.clone().into();
    object["after"] = row.thumbnails.after.clone().into();
    object.to_string()
}

/// JSON within which no browser finds the end of the script that it stands in.
fn harmless(json: &str) -> String {
    json.replace('<', "\\u003c")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::batch::record::Record;
    use crate::cli::batch::task::Thumbnails;

    #[test]
    fn what_a_document_says_stays_a_text() {
        let record = Record::open("a", "</script><script>alert(1)</script>");
        let row = Row { record, thumbnails: Thumbnails::default() };
        let mut out = vec![];
        assert!(write(&mut out, std::iter::once(Ok(row))).is_ok());
        let page = String::from_utf8(out).unwrap();
        assert!(
            !page.contains("</script><script>alert") && page.contains("\\u003c/script>\\u003cscript>alert")
        );
        assert!(!page.contains(ROWS));
        // Nothing is loaded from elsewhere, and no text becomes markup.
        assert!(!page.contains("//www") && !page.contains("http:") && !page.contains("https:"));
        assert!(!page.contains("innerHTML") && page.contains("Content-Security-Policy"));
    }
}
