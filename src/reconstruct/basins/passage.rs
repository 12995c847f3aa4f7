//! Where two regions of the free space meet: how wide the passage is, and what stands around it.

use super::clearance::Clearance;
use super::space::Space;
use super::watershed::gaussian;
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;

/// How far wall is looked for beyond either end of a passage, metres.
const BEYOND: f64 = 1.5;

/// Angles at which wall is looked for, to either side of the chord's: 9 within 18 degrees.
const TURNS: i32 = 4;

/// Angle between two of them, radians.
const TURN: f64 = 0.0785;

/// A cell with less clearance than this lies on a wall, metres: two cells at 0.05 m.
const ON_WALL: f64 = 0.11;

/// How far to either side a wall has to have free space to count as one, metres.
const BESIDE: [f64; 4] = [0.3, 0.45, -0.3, -0.45];

/// Width of the Gaussian that tells a wall's tip from its flank, standard deviation in metres.
const TIP: f64 = 0.267;

/// The most obstacle cells on a side of a boundary that are tried as ends of the chord.
const TRIED: usize = 80;

/// What a space shows: free cells and their clearance.
pub struct View<'a> {
    /// The free cells.
    pub space: &'a Space,
    /// Their clearance.
    pub clearance: &'a Clearance,
    /// Half a Gaussian kernel of [`TIP`].
    kernel: Vec<f32>,
}

/// A connected piece of the boundary between two regions. Lengths in metres.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The two obstacle cells between which the passage is narrowest, as column and row.
    pub ends: [(f64, f64); 2],
    /// Their distance.
    pub gap: f64,
    /// The largest clearance on the boundary.
    pub saddle: f64,
    /// Length of the boundary: its number of cells.
    pub length: f64,
    /// Angle of the line through the passage along which most wall lies, radians.
    pub angle: f64,
    /// Wall along that line beyond the end with less and the one with more of it.
    pub wall: [f64; 2],
    /// Share of free space around the end with less and the one with more of it: above a half at a wall's tip.
    pub tip: [f64; 2],
    /// The larger of the largest clearances within about the passage's width to either side.
    pub wide: f64,
    /// How far one can go straight on from the passage, to the nearer side.
    pub depth: f64,
}

impl<'a> View<'a> {
    /// The view of a space.
    pub fn new(space: &'a Space, clearance: &'a Clearance) -> Self {
        Self { space, clearance, kernel: gaussian(TIP / space.resolution) }
    }

    fn at(&self, i: usize) -> (f64, f64) {
        ((i % self.space.width) as f64, (i / self.space.width) as f64)
    }

    /// Clearance at a place, metres; none outside.
    fn clear(&self, x: f64, y: f64) -> Option<f64> {
        self.space.index(x, y).map(|i| f64::from(self.clearance.metres[i]))
    }

    /// The pieces of a boundary, given its cells; some may come twice.
    pub fn passages(&self, cells: &[u32]) -> Vec<Passage> {
        let mut cells = cells.to_vec();
        cells.sort_unstable();
        cells.dedup();
        self.pieces(&cells).iter().map(|p| self.passage(p)).collect()
    }

    /// Cells that are at most two apart hang together.
    fn pieces(&self, cells: &[u32]) -> Vec<Vec<u32>> {
        let position: HashMap<u32, usize> = cells.iter().enumerate().map(|(k, &c)| (c, k)).collect();
        let width = self.space.width as i64;
        let mut taken = vec![false; cells.len()];
        let mut pieces = Vec::new();
        for start in 0..cells.len() {
            if std::mem::replace(&mut taken[start], true) {
                continue;
            }
            let mut piece = vec![start];
            let mut next = 0;
            while next < piece.len() {
                let cell = i64::from(cells[piece[next]]);
                next += 1;
                for step in (-2..=2).flat_map(|dy| (-2..=2).map(move |dx| dy * width + dx)) {
                    if let Some(&k) = u32::try_from(cell + step).ok().and_then(|c| position.get(&c))
                        && !std::mem::replace(&mut taken[k], true)
                    {
                        piece.push(k);
                    }
                }
            }
            piece.sort_unstable();
            pieces.push(piece.into_iter().map(|k| cells[k]).collect());
        }
        pieces
    }

    fn passage(&self, piece: &[u32]) -> Passage {
        let clear = |c: u32| self.clearance.metres[c as usize];
        let top = piece.iter().copied().fold(piece[0], |a, b| if clear(b) > clear(a) { b } else { a });
        let ends = self.chord(piece, top);
        let [a, b] = ends;
        let gap = (a.0 - b.0).hypot(a.1 - b.1) * self.space.resolution;
        let middle = ((a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0);
        let chord = (a.1 - b.1).atan2(a.0 - b.0);
        let (angle, wall) = self.line(middle, chord, gap);
        let tips = ends.map(|e| self.tip(e));
        let saddle = f64::from(clear(top));
        let sides = [FRAC_PI_2, -FRAC_PI_2].map(|turn| self.beyond(middle, chord + turn, saddle, gap));
        Passage {
            ends,
            gap,
            saddle,
            length: piece.len() as f64 * self.space.resolution,
            angle,
            wall,
            tip: [tips[0].min(tips[1]), tips[0].max(tips[1])],
            wide: sides[0].0.max(sides[1].0),
            depth: sides[0].1.min(sides[1].1),
        }
    }

    /// The nearest two obstacle cells on opposite sides of the boundary. The obstacle nearest to its widest place
    /// tells which side is which; on a dead end the other side is that obstacle's mirror image.
    fn chord(&self, piece: &[u32], top: u32) -> [(f64, f64); 2] {
        let nearest = |c: u32| self.at(self.clearance.nearest[c as usize] as usize);
        let (from, own) = (self.at(top as usize), nearest(top));
        let towards = (own.0 - from.0, own.1 - from.1);
        let step = 1 + piece.len() / TRIED;
        let tried = piece.iter().enumerate().filter(|(k, c)| (k + 1) % step == 0 || **c == top);
        let side = |e: &(f64, f64)| (e.0 - from.0) * towards.0 + (e.1 - from.1) * towards.1;
        let (mut near, mut far) = (Vec::new(), Vec::new());
        for e in tried.map(|(_, &c)| nearest(c)) {
            let s = side(&e);
            if s > 0.0 {
                near.push(e);
            } else if s < 0.0 {
                far.push(e);
            }
        }
        let mut best: Option<(f64, [(f64, f64); 2])> = None;
        for a in near {
            for &b in &far {
                let square = (a.0 - b.0).powi(2) + (a.1 - b.1).powi(2);
                if best.is_none_or(|s| square < s.0) {
                    best = Some((square, [a, b]));
                }
            }
        }
        let within = |v: f64, n: usize| v.clamp(0.0, n as f64 - 1.0);
        let mirrored =
            (within(2.0 * from.0 - own.0, self.space.width), within(2.0 * from.1 - own.1, self.space.height));
        best.map_or([own, mirrored], |b| b.1)
    }

    /// Of the lines through the middle of a passage the one along which most wall lies at both ends, and how much.
    fn line(&self, middle: (f64, f64), chord: f64, gap: f64) -> (f64, [f64; 2]) {
        let mut best = (f64::MIN, chord, [0.0; 2]);
        for k in -TURNS..=TURNS {
            let angle = chord + f64::from(k) * TURN;
            let sides = [1.0, -1.0].map(|sign| self.wall_beyond(middle, angle, sign, gap));
            let (a, b) = (sides[0].0, sides[1].0);
            let longer = (sides[0].1 + sides[1].1 - gap).max(0.0);
            let score = a.min(b) + 0.5 * a.max(b) - 0.5 * longer - 0.02 * f64::from(k.abs());
            if score > best.0 {
                best = (score, angle, [a.min(b), a.max(b)]);
            }
        }
        (best.1, best.2)
    }

    /// Wall beyond one end of a passage along a line, and how far that end is from the middle.
    fn wall_beyond(&self, middle: (f64, f64), angle: f64, sign: f64, gap: f64) -> (f64, f64) {
        let res = self.space.resolution;
        let (sin, cos) = angle.sin_cos();
        let at = |t: f64| (middle.0 + sign * cos * t, middle.1 + sign * sin * t);
        let mut t = 0.0;
        while t * res <= gap + 0.6 {
            let p = at(t);
            let Some(clear) = self.clear(p.0, p.1) else { break };
            if clear == 0.0 || (clear <= 0.051 && t * res > 0.05) {
                break;
            }
            t += 1.0;
        }
        let steps = (BEYOND / res) as usize;
        let mut wall = 0.0;
        for k in 1..=steps {
            let p = at(t + k as f64);
            let Some(clear) = self.clear(p.0, p.1) else { break };
            let beside = |q: f64| self.clear(p.0 - sin * q / res, p.1 + cos * q / res);
            if clear <= ON_WALL && BESIDE.iter().any(|&q| beside(q).is_some_and(|c| c > ON_WALL)) {
                wall += res;
            }
        }
        (wall, t * res)
    }

    /// The share of free space around a cell, through a Gaussian.
    fn tip(&self, (x, y): (f64, f64)) -> f64 {
        let reach = self.kernel.len() as i64 - 1;
        let (width, height) = (self.space.width as i64, self.space.height as i64);
        let (x, y) = (x as i64, y as i64);
        let mut share = 0.0;
        for dy in (-reach).max(-y)..=reach.min(height - 1 - y) {
            let row = &self.space.free[((y + dy) * width) as usize..][..width as usize];
            let columns = (-reach).max(-x)..=reach.min(width - 1 - x);
            let free = columns.filter(|dx| row[(x + dx) as usize]);
            let across: f32 = free.map(|dx| self.kernel[dx.unsigned_abs() as usize]).sum();
            share += f64::from(across * self.kernel[dy.unsigned_abs() as usize]);
        }
        share
    }

    /// What lies to one side of a passage: the largest clearance within about its width, and how far one can go.
    fn beyond(&self, middle: (f64, f64), angle: f64, saddle: f64, gap: f64) -> (f64, f64) {
        let res = self.space.resolution;
        let near = gap.max(1.2) / res;
        let (mut wide, mut depth) = (saddle * 0.5, 0.0);
        for k in -2..=2 {
            let (sin, cos) = (angle + f64::from(k) * 0.35).sin_cos();
            let limit = if k == 0 { 8.0 / res } else { near };
            let mut t = 0.0;
            while t < limit {
                let Some(clear) = self.clear(middle.0 + cos * t, middle.1 + sin * t) else { break };
                if clear == 0.0 && t * res > 0.15 {
                    break;
                }
                if t <= near {
                    wide = f64::max(wide, clear);
                }
                t += 1.0;
            }
            if k == 0 {
                depth = t * res;
            }
        }
        (wide, depth)
    }
}

#[cfg(test)]
mod tests {
    use super::super::clearance;
    use super::super::space::tests::space;
    use super::*;

    /// Two rooms of 4 m with a door of 0.8 m in the wall between them.
    fn door() -> (Space, Vec<u32>) {
        let room = format!("{}#{}", ".".repeat(40), ".".repeat(40));
        let open = ".".repeat(81);
        let mut rows = vec![room.as_str(); 16];
        rows.extend([open.as_str(); 8]);
        rows.extend(vec![room.as_str(); 16]);
        let space = space(&rows, 0.1);
        let cells = (17..25).map(|r| (r * space.width + 41) as u32).collect();
        (space, cells)
    }

    #[test]
    fn a_door_has_its_width_and_wall_at_both_ends() {
        let (space, cells) = door();
        let clearance = clearance::measure(&space);
        let found = View::new(&space, &clearance).passages(&cells);
        assert_eq!(found.len(), 1);
        let p = &found[0];
        assert!((p.gap - 0.9).abs() < 1e-9, "{p:?}");
        assert!(p.wall[0] > 1.2 && (p.saddle - 0.4).abs() < 0.11, "{p:?}");
        assert!((p.angle.abs() - FRAC_PI_2).abs() < 0.01 && p.tip[0] > 0.5, "{p:?}");
        assert!(p.depth > 3.8 && p.wide > 1.0, "{p:?}");
    }

    #[test]
    fn pieces_that_lie_apart_are_passages_of_their_own() {
        let (space, mut cells) = door();
        cells.drain(3..6);
        let clearance = clearance::measure(&space);
        assert_eq!(View::new(&space, &clearance).passages(&cells).len(), 2);
    }
}
