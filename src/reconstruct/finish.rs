//! The last step: what was found becomes a layout in the map frame.

use super::Params;
use super::boundary::Run;
use super::inner;
use super::lines::Line;
use super::names::{self, Called};
use super::openings::Gap;
use super::outline::Outline;
use super::paper::{Built, Division};
use super::partial::is_frontier;
use super::walls::{self, Faces, Profile};
use planform_sdk::{
    Frontier, FrontierKind, Grid, Layout, Opening, Point, Polygon, RepresentativeLine, Room, RoomId,
    RoomState, Scene, Segment, Wall,
};
use std::collections::BTreeMap;

/// All that a layout is made of, in metres from the grid's corner.
pub struct Found<'a> {
    /// Lines, faces, edges.
    pub division: &'a Division,
    /// Rooms and boundaries.
    pub built: &'a Built,
    /// Openings.
    pub gaps: Vec<Gap>,
    /// For each room whether it is partial.
    pub partial: Vec<bool>,
}

/// The floor of each room within the inner faces of its walls, disjoint.
pub fn floors(
    outlines: &[Outline],
    lines: &[Line],
    runs: &[Run],
    profiles: &[Profile],
) -> Vec<Option<Polygon>> {
    let mut along: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (i, run) in runs.iter().enumerate() {
        for room in run.rooms.iter().flatten() {
            if let Some(line) = run.line {
                along.entry((*room, line)).or_default().push(i);
            }
        }
    }
    let inset = |room: usize, (a, b, line): (Point, Point, Option<usize>)| {
        let Some(line) = line else { return 0.0 };
        let (from, to) = (lines[line].along(a), lines[line].along(b));
        let runs_here = along.get(&(room, line)).into_iter().flatten();
        inset_of_side(from, to, runs_here.map(|&i| (&runs[i], &profiles[i])), &lines[line])
    };
    let mut floors: Vec<Option<Polygon>> = outlines
        .iter()
        .enumerate()
        .map(|(room, o)| inner::floor(o, &o.sides().map(|s| inset(room, s)).collect::<Vec<_>>()))
        .collect();
    let polygons: Vec<Polygon> = outlines.iter().map(Outline::polygon).collect();
    inner::part(&mut floors, &polygons);
    floors
}

/// How far inside a room's side its inner face lies: the median over the stations along it. A side that runs with
/// its line has the room to its left.
fn inset_of_side<'a>(
    from: f64,
    to: f64,
    runs: impl Iterator<Item = (&'a Run, &'a Profile)>,
    line: &Line,
) -> f64 {
    let (low, high) = (from.min(to), from.max(to));
    let mut insets: Vec<f64> = Vec::new();
    for (run, profile) in runs {
        let begin = line.along(run.segment.a);
        for (i, faces) in profile.stations.iter().enumerate() {
            let at = begin + (i as f64 + 0.5) * profile.step;
            if let Some(f) = faces.filter(|_| (low..=high).contains(&at)) {
                insets.push(if to > from { f.left } else { -f.right });
            }
        }
    }
    walls::median(&mut insets).unwrap_or(0.0)
}

/// The layout in the map frame.
pub fn layout(scene: &Scene, params: &Params, found: &Found<'_>) -> Layout {
    let frame = Frame(&scene.grid);
    Layout {
        rooms: rooms(scene, &frame, found),
        walls: walls(&frame, found, params),
        openings: found.gaps.iter().map(|g| opening(&frame, g)).collect(),
        frontiers: frontiers(&frame, found, params),
        lines: representative_lines(&frame, found.division),
        texts: scene.texts.clone(),
        symbols: scene.symbols.clone(),
        anchor: scene.anchor,
        scale: scene.scale.clone(),
        provenance: scene.provenance.clone(),
        method: params.method.name().into(),
    }
}

/// From metres in the grid to the map frame.
pub struct Frame<'a>(pub &'a Grid);

impl Frame<'_> {
    /// A point.
    pub fn point(&self, p: Point) -> Point {
        let resolution = self.0.resolution();
        self.0.to_map(Point::new(p.x / resolution, p.y / resolution))
    }

    /// A segment.
    pub fn segment(&self, s: Segment) -> Segment {
        Segment::new(self.point(s.a), self.point(s.b))
    }

    /// A polygon.
    pub fn polygon(&self, p: &Polygon) -> Polygon {
        let ring = |r: &Vec<Point>| r.iter().map(|&p| self.point(p)).collect();
        Polygon::new(ring(&p.exterior), p.holes.iter().map(ring).collect())
    }
}

/// The id of a room that is counted from 0.
pub fn id(room: usize) -> RoomId {
    room as RoomId + 1
}

fn rooms(scene: &Scene, frame: &Frame<'_>, found: &Found<'_>) -> Vec<Room> {
    let room = |(i, floor): (usize, &Polygon)| {
        let inner = frame.polygon(floor);
        let Called { name, stated_area } = names::of_room(&scene.texts, &inner);
        Room {
            id: id(i),
            name,
            stated_area,
            state: if found.partial[i] { RoomState::Partial } else { RoomState::Complete },
            centre: frame.polygon(&found.built.clusters.outlines[i].polygon()),
            inner,
        }
    };
    found.built.floors.iter().enumerate().map(room).collect()
}

fn walls(frame: &Frame<'_>, found: &Found<'_>, params: &Params) -> Vec<Wall> {
    let built = found.built;
    let along = built.runs.iter().zip(&built.profiles).filter(|(r, _)| !is_frontier(r, &params.partial));
    let wall = |(run, profile): (&Run, &Profile)| {
        let faces = profile.faces.unwrap_or(Faces::around(params.walls.unseen_thickness));
        let line =
            Segment::new(run.point(0.0, faces.middle()), run.point(run.segment.length(), faces.middle()));
        Wall {
            line: frame.segment(line),
            thickness: faces.thickness(),
            weight: run.weight.clamp(0.0, 1.0),
            rooms: run.rooms.map(|r| r.map(id)),
        }
    };
    along.map(wall).collect()
}

/// An opening in the map frame.
pub fn opening(frame: &Frame<'_>, gap: &Gap) -> Opening {
    let [a, b] = gap.rooms.map(id);
    Opening { kind: gap.kind, segment: frame.segment(gap.segment), rooms: [a.min(b), a.max(b)] }
}

fn frontiers(frame: &Frame<'_>, found: &Found<'_>, params: &Params) -> Vec<Frontier> {
    let open = found.built.runs.iter().filter(|r| is_frontier(r, &params.partial));
    let frontier = |run: &Run| {
        let room = run.rooms.iter().flatten().next()?;
        // The room is closed there, by a line or where the seen cells end: what lies behind is no part of it.
        let segment = frame.segment(run.segment);
        Some(Frontier { segment, room: id(*room), leads: FrontierKind::Space, area: 0.0 })
    };
    open.filter_map(frontier).collect()
}

fn representative_lines(frame: &Frame<'_>, division: &Division) -> Vec<RepresentativeLine> {
    let (low, high) = division.bounds;
    let line = |l: &Line| {
        let segment = l.within(low, high)?;
        Some(RepresentativeLine { segment: frame.segment(segment), support: l.support })
    };
    division.lines[..division.representative].iter().filter_map(line).collect()
}
