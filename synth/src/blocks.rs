//! Floor plans with rooms along the facade, a ring of corridor inside, and blocks of rooms or courtyards in the ring.

use crate::corridors::{back, room};
use crate::draft::Draft;
use crate::lattice::Rect;
use crate::params::{RoomKind, Size};
use crate::rng::Rng;
use crate::variety::Variety;

/// Typical measures, in cells of 0.1 m.
struct Style {
    foot: [(i32, i32); 2],
    depth: (i32, i32),
    width: (i32, i32),
}

const SCHOOL: Style = Style { foot: [(330, 700), (280, 520)], depth: (35, 90), width: (30, 110) };
const OFFICE: Style = Style { foot: [(190, 330), (150, 240)], depth: (28, 50), width: (24, 62) };

/// A row of rooms shall be at least this deep, in cells.
const LEAST_DEPTH: i32 = 22;

/// Draws a floor plan of this size.
pub(crate) fn draw(size: Size, variety: &Variety, rng: &mut Rng) -> Draft {
    let style = if size == Size::Office { &OFFICE } else { &SCHOOL };
    let mut draft = Draft::new(1500, 1200);
    let foot = Rect::new(300, 300, 300 + rng.int(style.foot[0]), 300 + rng.int(style.foot[1]));
    // At times a side has no rooms: there the corridor has the windows.
    let depths = [0; 4].map(|_| if rng.chance(0.12) { 0 } else { rng.int(style.depth) });
    let inside = inset(foot, depths);
    let court = inset(inside, [0; 4].map(|_| rng.int((14, 40))));
    let (blocks, ways) = split(court, rng);
    let ring = [
        Rect { y1: court.y0, ..inside },
        Rect { y0: court.y1, ..inside },
        Rect { x1: court.x0, ..inside },
        Rect { x0: court.x1, ..inside },
    ];
    let corridor: Vec<Rect> = ring.into_iter().chain(ways).collect();
    draft.add_corridor(&corridor);
    facade(&mut draft, foot, inside, style, variety, rng);
    for block in blocks {
        fill_block(&mut draft, block, style, variety, rng);
    }
    draft
}

/// The rectangle with these depths taken off its left, right, lower and upper side.
fn inset(r: Rect, [left, right, low, high]: [i32; 4]) -> Rect {
    Rect::new(r.x0 + left, r.y0 + low, (r.x1 - right).max(r.x0 + left + 1), (r.y1 - high).max(r.y0 + low + 1))
}

/// Cuts the court by cross corridors; returns the blocks and the corridors.
fn split(court: Rect, rng: &mut Rng) -> (Vec<Rect>, Vec<Rect>) {
    let mut blocks = vec![court];
    let mut ways = Vec::new();
    for _ in 0..rng.int((0, 3)) {
        let Some(i) = (0..blocks.len()).max_by_key(|&i| blocks[i].width() * blocks[i].height()) else {
            break;
        };
        let (block, width, at) = (blocks[i], rng.int((14, 36)), rng.int((25, 70)));
        let wide = block.width() >= block.height();
        let side = if wide { block.width() } else { block.height() };
        let cut = side * at / 100;
        if cut < 45 || side - cut - width < 45 {
            continue;
        }
        if wide {
            let x = block.x0 + cut;
            ways.push(Rect { x0: x, x1: x + width, ..block });
            blocks[i] = Rect { x1: x, ..block };
            blocks.push(Rect { x0: x + width, ..block });
        } else {
            let y = block.y0 + cut;
            ways.push(Rect { y0: y, y1: y + width, ..block });
            blocks[i] = Rect { y1: y, ..block };
            blocks.push(Rect { y0: y + width, ..block });
        }
    }
    (blocks, ways)
}

/// Rooms along the outer walls. The lower and upper rows have the corners.
fn facade(draft: &mut Draft, foot: Rect, inside: Rect, style: &Style, variety: &Variety, rng: &mut Rng) {
    let corners = [inside.x0 - foot.x0 + 20, foot.x1 - inside.x1 + 20];
    let rows = [
        (Rect { y1: inside.y0, ..foot }, true, false, corners),
        (Rect { y0: inside.y1, ..foot }, true, true, corners),
        (Rect { x1: inside.x0, y0: inside.y0, y1: inside.y1, ..foot }, false, true, [0; 2]),
        (Rect { x0: inside.x1, y0: inside.y0, y1: inside.y1, ..foot }, false, false, [0; 2]),
    ];
    for (rect, horizontal, left, ends) in rows {
        row(draft, rect, (horizontal, left), ends, style, variety, rng);
    }
}

/// One row of rooms; the first and the last are at least as wide as `ends` says.
fn row(
    draft: &mut Draft,
    rect: Rect,
    (horizontal, left): (bool, bool),
    ends: [i32; 2],
    style: &Style,
    variety: &Variety,
    rng: &mut Rng,
) {
    let (length, depth) =
        if horizontal { (rect.width(), rect.height()) } else { (rect.height(), rect.width()) };
    if depth < LEAST_DEPTH {
        return;
    }
    let uniform = rng.chance(0.4).then(|| rng.int(style.width));
    let mut at = 0;
    let mut before = None;
    while at < length {
        let least = if at == 0 { ends[0] } else { 0 };
        let narrow = uniform.is_none() && rng.chance(0.15);
        let want = if narrow { rng.int((14, 26)) } else { uniform.unwrap_or_else(|| rng.int(style.width)) };
        let want = want.max(least);
        let width = if length - at - want < ends[1].max(22) { length - at } else { want };
        let part = if horizontal {
            Rect { x0: rect.x0 + at, x1: rect.x0 + at + width, ..rect }
        } else {
            Rect { y0: rect.y0 + at, y1: rect.y0 + at + width, ..rect }
        };
        let inner = at > 0 && at + width < length;
        if inner && rng.chance(variety.alcoves) {
            draft.widen(0, part);
            before = None;
        } else {
            let id = room(draft, part, horizontal, left, rng);
            if let (Some(a), Some(b)) = (before, id)
                && rng.chance(variety.l_shapes)
            {
                draft.annex(a, b, back(part, (horizontal, left), rng.int((30, 55))));
            }
            before = id;
        }
        at += width;
    }
}

/// Fills a block with one room, one or two rows of rooms, or leaves it a courtyard.
fn fill_block(draft: &mut Draft, block: Rect, style: &Style, variety: &Variety, rng: &mut Rng) {
    let horizontal = block.width() >= block.height();
    let deep = block.width().min(block.height());
    let no_alcoves = Variety { alcoves: 0.0, ..*variety };
    match rng.index(10) {
        0..=2 => (),
        3 => {
            draft.add(block, if deep > 90 { RoomKind::Hall } else { RoomKind::Room });
        }
        _ if deep >= 2 * LEAST_DEPTH + 10 && rng.chance(0.8) => {
            let cut = deep * rng.int((35, 65)) / 100;
            let halves = if horizontal {
                [Rect { y1: block.y0 + cut, ..block }, Rect { y0: block.y0 + cut, ..block }]
            } else {
                [Rect { x1: block.x0 + cut, ..block }, Rect { x0: block.x0 + cut, ..block }]
            };
            // The back of each row is the middle of the block.
            for (half, left) in halves.into_iter().zip([horizontal, !horizontal]) {
                row(draft, half, (horizontal, left), [0; 2], style, &no_alcoves, rng);
            }
        }
        _ => row(draft, block, (horizontal, true), [0; 2], style, &no_alcoves, rng),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corridor_runs_around_at_least_one_block() {
        let holes = (0..20).map(|seed| {
            let draft = draw(Size::School, &Variety::default(), &mut Rng::new(seed, 0));
            draft.lattice.trace(draft.rooms[0].frame, 1).len() - 1
        });
        let holes: Vec<usize> = holes.collect();
        assert!(holes.iter().all(|&h| h >= 1) && holes.iter().any(|&h| h >= 3), "{holes:?}");
    }
}
