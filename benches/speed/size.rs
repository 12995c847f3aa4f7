//! What becomes of time and memory as maps get larger.

use crate::Bench;
use crate::page::table;
use crate::run::Run;
use crate::tiles::{RESOLUTION, building, tiled};
use std::thread::available_parallelism;

/// Columns and rows of tiles: 0.2, 1, 4, 16 and 100 megapixels.
const SIZES: [(usize, usize); 5] = [(1, 1), (1, 5), (4, 5), (8, 10), (20, 25)];

/// How many of them are small, and which one has one megapixel: the others are compared with it.
const QUICK: usize = 2;
const UNIT: usize = 1;

/// The memory that a map of any size may take, bytes.
const BASE: f64 = 64e6;

/// A map that was converted.
struct Sized {
    cells: f64,
    run: Run,
}

/// The tables: one for one thread, one for all.
pub fn report(bench: &Bench<'_>) -> String {
    let most = available_parallelism().unwrap().get();
    let counts: Vec<usize> = [1].into_iter().chain((most > 1).then_some(most)).collect();
    let tables = counts.iter().zip(measure(bench, &counts)).map(|(&count, maps)| {
        let threads = if count == 1 { "One thread".into() } else { format!("{count} threads") };
        format!("#### {threads}\n\n{}\n", told(&maps))
    });
    format!("### Size\n\n{}", tables.collect::<String>())
}

/// For each number of threads, all maps.
fn measure(bench: &Bench<'_>, threads: &[usize]) -> Vec<Vec<Sized>> {
    let building = building();
    let sizes = &SIZES[..if bench.quick { QUICK } else { SIZES.len() }];
    let mut found: Vec<Vec<Sized>> = threads.iter().map(|_| vec![]).collect();
    for &(columns, rows) in sizes {
        let map = tiled(&building, columns, rows);
        map.save(bench.folder, RESOLUTION);
        for (found, count) in found.iter_mut().zip(threads) {
            let arguments = ["-o", "out.geojson", "--threads", &count.to_string()];
            let run = Run::best(bench.runs, bench.folder, &arguments);
            found.push(Sized { cells: map.greys.len() as f64, run });
        }
    }
    found
}

fn told(maps: &[Sized]) -> String {
    let steps: Vec<&str> = maps[UNIT].run.steps().collect();
    let before = ["megapixels", "whole, ms"].into_iter().map(String::from);
    let after = ["per megapixel", "without reading and writing", "peak, MiB", "bytes per cell over 64 MB"];
    let header = before.chain(steps.iter().map(|s| s.to_string())).chain(after.map(String::from));
    let rows: Vec<_> = maps.iter().map(|map| row(map, &maps[UNIT], &steps)).collect();
    table(&header.collect::<Vec<_>>(), &rows)
}

fn row(map: &Sized, unit: &Sized, steps: &[&str]) -> Vec<String> {
    let milliseconds = |seconds: f64| format!("{:.0}", 1e3 * seconds);
    let times = steps.iter().map(|s| milliseconds(map.run.step(s)));
    let megapixels = format!("{:.1}", map.cells / 1e6);
    let ratios =
        [Sized::whole, Sized::work].map(|time| format!("{:.2}", map.per_cell(time) / unit.per_cell(time)));
    let memory = [map.run.told_peak(), map.told_bytes_per_cell()];
    [megapixels, milliseconds(map.run.whole)].into_iter().chain(times).chain(ratios).chain(memory).collect()
}

impl Sized {
    fn whole(&self) -> f64 {
        self.run.whole
    }

    /// Without what depends on the formats.
    fn work(&self) -> f64 {
        self.run.whole - self.run.step("reading") - self.run.step("writing")
    }

    fn per_cell(&self, time: fn(&Self) -> f64) -> f64 {
        time(self) / self.cells
    }

    fn told_bytes_per_cell(&self) -> String {
        let over = |mib: f64| (mib * f64::from(1 << 20) - BASE).max(0.0);
        self.run.peak.map_or("-".into(), |p| format!("{:.1}", over(p) / self.cells))
    }
}
