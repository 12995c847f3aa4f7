//! The text of a log, be it compressed or not, read piece by piece and bounded.

use bzip2::bufread::MultiBzDecoder;
use flate2::bufread::MultiGzDecoder;
use std::io::{self, BufReader, Read};

/// How a log is packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Packing {
    /// Not at all.
    Plain,
    /// With gzip.
    Gzip,
    /// With bzip2.
    Bzip2,
}

impl Packing {
    /// How the document with these first bytes is packed.
    pub fn of(head: &[u8]) -> Self {
        match head {
            [0x1f, 0x8b, ..] => Self::Gzip,
            [b'B', b'Z', b'h', b'1'..=b'9', ..] => Self::Bzip2,
            _ => Self::Plain,
        }
    }

    /// What people should know of it, after the name of what is packed.
    pub fn words(self) -> &'static str {
        match self {
            Self::Plain => "",
            Self::Gzip => ", packed with gzip",
            Self::Bzip2 => ", packed with bzip2",
        }
    }
}

/// The text that these bytes hold. What is packed is unpacked as it is read, and not kept.
pub fn text(bytes: &[u8]) -> BufReader<Box<dyn Read + '_>> {
    let unpacked: Box<dyn Read + '_> = match Packing::of(bytes) {
        Packing::Plain => Box::new(bytes),
        Packing::Gzip => Box::new(MultiGzDecoder::new(bytes)),
        Packing::Bzip2 => Box::new(MultiBzDecoder::new(bytes)),
    };
    BufReader::with_capacity(1 << 16, unpacked)
}

/// The first bytes of the text, at most `most`, as far as they can be unpacked.
pub fn first_bytes(head: &[u8], most: u64) -> Vec<u8> {
    let mut first = vec![];
    // The head of a packed document ends within a block, which is an error after what could be read.
    let _: io::Result<usize> = text(head).take(most).read_to_end(&mut first);
    first
}
