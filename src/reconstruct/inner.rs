//! The floor of a room: its polygon along the walls' inner faces.
//!
//! Each side of a room's outline is moved to where the room's walls along it have their inner face: strips of floor
//! are added where the face lies beyond the line, and strips of wall taken away where it lies before it.

use super::outline::Outline;
use geo::buffer::{BufferStyle, LineJoin};
use geo::{Area, BooleanOps, Buffer, Intersects, MapCoords, RemoveRepeatedPoints, Validation};
use planform_sdk::{Point, Polygon, bounds, ring_signed_area};

/// What is nearer than this touches, metres.
const TOUCH: f64 = 1e-6;

/// A piece or a slit thinner than this is an artefact of the cutting, metres.
const SLIVER: f64 = 1e-3;

/// Two floors that share less than this are disjoint, square metres.
const HAIR: f64 = 1e-5;

/// Vertices nearer than this are one, metres: files round to 0.1 mm.
const SHORTEST: f64 = 3e-4;

/// How far an added strip reaches into the room, metres.
const OVERLAP: f64 = 1e-2;

/// The sharpest angle that a mitred corner may have, radians.
const MITRE: f64 = 0.1;

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
        (floors[a], floors[b]) = (kept(p, &outlines[a]), kept(q, &outlines[b]));
    }
}

/// Cuts off what two floors still share after [`part`], where smoothing made one of them reach over the other's side by
/// a hair: from the first, without smoothing it again. Should that not survive a file's rounding, it ends farther and
/// farther before the second, until smoothing does not bring it back.
pub fn separate(floors: &mut [Option<Polygon>], outlines: &[Polygon]) {
    for gap in [0.0, 2.0 * SLIVER, 8.0 * SLIVER, 32.0 * SLIVER] {
        for (a, b) in neighbours(floors) {
            let (Some(p), Some(q)) = (&floors[a], &floors[b]) else { continue };
            let (p, q) = (to_geo(p), to_geo(q));
            if !p.intersects(&q) || p.intersection(&q).unsigned_area() < HAIR {
                continue;
            }
            let cut = if gap == 0.0 {
                by_area(p.difference(&q)).and_then(|rest| cleaned(&rest)).filter(survives_rounding)
            } else {
                let style = BufferStyle::new(gap).line_join(LineJoin::Miter(MITRE));
                kept(p.difference(&solid(q.buffer_with_style(style))), &outlines[a])
            };
            floors[a] = cut.or_else(|| floors[a].take());
        }
    }
}

/// Of the parts of a floor that was cut the one with most of the room's outline.
fn kept(mut parts: geo::MultiPolygon, outline: &Polygon) -> Option<Polygon> {
    if parts.0.len() > 1 {
        let outline = to_geo(outline);
        let within = |p: &geo::Polygon| p.intersection(&outline).unsigned_area();
        let best = parts.0.into_iter().map(|p| (within(&p), p)).max_by(|a, b| a.0.total_cmp(&b.0));
        parts = geo::MultiPolygon::new(best.into_iter().map(|b| b.1).collect());
    }
    largest(parts)
}

/// The pairs of floors whose boxes meet, the smaller index first, in rising order.
fn neighbours(floors: &[Option<Polygon>]) -> Vec<(usize, usize)> {
    let around = |floor: &Option<Polygon>| bounds(floor.iter().flat_map(|f| f.exterior.iter().copied()));
    let mut boxes: Vec<(usize, (Point, Point))> =
        floors.iter().enumerate().filter_map(|(i, f)| Some((i, around(f)?))).collect();
    boxes.sort_by(|a, b| a.1.0.x.total_cmp(&b.1.0.x));
    let mut pairs = Vec::new();
    for (k, (a, (low, high))) in boxes.iter().enumerate() {
        let beside = boxes[k + 1..].iter().take_while(|(_, (l, _))| l.x < high.x);
        let meeting = beside.filter(|(_, (l, h))| l.y < high.y && low.y < h.y);
        pairs.extend(meeting.map(|(b, _)| (*a.min(b), *a.max(b))));
    }
    pairs.sort_unstable();
    pairs
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
        let bends = |i: usize| bends(ring[(i + n - 1) % n].at, ring[i % n].at, ring[(i + 1) % n].at);
        sides.extend((0..n).map(|i| Side {
            from: ring[i].at,
            to: ring[(i + 1) % n].at,
            inset: at(i),
            before: if bends(i) { at(i + n - 1) } else { 0.0 },
            after: if bends(i + 1) { at(i + 1) } else { 0.0 },
        }));
        first += n;
    }
    sides
}

/// Whether a ring turns at `b`. A side that goes straight on has no corner to fill.
fn bends(a: Point, b: Point, c: Point) -> bool {
    let twice_area = ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)).abs();
    twice_area > TOUCH * a.distance(b).max(b.distance(c)).max(a.distance(c))
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
        // An added strip overlaps the room: rounding would leave a hairline between two that only touch.
        let (low, high) = if self.inset > 0.0 { (0.0, self.inset) } else { (self.inset, OVERLAP) };
        let corners = vec![
            at(self.from, -before, low),
            at(self.to, after, low),
            at(self.to, after, high),
            at(self.from, -before, high),
        ];
        geo::Polygon::new(geo::LineString::from(corners), vec![])
    }
}

/// The polygon as it is if it is valid and stays so in a file, else cleaned; `None` if nothing valid is left.
pub fn settled(polygon: Polygon) -> Option<Polygon> {
    let sound =
        |p: &Polygon| to_geo(p).is_valid() && survives_rounding(p) && ring_signed_area(&p.exterior) > 0.0;
    if polygon.exterior.len() > 2 && sound(&polygon) {
        return Some(polygon);
    }
    largest(geo::MultiPolygon::new(vec![to_geo(&polygon)])).filter(sound)
}

/// Whether a polygon covers another one but for artefacts of the cutting.
pub fn covers(outer: &Polygon, inner: &Polygon) -> bool {
    to_geo(inner).difference(&to_geo(outer)).unsigned_area() <= SLIVER * inner.area().max(SLIVER)
}

fn to_geo(p: &Polygon) -> geo::Polygon {
    let ring = |r: &[Point]| r.iter().map(|p| (p.x, p.y)).collect::<geo::LineString>();
    geo::Polygon::new(ring(&p.exterior), p.holes.iter().map(|h| ring(h)).collect())
}

/// The largest polygon without spikes, necks and slits that nobody could see, cleaned of vertices that bend nothing.
/// Should one be left that a file's rounding would turn over, wider ones go too.
fn largest(polygons: geo::MultiPolygon) -> Option<Polygon> {
    let largest = by_area(polygons)?;
    let mut floor = None;
    for width in [SLIVER, 4.0 * SLIVER, 16.0 * SLIVER] {
        floor = Some(cleaned(&by_area(smooth(&largest, width))?)?);
        if floor.as_ref().is_some_and(survives_rounding) {
            break;
        }
    }
    floor
}

fn by_area(polygons: geo::MultiPolygon) -> Option<geo::Polygon> {
    polygons.0.into_iter().max_by(|a, b| a.unsigned_area().total_cmp(&b.unsigned_area()))
}

fn cleaned(polygon: &geo::Polygon) -> Option<Polygon> {
    let ring = |r: &geo::LineString| clean(r.coords().map(|c| Point::new(c.x, c.y)).collect());
    let exterior = ring(polygon.exterior());
    let holes = polygon.interiors().iter().map(ring).filter(|h| h.len() > 2).collect();
    (exterior.len() > 2).then(|| Polygon::new(exterior, holes))
}

/// Whether the polygon stays valid when its coordinates are rounded as files do, and a little more coarsely.
fn survives_rounding(polygon: &Polygon) -> bool {
    let rounded = |step: f64| {
        to_geo(polygon)
            .map_coords(|c| geo::coord! { x: (c.x / step).round() * step, y: (c.y / step).round() * step })
    };
    [1e-4, 2e-4].iter().all(|&step| rounded(step).remove_repeated_points().is_valid())
}

/// A morphological closing and opening (Serra 1982): fills slits and removes spikes and necks thinner than a few
/// widths, which the cutting leaves where strips nearly meet, and which would cross themselves when a file rounds
/// their coordinates. `width` in metres. Mitred joins keep the corners. An opening of twice the width makes sure that no other
/// floor reaches into a slit that is filled.
fn smooth(polygon: &geo::Polygon, width: f64) -> geo::MultiPolygon {
    let offset = |polygons: &geo::MultiPolygon, by: f64| {
        let style = BufferStyle::new(by).line_join(LineJoin::Miter(MITRE));
        solid(polygons.buffer_with_style(style))
    };
    let whole = solid(geo::MultiPolygon::new(vec![polygon.clone()]));
    let opened = offset(&offset(&whole, -2.0 * width), 2.0 * width);
    offset(&offset(&opened, width), -width)
}

/// Without rings that enclose nothing, such as shrinking leaves: the next offset would panic.
fn solid(polygons: geo::MultiPolygon) -> geo::MultiPolygon {
    let encloses = |r: &geo::LineString| r.0.len() > 3;
    let whole = polygons.0.into_iter().filter(|p| encloses(p.exterior()));
    let parts = whole.map(geo::Polygon::into_inner);
    parts
        .map(|(outer, inner)| geo::Polygon::new(outer, inner.into_iter().filter(encloses).collect()))
        .collect()
}

/// Drops the repeated last point, every vertex that lies on the line between its neighbours, and all but one of those
/// at one place.
pub fn clean(mut ring: Vec<Point>) -> Vec<Point> {
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    // What is kept so far is `..kept`, what was not looked at yet `next..`; between them is a gap.
    let (mut kept, mut next, end) = (0, 0, ring.len());
    while next < end && kept + end - next > 2 {
        let before = if kept > 0 { ring[kept - 1] } else { ring[end - 1] };
        let after = if next + 1 < end { ring[next + 1] } else { ring[0] };
        let here = ring[next];
        if !bends(before, here, after) || here.distance(after) < SHORTEST {
            next += 1;
            // The two before it have new neighbours.
            for _ in 0..kept.min(2) {
                (kept, next) = (kept - 1, next - 1);
                ring[next] = ring[kept];
            }
        } else {
            ring[kept] = here;
            (kept, next) = (kept + 1, next + 1);
        }
    }
    ring.drain(kept..next);
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
    fn a_turned_room_gets_its_floor_too() {
        let turned = outline(&[[-1.1605, 0.4709], [-4.3026, 2.5229], [-6.2437, -0.4166], [-3.1017, -2.4686]]);
        let area = |insets: &[f64]| floor(&turned, insets).unwrap().area();
        for side in 0..4 {
            let insets: Vec<f64> = (0..4).map(|i| if i == side { -0.4 } else { 0.1 }).collect();
            let grown = area(&insets) - area(&[0.1; 4]);
            assert!(grown > 0.4 * 3.0, "side {side}: {grown}");
        }
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
    fn spikes_and_slits_are_smoothed_away() {
        let ring = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, -5.0],
            [2.0 + 1e-4, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [1.0, 4.0],
            [1.0, 2.0],
            [1.0 - 1e-4, 4.0],
            [0.0, 4.0],
        ];
        let polygon = Polygon::new(ring.map(Point::from).to_vec(), vec![]);
        let floor = largest(geo::MultiPolygon::new(vec![to_geo(&polygon)])).unwrap();
        assert_eq!(floor.exterior.len(), 4, "{floor:?}");
        assert!((floor.area() - 16.0).abs() < 1e-6);
    }

    #[test]
    fn a_hook_that_rounding_would_turn_over_is_cut_off() {
        let hook = [
            [33.6085, 17.6848],
            [33.61079, 17.0623],
            [33.6233, 17.0623],
            [33.61077, 17.0702],
            [33.6174, 17.0808],
            [36.6989, 15.1445],
            [38.0672, 14.9937],
            [38.0499, 17.7012],
        ];
        let polygon = to_geo(&Polygon::new(hook.map(Point::from).to_vec(), vec![]));
        let before = polygon.unsigned_area();
        let floor = largest(geo::MultiPolygon::new(vec![polygon])).unwrap();
        assert!(survives_rounding(&floor), "{floor:?}");
        assert!((floor.area() - before).abs() < 0.05);
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
