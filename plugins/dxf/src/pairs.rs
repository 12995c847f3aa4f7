//! The lowest layer of a DXF file: pairs of a group code and a value, one line each.

use crate::text::encode;
use crate::version::Version;
use planform_sdk::Point;

/// The number by which other parts of the file name an object; unique, above 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Handle(pub u64);

impl Handle {
    /// No object; the owner of what stands at the top.
    pub const NONE: Self = Self(0);
}

/// A growing file, and the one counter of its handles.
pub struct Pairs {
    bytes: Vec<u8>,
    version: Version,
    last_handle: u64,
}

impl Pairs {
    pub fn new(version: Version) -> Self {
        Self { bytes: Vec::new(), version, last_handle: 0 }
    }

    pub fn version(&self) -> Version {
        self.version
    }

    /// A handle that nothing else has.
    pub fn new_handle(&mut self) -> Handle {
        self.last_handle += 1;
        Handle(self.last_handle)
    }

    /// The handle that would come next.
    pub fn next_handle(&self) -> Handle {
        Handle(self.last_handle + 1)
    }

    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    /// A word of the format. Texts from outside go through [`Pairs::text`].
    pub fn word(&mut self, code: u16, word: &str) {
        debug_assert!(!word.contains(char::is_control), "{word:?}");
        self.bytes.extend_from_slice(format!("{code:>3}\n{word}\n").as_bytes());
    }

    /// A text from outside, of at most `limit` bytes.
    pub fn text(&mut self, code: u16, text: &str, limit: usize) {
        let encoded = encode(text, self.version, limit);
        self.word(code, &encoded);
    }

    pub fn integer(&mut self, code: u16, value: i64) {
        self.word(code, &value.to_string());
    }

    /// A number with as many digits as it takes to read back the very same.
    pub fn real(&mut self, code: u16, value: f64) {
        debug_assert!(value.is_finite(), "group {code}");
        // Adding zero turns -0 into 0.
        let digits = (value + 0.0).to_string();
        let point = if digits.contains('.') { "" } else { ".0" };
        self.word(code, &(digits + point));
    }

    pub fn handle(&mut self, code: u16, handle: Handle) {
        self.word(code, &format!("{:X}", handle.0));
    }

    /// A point of two coordinates: groups `code` and `code` + 10.
    pub fn point_2d(&mut self, code: u16, p: Point) {
        self.real(code, p.x);
        self.real(code + 10, p.y);
    }

    /// A point at height 0: groups `code`, `code` + 10 and `code` + 20.
    pub fn point_3d(&mut self, code: u16, p: Point) {
        self.point_2d(code, p);
        self.real(code + 20, 0.0);
    }

    /// The marker of a subclass, where the version has them.
    pub fn subclass(&mut self, name: &str) {
        if self.version.has_objects() {
            self.word(100, name);
        }
    }

    /// The owner, where the version has owners.
    pub fn owner(&mut self, owner: Handle) {
        if self.version.has_objects() {
            self.handle(330, owner);
        }
    }

    /// A whole section.
    pub fn section(&mut self, name: &str, content: impl FnOnce(&mut Self)) {
        self.word(0, "SECTION");
        self.word(2, name);
        content(self);
        self.word(0, "ENDSEC");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(write: impl FnOnce(&mut Pairs)) -> String {
        let mut pairs = Pairs::new(Version::R2018);
        write(&mut pairs);
        String::from_utf8(pairs.into_bytes()).unwrap()
    }

    #[test]
    fn numbers_keep_every_digit() {
        for v in [1.0, -0.1, 1_000_000.123_456_789, 1e-9, 1e20] {
            let line = written(|p| p.real(40, v));
            let value = line.lines().nth(1).unwrap();
            assert!(value.contains('.'), "{value}");
            assert_eq!(value.parse::<f64>().unwrap(), v);
        }
        assert_eq!(written(|p| p.real(40, -0.0)), " 40\n0.0\n");
    }

    #[test]
    fn a_text_cannot_break_the_pairs() {
        assert_eq!(written(|p| p.text(1, "a\n  0\nEOF", 255)).lines().count(), 2);
    }

    #[test]
    fn handles_are_hexadecimal_and_rise() {
        let mut pairs = Pairs::new(Version::R12);
        let handles: Vec<_> = (0..3).map(|_| pairs.new_handle().0).collect();
        assert_eq!((handles, pairs.next_handle().0), (vec![1, 2, 3], 4));
        assert_eq!(written(|p| p.handle(5, Handle(255))), "  5\nFF\n");
    }
}
