//! Rooms along their walls' centre lines: each floor grown by half of the walls around it.

use super::super::inner;
use super::super::outline::{Corner, Outline};
use super::carrier::Carrier;
use super::facing::{Beyond, Face, Stretch};
use planform_sdk::{Polygon, parallel};

/// Half thicknesses along a face that differ by less are one, metres: they are measured in cells.
const SAME: f64 = 0.03;

/// The polygons along the centre lines. They contain the floors and are disjoint. `faces` are the floors' sides in
/// order, `stretches` what lies beyond each.
pub fn centres(
    floors: &[Option<Polygon>],
    faces: &[Face],
    stretches: &[Vec<Stretch>],
) -> Vec<Option<Polygon>> {
    let mut begin = vec![0];
    for floor in floors {
        let sides = floor.iter().flat_map(Polygon::rings).map(<[_]>::len).sum::<usize>();
        begin.push(begin[begin.len() - 1] + sides);
    }
    let mut centres = parallel::map(floors.len(), |room| {
        let own = begin[room]..begin[room + 1];
        floors[room].as_ref().map(|floor| grown(floor, &faces[own.clone()], &stretches[own]))
    });
    let own: Vec<Polygon> = floors.iter().map(|f| f.clone().unwrap_or_default()).collect();
    inner::part(&mut centres, &own);
    if fall_back(&mut centres, floors) {
        inner::part(&mut centres, &own);
    }
    inner::separate(&mut centres, &own);
    centres
}

/// Where a narrow room lost its floor to its neighbours' walls, its floor is its outline. Tells whether there was one.
fn fall_back(centres: &mut [Option<Polygon>], floors: &[Option<Polygon>]) -> bool {
    let mut any = false;
    for (centre, floor) in centres.iter_mut().zip(floors) {
        let Some(floor) = floor else { continue };
        if !centre.as_ref().is_some_and(|c| inner::covers(c, floor)) {
            *centre = Some(floor.clone());
            any = true;
        }
    }
    any
}

fn grown(floor: &Polygon, faces: &[Face], stretches: &[Vec<Stretch>]) -> Polygon {
    let (mut rings, mut insets) = (Vec::new(), Vec::new());
    let mut next = 0;
    for ring in floor.rings() {
        let mut corners = Vec::new();
        for i in next..next + ring.len() {
            for (from, half) in halves(&stretches[i]) {
                let line = Carrier::of(&faces[i].segment);
                let at = if from > 0.0 {
                    line.point(line.along(faces[i].segment.a) + from, 0.0)
                } else {
                    faces[i].segment.a
                };
                corners.push(Corner { at, line: None });
                insets.push(-half);
            }
        }
        next += ring.len();
        rings.push(corners);
    }
    inner::floor(&Outline { rings }, &insets).unwrap_or_else(|| floor.clone())
}

/// Along a face, where the half thickness of the wall changes, from its begin on.
fn halves(stretches: &[Stretch]) -> Vec<(f64, f64)> {
    let half = |s: &Stretch| (s.gap_at(s.from) + s.gap_at(s.to)) / 4.0;
    let length = |s: &&Stretch| s.to - s.from;
    let longest = stretches.iter().max_by(|a, b| length(a).total_cmp(&length(b))).map_or(0.0, half);
    let mut found: Vec<(f64, f64)> = vec![(0.0, longest)];
    for (i, stretch) in stretches.iter().enumerate() {
        // At the end of another wall the walls beside it go on.
        let here = if stretch.beyond == Beyond::Other {
            let beside = [i.checked_sub(1).and_then(|k| stretches.get(k)), stretches.get(i + 1)];
            beside.into_iter().flatten().map(half).fold(0.0, f64::max)
        } else {
            half(stretch)
        };
        let here = if (here - longest).abs() < SAME { longest } else { here };
        if i == 0 {
            found = vec![(0.0, here)];
        } else if found.last().is_some_and(|(_, last)| (last - here).abs() >= 1e-3) {
            found.push((stretch.from, here));
        }
    }
    found
}
