//! One run of the program, and what it tells of itself.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// What came of a run.
pub struct Run {
    /// From its start to its end, seconds.
    pub whole: f64,
    /// Each step's name and seconds.
    steps: Vec<(String, f64)>,
    /// The most memory that it held, MiB; nothing where the system does not tell.
    pub peak: Option<f64>,
}

impl Run {
    /// The quickest of so many runs of `planform convert map.yaml` in this folder, with these further arguments.
    pub fn best(runs: usize, folder: &Path, arguments: &[&str]) -> Self {
        let all = (0..runs).map(|_| Self::once(folder, arguments));
        all.min_by(|a, b| a.whole.total_cmp(&b.whole)).unwrap()
    }

    fn once(folder: &Path, arguments: &[&str]) -> Self {
        let mut planform = Command::new(env!("CARGO_BIN_EXE_planform"));
        planform.current_dir(folder).args(["convert", "map.yaml", "--force", "--verbose"]).args(arguments);
        let start = Instant::now();
        let output = planform.output().unwrap();
        let whole = start.elapsed().as_secs_f64();
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{told}");
        let peak = told.lines().find_map(|l| l.strip_prefix("peak memory")?.strip_suffix("MiB"));
        let peak = peak.map(|p| p.trim().parse().unwrap());
        Self { whole, steps: told.lines().filter_map(step).collect(), peak }
    }

    /// How long this step took, seconds.
    pub fn step(&self, name: &str) -> f64 {
        self.steps.iter().filter(|s| s.0 == name).map(|s| s.1).sum()
    }

    /// The names of the steps, in their order.
    pub fn steps(&self) -> impl Iterator<Item = &str> {
        self.steps.iter().map(|s| s.0.as_str())
    }

    /// The most memory that it held, for a table.
    pub fn told_peak(&self) -> String {
        self.peak.map_or("-".into(), |p| p.to_string())
    }
}

/// `basins         0.081 s`. The stages of a step are indented.
fn step(line: &str) -> Option<(String, f64)> {
    let (name, seconds) = line.strip_suffix(" s")?.split_once(' ')?;
    Some((name.into(), seconds.trim().parse().ok()?)).filter(|_| !name.is_empty())
}
