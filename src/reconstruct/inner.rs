//! The floor of a room: its polygon along the walls' inner faces.
//!
//! Each side of a room's outline is moved to where the room's walls along it have their inner face: strips of floor
//! are added where the face lies beyond the line, and strips of wall taken away where it lies before it.

use super::outline::Outline;
use geo::{Area, BooleanOps, Intersects, Validation};
use planform_sdk::{Point, Polygon};

/// What is nearer than this touches, metres.
const TOUCH: f64 = 1e-6;

/// A piece thinner than this is an artefact of the cutting, metres.
const SLIVER: f64 = 1e-3;

/// The floor within an outline; `inset` tells for each side, in the order of [`Outline::sides`], how far its inner
/// face lies inside, metres (negative: outside). `None` if the walls leave no floor.
pub fn floor(outline: &Outline, inset: &[f64]) -> Option<Polygon> {
    let sides = sides(outline, inset);
    let added: Vec<_> = sides.iter().filter(|s| s.inset < 0.0).map(Side::strip).collect();
    let removed: Vec<_> = sides.iter().filter(|s| s.inset > 0.0).map(Side::strip).collect();
    let mut floor = geo::MultiPolygon::new(vec![to_geo(&outline.polygon())]);
    if !added.is_empty() {
        floor = floor.union(&geo::unary_union(&added));
    }
    if !removed.is_empty() {
        floor = floor.difference(&geo::unary_union(&removed));
    }
    largest(floor)
}

/// Makes floors disjoint: what two of them share goes to the room in whose outline it lies, else to the first.
pub fn part(floors: &mut [Option<Polygon>], outlines: &[Polygon]) {
    for (a, b) in neighbours(floors) {
        let (Some(p), Some(q)) = (&floors[a], &floors[b]) else { continue };
        let (p, q) = (to_geo(p), to_geo(q));
        if !p.intersects(&q) || p.intersection(&q).unsigned_area() < SLIVER * SLIVER {
            continue;
        }
        let p = p.difference(&q.intersection(&to_geo(&outlines[b])));
        let q = geo::MultiPolygon::new(vec![q]).difference(&p);
        (floors[a], floors[b]) = (largest(p), largest(q));
    }
}

/// The pairs of floors whose boxes meet, the smaller index first, in rising order.
fn neighbours(floors: &[Option<Polygon>]) -> Vec<(usize, usize)> {
    let mut boxes: Vec<(usize, [f64; 4])> =
        floors.iter().enumerate().filter_map(|(i, f)| Some((i, extent(f.as_ref()?)))).collect();
    boxes.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let mut pairs = Vec::new();
    for (k, (a, p)) in boxes.iter().enumerate() {
        let beside = boxes[k + 1..].iter().take_while(|(_, q)| q[0] < p[2]);
        pairs.extend(beside.filter(|(_, q)| q[1] < p[3] && p[1] < q[3]).map(|(b, _)| (*a.min(b), *a.max(b))));
    }
    pairs.sort_unstable();
    pairs
}

/// The box around a polygon: low x, low y, high x, high y.
fn extent(p: &Polygon) -> [f64; 4] {
    p.exterior.iter().fold([f64::MAX, f64::MAX, f64::MIN, f64::MIN], |b, p| {
        [b[0].min(p.x), b[1].min(p.y), b[2].max(p.x), b[3].max(p.y)]
    })
}

/// One side of an outline with the insets of its neighbours.
struct Side {
    from: Point,
    to: Point,
    inset: f64,
    before: f64,
    after: f64,
}

fn sides(outline: &Outline, inset: &[f64]) -> Vec<Side> {
    let mut sides = Vec::new();
    let mut first = 0;
    for ring in &outline.rings {
        let n = ring.len();
        let at = |i: usize| inset.get(first + i % n).copied().unwrap_or(0.0);
        sides.extend((0..n).map(|i| Side {
            from: ring[i].at,
            to: ring[(i + 1) % n].at,
            inset: at(i),
            before: at(i + n - 1),
            after: at(i + 1),
        }));
        first += n;
    }
    sides
}

impl Side {
    /// The strip between the side and its inner face. At its ends it reaches as far as the neighbours' faces, so that
    /// the strips of two walls fill the corner where they meet; an added strip only when they are added too.
    fn strip(&self) -> geo::Polygon {
        let length = self.from.distance(self.to).max(f64::MIN_POSITIVE);
        let along = Point::new((self.to.x - self.from.x) / length, (self.to.y - self.from.y) / length);
        let reach = |neighbour: f64| {
            if self.inset > 0.0 { neighbour.abs() } else { (-neighbour).max(0.0) }
        };
        let at = |p: Point, forward: f64, left: f64| {
            (p.x + forward * along.x - left * along.y, p.y + forward * along.y + left * along.x)
        };
        let (before, after) = (reach(self.before), reach(self.after));
        let (low, high) = (self.inset.min(0.0), self.inset.max(0.0));
        let corners = vec![
            at(self.from, -before, low),
            at(self.to, after, low),
            at(self.to, after, high),
            at(self.from, -before, high),
        ];
        geo::Polygon::new(geo::LineString::from(corners), vec![])
    }
}

fn to_geo(p: &Polygon) -> geo::Polygon {
    let ring = |r: &[Point]| r.iter().map(|p| (p.x, p.y)).collect::<geo::LineString>();
    geo::Polygon::new(ring(&p.exterior), p.holes.iter().map(|h| ring(h)).collect())
}

/// How often a polygon that cleaning made invalid is cut at its crossings and cleaned again.
const REPAIRS: usize = 4;

/// The largest polygon, cleaned of vertices that bend nothing.
fn largest(polygons: geo::MultiPolygon) -> Option<Polygon> {
    let mut floor = largest_cleaned(polygons)?;
    for _ in 0..REPAIRS {
        let polygon = to_geo(&floor);
        if polygon.is_valid() {
            return Some(floor);
        }
        floor = largest_cleaned(geo::unary_union(&[polygon]))?;
    }
    to_geo(&floor).is_valid().then_some(floor)
}

fn largest_cleaned(polygons: geo::MultiPolygon) -> Option<Polygon> {
    let largest = polygons.0.into_iter().max_by(|a, b| a.unsigned_area().total_cmp(&b.unsigned_area()))?;
    let ring = |r: &geo::LineString| clean(r.coords().map(|c| Point::new(c.x, c.y)).collect());
    let exterior = ring(largest.exterior());
    let holes = largest.interiors().iter().map(ring).filter(|h| h.len() > 2).collect();
    (exterior.len() > 2).then(|| Polygon::new(exterior, holes))
}

/// Drops the repeated last point, every vertex that lies on the line between its neighbours, and every spike: where
/// two strips' ends nearly meet, the cutting leaves rings that run out and back along the same line. Files round to
/// 0.1 mm, where a thin spike would cross itself. A thin slit stays: filled, it could overlap another room.
fn clean(mut ring: Vec<Point>) -> Vec<Point> {
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    let mut i = 0;
    while ring.len() > 2 && i < ring.len() {
        let n = ring.len();
        let (a, b, c) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
        let twice_area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        let longest = a.distance(b).max(b.distance(c)).max(a.distance(c));
        let turns_back = (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) > 0.0;
        let least = if turns_back && twice_area > 0.0 { SLIVER } else { TOUCH };
        if twice_area.abs() <= longest * least {
            ring.remove(i);
            i = i.saturating_sub(2);
        } else {
            i += 1;
        }
    }
    ring
}

#[cfg(test)]
mod tests {
    use super::super::outline::Corner;
    use super::*;

    fn outline(points: &[[f64; 2]]) -> Outline {
        Outline { rings: vec![points.iter().map(|&p| Corner { at: p.into(), line: None }).collect()] }
    }

    #[test]
    fn a_square_shrinks_by_its_walls() {
        let square = outline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let floor = floor(&square, &[0.1, 0.2, 0.3, 0.4]).unwrap();
        assert_eq!(floor.exterior.len(), 4);
        assert!((floor.area() - (4.0 - 0.6) * (4.0 - 0.4)).abs() < 1e-6);
    }

    #[test]
    fn a_wall_beyond_the_line_gives_floor() {
        let square = outline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let floor = floor(&square, &[-0.5, 0.2, -0.3, -0.1]).unwrap();
        assert_eq!(floor.exterior.len(), 4);
        assert!((floor.area() - (4.0 - 0.2 + 0.1) * 4.8).abs() < 1e-6);
    }

    #[test]
    fn the_corner_that_juts_in_is_wall() {
        let l = outline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]]);
        let floor = floor(&l, &[0.1; 6]).unwrap();
        assert_eq!(floor.exterior.len(), 6);
        assert!((floor.area() - (3.8 * 1.8 + 1.8 * 2.0)).abs() < 1e-6);
    }

    #[test]
    fn walls_without_floor_between_are_no_room() {
        let thin = outline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 0.2], [0.0, 0.2]]);
        assert_eq!(floor(&thin, &[0.15; 4]), None);
    }

    #[test]
    fn spikes_and_hairlines_are_cleaned_away() {
        let ring = |points: &[[f64; 2]]| points.iter().map(|&p| p.into()).collect::<Vec<Point>>();
        let spike = ring(&[[0.0, 0.0], [2.0, 0.0], [2.0, -5.0], [2.0 + 1e-4, 0.0], [4.0, 0.0], [4.0, 4.0]]);
        assert_eq!(clean(spike), ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]]));
        let hairline = ring(&[[1.0, 1.0], [3.0, 2.0], [1.0 + 1e-9, 1.0], [0.5, 3.0]]);
        assert_eq!(clean(hairline).len(), 2);
    }

    #[test]
    fn floors_that_overlap_are_parted() {
        let square = |x: f64| {
            Polygon::new(
                [[x, 0.0], [x + 2.0, 0.0], [x + 2.0, 2.0], [x, 2.0]].map(Point::from).to_vec(),
                vec![],
            )
        };
        let mut floors = [Some(square(0.5)), Some(square(2.0))];
        part(&mut floors, &[square(0.0), square(2.0)]);
        let areas: Vec<f64> = floors.iter().flatten().map(Polygon::area).collect();
        assert!((areas[0] - 3.0).abs() < 1e-6 && (areas[1] - 4.0).abs() < 1e-6);
    }
}
