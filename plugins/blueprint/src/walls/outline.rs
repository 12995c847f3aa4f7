//! How straight walls are. Photographs and textures have dark parts as plans do, but people build in straight lines.

use super::drawing::Drawing;

/// A stretch of outline this long is judged, as a share of the drawing's diagonal, within these bounds, pixels.
const SHARE: f64 = 0.03;
const LENGTHS: [f64; 2] = [15.0, 40.0];

/// It is straight if no corner of it is farther than this from its chord, pixels.
const ASIDE: f64 = 1.2;

/// What lies this near to the sheet's edge may be the edge of the picture, as a share of the longer side.
const MARGIN: f64 = 0.02;

/// Steps along an outline: to the right, down, to the left, up.
const STEPS: [[i64; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// The share of the walls' outline that lies in long straight stretches; 0 if there are no walls.
pub fn straightness(drawing: &Drawing, occupied: &[bool]) -> f64 {
    let diagonal = (drawing.width as f64).hypot(drawing.height as f64);
    let length = (SHARE * diagonal).clamp(LENGTHS[0], LENGTHS[1]) as usize;
    let mut outlines = Outlines { drawing, occupied, seen: vec![0; corners(drawing)], from: 0 };
    let (mut straight, mut all) = (0, 0);
    while let Some(line) = outlines.next() {
        let is_inner: Vec<bool> = line.iter().map(|c| is_inner(drawing, *c)).collect();
        let is_straight = stretches(&line, length);
        all += is_inner.iter().filter(|&&i| i).count();
        straight += is_inner.iter().zip(is_straight).filter(|(i, s)| **i && *s).count();
    }
    straight as f64 / all.max(1) as f64
}

fn corners(drawing: &Drawing) -> usize {
    (drawing.width + 1) * (drawing.height + 1)
}

fn is_inner(drawing: &Drawing, [x, y]: [i64; 2]) -> bool {
    let (width, height) = (drawing.width as i64, drawing.height as i64);
    let margin = (MARGIN * width.max(height) as f64) as i64;
    x >= margin && y >= margin && x + margin <= width && y + margin <= height
}

/// Which corners of a closed line belong to a straight stretch of so many steps.
fn stretches(line: &[[i64; 2]], length: usize) -> Vec<bool> {
    let mut out = vec![false; line.len()];
    for from in (0..line.len()).step_by((length / 4).max(1)).filter(|_| line.len() > 2 * length) {
        let at = |i: usize| line[(from + i) % line.len()];
        if (0..=length).all(|i| aside(at(0), at(length), at(i)) <= ASIDE) {
            (0..length).for_each(|i| out[(from + i) % line.len()] = true);
        }
    }
    out
}

/// How far a point is from the line through two others; infinitely far if these are one.
fn aside([ax, ay]: [i64; 2], [bx, by]: [i64; 2], [x, y]: [i64; 2]) -> f64 {
    let length = ((bx - ax) as f64).hypot((by - ay) as f64);
    let twice_area = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)).abs();
    if length > 0.0 { twice_area as f64 / length } else { f64::INFINITY }
}

/// The closed lines along the corners of pixels between what is occupied, on the right, and what is not.
struct Outlines<'a> {
    drawing: &'a Drawing,
    occupied: &'a [bool],
    /// Of every corner the steps from it that were walked, a bit each.
    seen: Vec<u8>,
    /// Before this corner no line begins any more.
    from: usize,
}

impl Outlines<'_> {
    /// The next line. Each has a step to the right somewhere.
    fn next(&mut self) -> Option<Vec<[i64; 2]>> {
        let columns = self.drawing.width + 1;
        let corner = |i: usize| [(i % columns) as i64, (i / columns) as i64];
        let start =
            (self.from..self.seen.len()).find(|&i| self.seen[i] & 1 == 0 && self.is_outline(corner(i), 0))?;
        self.from = start;
        let (mut at, mut step) = (corner(start), 0);
        let mut line = Vec::new();
        while self.mark(at, step) {
            line.push(at);
            at = [at[0] + STEPS[step][0], at[1] + STEPS[step][1]];
            let turns = [1, 0, 3].map(|turn| (step + turn) % 4);
            step = turns.into_iter().find(|&s| self.is_outline(at, s))?;
        }
        Some(line)
    }

    /// Whether a step has just been walked for the first time.
    fn mark(&mut self, [x, y]: [i64; 2], step: usize) -> bool {
        let seen = &mut self.seen[y as usize * (self.drawing.width + 1) + x as usize];
        let is_new = *seen & (1 << step) == 0;
        *seen |= 1 << step;
        is_new
    }

    fn is_outline(&self, [x, y]: [i64; 2], step: usize) -> bool {
        let [right, left] = match step {
            0 => [[x, y], [x, y - 1]],
            1 => [[x - 1, y], [x, y]],
            2 => [[x - 1, y - 1], [x - 1, y]],
            _ => [[x, y - 1], [x - 1, y - 1]],
        };
        self.is_occupied(right) && !self.is_occupied(left)
    }

    fn is_occupied(&self, [x, y]: [i64; 2]) -> bool {
        let (width, height) = (self.drawing.width as i64, self.drawing.height as i64);
        (0..width).contains(&x) && (0..height).contains(&y) && self.occupied[(y * width + x) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// Of a drawing of 1200 x 800 pixels.
    fn of(is_wall: impl Fn(f64, f64) -> bool) -> f64 {
        let drawing = Drawing::of_sheet(&Mask::empty(1200, 800), 0.05);
        let occupied: Vec<bool> =
            (0..1200 * 800).map(|i| is_wall(f64::from(i % 1200), f64::from(i / 1200))).collect();
        straightness(&drawing, &occupied)
    }

    #[test]
    fn walls_are_straight_at_any_angle() {
        for degrees in 0..30 {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let wall = of(|x, y| {
                let (x, y) = (x - 600.0, y - 400.0);
                (x * cos + y * sin).abs() < 360.0 && (y * cos - x * sin).abs() < 8.0
            });
            assert!(wall > 0.9, "{degrees} degrees: {wall}");
        }
    }

    #[test]
    fn blots_are_not_straight() {
        assert!(of(|x, y| (x % 80.0 - 40.0).hypot(y % 80.0 - 40.0) < 28.0) < 0.1);
        assert_eq!(of(|_, _| false), 0.0);
    }
}
