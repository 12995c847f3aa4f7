//! Where in a drawing the building is.

use super::plane::Point;
use super::shapes::Shape;

/// The core of the drawing is where the lines lie but for this part of them at each of the four sides.
const STRAY: f64 = 0.1;
/// What lies beyond the core by this much of its size is stray.
const REACH: f64 = 1.5;

/// The bounds of the lines, the smallest and the largest corner, but for strays: a few lines far from all others, such as
/// a line at the origin of a drawing in land coordinates. `None` without lines.
pub fn extent<'s>(shapes: impl Iterator<Item = &'s Shape> + Clone) -> Option<[Point; 2]> {
    let [x, y] = [0, 1].map(|axis| core(shapes.clone(), axis));
    let ([x0, x1], [y0, y1]) = (x?, y?);
    let size = (x1 - x0).max(y1 - y0).max(f64::MIN_POSITIVE);
    let near = |p: &Point| {
        p[0] >= x0 - REACH * size
            && p[0] <= x1 + REACH * size
            && p[1] >= y0 - REACH * size
            && p[1] <= y1 + REACH * size
    };
    let kept = shapes.filter(|s| s.points.iter().all(near)).flat_map(|s| &s.points);
    let mut corners: Option<[Point; 2]> = None;
    for &[x, y] in kept {
        let [low, high] = corners.unwrap_or([[x, y]; 2]);
        corners = Some([[low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]]);
    }
    corners
}

/// From where to where all but the strays lie along an axis.
fn core<'s>(shapes: impl Iterator<Item = &'s Shape>, axis: usize) -> Option<[f64; 2]> {
    // Each line weighs the same, however long it is and however many points it has.
    let mut pieces: Vec<(f64, f64)> = vec![];
    for shape in shapes {
        let weight = 1.0 / shape.points.len() as f64;
        pieces.extend(shape.points.iter().map(|p| (p[axis], weight)));
    }
    pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = pieces.iter().map(|p| p.1).sum();
    let low = quantile(pieces.iter(), total * STRAY)?;
    let high = quantile(pieces.iter().rev(), total * STRAY)?;
    Some([low, high])
}

fn quantile<'p>(pieces: impl Iterator<Item = &'p (f64, f64)>, weight: f64) -> Option<f64> {
    let mut sum = 0.0;
    let mut last = None;
    for (value, own) in pieces {
        sum += own;
        last = Some(*value);
        if sum > weight {
            break;
        }
    }
    last
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(a: Point, b: Point) -> Shape {
        Shape { points: vec![a, b], width: 0.0, filled: false }
    }

    #[test]
    fn one_stray_line_does_not_count() {
        let mut shapes: Vec<_> = (0..200).map(|i| line([f64::from(i), 0.0], [f64::from(i), 50.0])).collect();
        shapes.push(line([1e7, 1e7], [1.1e7, 1e7]));
        assert_eq!(extent(shapes.iter()), Some([[0.0, 0.0], [199.0, 50.0]]));
        let few = [line([0.0, 0.0], [10.0, 0.0]), line([0.0, 0.0], [0.0, 5.0])];
        assert_eq!(extent(few.iter()), Some([[0.0, 0.0], [10.0, 5.0]]));
        assert_eq!(extent([].iter()), None);
    }
}
