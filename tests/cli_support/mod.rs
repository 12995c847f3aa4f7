//! A folder to run the program in, and what every refusal must look like.
// Every test program has its own copy of this module and uses a part of it.
#![allow(dead_code)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use assert_cmd::Command;
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::Output;
use std::time::Duration;
use tempfile::TempDir;

pub const YAML: &str = "image: map.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n\
    occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// Grey of a cell in the maps that are made here.
pub const WALL: u8 = 0;
pub const FREE: u8 = 254;
pub const UNKNOWN: u8 = 205;

pub struct Workshop(TempDir);

impl Workshop {
    /// An empty folder.
    pub fn empty() -> Self {
        Self(TempDir::new().unwrap())
    }

    /// A folder with the map of two rooms and a door between them: `map.yaml`, `map.pgm`.
    pub fn new() -> Self {
        let workshop = Self::empty();
        workshop.write("map.yaml", YAML);
        workshop.write("map.pgm", pgm(200, 120, two_rooms));
        workshop
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).unwrap();
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub fn files(&self) -> BTreeSet<String> {
        let names = fs::read_dir(self.0.path()).unwrap();
        names.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    /// The program in this folder with these arguments, parted by spaces.
    pub fn command(&self, args: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_planform"));
        command.current_dir(self.0.path()).args(args.split_whitespace());
        command.env_remove("RUST_BACKTRACE").timeout(Duration::from_secs(120));
        command
    }

    pub fn run(&self, args: &str) -> Output {
        self.command(args).output().unwrap()
    }

    /// Runs the program, which must do what it is told; its standard output and its standard error.
    pub fn does(&self, args: &str) -> (String, String) {
        let output = self.run(args);
        let (out, err) = (text(&output.stdout), text(&output.stderr));
        assert_eq!(output.status.code(), Some(0), "planform {args}\n{err}");
        (out, err)
    }

    /// Runs the program, which must fail with this exit status and one sentence that contains all these words, and
    /// leave no file behind.
    pub fn refuses(&self, args: &str, code: i32, words: &[&str]) {
        let before = self.files();
        refused(&self.run(args), code, words, args);
        assert_eq!(self.files(), before, "planform {args} left files behind");
    }
}

/// Fails unless the program ended with this exit status and one sentence that contains all these words.
pub fn refused(output: &Output, code: i32, words: &[&str], args: &str) {
    let err = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "planform {args}\n{err}");
    let errors: Vec<_> = err.lines().filter(|l| l.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 1, "planform {args}\n{err}");
    for word in words {
        assert!(errors[0].contains(word), "planform {args}: `{word}` is not in\n{err}");
    }
    for word in ["panicked", "bug in planform", "os error", "RUST_BACKTRACE"] {
        assert!(!err.contains(word), "planform {args}\n{err}");
    }
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A picture with this grey at each column and row from the top.
pub fn pgm(width: u32, height: u32, grey: impl Fn(u32, u32) -> u8) -> Vec<u8> {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| grey(x, y));
    format!("P5\n{width} {height}\n255\n").into_bytes().into_iter().chain(pixels).collect()
}

/// Two rooms of 4.2 x 5 m side by side within 200 x 120 cells, a door of 1 m between them.
pub fn two_rooms(x: u32, y: u32) -> u8 {
    let (outside, inside) =
        (!(8..192).contains(&x) || !(8..112).contains(&y), (11..189).contains(&x) && (11..109).contains(&y));
    let divides = (98..101).contains(&x) && !(50..70).contains(&y);
    match (outside, inside && !divides) {
        (true, _) => UNKNOWN,
        (_, true) => FREE,
        _ => WALL,
    }
}
