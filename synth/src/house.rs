//! Floor plans of dwellings: a rectangle split again and again, often around a hallway.

use crate::draft::Draft;
use crate::lattice::Rect;
use crate::params::RoomKind;
use crate::rng::Rng;

/// No part of a house is narrower, in cells of 0.1 m.
const LEAST_SIDE: i32 = 17;

/// Draws a house.
pub(crate) fn draw(rng: &mut Rng) -> Draft {
    let mut draft = Draft::new(300, 300);
    let foot = Rect::new(80, 80, 80 + rng.int((85, 140)), 80 + rng.int((70, 110)));
    let target = rng.int((5, 8)) as usize;
    let mut leaves = if rng.chance(0.65) { hallway(&mut draft, foot, rng) } else { vec![foot] };
    let halls = draft.rooms.len();
    while leaves.len() + halls < target && split_largest(&mut leaves, rng) {}
    for leaf in leaves {
        let small = leaf.width().min(leaf.height()) < 22;
        draft.add(leaf, if small { RoomKind::Small } else { RoomKind::Room });
    }
    draft
}

/// Paints a hallway and returns what is left of the footprint on its two sides and beyond its end.
fn hallway(draft: &mut Draft, foot: Rect, rng: &mut Rng) -> Vec<Rect> {
    let width = rng.int((13, 22));
    let y = foot.y0 + foot.height() * rng.int((35, 55)) / 100;
    let end = foot.x0 + foot.width() * rng.int((55, 75)) / 100;
    draft.add_corridor(&[Rect::new(foot.x0, y, end, y + width)]);
    let beyond = Rect { x0: end, ..foot };
    let sides = [Rect { y0: y + width, x1: end, ..foot }, Rect { y1: y, x1: end, ..foot }];
    sides.into_iter().chain([beyond]).collect()
}

fn split_largest(leaves: &mut Vec<Rect>, rng: &mut Rng) -> bool {
    let Some(i) = (0..leaves.len()).max_by_key(|&i| leaves[i].width() * leaves[i].height()) else {
        return false;
    };
    let Some((a, b)) = split(leaves[i], rng) else { return false };
    leaves[i] = a;
    leaves.push(b);
    true
}

fn split(r: Rect, rng: &mut Rng) -> Option<(Rect, Rect)> {
    let part = |side: i32, rng: &mut Rng| {
        let cut = side * rng.int((32, 62)) / 100;
        (cut >= LEAST_SIDE && side - cut >= LEAST_SIDE).then_some(cut)
    };
    if r.width() >= r.height() {
        let x = r.x0 + part(r.width(), rng)?;
        Some((Rect { x1: x, ..r }, Rect { x0: x, ..r }))
    } else {
        let y = r.y0 + part(r.height(), rng)?;
        Some((Rect { y1: y, ..r }, Rect { y0: y, ..r }))
    }
}
