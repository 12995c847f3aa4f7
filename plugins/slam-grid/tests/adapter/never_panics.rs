//! Whatever the bytes are, reading and probing end, and end well.

use crate::support::*;
use image::ImageFormat;
use planform_sdk::Probe;
use proptest::prelude::*;
use std::path::Path;

fn digest(bytes: &[u8]) {
    let head = &bytes[..bytes.len().min(4096)];
    for name in ["", "map.yaml", "map.pgm", "map.png"] {
        let confidence = planform_slam_grid::adapter().probe(&Probe { path: Path::new(name), head });
        assert!(confidence.percent <= 100);
        if let Err(e) = read_bytes(name, bytes, &[]) {
            assert!(!e.to_string().is_empty());
        }
    }
}

fn sound_file() -> impl Strategy<Value = Vec<u8>> {
    let greys: Vec<u8> = (0..100).map(|i| [0, 205, 254, 100][i % 4]).collect();
    let formats =
        [ImageFormat::Png, ImageFormat::Pnm, ImageFormat::Bmp, ImageFormat::Tiff, ImageFormat::Jpeg];
    let mut files: Vec<_> = formats.iter().map(|&f| encode(&picture(10, &greys), f)).collect();
    files.push(b"P2\n3 2\n255\n0 255 51\n204 102 153\n".to_vec());
    files.push(format!("{YAML}mode: scale\n").into_bytes());
    files.push(
        format!("{YAML}planform: {{openings: [{{kind: door, from: [-1, 2], to: [0, 2]}}]}}\n").into_bytes(),
    );
    proptest::sample::select(files)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        digest(&bytes);
    }

    #[test]
    fn random_text(text in "[ -~\n]{0,200}") {
        digest(text.as_bytes());
    }

    #[test]
    fn random_values(key in 0..6_usize, value in "\\PC{0,20}") {
        let lines = YAML.lines().enumerate().map(|(i, line)| match line.split_once(':') {
            Some((name, _)) if i == key => format!("{name}: {value}\n"),
            _ => format!("{line}\n"),
        });
        digest(lines.collect::<String>().as_bytes());
    }

    #[test]
    fn truncated_files(file in sound_file(), share in 0.0..1.0) {
        digest(&file[..(file.len() as f64 * share) as usize]);
    }

    #[test]
    fn flipped_bits(file in sound_file(), flips in prop::collection::vec((any::<prop::sample::Index>(), 0..8_u32), 1..6)) {
        let mut file = file;
        for (at, bit) in flips {
            let at = at.index(file.len());
            file[at] ^= 1_u8 << bit;
        }
        digest(&file);
    }
}
