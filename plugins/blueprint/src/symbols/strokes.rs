//! Straight and round parts of thinned strokes.

use super::plane::{Vec2, direction, distance, dot, moved};
use super::thin::Chain;

/// How far a stroke may leave its straight line or its circle, pixels: what thinning leaves uneven.
const ROUGHNESS: f64 = 0.9;

/// A straight stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// One end.
    pub a: Vec2,
    /// The other end.
    pub b: Vec2,
}

impl Segment {
    /// How long it is.
    pub fn length(&self) -> f64 {
        distance(self.a, self.b)
    }

    /// The unit vector from its first end to its second one.
    pub fn along(&self) -> Vec2 {
        direction(self.a, self.b).0
    }

    /// Its middle.
    pub fn middle(&self) -> Vec2 {
        [(self.a[0] + self.b[0]) / 2.0, (self.a[1] + self.b[1]) / 2.0]
    }
}

/// A part of a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// The circle's middle.
    pub centre: Vec2,
    /// Its radius.
    pub radius: f64,
    /// A point of the stroke, near its middle.
    pub through: Vec2,
}

fn points(chain: &Chain) -> Vec<Vec2> {
    chain.iter().map(|p| [f64::from(p[0]) + 0.5, f64::from(p[1]) + 0.5]).collect()
}

/// The straight parts of all chains.
pub fn parts(chains: &[Chain]) -> Vec<Segment> {
    let mut found = Vec::new();
    for chain in chains {
        split(&points(chain), &mut found);
    }
    found.retain(|s| s.length() >= 3.0);
    found
}

/// The parts joined over the gaps where other strokes cross them, if they then are at least so long.
pub fn segments(parts: &[Segment], shortest: f64) -> Vec<Segment> {
    let mut joined = joined(parts.to_vec());
    joined.retain(|s| s.length() >= shortest);
    joined
}

/// Splits a chain at the point furthest from the line between its ends, until every part is straight (after U. Ramer, and
/// D. Douglas and T. Peucker, 1972 and 1973).
fn split(points: &[Vec2], found: &mut Vec<Segment>) {
    let mut open = vec![points];
    while let Some(part) = open.pop() {
        let [a, .., b] = part else { continue };
        let (along, _) = direction(*a, *b);
        let off = |p: &Vec2| dot([p[0] - a[0], p[1] - a[1]], [-along[1], along[0]]).abs();
        let far = (0..part.len()).max_by(|&i, &j| off(&part[i]).total_cmp(&off(&part[j])));
        match far.filter(|&i| off(&part[i]) > ROUGHNESS && i > 0 && i + 1 < part.len()) {
            Some(i) => open.extend([&part[i..], &part[..=i]]),
            None if part.len() > 2 || distance(*a, *b) > 2.0 => found.push(Segment { a: *a, b: *b }),
            None => {}
        }
    }
}

/// Crossing strokes leave a gap as wide as this, pixels.
const GAP: f64 = 9.0;

/// Joins segments that go on in the same direction.
fn joined(mut segments: Vec<Segment>) -> Vec<Segment> {
    // Long ones first: their direction is the surest.
    segments.sort_by(|s, t| t.length().total_cmp(&s.length()));
    let near = Near::new(&segments);
    let mut taken = vec![false; segments.len()];
    let mut result = Vec::new();
    for i in 0..segments.len() {
        if std::mem::replace(&mut taken[i], true) {
            continue;
        }
        let mut whole = segments[i];
        for _ in 0..2 {
            while let Some(j) = near.at(whole.b).find(|&j| !taken[j] && goes_on(&whole, &segments[j])) {
                taken[j] = true;
                whole.b = further(&whole, &segments[j]);
            }
            whole = Segment { a: whole.b, b: whole.a };
        }
        result.push(whole);
    }
    result
}

fn goes_on(whole: &Segment, next: &Segment) -> bool {
    let along = whole.along();
    let off = |p: Vec2| {
        let d = [p[0] - whole.b[0], p[1] - whole.b[1]];
        (dot(d, along), dot(d, [-along[1], along[0]]).abs())
    };
    let (a, b) = (off(next.a), off(next.b));
    let reach = 1.2 + 0.06 * next.length();
    let ahead = a.0.min(b.0) > -2.5 && a.0.min(b.0) < GAP && a.0.max(b.0) > 0.0;
    ahead && a.1 < reach && b.1 < reach && dot(along, next.along()).abs() > 0.97
}

fn further(whole: &Segment, next: &Segment) -> Vec2 {
    if distance(whole.a, next.a) > distance(whole.a, next.b) { next.a } else { next.b }
}

/// Which segments end where.
struct Near {
    ends: Vec<([i32; 2], usize)>,
}

impl Near {
    fn new(segments: &[Segment]) -> Self {
        let mut ends: Vec<_> = segments
            .iter()
            .enumerate()
            .flat_map(|(i, s)| [(Self::cell(s.a), i), (Self::cell(s.b), i)])
            .collect();
        ends.sort_unstable();
        Self { ends }
    }

    fn cell(p: Vec2) -> [i32; 2] {
        [(p[0] / GAP).floor() as i32, (p[1] / GAP).floor() as i32]
    }

    fn at(&self, p: Vec2) -> impl Iterator<Item = usize> + '_ {
        let [x, y] = Self::cell(p);
        let cells = (-1..=1).flat_map(move |dx| (-1..=1).map(move |dy| [x + dx, y + dy]));
        cells.flat_map(|cell| {
            let from = self.ends.partition_point(|e| e.0 < cell);
            self.ends[from..].iter().take_while(move |e| e.0 == cell).map(|e| e.1)
        })
    }
}

/// The round parts of all chains whose radius lies within the range.
pub fn curves(chains: &[Chain], [least, most]: [f64; 2]) -> Vec<Curve> {
    chains.iter().flat_map(|chain| curves_of(&points(chain), [least, most])).collect()
}

/// Windows of several lengths slide over the chain; where one is round, and less turned than it could be, it is taken.
fn curves_of(points: &[Vec2], [least, most]: [f64; 2]) -> Vec<Curve> {
    let mut found: Vec<Curve> = Vec::new();
    let mut length = (least * 0.7).max(7.0);
    while length <= most * 1.6 && length as usize <= points.len() {
        let n = length as usize;
        for window in points.windows(n).step_by((n / 4).max(1)) {
            let round =
                circle(window).filter(|c| (least..=most).contains(&c.radius) && turn(window, c) > 0.55);
            found.extend(round.filter(|c| found.last().is_none_or(|l| !same(l, c))));
        }
        length *= 1.4;
    }
    found
}

fn same(a: &Curve, b: &Curve) -> bool {
    distance(a.centre, b.centre) < 1.0 && (a.radius - b.radius).abs() < 1.0
}

/// By how much the circle turns between the ends of a window, radians.
fn turn(window: &[Vec2], circle: &Curve) -> f64 {
    let chord = distance(window[0], window[window.len() - 1]);
    2.0 * (chord / 2.0 / circle.radius).clamp(0.0, 1.0).asin()
}

/// The circle through points, by least squares (I. Kasa, "A circle fitting procedure and its error analysis", 1976), if
/// they all lie on it.
fn circle(points: &[Vec2]) -> Option<Curve> {
    let n = points.len() as f64;
    let mean = |f: &dyn Fn(&Vec2) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (mx, my) = (mean(&|p| p[0]), mean(&|p| p[1]));
    let m = |i: i32, j: i32| mean(&|p| (p[0] - mx).powi(i) * (p[1] - my).powi(j));
    let (xx, xy, yy) = (m(2, 0), m(1, 1), m(0, 2));
    let (a, b) = ((m(3, 0) + m(1, 2)) / 2.0, (m(2, 1) + m(0, 3)) / 2.0);
    let determinant = xx * yy - xy * xy;
    if determinant.abs() < 1e-6 {
        return None;
    }
    let (cx, cy) = ((a * yy - b * xy) / determinant, (b * xx - a * xy) / determinant);
    let centre = [mx + cx, my + cy];
    let radius = (cx * cx + cy * cy + xx + yy).sqrt();
    let fits = points.iter().all(|&p| (distance(p, centre) - radius).abs() < ROUGHNESS);
    fits.then(|| Curve { centre, radius, through: nearest(points[points.len() / 2], centre, radius) })
}

fn nearest(p: Vec2, centre: Vec2, radius: f64) -> Vec2 {
    moved(centre, direction(centre, p).0, radius)
}

#[cfg(test)]
mod tests {
    use super::super::plane::unit;
    use super::*;

    fn arc(centre: Vec2, radius: f64, from: f64, to: f64) -> Chain {
        let n = (radius * (to - from)).round() as u32;
        let at = |i: u32| moved(centre, unit(from + (to - from) * f64::from(i) / f64::from(n)), radius);
        (0..=n).map(|i| at(i).map(|v| v.floor() as i32)).collect()
    }

    #[test]
    fn a_quarter_circle_is_found_and_a_line_is_not() {
        let found = curves(&[arc([40.0, 40.0], 22.0, 0.0, 1.57)], [12.0, 40.0]);
        assert!(
            found.iter().any(|c| distance(c.centre, [40.0, 40.0]) < 2.0 && (c.radius - 22.0).abs() < 2.0)
        );
        let line: Chain = (0..60).map(|x| [x, x / 4]).collect();
        assert!(curves(&[line], [12.0, 40.0]).is_empty());
    }

    #[test]
    fn a_line_goes_on_over_a_crossing() {
        let part = |from: i32, to: i32| (from..to).map(|x| [x, 20 + x / 10]).collect::<Chain>();
        let found = segments(&parts(&[part(0, 30), part(34, 70)]), 10.0);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].length() - 69.0).abs() < 2.5);
    }

    #[test]
    fn a_corner_makes_two_lines() {
        let mut chain: Chain = (0..20).map(|x| [x, 0]).collect();
        chain.extend((1..30).map(|y| [19, y]));
        let mut lengths: Vec<f64> =
            segments(&parts(&[chain]), 5.0).iter().map(|s| s.length().round()).collect();
        lengths.sort_by(f64::total_cmp);
        assert_eq!(lengths, [19.0, 29.0]);
    }
}
