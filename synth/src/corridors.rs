//! Floor plans along corridors: schools and offices.

use crate::draft::Draft;
use crate::lattice::Rect;
use crate::params::{RoomKind, Size};
use crate::rng::Rng;
use crate::variety::Variety;

/// Typical measures, in cells of 0.1 m.
struct Style {
    length: (i32, i32),
    arm: (i32, i32),
    corridor: (i32, i32),
    width: (i32, i32),
    depth: (i32, i32),
    hall: f64,
}

const SCHOOL: Style = Style {
    length: (420, 780),
    arm: (160, 330),
    corridor: (20, 36),
    width: (48, 100),
    depth: (50, 85),
    hall: 0.7,
};

const OFFICE: Style = Style {
    length: (190, 320),
    arm: (90, 160),
    corridor: (15, 24),
    width: (27, 62),
    depth: (36, 62),
    hall: 0.0,
};

/// A straight piece of corridor.
#[derive(Clone, Copy)]
struct Leg {
    rect: Rect,
    horizontal: bool,
}

impl Leg {
    fn length(self) -> i32 {
        if self.horizontal { self.rect.width() } else { self.rect.height() }
    }

    /// The rectangle from `from` to `to` along the leg and `depth` deep beside it, `left` or right of its direction.
    fn strip(self, left: bool, (from, to): (i32, i32), depth: i32) -> Rect {
        let r = self.rect;
        match (self.horizontal, left) {
            (true, true) => Rect::new(r.x0 + from, r.y1, r.x0 + to, r.y1 + depth),
            (true, false) => Rect::new(r.x0 + from, r.y0 - depth, r.x0 + to, r.y0),
            (false, true) => Rect::new(r.x0 - depth, r.y0 + from, r.x0, r.y0 + to),
            (false, false) => Rect::new(r.x1, r.y0 + from, r.x1 + depth, r.y0 + to),
        }
    }
}

/// A drawn plan and where a wing could be joined to it.
pub(crate) struct CorridorPlan {
    pub(crate) draft: Draft,
    /// The corridor whose right end is the building's right end, if there is one.
    pub(crate) right_end: Option<Rect>,
    /// The corridor at the left end of a straight plan.
    pub(crate) left_end: Option<Rect>,
}

/// Draws a floor plan of this size around a corridor of any shape.
pub(crate) fn draw(size: Size, variety: &Variety, rng: &mut Rng) -> CorridorPlan {
    let style = if size == Size::Office { &OFFICE } else { &SCHOOL };
    let shape = rng.index(if size == Size::Office { 4 } else { 6 });
    let mut draft = Draft::new(1500, 1200);
    let legs = skeleton(style, shape, rng);
    paint_corridors(&mut draft, &legs, rng);
    let straight = shape == 0 || shape == 3;
    if !straight && rng.chance(0.5) {
        end_room(&mut draft, &legs, rng);
    }
    for &leg in &legs {
        open_ends(&mut draft, leg, variety, rng);
    }
    fill(&mut draft, &legs, style, variety, rng);
    let end = straight.then(|| legs[0].rect);
    CorridorPlan { draft, right_end: end, left_end: None }
}

/// Draws a wing: one corridor with rooms on both sides, nothing beyond its ends.
pub(crate) fn draw_wing(size: Size, variety: &Variety, rng: &mut Rng) -> CorridorPlan {
    let style = if size == Size::Office { &OFFICE } else { &SCHOOL };
    let mut draft = Draft::new(600, 600);
    let leg = main_leg((100, 300), (style.arm.0, style.arm.1), style, rng);
    paint_corridors(&mut draft, &[leg], rng);
    fill(&mut draft, &[leg], &Style { hall: 0.0, ..*style }, variety, rng);
    CorridorPlan { draft, right_end: None, left_end: Some(leg.rect) }
}

fn main_leg((x, y): (i32, i32), length: (i32, i32), style: &Style, rng: &mut Rng) -> Leg {
    let (length, width) = (rng.int(length), rng.int(style.corridor));
    Leg { rect: Rect::new(x, y, x + length, y + width), horizontal: true }
}

/// The corridor's legs: straight (0 and 3), L, T, U, ring.
fn skeleton(style: &Style, shape: usize, rng: &mut Rng) -> Vec<Leg> {
    let length = match shape {
        4 | 5 => (style.length.0, style.length.1 * 8 / 10),
        _ => style.length,
    };
    let main = main_leg((350, 500), length, style, rng);
    let m = main.rect;
    let arm = |at: i32, rng: &mut Rng| {
        let (width, length) = (rng.int(style.corridor), rng.int(style.arm));
        let up = rng.chance(0.5);
        let (y0, y1) = if up { (m.y1, m.y1 + length) } else { (m.y0 - length, m.y0) };
        Leg { rect: Rect::new(at, y0, at + width, y1), horizontal: false }
    };
    match shape {
        0 | 3 => vec![main],
        1 => {
            let at = if rng.chance(0.5) { m.x0 } else { m.x1 - 30 };
            vec![main, arm(at, rng)]
        }
        2 => {
            let at = m.x0 + m.width() * rng.int((30, 65)) / 100;
            vec![main, arm(at, rng)]
        }
        4 => vec![main, up_leg(m, m.x0, style, rng), up_leg(m, m.x1 - 30, style, rng)],
        _ => ring(main, style, rng),
    }
}

fn up_leg(m: Rect, at: i32, style: &Style, rng: &mut Rng) -> Leg {
    let (width, length) = (rng.int(style.corridor), rng.int(style.arm));
    Leg { rect: Rect::new(at, m.y1, at + width, m.y1 + length), horizontal: false }
}

/// Four legs around a courtyard.
fn ring(main: Leg, style: &Style, rng: &mut Rng) -> Vec<Leg> {
    let m = main.rect;
    let m = Rect { x1: m.x1.min(m.x0 + 560), ..m };
    let gap = rng.int((130, 260));
    let widths = [0; 3].map(|_| rng.int(style.corridor));
    let (y, top) = (m.y1, m.y1 + gap);
    let left = Rect::new(m.x0, y, m.x0 + widths[0], top);
    let right = Rect::new(m.x1 - widths[1], y, m.x1, top);
    let upper = Rect::new(m.x0, top, m.x1, top + widths[2]);
    [(m, true), (upper, true), (left, false), (right, false)]
        .map(|(rect, horizontal)| Leg { rect, horizontal })
        .to_vec()
}

/// Paints the legs as one room, or as several with a wall between them.
fn paint_corridors(draft: &mut Draft, legs: &[Leg], rng: &mut Rng) {
    let rects: Vec<Rect> = legs.iter().map(|l| l.rect).collect();
    let main = rects[0];
    if rects.len() > 1 && rng.chance(0.5) {
        draft.add_corridor(&rects);
        return;
    }
    let cut = main.x0 + main.width() * rng.int((35, 65)) / 100;
    if main.width() > 250 && rng.chance(0.4) {
        draft.add_corridor(&[Rect { x1: cut, ..main }]);
        draft.add_corridor(&[Rect { x0: cut, ..main }]);
    } else {
        draft.add_corridor(&[main]);
    }
    for &rect in &rects[1..] {
        draft.add_corridor(&[rect]);
    }
}

/// A room across the far end of the last leg.
fn end_room(draft: &mut Draft, legs: &[Leg], rng: &mut Rng) {
    let Some(leg) = legs.last().filter(|l| !l.horizontal) else { return };
    let (wide, deep) = (rng.int((50, 110)), rng.int((45, 80)));
    let middle = (leg.rect.x0 + leg.rect.x1) / 2 + rng.int((-20, 20));
    let up = leg.rect.y0 >= legs[0].rect.y1;
    let y = if up { leg.rect.y1 } else { leg.rect.y0 - deep };
    let rect = Rect::new(middle - wide / 2, y, middle + wide / 2, y + deep);
    if draft.lattice.is_empty(rect) {
        draft.add(rect, RoomKind::Room);
    }
}

/// Large rooms across the ends of a leg.
fn open_ends(draft: &mut Draft, leg: Leg, variety: &Variety, rng: &mut Rng) {
    let r = leg.rect;
    for far in [false, true] {
        if !rng.wants(variety.open_ends) {
            continue;
        }
        let (wide, deep) = (rng.int((45, 160)), rng.int((40, 150)));
        let across = if leg.horizontal { (r.y0, r.y1) } else { (r.x0, r.x1) };
        // The room reaches past the corridor on both sides.
        let from = rng.int((across.1 + 13 - wide, across.0 - 13));
        let at = match (leg.horizontal, far) {
            (true, true) => Rect::new(r.x1, from, r.x1 + deep, from + wide),
            (true, false) => Rect::new(r.x0 - deep, from, r.x0, from + wide),
            (false, true) => Rect::new(from, r.y1, from + wide, r.y1 + deep),
            (false, false) => Rect::new(from, r.y0 - deep, from + wide, r.y0),
        };
        if draft.lattice.is_empty(at) {
            draft.add(at, if wide * deep > 10_000 { RoomKind::Hall } else { RoomKind::Room });
        }
    }
}

fn fill(draft: &mut Draft, legs: &[Leg], style: &Style, variety: &Variety, rng: &mut Rng) {
    if rng.chance(style.hall) {
        hall(draft, legs[0], rng);
    }
    for &leg in legs {
        for left in [true, false] {
            fill_side(draft, leg, left, style, variety, rng);
        }
    }
}

/// A big hall somewhere along the leg.
fn hall(draft: &mut Draft, leg: Leg, rng: &mut Rng) {
    let (wide, deep) = (rng.int((140, 260)), rng.int((110, 190)));
    let from = rng.int((0, (leg.length() - wide).max(0)));
    let rect = leg.strip(rng.chance(0.4), (from, from + wide), deep);
    if draft.lattice.is_empty(rect) {
        draft.add(rect, RoomKind::Hall);
    }
}

/// Lines one side of a leg with rooms, wherever there is place.
fn fill_side(draft: &mut Draft, leg: Leg, left: bool, style: &Style, variety: &Variety, rng: &mut Rng) {
    let mut depth = rng.int(style.depth);
    let mut at = 0;
    let mut before = None;
    while at < leg.length() {
        let stretch = free_stretch(draft, leg, left, at);
        if stretch == 0 {
            at += 1;
            continue;
        }
        if rng.chance(0.22) {
            depth = rng.int(style.depth);
        }
        let width = room_width(stretch, style, rng);
        let gap = width > 30 && rng.chance(0.03);
        let place = leg.strip(left, (at, at + width), depth);
        if rng.wants(variety.alcoves) {
            let deep = if rng.chance(0.6) { rng.int((4, 30)) } else { depth };
            alcove(draft, leg, left, (at, at + width), deep);
            before = None;
        } else if !gap {
            let id = room(draft, place, leg.horizontal, left, rng);
            if let (Some(a), Some(b)) = (before, id)
                && rng.wants(variety.l_shapes)
            {
                draft.annex(a, b, back(place, (leg.horizontal, left), rng.int((30, 55))));
            }
            before = id;
        }
        at += width;
    }
}

/// Widens the corridor beside the leg.
fn alcove(draft: &mut Draft, leg: Leg, left: bool, (from, to): (i32, i32), depth: i32) {
    let at = leg.rect;
    let (x, y) = if leg.horizontal { (at.x0 + from, at.y0) } else { (at.x0, at.y0 + from) };
    let label = draft.lattice.label(x, y);
    if label > 0 && usize::from(label) <= draft.rooms.len() {
        draft.widen(usize::from(label) - 1, leg.strip(left, (from, to), depth));
    }
}

/// The number of cells along the leg, from `at`, that are empty beside it.
fn free_stretch(draft: &Draft, leg: Leg, left: bool, at: i32) -> i32 {
    let free = |&i: &i32| draft.lattice.is_empty(leg.strip(left, (i, i + 1), 12));
    (at..leg.length()).take_while(free).count() as i32
}

fn room_width(stretch: i32, style: &Style, rng: &mut Rng) -> i32 {
    let narrow = rng.chance(0.25);
    let want = if narrow { rng.int((18, style.width.0)) } else { rng.int(style.width) };
    if stretch - want < 20 { stretch } else { want }
}

/// A room beside a corridor, at times divided.
pub(crate) fn room(
    draft: &mut Draft,
    rect: Rect,
    horizontal: bool,
    left: bool,
    rng: &mut Rng,
) -> Option<usize> {
    let along = if horizontal { rect.width() } else { rect.height() };
    let kind = if along < 26 { RoomKind::Small } else { RoomKind::Room };
    let id = draft.add(rect, kind)?;
    match rng.index(20) {
        0..=2 => en_suite(draft, id, rect, (horizontal, left), rng),
        3..=5 => cupboard(draft, id, rect, rng),
        6 | 7 => toilets(draft, id, rect, horizontal, rng),
        _ => (),
    }
    Some(id)
}

/// Parts off the back of a room; it is reached through the front only.
fn en_suite(draft: &mut Draft, id: usize, rect: Rect, way: (bool, bool), rng: &mut Rng) {
    draft.carve(id, back(rect, way, rng.int((35, 55))), RoomKind::Room, Some(id));
}

/// So many percent of a room that lie away from its corridor, which is `horizontal`, the room to its `left` or not.
pub(crate) fn back(rect: Rect, (horizontal, left): (bool, bool), percent: i32) -> Rect {
    let deep = if horizontal { rect.height() } else { rect.width() };
    let part = deep * percent / 100;
    match (horizontal, left) {
        (true, true) => Rect { y0: rect.y1 - part, ..rect },
        (true, false) => Rect { y1: rect.y0 + part, ..rect },
        (false, true) => Rect { x1: rect.x0 + part, ..rect },
        (false, false) => Rect { x0: rect.x1 - part, ..rect },
    }
}

/// Parts a store off a corner.
fn cupboard(draft: &mut Draft, id: usize, rect: Rect, rng: &mut Rng) {
    let (w, h) = (rng.int((14, 28)), rng.int((14, 28)));
    let (x, y) = if rng.chance(0.5) { (rect.x0, rect.y0) } else { (rect.x1 - w, rect.y1 - h) };
    draft.carve(id, Rect::new(x, y, x + w, y + h), RoomKind::Small, Some(id));
}

/// Splits a room across the corridor into narrow ones, each with its own door.
fn toilets(draft: &mut Draft, id: usize, rect: Rect, horizontal: bool, rng: &mut Rng) {
    let width = rng.int((17, 26));
    let along = if horizontal { rect.width() } else { rect.height() };
    for i in 0..(along / width - 1).clamp(0, 3) {
        let part = if horizontal {
            Rect::new(rect.x0 + i * width, rect.y0, rect.x0 + (i + 1) * width, rect.y1)
        } else {
            Rect::new(rect.x0, rect.y0 + i * width, rect.x1, rect.y0 + (i + 1) * width)
        };
        draft.carve(id, part, RoomKind::Small, None);
    }
}
