//! Folders of documents for batches, and what came of them.
// Every test program has its own copy of this module and uses a part of it.
#![allow(dead_code)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use crate::cli_support::{Workshop, YAML, pgm, text, two_rooms};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

/// The plan of two rooms with a door between them, at 1 cm per unit.
pub const PLAN: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" width="1200" height="800" viewBox="0 0 1200 800">
<rect width="1200" height="800" fill="white"/>
<path fill="none" stroke="black" stroke-width="24" d="M100 100H1100V700H100Z M600 100V340 M600 440V700"/>
</svg>"#;

/// The log of a laser that turns in a room which is a square of 4 m.
pub fn log() -> String {
    let range = |direction: f64| 2.0 / direction.cos().abs().max(direction.sin().abs());
    let scan = |i: u32| {
        let heading = f64::from(i) * 0.3;
        let beam = |j: u32| format!("{:.2} ", range(heading + (f64::from(j) - 90.0).to_radians()));
        let ranges: String = (0..181).map(beam).collect();
        format!("FLASER 181 {ranges}0 0 {heading} 0 0 {heading} {i} host {i}\nNEFF 10\n")
    };
    (0..20).map(scan).collect()
}

impl Workshop {
    /// Writes a file in folders that are made if need be.
    pub fn put(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::create_dir_all(self.path(name).parent().unwrap()).unwrap();
        self.write(name, bytes);
    }

    /// The map of two rooms, the more to the right its door the larger the number: `in/NAME.yaml` with its picture.
    pub fn put_map(&self, name: &str, number: u32) {
        let stem = Path::new(name).file_name().unwrap().to_str().unwrap();
        self.put(&format!("in/{name}.yaml"), YAML.replace("map.pgm", &format!("{stem}.pgm")));
        let shifted = |x: u32, y: u32| two_rooms(x, if (98..101).contains(&x) { y + number % 30 } else { y });
        self.put(&format!("in/{name}.pgm"), pgm(200, 120, shifted));
    }

    /// Maps, a log, a plan, and so many that are broken, in a folder `in` with others in it.
    pub fn put_documents(&self, maps: u32) {
        (0..maps).for_each(|n| self.put_map(&format!("maps/{}/{n}", n % 3), n));
        self.put("in/logs/turning.log", log());
        self.put("in/plan.svg", PLAN);
        self.put("in/broken/empty.png", "");
        self.put("in/broken/garbage.pdf", "%PDF-1.7\nthis is no PDF");
        self.put("in/broken/short.pgm", &pgm(200, 120, two_rooms)[..5000]);
        self.put("in/broken/alone.yaml", YAML);
        self.put("in/notes.txt", "not a document");
    }

    /// The files of a folder but for those that are a batch's own, by their paths in it.
    pub fn tree(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let mut tree = BTreeMap::new();
        collect(&self.path(folder), "", &mut tree);
        tree
    }

    /// The report's rows by the documents' names.
    pub fn report(&self, folder: &str) -> BTreeMap<String, serde_json::Value> {
        let text = text(&self.read(&format!("{folder}/report.jsonl")));
        let rows = text.lines().map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap());
        rows.map(|row| (row["name"].as_str().unwrap().to_owned(), row)).collect()
    }

    /// Starts the program and does not wait for it.
    pub fn start(&self, args: &str) -> Child {
        let mut command = Command::new(env!("CARGO_BIN_EXE_planform"));
        command.current_dir(self.path("")).args(args.split_whitespace());
        // A group of its own, as a shell gives it: signals of this test reach nobody else.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    }

    /// Runs the program in a shell, after this.
    pub fn shell(&self, before: &str, args: &str) -> Output {
        let script = format!("{before}; exec '{}' {args}", env!("CARGO_BIN_EXE_planform"));
        Command::new("sh").args(["-c", &script]).current_dir(self.path("")).output().unwrap()
    }
}

fn collect(folder: &Path, prefix: &str, tree: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let entry = entry.unwrap();
        let name = format!("{prefix}{}", entry.file_name().to_str().unwrap());
        match entry.file_type().unwrap().is_dir() {
            true if name == "planform-batch" => {}
            true => collect(&entry.path(), &format!("{name}/"), tree),
            false => drop(tree.insert(name, fs::read(entry.path()).unwrap())),
        }
    }
}

/// Ends a program as this signal does.
#[cfg(unix)]
pub fn signal(child: &Child, signal: &str) {
    Command::new("kill").args([format!("-{signal}"), child.id().to_string()]).status().unwrap();
}
