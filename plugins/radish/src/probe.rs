//! How sure the adapter is of a document.

use crate::log;
use crate::picture;
use crate::unpack::{Packing, first_bytes};
use planform_sdk::{Confidence, Probe};

/// How much of a packed text is looked at, bytes.
const HEAD: u64 = 1 << 16;

/// A log is known by its messages, whatever its name. Of a bzip2 document nothing can be read before all of its first
/// block is there, so that its name must do.
pub fn probe(probe: &Probe<'_>) -> Confidence {
    let packing = Packing::of(probe.head);
    let text = first_bytes(probe.head, HEAD);
    if log::is_log(&text) {
        return Confidence::because(95, format!("a CARMEN log by its first messages{}", packing.words()));
    }
    if picture::is_picture(probe.head) {
        return picture::probe(probe);
    }
    let named = named_as_log(probe);
    match packing {
        Packing::Bzip2 if text.is_empty() && named => {
            Confidence::because(60, "a bzip2 file that is named like a log")
        }
        Packing::Bzip2 if text.is_empty() => Confidence::because(20, "a bzip2 file, which may hold a log"),
        _ if named => Confidence::because(5, "a log by its name, but without the messages of a CARMEN log"),
        _ => Confidence::no(),
    }
}

fn named_as_log(probe: &Probe<'_>) -> bool {
    let name = probe.path.file_name().map(|n| n.to_string_lossy().to_lowercase()).unwrap_or_default();
    let stem = [".gz", ".bz2"].iter().find_map(|end| name.strip_suffix(end)).unwrap_or(&name);
    [".log", ".clf", ".gfs"].iter().any(|end| stem.ends_with(end))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn percent(path: &str, head: &[u8]) -> u8 {
        probe(&Probe { path: Path::new(path), head }).percent
    }

    #[test]
    fn logs_are_known_by_their_messages() {
        let sweep = format!("FLASER 361 {}", "1.25 ".repeat(2000));
        for head in [
            "FLASER 1 2 0 0 0 0 0 0 0 h 0\n",
            "# CARMEN Logfile\n# file format\nmessage_name [message contents]\nPARAM robot_width 0.5 0 h 0\n",
            "ODOM 0 0 0 0 0 0 0 h 0\nUNHEARD of\n",
            &sweep[..4096],
        ] {
            assert_eq!(percent("", head.as_bytes()), 95, "{head}");
            assert_eq!(percent("map.png", head.as_bytes()), 95, "{head}");
        }
    }

    #[test]
    fn other_documents_are_left_to_others() {
        for head in [
            "",
            "image: map.pgm\nresolution: 0.05\n",
            "# only a comment\n",
            "FLASER\n",
            "hello\nworld\nODOM\n",
        ] {
            assert_eq!(percent("", head.as_bytes()), 0, "{head}");
            assert_eq!(percent("a.LOG", head.as_bytes()), 5, "{head}");
        }
        assert_eq!(percent("", b"\x1f\x8b\x08\0 no gzip"), 0);
        assert_eq!((percent("", b"BZh9"), percent("a.clf.bz2", b"BZh9")), (20, 60));
    }
}
