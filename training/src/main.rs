//! Fits the weights of the method `basins` to synthetic buildings, and checks them on maps that have a truth.

mod fit;
mod maps;
mod samples;
mod score;
mod weights;

use clap::Parser;
use maps::Map;
use planform::evaluate::Measures;
use planform::reconstruct::Params;
use planform::reconstruct::basins::evidence::COUNT;
use planform::reconstruct::basins::model::Model;
use planform_synth::parallel_map;
use samples::{Lesson, Sample};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::ExitCode;

/// Fits the weights of the method `basins` to synthetic buildings.
#[derive(Parser)]
struct Args {
    /// Synthetic buildings to learn from: the seeds from 1
    #[arg(long, default_value_t = 600)]
    buildings: u64,
    /// Synthetic buildings to check on: the seeds after those
    #[arg(long, default_value_t = 40)]
    unseen: u64,
    /// Write the weights to this Rust file
    #[arg(long)]
    write: Option<PathBuf>,
    /// Check as well on a folder with a manifest; `FOLDER:KEY` takes another map of each entry
    #[arg(long, value_name = "FOLDER[:KEY]")]
    check: Vec<String>,
    /// Maps whose names contain this word show the same building
    #[arg(long, value_name = "WORD")]
    same: Vec<String>,
    /// Learn from the checked maps instead, always from other buildings than the one checked
    #[arg(long)]
    cross_validate: bool,
    /// Tell the measures of every map
    #[arg(long)]
    each: bool,
}

/// Parts of the maps that are held out in turn.
const FOLDS: usize = 6;

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("error: {e}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &Args) -> Result<(), String> {
    let checked = checked(args)?;
    let lessons = lessons(&checked);
    if args.cross_validate {
        report("held out, by building", &cross_validated(&lessons), args.each);
        return Ok(());
    }
    let drawn = |seeds: std::ops::RangeInclusive<u64>| -> Result<Vec<Map>, String> {
        parallel_map(&seeds.collect::<Vec<_>>(), |&seed| maps::synthetic(seed)).into_iter().collect()
    };
    let learned = drawn(1..=args.buildings)?;
    let model = learn(&self::lessons(&learned));
    if let Some(file) = &args.write {
        std::fs::write(file, weights::source(&model, args.buildings))
            .map_err(|e| format!("{}: {e}", file.display()))?;
    }
    let unseen = drawn(args.buildings + 1..=args.buildings + args.unseen)?;
    let all: Vec<&Lesson<'_>> = lessons.iter().collect();
    report(
        "synthetic, unseen",
        &scores(&self::lessons(&unseen).iter().collect::<Vec<_>>(), &model),
        args.each,
    );
    report("checked", &scores(&all, &model), args.each);
    Ok(())
}

fn checked(args: &Args) -> Result<Vec<Map>, String> {
    let mut maps = Vec::new();
    for folder in &args.check {
        let (folder, key) = folder.rsplit_once(':').unwrap_or((folder, "map"));
        maps.extend(maps::of_manifest(folder.as_ref(), key)?);
    }
    for map in &mut maps {
        let name = map.name.to_lowercase();
        if let Some(word) = args.same.iter().find(|w| name.contains(&w.to_lowercase())) {
            map.building.clone_from(word);
        }
    }
    Ok(maps)
}

fn lessons(maps: &[Map]) -> Vec<Lesson<'_>> {
    parallel_map(maps, Lesson::of).into_iter().flatten().collect()
}

/// Learns in two rounds: on the way of a rough guess, then on the way of what was learned there as well.
fn learn(lessons: &[Lesson<'_>]) -> Model {
    let of = |model: &Model| parallel_map(lessons, |l| l.samples(model)).concat();
    let mut samples = of(&guess());
    samples.extend(of(&fit::fit(&samples.iter().collect::<Vec<_>>())));
    fit::fit(&samples.iter().collect::<Vec<_>>())
}

/// A rough guess: two regions are one room if the passage has three quarters of the smaller one's clearance.
fn guess() -> Model {
    let mut weights = [0.0; COUNT];
    weights[1] = 8.0;
    Model { bias: -6.0, weights }
}

fn scores<'a>(lessons: &[&'a Lesson<'a>], model: &Model) -> Vec<(&'a Map, Measures)> {
    let params = Params::default();
    parallel_map(lessons, |l| (l.map, score::score(l, model, &params)))
}

fn cross_validated<'a>(lessons: &'a [Lesson<'a>]) -> Vec<(&'a Map, Measures)> {
    let mut buildings: Vec<&str> = lessons.iter().map(|l| l.map.building.as_str()).collect();
    buildings.sort_unstable();
    buildings.dedup();
    let fold: BTreeMap<&str, usize> = buildings.iter().enumerate().map(|(i, b)| (*b, i % FOLDS)).collect();
    let of = |l: &Lesson<'_>| fold[l.map.building.as_str()];
    let first: Vec<Vec<Sample>> = parallel_map(lessons, |l| l.samples(&guess()));
    let mut found = Vec::new();
    for k in 0..FOLDS {
        let mine = |i: &usize| of(&lessons[*i]) != k;
        let train: Vec<usize> = (0..lessons.len()).filter(mine).collect();
        let rough = fit::fit(&train.iter().flat_map(|&i| &first[i]).collect::<Vec<_>>());
        let second = parallel_map(&train, |&i| lessons[i].samples(&rough));
        let samples = train.iter().flat_map(|&i| &first[i]).chain(second.iter().flatten());
        let model = fit::fit(&samples.collect::<Vec<_>>());
        let test: Vec<&Lesson<'_>> = lessons.iter().filter(|l| of(l) == k).collect();
        found.extend(scores(&test, &model));
    }
    found
}

/// Prints the means of every set, and the measures of every map if asked to.
fn report(title: &str, scores: &[(&Map, Measures)], each: bool) {
    let mut sets: BTreeMap<&str, Vec<&Measures>> = BTreeMap::new();
    for (map, measures) in scores {
        sets.entry(&map.set).or_default().push(measures);
    }
    if !sets.is_empty() {
        println!("{title:44}  A_FC  A_BC     P     R  mIoU");
    }
    for (set, measures) in sets {
        let mean = |of: fn(&Measures) -> f64| {
            100.0 * measures.iter().map(|m| of(m)).sum::<f64>() / measures.len() as f64
        };
        println!(
            "{}",
            row(
                set,
                [
                    mean(|m| m.a_fc),
                    mean(|m| m.a_bc),
                    mean(|m| m.precision),
                    mean(|m| m.recall),
                    mean(|m| m.miou)
                ]
            )
        );
    }
    for (map, m) in scores.iter().filter(|_| each) {
        let values = [m.a_fc, m.a_bc, m.precision, m.recall, m.miou].map(|v| 100.0 * v);
        println!("{}", row(&format!("{}, {}", map.set, map.name), values));
    }
}

fn row(name: &str, values: [f64; 5]) -> String {
    let values: Vec<String> = values.iter().map(|v| format!("{v:5.1}")).collect();
    format!("  {name:42}  {}", values.join(" "))
}
