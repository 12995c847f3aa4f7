//! Frontiers: where the cells of a room border on unknown ones.

use super::super::super::straight::Labelled;
use super::Explored;
use super::field::{Field, Shown, Side, middle};
use super::lines::{self, Lines};
use planform_sdk::Segment;

/// A connected stretch of a room's border without a wall.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Index of the room.
    pub room: usize,
    /// The room's cells along it, rising.
    pub cells: Vec<usize>,
    /// From end to end, metres.
    pub length: f64,
}

impl Run {
    /// From one end to the other, metres.
    pub fn chord(&self, input: &Labelled<'_>) -> Segment {
        let [a, b] = ends(&self.cells, input.free.width());
        Segment::new(middle(input, a), middle(input, b))
    }
}

/// Two cells that are far apart.
fn ends(cells: &[usize], width: usize) -> [usize; 2] {
    let square =
        |a: usize, b: usize| (a % width).abs_diff(b % width).pow(2) + (a / width).abs_diff(b / width).pow(2);
    let far = |from: usize| cells.iter().copied().max_by_key(|&c| (square(from, c), c)).unwrap_or(from);
    let a = far(cells.first().copied().unwrap_or(0));
    [a, far(a)]
}

/// The runs of all rooms, room by room.
pub fn runs(input: &Labelled<'_>, lines: &[Lines], params: &Explored) -> Vec<Run> {
    let looks = Looks { input, depth: (params.depth / input.resolution).ceil().max(1.0) as i64 };
    let is_open = |i: usize| looks.is_open(i) && !is_grazed(input, i, lines, params);
    let mut open = vec![false; input.label.len()];
    for i in borders(input) {
        open[i] = is_open(i);
    }
    let reach = (params.gap / input.resolution).floor().max(1.0) as i64;
    let mut runs = connected(input, &open, reach);
    runs.sort_by_key(|r| r.room);
    runs
}

/// The free cells of rooms with a cell of no room beside, or at the end of the grid, rising.
fn borders(input: &Labelled<'_>) -> Vec<usize> {
    let bare = input.free.with_bits(input.label.iter().map(|&l| l == 0).collect());
    let borders = input.free.and(&bare.beside()).without(&bare);
    borders.runs().flat_map(|run| run.cells(borders.width())).collect()
}

/// Whether a cell is open only where the room has a wall: far along a corridor few rays meet it.
fn is_grazed(input: &Labelled<'_>, cell: usize, lines: &[Lines], params: &Explored) -> bool {
    let room = input.label[cell] as usize - 1;
    let Some(lines) = lines::sharpest(lines, room) else { return false };
    let field = Field { input, label: input.label, frame: lines.frame };
    let place = field.middle(cell);
    Side::ALL.into_iter().any(|side| {
        let mut out = place;
        out[side.axis] += side.sense() * input.resolution / 2.0;
        let open = field.depth(out, side, params.depth).1 == Shown::Unknown;
        open && lines.is_wall(room, side, out[side.axis])
    })
}

/// The open cells of each room in groups that hang together over gaps of `reach` cells.
fn connected(input: &Labelled<'_>, open: &[bool], reach: i64) -> Vec<Run> {
    let width = input.free.width();
    let mut done = vec![false; open.len()];
    let mut runs = Vec::new();
    for start in 0..open.len() {
        if !open[start] || done[start] {
            continue;
        }
        done[start] = true;
        let (label, mut cells, mut next) = (input.label[start], vec![start], 0);
        while let Some(&at) = cells.get(next) {
            next += 1;
            let (c, r) = ((at % width) as i64, (at / width) as i64);
            for row in r - reach..=r + reach {
                for column in c - reach..=c + reach {
                    let Some(i) = input.free.index(column, row) else { continue };
                    if open[i] && !done[i] && input.label[i] == label {
                        done[i] = true;
                        cells.push(i);
                    }
                }
            }
        }
        cells.sort_unstable();
        let mut run = Run { room: label as usize - 1, cells, length: 0.0 };
        run.length = run.chord(input).length() + input.resolution;
        runs.push(run);
    }
    runs
}

struct Looks<'a> {
    input: &'a Labelled<'a>,
    /// How many cells must be unknown.
    depth: i64,
}

impl Looks<'_> {
    /// Whether a cell of a room borders on the unknown.
    fn is_open(&self, cell: usize) -> bool {
        let label = self.input.label[cell] as usize;
        if label == 0 || label > self.input.rooms || !self.input.free.bits()[cell] {
            return false;
        }
        let width = self.input.free.width();
        let (c, r) = ((cell % width) as i64, (cell / width) as i64);
        [(1, 0), (-1, 0), (0, 1), (0, -1)].into_iter().any(|d| self.is_open_towards((c, r), d))
    }

    /// Whether all is unknown in a direction, and no obstacle beside.
    fn is_open_towards(&self, (c, r): (i64, i64), (dx, dy): (i64, i64)) -> bool {
        (1..=self.depth).all(|k| {
            let (x, y) = (c + k * dx, r + k * dy);
            self.is_unknown(x, y)
                && !self.input.obstacles.get(x + dy, y + dx)
                && !self.input.obstacles.get(x - dy, y - dx)
        })
    }

    fn is_unknown(&self, column: i64, row: i64) -> bool {
        let at = self.input.free.index(column, row);
        at.is_none_or(|i| self.input.label[i] == 0 && !self.input.obstacles.bits()[i])
    }
}
