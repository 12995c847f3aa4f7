//! How far a floor goes on behind a frontier.

use super::Explored;
use super::field::{Field, Shown, Side};
use super::frontier::Run;
use super::lines::Lines;
use planform_sdk::FrontierKind;

/// A frontier faces a side if it is open that way at this share of its cells.
const FACING: f64 = 0.3;

/// A side is open if it is unknown beyond this share of it.
const OPEN: f64 = 0.5;

/// How far new space is looked over, metres: what is farther away does not bound it.
const HORIZON: f64 = 20.0;

/// What lies behind a frontier.
#[derive(Debug, Clone, PartialEq)]
pub struct Extent {
    /// The box of the room's unseen part in the frame: lowest and highest coordinates.
    pub low: [f64; 2],
    pub high: [f64; 2],
    /// To the room's rest if something closes it.
    pub leads: FrontierKind,
    /// Unknown area beyond the box up to what was seen there, square metres; 0 where nothing was.
    pub area: f64,
}

/// The box around a frontier, extended on its open sides to what closes the room there.
pub fn extent(field: &Field<'_>, run: &Run, lines: &Lines, wall: f64, params: &Explored) -> Extent {
    let mut extent = around(field, run);
    let facing: Vec<Side> =
        Side::ALL.into_iter().filter(|&s| share_facing(field, run, s, params) >= FACING).collect();
    let mut open = Vec::new();
    for &side in &facing {
        let beyond = Beyond::of(field, &extent, side, params.depth, params.reach);
        if beyond.open < OPEN {
            continue;
        }
        match beyond.end(field, &extent, side, lines, wall, params) {
            Some(end) => extent.set(side, end),
            None => open.push(side),
        }
    }
    for side in open {
        extent.leads = FrontierKind::Space;
        extent.area += Beyond::of(field, &extent, side, params.depth, HORIZON).area;
    }
    extent
}

fn around(field: &Field<'_>, run: &Run) -> Extent {
    let half = field.input.resolution / 2.0;
    let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
    for &cell in &run.cells {
        let place = field.middle(cell);
        for axis in 0..2 {
            low[axis] = low[axis].min(place[axis] - half);
            high[axis] = high[axis].max(place[axis] + half);
        }
    }
    Extent { low, high, leads: FrontierKind::Room, area: 0.0 }
}

fn share_facing(field: &Field<'_>, run: &Run, side: Side, params: &Explored) -> f64 {
    let open = |cell: &&usize| {
        let mut place = field.middle(**cell);
        place[side.axis] += side.sense() * 0.5 * field.input.resolution;
        field.depth(place, side, params.depth).1 == Shown::Unknown
    };
    run.cells.iter().filter(open).count() as f64 / run.cells.len().max(1) as f64
}

impl Extent {
    /// Position of a side.
    fn edge(&self, side: Side) -> f64 {
        if side.up { self.high[side.axis] } else { self.low[side.axis] }
    }

    fn set(&mut self, side: Side, edge: f64) {
        let place = if side.up { &mut self.high } else { &mut self.low };
        place[side.axis] = edge;
    }

    /// From where to where a side runs.
    fn aside(&self, side: Side) -> [f64; 2] {
        [self.low[1 - side.axis], self.high[1 - side.axis]]
    }
}

/// What the map shows beyond a side of a box.
struct Beyond {
    /// The share of it behind which is nothing.
    open: f64,
    /// How far it is to what stands there, and what that is, at the median of the open places.
    first: Option<(f64, Shown)>,
    /// Unknown area up to what stands there, square metres.
    area: f64,
}

impl Beyond {
    /// Looks up to `most` metres out; it is open where nothing is for `depth` metres.
    fn of(field: &Field<'_>, extent: &Extent, side: Side, depth: f64, most: f64) -> Self {
        let step = field.input.resolution;
        let [low, high] = extent.aside(side);
        let count = (((high - low) / step).round() as usize).max(1);
        let look = |i: usize| {
            let mut place = [0.0; 2];
            place[side.axis] = extent.edge(side);
            place[1 - side.axis] = low + (i as f64 + 0.5) * (high - low) / count as f64;
            field.depth(place, side, most)
        };
        let all: Vec<(f64, Shown)> = (0..count).map(look).collect();
        let mut free: Vec<(f64, Shown)> = all.into_iter().filter(|l| l.0 >= depth).collect();
        free.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = free.get(free.len() / 2).copied().filter(|f| f.1 != Shown::Unknown);
        let area = first.map_or(0.0, |_| free.iter().map(|f| f.0 * step).sum());
        Self { open: free.len() as f64 / count as f64, first, area }
    }

    /// Where the floor ends: at a line, or at what was seen there, whichever is nearer.
    fn end(
        &self,
        field: &Field<'_>,
        extent: &Extent,
        side: Side,
        lines: &Lines,
        wall: f64,
        params: &Explored,
    ) -> Option<f64> {
        let edge = extent.edge(side);
        let line = lines.nearest(side, edge, extent.aside(side), params).map(|l| (l - edge) * side.sense());
        let seen = self.first.map(|(depth, shown)| match shown {
            // Two rooms that were seen in part share what is between them.
            Shown::Room(_) => (depth - wall) / 2.0,
            _ => depth - wall + field.input.resolution,
        });
        let end = line.into_iter().chain(seen).min_by(f64::total_cmp)?;
        Some(edge + side.sense() * end.max(0.0))
    }
}
