//! Identifiers that stay with an object as long as it is what it is.

use crate::grain::Grain;
use crate::thread::TOLERANCE;
use std::collections::BTreeSet;

/// How many identifiers there are: a number below 2^52 survives every program, those that keep them as doubles too.
const SPACE: u64 = 1 << 52;

/// What an object is, as far as its identifier goes: its kind and level, then its corners.
pub type Key = (String, Vec<Grain>);

/// The identifiers of the objects with these keys, all below 0 and no two of them equal.
///
/// Each is a hash of its key. Where two hashes fall together, or two keys are equal, the lesser key (of equal ones the
/// first) is served first, and the other one tries the next hash.
pub fn assign(keys: &[Key]) -> Vec<i64> {
    assign_within(keys, SPACE)
}

fn assign_within(keys: &[Key], space: u64) -> Vec<i64> {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_by_key(|&i| &keys[i]);
    let (mut taken, mut ids) = (BTreeSet::new(), vec![0; keys.len()]);
    for i in order {
        ids[i] = first_free(&keys[i], space, &mut taken);
    }
    ids
}

fn first_free(key: &Key, space: u64, taken: &mut BTreeSet<i64>) -> i64 {
    let mut id = candidate(hash(key), space);
    let mut seed = hash(key);
    while !taken.insert(id) {
        seed = mixed(seed, &1u64.to_le_bytes());
        id = candidate(seed, space);
    }
    id
}

fn candidate(hash: u64, space: u64) -> i64 {
    // The upper bits of FNV are the better ones.
    -1 - ((hash ^ (hash >> 32)) % space).cast_signed()
}

/// FNV-1a over the key, the same on every machine and in every version: `std`'s hashes promise neither.
fn hash((kind, corners): &Key) -> u64 {
    let seed = mixed(0xcbf2_9ce4_8422_2325, kind.as_bytes());
    corners.iter().fold(seed, |hash, p| mixed(mixed(hash, &p.x.to_le_bytes()), &p.y.to_le_bytes()))
}

fn mixed(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &b| (hash ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// The corners of a ring as its identity sees them: from the least one on, counter-clockwise, and without those in a
/// straight side, which come and go with the neighbours.
pub fn of_ring(ring: &[Grain]) -> Vec<Grain> {
    let mut ring = ring.to_vec();
    ring.dedup();
    if let Some(least) = (0..ring.len()).min_by_key(|&i| ring[i]) {
        ring.rotate_left(least);
    }
    if signed_area(&ring) < 0 {
        // The least stays in front.
        ring[1..].reverse();
    }
    let mut corners: Vec<Grain> = vec![];
    for (i, &p) in ring.iter().enumerate() {
        let next = ring[(i + 1) % ring.len()];
        if corners.last().is_none_or(|&last| is_corner(p, last, next)) {
            corners.push(p);
        }
    }
    corners
}

/// The ends of a line as its identity sees them, whichever way it runs.
pub fn of_line([a, b]: [Grain; 2]) -> Vec<Grain> {
    vec![a.min(b), a.max(b)]
}

fn is_corner(p: Grain, last: Grain, next: Grain) -> bool {
    p.beside(last, next).is_none_or(|(_, off)| off > TOLERANCE)
}

/// Twice the area of a ring; above 0 when it runs counter-clockwise.
pub fn signed_area(ring: &[Grain]) -> i128 {
    let ends = ring.iter().cycle().skip(1);
    let wide = i128::from;
    ring.iter().zip(ends).map(|(a, b)| wide(a.x) * wide(b.y) - wide(b.x) * wide(a.y)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(x: i64) -> Key {
        ("node".into(), vec![Grain { x, y: 0 }])
    }

    #[test]
    fn identifiers_are_negative_and_stay_the_same() {
        let ids = assign(&[key(1), key(-2), key(300)]);
        assert!(ids.iter().all(|&id| id < 0 && id >= -SPACE.cast_signed()));
        // They are in files that people keep: another hash would be another format.
        assert_eq!(assign(&[key(300), key(1)]), [ids[2], ids[0]]);
        assert_eq!(ids[0], -1_098_867_852_503_751);
    }

    #[test]
    fn collisions_are_resolved_alike_in_every_order() {
        let keys: Vec<Key> = (0..14).map(key).collect();
        let ids = assign_within(&keys, 16);
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), 14);
        let reversed: Vec<Key> = keys.iter().rev().cloned().collect();
        assert_eq!(assign_within(&reversed, 16), ids.iter().rev().copied().collect::<Vec<_>>());
    }

    #[test]
    fn equal_keys_have_identifiers_of_their_own() {
        let ids = assign(&[key(7), key(7)]);
        assert_ne!(ids[0], ids[1]);
        assert_eq!(ids[0], assign(&[key(7)])[0]);
    }

    #[test]
    fn a_ring_is_itself_wherever_it_begins() {
        let ring = |points: &[[i64; 2]]| points.iter().map(|&[x, y]| Grain { x, y }).collect::<Vec<_>>();
        let square = ring(&[[0, 0], [1000, 0], [1000, 1000], [0, 1000]]);
        let turned = ring(&[[1000, 1000], [0, 1000], [0, 400], [0, 0], [500, 1], [1000, 0]]);
        let mut back = turned.clone();
        back.reverse();
        for other in [&square, &turned, &back] {
            assert_eq!(of_ring(other), square);
        }
    }
}
