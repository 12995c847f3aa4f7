//! A log's lines, one at a time and bounded.

use planform_sdk::{ErrorKind, Place, PluginError};
use std::io::{self, BufRead, Read};

/// The longest line that a log may have, bytes: some 50 000 readings.
const LINE_LIMIT: u64 = 1 << 20;
/// The most text that a log may hold once it is unpacked, bytes.
const TEXT_LIMIT: u64 = 1 << 30;

/// How a line ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// With a line feed.
    Whole,
    /// With the text.
    Text,
}

/// A line.
#[derive(Debug, Clone, Copy)]
pub struct Line<'a> {
    /// Without its end, and without blanks around it.
    pub bytes: &'a [u8],
    /// How it ended.
    pub end: End,
    /// From 1.
    pub number: usize,
}

/// Reads lines.
pub struct Lines<R> {
    reader: R,
    line: Vec<u8>,
    number: usize,
    taken: u64,
    damage: Option<io::Error>,
}

impl<R: BufRead> Lines<R> {
    /// The lines of this text.
    pub fn new(reader: R) -> Self {
        Self { reader, line: vec![], number: 0, taken: 0, damage: None }
    }

    /// The next line; none after the last. Text that cannot be read any further ends there.
    ///
    /// # Errors
    /// When the line, or all of the text, is longer than a log may be.
    pub fn next(&mut self) -> Result<Option<Line<'_>>, PluginError> {
        self.line.clear();
        let read = self.reader.by_ref().take(LINE_LIMIT + 1).read_until(b'\n', &mut self.line);
        self.damage = read.err().or(self.damage.take());
        if self.line.is_empty() {
            return Ok(None);
        }
        self.number += 1;
        self.taken += self.line.len() as u64;
        self.check()?;
        let end = if self.line.last() == Some(&b'\n') { End::Whole } else { End::Text };
        Ok(Some(Line { bytes: self.line.trim_ascii(), end, number: self.number }))
    }

    /// How many lines were read.
    pub fn number(&self) -> usize {
        self.number
    }

    /// Why no more could be read, if it was not the end.
    pub fn damage(&self) -> Option<&io::Error> {
        self.damage.as_ref()
    }

    fn check(&self) -> Result<(), PluginError> {
        if self.line.len() as u64 > LINE_LIMIT {
            let message =
                format!("the line has more than {LINE_LIMIT} bytes, the most that a log's may have");
            return Err(PluginError::new(ErrorKind::Limit, message)
                .at(Place::Line(self.number))
                .advise("this is hardly a laser log"));
        }
        if self.taken > TEXT_LIMIT {
            let message = format!("the log has more than {} MiB of text, unpacked", TEXT_LIMIT >> 20);
            return Err(PluginError::new(ErrorKind::Limit, message)
                .at(Place::Line(self.number))
                .advise("cut it into parts"));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: impl Read) -> (Vec<(String, End)>, bool) {
        let mut lines = Lines::new(io::BufReader::new(text));
        let mut found = vec![];
        while let Some(line) = lines.next().unwrap() {
            found.push((String::from_utf8_lossy(line.bytes).into_owned(), line.end));
        }
        (found, lines.damage().is_some())
    }

    #[test]
    fn the_last_line_may_have_no_end() {
        let expected = [("a".into(), End::Whole), (String::new(), End::Whole), ("b c".into(), End::Text)];
        assert_eq!(all(&b"a\r\n\nb c"[..]), (expected.to_vec(), false));
    }

    #[test]
    fn what_was_read_before_damage_is_kept() {
        struct Broken;
        impl Read for Broken {
            fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
                Err(io::ErrorKind::InvalidData.into())
            }
        }
        let expected = [("a".into(), End::Whole), ("b".into(), End::Text)];
        assert_eq!(all(b"a\nb".chain(Broken)), (expected.to_vec(), true));
    }

    #[test]
    fn lines_are_bounded_and_so_is_the_text() {
        let mut lines = Lines::new(io::BufReader::new(io::repeat(b'x')));
        assert_eq!(lines.next().unwrap_err().kind, ErrorKind::Limit);
        assert_eq!(lines.line.len() as u64, LINE_LIMIT + 1);
        let mut lines = Lines::new(&b"x\nx\n"[..]);
        lines.taken = TEXT_LIMIT - 2;
        assert!(lines.next().is_ok());
        assert_eq!(lines.next().unwrap_err().place, Some(Place::Line(2)));
    }
}
