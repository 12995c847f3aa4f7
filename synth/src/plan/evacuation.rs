//! What makes an evacuation plan: escape routes, signs, header, legend.

use super::drawing::{Drawing, Line, block};
use super::gaps::{Gap, Purpose as GapPurpose};
use super::letters::Face;
use super::margin::{aside, write_left};
use super::paper::Area;
use super::places::{against_wall, anywhere};
use super::rooms::Purpose;
use super::signs::{Sign, stamp};
use super::surface::{Colour, Pen};
use super::truth::PlanTextRole;
use crate::furniture::{Block, Extent, extent};
use planform_sdk::{Point, Room};

/// Metres from arrow to arrow.
const ARROWS: f64 = 4.5;

/// What signs there are for, the legend's words for them, and how many there are for a hundred square metres.
const KINDS: [(&str, &str, f64); 5] = [
    ("fire-extinguisher", "Fire extinguisher", 1.6),
    ("fire-hose-reel", "Fire hose reel", 0.7),
    ("fire-alarm-call-point", "Fire alarm call point", 0.7),
    ("first-aid", "First aid", 0.5),
    ("emergency-exit", "Emergency exit", 0.4),
];

/// Colours the floor of the ways out. Comes before all else.
pub(super) fn routes(drawing: &mut Drawing, purposes: &[Purpose]) {
    let Some(colour) = drawing.look.evacuation.route else { return };
    let rooms = drawing.site.layout.rooms.iter().zip(purposes);
    for (room, _) in rooms.filter(|(_, p)| **p == Purpose::Corridor) {
        drawing.picture.fill(room.inner.rings(), colour);
    }
}

/// Arrows and signs.
pub(super) fn draw(drawing: &mut Drawing, purposes: &[Purpose], gaps: &[Gap]) {
    let Some(signs) = Signs::draw(drawing) else { return };
    let exits: Vec<&Gap> =
        gaps.iter().filter(|g| g.rooms[1].is_none() && g.purpose != GapPurpose::Window).collect();
    let rooms = drawing.site.layout.rooms.clone();
    let corridors: Vec<&Room> =
        rooms.iter().zip(purposes).filter(|(_, p)| **p == Purpose::Corridor).map(|(r, _)| r).collect();
    exits.iter().for_each(|exit| at_exit(drawing, &signs, exit));
    you_are_here(drawing, &signs, &corridors, &rooms);
    equipment(drawing, &signs, &rooms, &corridors);
    for corridor in &corridors {
        arrows(drawing, corridor, &exits);
    }
    assembly_point(drawing, &signs);
    header(drawing);
    legend(drawing, &signs);
}

/// The signs of this plan: one drawing for each kind.
struct Signs {
    kinds: Vec<Sign>,
    here: Sign,
    assembly: Sign,
    side: f64,
}

impl Signs {
    fn draw(drawing: &mut Drawing) -> Option<Self> {
        let rng = &mut drawing.rng;
        let kinds: Option<Vec<Sign>> = KINDS.iter().map(|(kind, _, _)| Sign::draw(kind, rng)).collect();
        let (here, assembly) = (Sign::draw("you-are-here", rng)?, Sign::draw("assembly-point", rng)?);
        let least = 26.0 * drawing.view.metres_per_pixel();
        let side = drawing.view.mm(drawing.look.evacuation.sign).max(least);
        Some(Self { kinds: kinds?, here, assembly, side })
    }
}

/// The sign of an exit, inside, beside its door.
fn at_exit(drawing: &mut Drawing, signs: &Signs, exit: &Gap) {
    let Some(room) = exit.rooms[0].and_then(|id| drawing.site.room(id)).cloned() else { return };
    let (wide, high) = signs.kinds[4].size(signs.side);
    let reach = wide.max(high) / 2.0;
    let (length, off) = (exit.segment.length(), exit.depth / 2.0 + reach + 0.08);
    let beside = reach + 0.15;
    let ways = [-beside, length + beside].into_iter().map(|u| (u, off));
    let before = (0..6).map(|i| (length / 2.0, off + length * (0.6 + 0.3 * f64::from(i))));
    for (u, v) in ways.chain(before) {
        let place = block(exit.at(u, v), (1.0, 0.0), wide, high);
        if drawing.take(&room, place, 0.1) {
            return stamp(drawing, &signs.kinds[4], place.middle, signs.side, true);
        }
    }
}

fn you_are_here(drawing: &mut Drawing, signs: &Signs, corridors: &[&Room], others: &[Room]) {
    let mut rooms: Vec<&Room> = corridors.to_vec();
    drawing.rng.shuffle(&mut rooms);
    rooms.extend(others);
    let size = signs.here.size(signs.side);
    let found = rooms.iter().find_map(|room| Some((*room, upright(drawing, room, size, false)?)));
    let Some((room, place)) = found else { return };
    stamp(drawing, &signs.here, place.middle, signs.side, true);
    let capital = drawing.view.mm(drawing.look.capital);
    let line = drawing.line("You are here", capital, PlanTextRole::Remark);
    let (wide, high) = drawing.measure(&line);
    let reach = signs.side / 2.0 + 0.6 * capital;
    let tries = [
        Point::new(place.middle.x + reach + wide / 2.0, place.middle.y),
        Point::new(place.middle.x - reach - wide / 2.0, place.middle.y),
        Point::new(place.middle.x, place.middle.y - reach - high / 2.0),
    ];
    for middle in tries {
        if drawing.take(room, block(middle, (1.0, 0.0), wide, high), 0.3 * capital) {
            let line = Line { room: Some(room.id), ..line };
            return drawing.write(line, middle, 0.0);
        }
    }
}

/// Extinguishers and the rest: two thirds in corridors.
fn equipment(drawing: &mut Drawing, signs: &Signs, rooms: &[Room], corridors: &[&Room]) {
    let floor: f64 = rooms.iter().map(Room::area).sum();
    for (i, (_, _, often)) in KINDS.iter().enumerate() {
        let count = (often * floor / 100.0 * drawing.rng.range((0.4, 1.3))).ceil().min(8.0) as u32;
        for _ in 0..count {
            let in_corridor = !corridors.is_empty() && drawing.rng.chance(0.66);
            let room = if in_corridor {
                corridors[drawing.rng.index(corridors.len())]
            } else {
                &rooms[drawing.rng.index(rooms.len())]
            };
            if let Some(place) = upright(drawing, room, signs.kinds[i].size(signs.side), true) {
                stamp(drawing, &signs.kinds[i], place.middle, signs.side, true);
            }
        }
    }
}

/// A free upright place, at a wall if it is wished.
fn upright(drawing: &mut Drawing, room: &Room, (wide, high): (f64, f64), at_wall: bool) -> Option<Block> {
    let mark = drawing.taken.len();
    let place = if at_wall {
        against_wall(drawing, room, (wide, high), 0.12, Drawing::take)
    } else {
        anywhere(drawing, room, (wide, high), 0.12, Drawing::take)
    }?;
    // What is wider than high fits along level walls only.
    let square = (wide - high).abs() < 1e-9;
    let askew = place.along.1.abs() > 1e-3 && !(square && place.along.0.abs() < 1e-3);
    if askew {
        drawing.taken.truncate(mark);
    }
    (!askew).then_some(Block { along: (1.0, 0.0), ..place })
}

/// Arrows along a corridor, each to the exit that is nearest along it.
fn arrows(drawing: &mut Drawing, room: &Room, exits: &[&Gap]) {
    let Some(Extent { corner, along: (x, y), size }) = extent(&room.inner.exterior) else { return };
    let count = (size.0 / ARROWS).floor().max(1.0);
    let long = (0.55 * size.1).clamp(0.7, 1.6);
    for i in 0..count as i32 {
        let (u, v) = ((f64::from(i) + 0.5) / count * size.0, size.1 / 2.0);
        let middle = Point::new(corner.x + x * u - y * v, corner.y + y * u + x * v);
        let distance = |e: &&&Gap| e.segment.midpoint().distance(middle);
        let nearest = exits.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let ahead = nearest.is_none_or(|e| {
            let m = e.segment.midpoint();
            (m.x - middle.x) * x + (m.y - middle.y) * y >= 0.0
        });
        let along = if ahead { (x, y) } else { (-x, -y) };
        let place = block(middle, along, long, long * 0.5);
        if drawing.take(room, place, 0.05) {
            arrow(drawing, &place);
        }
    }
}

fn arrow(drawing: &mut Drawing, place: &Block) {
    let (l, d) = (place.half_length, place.half_depth);
    let shape = [
        (-l, -0.4 * d),
        (0.1 * l, -0.4 * d),
        (0.1 * l, -d),
        (l, 0.0),
        (0.1 * l, d),
        (0.1 * l, 0.4 * d),
        (-l, 0.4 * d),
    ];
    let colour = drawing.look.evacuation.arrow;
    drawing.picture.fill([shape.map(|(u, v)| place.at(u, v)).as_slice()], colour);
}

/// Where people gather: outside of the building, if the sheet has space beside it.
fn assembly_point(drawing: &mut Drawing, signs: &Signs) {
    let (low, high) = drawing.site.bounds();
    let (w, h) = drawing.view.size();
    let side = signs.side * 1.2;
    let off = side * 0.75;
    let tries = [
        Point::new(low.x + off, low.y + off),
        Point::new(high.x - off, low.y + off),
        Point::new(low.x + off, high.y - off),
        Point::new(high.x - off, high.y - off),
        Point::new(low.x - off, (low.y + high.y) / 2.0),
        Point::new((low.x + high.x) / 2.0, low.y - off),
    ];
    for middle in tries {
        let place = block(middle, (1.0, 0.0), side * 1.3, side * 1.3);
        let on_paper = place.corners().iter().all(|p| p.x > 0.0 && p.y > 0.0 && p.x < w && p.y < h);
        if on_paper && is_outside(drawing, &place) {
            return stamp(drawing, &signs.assembly, middle, side, true);
        }
    }
}

fn is_outside(drawing: &Drawing, place: &Block) -> bool {
    let larger = Block { half_length: place.half_length + 0.3, half_depth: place.half_depth + 0.3, ..*place };
    let rooms = &drawing.site.layout.rooms;
    let covers = |p: Point| rooms.iter().any(|r| r.centre.contains(p));
    let corners = rooms.iter().flat_map(|r| &r.centre.exterior);
    let free_of_doors = drawing.taken.iter().all(|t| !super::drawing::contains(&larger, t.middle));
    let points = larger.corners();
    let edges = points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a.midpoint(*b));
    free_of_doors
        && !edges.chain(points.iter().copied()).any(covers)
        && corners.into_iter().all(|&p| !super::drawing::contains(&larger, p))
}

fn header(drawing: &mut Drawing) {
    let Some(area) = drawing.paper.header else { return };
    let colour: Option<Colour> = [Some([0, 132, 79]), Some([0, 90, 160]), None][drawing.rng.index(3)];
    if let Some(colour) = colour {
        drawing.picture.fill([area.ring().as_slice()], colour);
    }
    let capital = (area.high.y - area.low.y) * 0.38;
    let text = ["EVACUATION PLAN", "Escape and Rescue Plan", "Fire Evacuation Plan"][drawing.rng.index(3)];
    let ink = if colour.is_some() { [255; 3] } else { drawing.look.ink };
    let line = Line { face: Face::Bold, colour: ink, ..aside(drawing, text, capital) };
    write_left(drawing, line, area.low.x + drawing.view.mm(4.0), area.middle().y);
}

/// What the signs mean, and what to do.
fn legend(drawing: &mut Drawing, signs: &Signs) {
    let Some(area) = drawing.paper.legend else { return };
    let mm = drawing.view.mm(1.0);
    let frame = Pen { width: drawing.view.mm(0.3), colour: drawing.look.ink };
    let side = drawing.view.mm(6.0).max(signs.side.min(drawing.view.mm(7.0)));
    let capital = drawing.view.mm(drawing.look.capital);
    let room = ((area.high.y - area.low.y - 12.0 * mm) / (side + 2.5 * mm)).floor() as usize;
    if room < 3 {
        return;
    }
    let shown: Vec<(usize, &str)> = KINDS.iter().enumerate().map(|(i, k)| (i, k.1)).take(room).collect();
    let foot = area.high.y - 12.0 * mm - (side + 2.5 * mm) * shown.len() as f64;
    let ring = Area { low: Point::new(area.low.x, foot), high: area.high }.ring();
    drawing.picture.rings([ring.as_slice()], frame);
    let title = Line { face: Face::Bold, ..aside(drawing, "Legend", capital * 1.2) };
    write_left(drawing, title, area.low.x + 3.0 * mm, area.high.y - 5.0 * mm);
    for (row, (i, words)) in shown.into_iter().enumerate() {
        let y = area.high.y - 10.0 * mm - (side + 2.5 * mm) * (row as f64 + 0.5);
        let wide = signs.kinds[i].size(side).0;
        stamp(drawing, &signs.kinds[i], Point::new(area.low.x + 3.0 * mm + wide / 2.0, y), side, false);
        let line = aside(drawing, words, capital);
        write_left(drawing, line, area.low.x + 6.0 * mm + wide.max(side), y);
    }
}
