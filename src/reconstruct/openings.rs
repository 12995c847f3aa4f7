//! Doors and passages: where the wall between two rooms is open.

use super::boundary::Run;
use super::walls::{Profile, Walls};
use planform_sdk::{OpeningKind, Segment};

/// An opening in the boundary between two rooms, metres from the grid's corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Gap {
    /// Door or passage.
    pub kind: OpeningKind,
    /// From jamb to jamb, along the middle of the wall.
    pub segment: Segment,
    /// The two rooms.
    pub rooms: [usize; 2],
}

/// The openings of a run between two rooms.
pub fn openings(run: &Run, profile: &Profile, params: &Walls) -> Vec<Gap> {
    let [Some(left), Some(right)] = run.rooms else { return Vec::new() };
    let middle = profile.faces.map_or(0.0, |f| f.middle());
    open_intervals(&profile.stations)
        .into_iter()
        .map(|(from, to)| (from as f64 * profile.step, to as f64 * profile.step))
        .filter(|(from, to)| to - from >= params.min_opening)
        .map(|(from, to)| Gap {
            kind: if to - from <= params.max_door { OpeningKind::Door } else { OpeningKind::Passage },
            segment: Segment::new(run.point(from, middle), run.point(to, middle)),
            rooms: [left, right],
        })
        .collect()
}

/// Begin and end of every row of stations without a wall.
fn open_intervals<T>(stations: &[Option<T>]) -> Vec<(usize, usize)> {
    let mut intervals: Vec<(usize, usize)> = Vec::new();
    for (i, _) in stations.iter().enumerate().filter(|(_, s)| s.is_none()) {
        match intervals.last_mut() {
            Some(last) if last.1 == i => last.1 = i + 1,
            _ => intervals.push((i, i + 1)),
        }
    }
    intervals
}

#[cfg(test)]
mod tests {
    use super::super::walls::Faces;
    use super::*;
    use planform_sdk::Point;

    fn run(rooms: [Option<usize>; 2]) -> Run {
        let segment = Segment::new(Point::new(0.0, 0.0), Point::new(5.0, 0.0));
        Run { line: Some(0), segment, weight: 0.8, rooms }
    }

    fn profile() -> Profile {
        let wall = Some(Faces { left: 0.15, right: -0.05 });
        let closed = |i: usize| ![3, 20, 21, 22, 23, 24, 25, 26, 27, 28].contains(&i);
        let stations = (0..50).map(|i| if closed(i) { wall } else { None }).collect();
        Profile { step: 0.1, stations, faces: wall }
    }

    #[test]
    fn a_gap_of_a_doors_width_is_a_door_in_the_middle_of_the_wall() {
        let found = openings(&run([Some(4), Some(2)]), &profile(), &Walls::default());
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].kind, found[0].rooms), (OpeningKind::Door, [4, 2]));
        assert!(found[0].segment.a.distance(Point::new(2.0, 0.05)) < 1e-9);
        assert!((found[0].segment.length() - 0.9).abs() < 1e-9);
    }

    #[test]
    fn outer_walls_have_no_openings() {
        assert!(openings(&run([Some(4), None]), &profile(), &Walls::default()).is_empty());
    }
}
