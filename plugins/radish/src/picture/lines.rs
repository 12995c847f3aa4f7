//! Takes coloured lines off a map: from outside in, each of their pixels becomes what most of its neighbours are. The
//! robot went there, so that free space wins where it is among them as often as anything else.

use super::greys::Meaning;
use planform_sdk::Cell;

/// What pixels are told apart by.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Free,
    Wall,
    Unknown,
}

/// Gives the pixels that are drawn the grey of what lies around them; those with nothing around them become free.
pub fn remove(shades: &mut [Option<u8>], drawn: &[bool], width: usize, meaning: &Meaning) {
    let mut open = drawn.to_vec();
    let mut rim: Vec<usize> = (0..open.len()).filter(|i| open[*i]).collect();
    while !rim.is_empty() {
        let taken = |i: &usize| Some((*i, majority(*i, shades, &open, width, meaning)?));
        let found: Vec<(usize, Option<u8>)> = rim.iter().filter_map(taken).collect();
        if found.is_empty() {
            rim.iter().for_each(|i| shades[*i] = Some(meaning.free));
            return;
        }
        for (i, shade) in found {
            shades[i] = shade;
            open[i] = false;
        }
        rim.retain(|i| open[*i]);
    }
}

/// The grey of what most neighbours are, if any is known.
fn majority(
    i: usize,
    shades: &[Option<u8>],
    open: &[bool],
    width: usize,
    meaning: &Meaning,
) -> Option<Option<u8>> {
    let kinds: Vec<Kind> =
        around(i, width, open.len()).filter(|n| !open[*n]).map(|n| kind(shades[n], meaning)).collect();
    let count = |kind: Kind| kinds.iter().filter(|k| **k == kind).count();
    let (free, wall, unknown) = (count(Kind::Free), count(Kind::Wall), count(Kind::Unknown));
    if kinds.is_empty() {
        None
    } else if free >= wall.max(unknown) {
        Some(Some(meaning.free))
    } else {
        Some(if wall >= unknown { Some(meaning.wall) } else { meaning.unknown })
    }
}

fn kind(shade: Option<u8>, meaning: &Meaning) -> Kind {
    match meaning.cell(shade) {
        Cell::UNKNOWN => Kind::Unknown,
        cell if cell.occupancy().is_some_and(|percent| percent > 50) => Kind::Wall,
        _ => Kind::Free,
    }
}

/// The up to eight neighbours.
fn around(i: usize, width: usize, pixels: usize) -> impl Iterator<Item = usize> {
    let (x, y, height) = (i % width, i / width, pixels / width);
    let rows = y.saturating_sub(1)..(y + 2).min(height);
    rows.flat_map(move |row| {
        (x.saturating_sub(1)..(x + 2).min(width)).map(move |column| row * width + column)
    })
    .filter(move |n| *n != i)
}
