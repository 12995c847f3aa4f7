//! How well scan matching does on logs whose poses were corrected by another program: the poses found from odometry
//! alone against those that the log states, after the rigid motion that lays one path over the other best.
//!
//!     cargo run --release -p planform-radish --example poses -- LOG...
//!
//! Prints one line for each log: the error of the place (median, 95th percentile, greatest; metres) and of the heading
//! (median, 95th percentile; radians), the seconds taken, and how many times as fast as the robot drove that is, taken
//! from the log's clock where it can be believed, and from a robot at 0.5 m/s where not (marked ~). With `--draw FOLDER`
//! the echoes as seen from the poses found are drawn to FOLDER/NAME.pgm, 0.1 m for each pixel. A log that has no odometry
//! is matched without, and says so, and once more with made-up odometry: the log's own poses, each step of which is off
//! like that of a poor robot.

use planform_radish::log::{LaserChoice, Log, Pose, Scan, read};
use planform_radish::matching::{MatchingParams, corrected};
use planform_radish::unpack;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Speed of a robot whose log's clock means nothing, metres per second.
const SPEED: f64 = 0.5;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let mut folder = None;
    println!(
        "log                          scans loops   median     95 %      max   median     95 %   seconds  x real"
    );
    while let Some(argument) = arguments.next() {
        if argument == "--draw" {
            folder = arguments.next().map(PathBuf::from);
        } else {
            measure(Path::new(&argument), folder.as_deref())?;
        }
    }
    Ok(())
}

fn measure(path: &Path, folder: Option<&Path>) -> Result<(), Box<dyn Error>> {
    let bytes = std::fs::read(path)?;
    let log = read(unpack::text(&bytes), LaserChoice { view: None, offset: 0.0 })?;
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let short = name.split('.').next().unwrap_or_default();
    let file = |end: &str| folder.map(|folder| folder.join(format!("{short}{end}.pgm")));
    compare(short, &log, &from_odometry(&log), file("").as_deref())?;
    if log.scans.iter().all(|s| s.odometry.is_none()) {
        compare("  with made-up odometry", &log, &drifting(&log), file("-made-up").as_deref())?;
    }
    Ok(())
}

/// Matches the scans, and prints how far that is from the log's poses.
fn compare(name: &str, log: &Log, scans: &[Scan], picture: Option<&Path>) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let matched = corrected(scans, &MatchingParams::default(), &mut |_| {});
    let seconds = start.elapsed().as_secs_f64();
    let truth: Vec<Pose> = log.scans.iter().map(|s| s.pose).collect();
    let (mut places, mut headings) = errors(&matched.poses, &truth);
    places.sort_by(f64::total_cmp);
    headings.sort_by(f64::total_cmp);
    let (duration, mark) = duration(log);
    println!(
        "{name:28} {:5} {:5} {:8.3} {:8.3} {:8.3} {:8.4} {:8.4} {seconds:9.2} {mark}{:7.0}{}",
        scans.len(),
        matched.loops,
        percentile(&places, 0.5),
        percentile(&places, 0.95),
        percentile(&places, 1.0),
        percentile(&headings, 0.5),
        percentile(&headings, 0.95),
        duration / seconds,
        if matched.odometry { "" } else { "  (no odometry)" },
    );
    picture.map_or(Ok(()), |picture| draw(scans, &matched.poses, picture))
}

/// The scans with odometry made of the log's poses: steps are 3 percent too long, off by up to a tenth of the way or of
/// the turn, and bend by half a degree for each metre.
fn drifting(log: &Log) -> Vec<Scan> {
    let mut state = 1_u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let (mut pose, mut last) = (Pose::IDENTITY, None);
    let mut follow = |scan: &Scan| {
        let step = last.unwrap_or(scan.pose).to(scan.pose);
        let way = step.x.hypot(step.y);
        pose = pose.then(Pose {
            x: 1.03 * step.x + 0.1 * way * noise(),
            y: step.y + 0.1 * way * noise(),
            theta: step.theta * (1.0 + 0.1 * noise()) + 0.0087 * way,
        });
        last = Some(scan.pose);
        Scan { pose, odometry: None, ..scan.clone() }
    };
    log.scans.iter().map(&mut follow).collect()
}

/// The scans with odometry as all that is known of their poses.
fn from_odometry(log: &Log) -> Vec<Scan> {
    let known = |scan: &Scan| Scan { pose: scan.odometry.unwrap_or(Pose::IDENTITY), ..scan.clone() };
    log.scans.iter().map(known).collect()
}

/// How long the robot drove, seconds, and a mark if that is guessed.
fn duration(log: &Log) -> (f64, char) {
    let way: f64 = log.scans.windows(2).map(|w| w[0].pose.distance(w[1].pose)).sum();
    let clock = log.scans.last().map_or(0.0, |s| s.time) - log.scans.first().map_or(0.0, |s| s.time);
    let runs_on = log.scans.windows(2).all(|w| w[0].time <= w[1].time);
    if runs_on && (way / 1.5..1e6).contains(&clock) { (clock, ' ') } else { (way / SPEED, '~') }
}

/// How far each place and each heading is off, after alignment.
fn errors(found: &[Pose], truth: &[Pose]) -> (Vec<f64>, Vec<f64>) {
    let laid = aligned(found, truth);
    let pairs = || laid.iter().zip(truth);
    (pairs().map(|(a, b)| a.distance(*b)).collect(), pairs().map(|(a, b)| a.turn(*b).abs()).collect())
}

/// The poses moved rigidly so that the sum of the squared distances is least.
fn aligned(found: &[Pose], truth: &[Pose]) -> Vec<Pose> {
    let middle = |poses: &[Pose]| {
        let n = poses.len().max(1) as f64;
        Pose {
            x: poses.iter().map(|p| p.x).sum::<f64>() / n,
            y: poses.iter().map(|p| p.y).sum::<f64>() / n,
            theta: 0.0,
        }
    };
    let (from, to) = (middle(found), middle(truth));
    let pairs = found.iter().zip(truth).map(|(a, b)| (from.to(*a), to.to(*b)));
    let (sin, cos) = pairs
        .fold((0.0, 0.0), |(sin, cos), (a, b)| (sin + a.x * b.y - a.y * b.x, cos + a.x * b.x + a.y * b.y));
    let to = Pose { theta: f64::atan2(sin, cos), ..to };
    found.iter().map(|pose| to.then(from.to(*pose))).collect()
}

fn percentile(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    sorted.get((share * last as f64).round() as usize).copied().unwrap_or(0.0)
}

/// Draws where the echoes came from.
fn draw(scans: &[Scan], poses: &[Pose], path: &Path) -> Result<(), Box<dyn Error>> {
    let echoes: Vec<(f64, f64)> = scans.iter().zip(poses).flat_map(|(s, p)| echoes(s, *p)).collect();
    let low = echoes.iter().fold((f64::MAX, f64::MAX), |l, e| (l.0.min(e.0), l.1.min(e.1)));
    let high = echoes.iter().fold((f64::MIN, f64::MIN), |h, e| (h.0.max(e.0), h.1.max(e.1)));
    let cells = |from: f64, to: f64| (((to - from) * 10.0).max(0.0) as usize + 1).min(10_000);
    let (width, height) = (cells(low.0, high.0), cells(low.1, high.1));
    let mut pixels = vec![255_u8; width * height];
    for (x, y) in echoes {
        let (column, row) = (cells(low.0, x) - 1, height - cells(low.1, y));
        pixels[row * width + column] = 0;
    }
    let mut file = format!("P5\n{width} {height}\n255\n").into_bytes();
    file.extend(pixels);
    Ok(std::fs::write(path, file)?)
}

fn echoes(scan: &Scan, pose: Pose) -> impl Iterator<Item = (f64, f64)> {
    let near = scan.beams().filter(|(_, range)| scan.is_echo(*range) && *range < 30.0);
    near.map(move |(angle, range)| {
        let (sin, cos) = (pose.theta + angle).sin_cos();
        (pose.x + f64::from(range) * cos, pose.y + f64::from(range) * sin)
    })
}
