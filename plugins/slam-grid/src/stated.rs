//! The openings between rooms that a map written by planform states, under the key `planform` of its YAML file:
//!
//! ```yaml
//! planform:
//!   openings:
//!     - {kind: passage, from: [1.5, 2], to: [4.25, 2], depth: 0.2}
//! ```
//!
//! Map servers ask for the keys that they know by name, and pass over all others: `loadMapYaml` in `map_io.cpp` of
//! nav2_map_server, and `main.cpp` of the map_server of ROS 1. What is wrong with this one is told, and the map is read
//! without it.

use crate::{metadata, scalar};
use planform_sdk::{Grid, OpeningKind, Point, Segment, StatedOpening};
use serde::Deserialize;
use serde_saphyr::Spanned;

/// The most openings: a floor with a thousand rooms has fewer.
const MOST: usize = 5_000;

/// The thickest wall, metres.
const THICKEST: f64 = 10.0;

/// An opening may end this far beyond the map, metres: outlines of rooms may lie a little outside of their cells.
const BEYOND: f64 = 1.0;

/// The key by itself, so that what is wrong with it spoils nothing else.
#[derive(Deserialize)]
struct Raw {
    planform: Option<RawBlock>,
}

#[derive(Deserialize)]
#[serde(expecting = "the key `openings`")]
struct RawBlock {
    openings: Option<Vec<RawOpening>>,
}

#[derive(Deserialize)]
#[serde(expecting = "an opening with the keys `kind`, `from` and `to`")]
struct RawOpening {
    kind: Spanned<String>,
    from: Spanned<Vec<String>>,
    to: Spanned<Vec<String>>,
    depth: Option<Spanned<String>>,
}

/// What is wrong, and in which line if that is known.
struct Fault(Option<u64>, String);

/// The openings that a YAML file states, if it does, in its own metres.
pub fn read(yaml: &str, warnings: &mut Vec<String>) -> Option<Vec<StatedOpening>> {
    let raw = metadata::keys::<Raw>(yaml).map_err(|e| {
        let reason = e.without_snippet().to_string();
        let reason = reason.lines().next().unwrap_or_default().chars().take(200).collect();
        Fault(e.location().map(|l| l.line()), reason)
    });
    let read = raw.and_then(|raw| raw.planform.and_then(|p| p.openings).map(checked).transpose());
    read.unwrap_or_else(|Fault(line, reason)| {
        let place = line.map(|l| format!("line {l}: ")).unwrap_or_default();
        warnings.push(format!("{place}the openings under `planform` are not used: {reason}"));
        None
    })
}

fn checked(raw: Vec<RawOpening>) -> Result<Vec<StatedOpening>, Fault> {
    if raw.len() > MOST {
        return Err(Fault(None, format!("there are {} of them, and the most are {MOST}", raw.len())));
    }
    raw.iter().map(opening).collect()
}

fn opening(raw: &RawOpening) -> Result<StatedOpening, Fault> {
    let kind = match raw.kind.value.trim() {
        "door" => OpeningKind::Door,
        "passage" => OpeningKind::Passage,
        _ => return Err(fault(&raw.kind, "`kind` is neither door nor passage")),
    };
    let segment = Segment::new(point(&raw.from)?, point(&raw.to)?);
    Ok(StatedOpening { kind, segment, depth: raw.depth.as_ref().map(depth).transpose()? })
}

fn depth(raw: &Spanned<String>) -> Result<f64, Fault> {
    let depth = scalar::number(&raw.value).filter(|v| (0.0..=THICKEST).contains(v));
    depth.ok_or_else(|| fault(raw, &format!("`depth` is no number of metres from 0 to {THICKEST}")))
}

fn point(raw: &Spanned<Vec<String>>) -> Result<Point, Fault> {
    let finite = |text: &String| scalar::number(text).filter(|v| v.is_finite());
    match raw.value.as_slice() {
        [x, y] => finite(x).zip(finite(y)).map(|(x, y)| Point::new(x, y)),
        _ => None,
    }
    .ok_or_else(|| fault(raw, "a place is not two finite numbers [x, y]"))
}

fn fault<T>(value: &Spanned<T>, reason: &str) -> Fault {
    Fault(Some(value.referenced.line()), reason.into())
}

/// The openings on the map: `scale` metres of the grid are one of the file's, counted from the map's corner.
pub fn placed(
    openings: Vec<StatedOpening>,
    grid: &Grid,
    scale: f64,
    warnings: &mut Vec<String>,
) -> Vec<StatedOpening> {
    let corner = grid.origin();
    let place =
        |p: Point| Point::new(corner.x + scale * (p.x - corner.x), corner.y + scale * (p.y - corner.y));
    let scaled = openings.iter().map(|o| {
        let segment = Segment::new(place(o.segment.a), place(o.segment.b));
        StatedOpening { segment, depth: o.depth.map(|d| scale * d), ..*o }
    });
    let kept: Vec<_> =
        scaled.filter(|o| [o.segment.a, o.segment.b].iter().all(|&p| is_on(p, grid))).collect();
    let lost = openings.len() - kept.len();
    if lost > 0 {
        let count = openings.len();
        warnings.push(format!(
            "of {count} openings under `planform`, {lost} lie outside of the map and are not used"
        ));
    }
    kept
}

fn is_on(p: Point, grid: &Grid) -> bool {
    let (p, margin) = (grid.to_cells(p), BEYOND / grid.resolution());
    let within = |v: f64, cells: u32| (-margin..=f64::from(cells) + margin).contains(&v);
    within(p.x, grid.width()) && within(p.y, grid.height())
}
