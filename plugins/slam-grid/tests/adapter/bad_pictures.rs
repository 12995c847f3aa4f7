//! Pictures that cannot be read, and what is said of them.

use crate::support::*;
use image::ImageFormat;
use planform_sdk::{ErrorKind, PluginError};

fn refused(name: &str, bytes: &[u8]) -> PluginError {
    read_bytes(name, bytes, &[]).unwrap_err()
}

#[test]
fn truncated_pictures_are_told() {
    let noise: Vec<u8> = (0..4096_u32).map(|i| (i * i % 251) as u8).collect();
    for format in [ImageFormat::Png, ImageFormat::Pnm, ImageFormat::Bmp, ImageFormat::Tiff] {
        let whole = encode(&picture(64, &noise), format);
        let e = refused("map", &whole[..whole.len() / 2]);
        assert_eq!(e.kind, ErrorKind::BadInput, "{format:?}: {e}");
        assert!(e.to_string().contains("cut short"), "{format:?}: {e}");
    }
}

#[test]
fn huge_claims_are_refused_before_memory_is_taken() {
    for header in
        ["P5\n60000 60000\n255\n", "P2\n60000 60000\n255\n", "P4\n60000 60000\n", "P6\n60000 60000\n255\n"]
    {
        let e = refused("map.pgm", header.as_bytes());
        assert_eq!(e.kind, ErrorKind::Limit, "{e}");
        assert!(
            e.to_string().contains("60000 x 60000")
                && e.to_string().contains(&planform_sdk::MAX_CELLS.to_string()),
            "{e}"
        );
    }
    let e = refused("map.ppm", b"P6\n100000 10\n65535\n");
    assert_eq!(e.kind, ErrorKind::Limit, "{e}");
    assert!(e.to_string().contains("100000 x 10") && e.to_string().contains("65536 a side"), "{e}");
    let mut png = encode(&picture(1, &[0]), ImageFormat::Png);
    png[16..24].copy_from_slice(&[0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60]);
    let sum = crc(&png[12..29]);
    png[29..33].copy_from_slice(&sum.to_be_bytes());
    let e = refused("map.png", &png);
    assert_eq!(e.kind, ErrorKind::Limit, "{e}");
    assert!(e.to_string().contains("60000 x 60000"), "{e}");
}

/// The check sum of a PNG chunk.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..8).fold(crc ^ u32::from(byte), |c, _| if c & 1 == 1 { c >> 1 ^ 0xedb8_8320 } else { c >> 1 })
    })
}

#[test]
fn empty_and_alien_files_are_told() {
    assert!(refused("map.png", b"").to_string().contains("the file is empty"));
    assert!(refused("map.png", b"\0\x01\x02\x03 no picture").to_string().contains("first bytes"));
    assert!(refused("map.pgm", b"<html>not found</html>").to_string().contains("first bytes"));
    let gif = refused("map.gif", b"GIF89a\x01\0\x01\0\0\0\0;");
    assert_eq!(
        (gif.kind, gif.to_string().contains("save it as PNG")),
        (ErrorKind::Unsupported, true),
        "{gif}"
    );
    assert_eq!(refused("map.pgm", b"P5\n0 5\n255\n").kind, ErrorKind::BadInput);
}
