//! The graph of regions: basins of the free space that grow together to rooms, and the boundaries between them.

use super::super::runs::{label_runs, meetings};
use super::hull::{Hull, Row};
use super::passage::{Passage, View};
use super::stated::Stated;
use super::watershed::Basins;
use planform_sdk::parallel;
use std::collections::{BTreeMap, BTreeSet};

/// Walls up to twice this thickness have a region on either side, metres.
const WALL: f64 = 0.35;

/// Two regions with less known door between them only touch at its jamb, metres.
const DOOR: f64 = 0.3;

/// With fewer pairs of regions at a known door the document does not show its doors.
const DOORS: usize = 4;

/// A region larger than this is a room though nothing is written in it, square metres.
const PIECE: f64 = 8.0;

/// A region: one basin or several.
#[derive(Debug, Clone, Default)]
pub struct Region {
    /// Square metres.
    pub area: f64,
    /// The largest clearance, metres.
    pub clearance: f64,
    /// The sum of the clearance over its cells; metres.
    pub total_clearance: f64,
    /// The hull of its cells, and the hull's area in square metres.
    pub hull: Hull,
    /// Area of the hull, square metres.
    pub hull_area: f64,
    /// Its basins.
    pub basins: Vec<u32>,
    /// How many cells it has.
    cells: usize,
    /// The regions that it meets.
    pub beside: BTreeSet<u32>,
    /// Metres of wall that it shares with other regions.
    walls: BTreeMap<u32, f64>,
    /// Metres of known door that it shares with other regions.
    doors: BTreeMap<u32, f64>,
    /// Whether something is written in it.
    named: bool,
    /// Its part of the free space between stated openings.
    chamber: u32,
}

impl Region {
    /// Length over width of a strip that has the region's area and mean clearance.
    pub fn elongation(&self) -> f64 {
        let mean = self.mean_clearance();
        self.area / (16.0 * mean * mean + 1e-3)
    }

    /// The mean clearance: a quarter of the width of a strip, a sixth of the side of a square. Metres.
    pub fn mean_clearance(&self) -> f64 {
        self.total_clearance / self.cells.max(1) as f64
    }
}

/// The boundary between two regions.
#[derive(Debug, Clone, Default)]
struct Boundary {
    cells: Vec<u32>,
    passages: Option<Vec<Passage>>,
}

/// The graph.
pub struct Regions<'a> {
    view: &'a View<'a>,
    /// The region of each name; one that was merged has no basins left.
    regions: Vec<Region>,
    boundaries: BTreeMap<(u32, u32), Boundary>,
    /// Whether the document shows its doors as such.
    shows_doors: bool,
    /// Whether the document states all openings.
    states_openings: bool,
}

/// The two, the smaller first.
pub fn pair(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

impl<'a> Regions<'a> {
    /// One region for each basin.
    pub fn of_basins(view: &'a View<'a>, basins: &Basins) -> Self {
        let mut graph = Self {
            view,
            regions: single_regions(view, basins),
            boundaries: BTreeMap::new(),
            shows_doors: false,
            states_openings: false,
        };
        let label = &basins.label;
        meetings(label, view.space.width, |m| {
            let beside = pair(label[m.cell], label[m.other]);
            graph.boundaries.entry(beside).or_default().cells.push(m.cell as u32);
        });
        let mut found: Vec<(&(u32, u32), &mut Boundary)> = graph.boundaries.iter_mut().collect();
        let passages = parallel::map(found.len(), |i| view.passages(&found[i].1.cells));
        found.iter_mut().zip(passages).for_each(|((_, b), passages)| b.passages = Some(passages));
        let pairs: Vec<(u32, u32)> = graph.boundaries.keys().copied().collect();
        for (a, b) in pairs {
            graph.regions[a as usize].beside.insert(b);
            graph.regions[b as usize].beside.insert(a);
        }
        let grown = view.space.grown(&basins.label, WALL);
        meetings(&grown, view.space.width, |m| {
            if view.space.free[m.cell] && view.space.free[m.other] {
                return;
            }
            for (a, b) in [(grown[m.cell], grown[m.other]), (grown[m.other], grown[m.cell])] {
                *graph.regions[a as usize].walls.entry(b).or_default() += view.space.resolution;
            }
        });
        graph
    }

    /// All regions with their names, by rising name.
    pub fn all(&self) -> impl Iterator<Item = (u32, &Region)> {
        (0..).zip(&self.regions).filter(|(_, r)| !r.basins.is_empty())
    }

    /// The region of this name, unless it was merged.
    pub fn get(&self, name: u32) -> Option<&Region> {
        self.regions.get(name as usize).filter(|r| !r.basins.is_empty())
    }

    /// The regions that one meets, by rising name.
    pub fn beside(&self, name: u32) -> Vec<u32> {
        self.get(name).map(|r| r.beside.iter().copied().collect()).unwrap_or_default()
    }

    /// All pairs of regions that meet, in rising order.
    pub fn pairs(&self) -> Vec<(u32, u32)> {
        self.boundaries.keys().copied().collect()
    }

    /// Metres per cell.
    pub fn resolution(&self) -> f64 {
        self.view.space.resolution
    }

    /// Metres of wall between two regions.
    pub fn wall(&self, a: u32, b: u32) -> f64 {
        self.get(a).and_then(|r| r.walls.get(&b)).copied().unwrap_or(0.0)
    }

    /// Tells of known doors: metres of door between two regions.
    pub fn know_doors(&mut self, doors: &BTreeMap<(u32, u32), f64>) {
        self.shows_doors = doors.len() >= DOORS;
        for (&(a, b), &metres) in doors {
            self.regions[a as usize].doors.insert(b, metres);
            self.regions[b as usize].doors.insert(a, metres);
        }
    }

    /// Tells in which regions something is written.
    pub fn know_names(&mut self, named: &BTreeSet<u32>) {
        named.iter().for_each(|&r| self.regions[r as usize].named = true);
    }

    /// Tells of the openings that the document states.
    pub fn know_openings(&mut self, stated: &Stated) {
        self.states_openings = true;
        for (region, &chamber) in self.regions.iter_mut().zip(&stated.chambers) {
            region.chamber = chamber;
        }
        for (&(a, b), &metres) in &stated.between {
            self.regions[a as usize].doors.insert(b, metres);
            self.regions[b as usize].doors.insert(a, metres);
        }
    }

    /// Whether the document states that two regions are one room, or that they are not.
    pub fn stated_one(&self, a: u32, b: u32) -> Option<bool> {
        let same = self.get(a)?.chamber == self.get(b)?.chamber;
        self.states_openings.then(|| same && !self.door(a, b))
    }

    /// Whether one of two regions is likely a piece of the other's room: it is small, nothing is written in it, and the
    /// document shows doors, but none between the two.
    pub fn likely_one(&self, a: u32, b: u32) -> bool {
        let is_piece = |r: u32| self.get(r).is_some_and(|r| !r.named && r.area <= PIECE);
        self.shows_doors && !self.door(a, b) && (is_piece(a) || is_piece(b))
    }

    /// Whether a known door parts two regions.
    pub fn door(&self, a: u32, b: u32) -> bool {
        self.get(a).and_then(|r| r.doors.get(&b)).is_some_and(|&metres| metres >= DOOR)
    }

    /// The passages between two regions.
    pub fn passages(&mut self, a: u32, b: u32) -> &[Passage] {
        let Some(boundary) = self.boundaries.get_mut(&pair(a, b)) else { return &[] };
        boundary.passages.get_or_insert_with(|| self.view.passages(&boundary.cells))
    }

    /// Merges two regions that meet; the larger one keeps its name, which is returned.
    pub fn merge(&mut self, a: u32, b: u32) -> Option<u32> {
        let (kept, gone) = if self.get(a)?.area < self.get(b)?.area { (b, a) } else { (a, b) };
        self.get(gone)?;
        let merged = std::mem::take(&mut self.regions[gone as usize]);
        self.boundaries.remove(&pair(a, b));
        self.take_boundaries(kept, gone, &merged);
        self.take_shared(kept, gone, &merged.walls, |r| &mut r.walls);
        self.take_shared(kept, gone, &merged.doors, |r| &mut r.doors);
        let resolution = self.view.space.resolution;
        let region = &mut self.regions[kept as usize];
        region.area += merged.area;
        region.cells += merged.cells;
        region.clearance = region.clearance.max(merged.clearance);
        region.total_clearance += merged.total_clearance;
        region.hull = region.hull.join(&merged.hull);
        region.hull_area = region.hull.area() * resolution * resolution;
        region.named |= merged.named;
        region.basins.extend(merged.basins);
        Some(kept)
    }

    fn take_boundaries(&mut self, kept: u32, gone: u32, merged: &Region) {
        self.regions[kept as usize].beside.remove(&gone);
        for &other in merged.beside.iter().filter(|&&o| o != kept) {
            let moved = self.boundaries.remove(&pair(gone, other)).unwrap_or_default();
            match self.boundaries.entry(pair(kept, other)) {
                std::collections::btree_map::Entry::Vacant(e) => {
                    e.insert(moved);
                }
                std::collections::btree_map::Entry::Occupied(mut e) => {
                    e.get_mut().cells.extend(moved.cells);
                    e.get_mut().passages = None;
                }
            }
            let beside = &mut self.regions[other as usize].beside;
            beside.remove(&gone);
            beside.insert(kept);
            self.regions[kept as usize].beside.insert(other);
        }
    }

    /// What a merged region shared with others is shared by the one that it became part of.
    fn take_shared(
        &mut self,
        kept: u32,
        gone: u32,
        shared: &BTreeMap<u32, f64>,
        of: fn(&mut Region) -> &mut BTreeMap<u32, f64>,
    ) {
        of(&mut self.regions[kept as usize]).remove(&gone);
        for (&other, &length) in shared.iter().filter(|w| *w.0 != kept) {
            let theirs = of(&mut self.regions[other as usize]);
            theirs.remove(&gone);
            *theirs.entry(kept).or_default() += length;
            *of(&mut self.regions[kept as usize]).entry(other).or_default() += length;
        }
    }
}

fn single_regions(view: &View<'_>, basins: &Basins) -> Vec<Region> {
    let space = view.space;
    let count = basins.count as usize + 1;
    let (mut cells, mut most, mut total) = (vec![0usize; count], vec![0.0f32; count], vec![0.0f64; count]);
    let mut rows: Vec<Vec<Row>> = vec![Vec::new(); count];
    for (row, labels) in basins.label.chunks_exact(space.width).enumerate() {
        for (run, l) in label_runs(labels).filter(|(_, l)| *l != 0) {
            let l = l as usize;
            cells[l] += run.len();
            for &clear in &view.clearance.metres[row * space.width..][run.clone()] {
                most[l] = most[l].max(clear);
                total[l] += f64::from(clear);
            }
            let run = Row { row: row as f64, from: run.start as f64 - 0.5, to: run.end as f64 - 0.5 };
            match rows[l].last_mut() {
                Some(last) if last.row == run.row => last.to = run.to,
                _ => rows[l].push(run),
            }
        }
    }
    let region = |l: usize| {
        let hull = Hull::of_rows(&std::mem::take(&mut rows[l]));
        let hull_area = hull.area() * space.resolution * space.resolution;
        Region {
            area: space.area(cells[l]),
            clearance: f64::from(most[l]),
            total_clearance: total[l],
            hull,
            hull_area,
            basins: vec![l as u32],
            cells: cells[l],
            beside: BTreeSet::new(),
            walls: BTreeMap::new(),
            named: false,
            chamber: 0,
            doors: BTreeMap::new(),
        }
    };
    // Basins are numbered from 1; the first region stays empty.
    std::iter::once(Region::default()).chain((1..count).map(region)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Cut;
    use super::super::space::tests::space;
    use super::*;

    /// Three rooms of 3 m in a row, with a door between each two.
    fn three() -> Cut {
        let room = ".".repeat(30);
        let (wall, door) = (format!("{room}#{room}#{room}"), ".".repeat(92));
        let mut rows = vec![wall.as_str(); 11];
        rows.extend([door.as_str(); 8]);
        rows.extend(vec![wall.as_str(); 11]);
        Cut::of_space(space(&rows, 0.1))
    }

    #[test]
    fn merged_regions_share_what_they_had() {
        let cut = three();
        let view = cut.view();
        let mut regions = Regions::of_basins(&view, &cut.basins);
        assert_eq!(regions.pairs().len(), 2);
        let total: f64 = regions.all().map(|(_, r)| r.area).sum();
        let middle = regions.all().find(|(_, r)| r.beside.len() == 2).map(|(name, _)| name).unwrap();
        let [a, b] = regions.get(middle).unwrap().beside.iter().copied().collect::<Vec<_>>()[..] else {
            panic!("the room in the middle has two neighbours")
        };
        assert!((regions.wall(a, middle) - 2.2).abs() < 0.3, "{}", regions.wall(a, middle));
        let both = regions.get(a).unwrap().area + regions.get(middle).unwrap().area;
        let kept = regions.merge(a, middle).unwrap();
        assert_eq!(regions.pairs(), [pair(kept, b)]);
        assert!((regions.get(kept).unwrap().area - both).abs() < 1e-9);
        assert!((regions.wall(kept, b) - 2.2).abs() < 0.3, "{}", regions.wall(kept, b));
        assert_eq!(regions.passages(kept, b).len(), 1);
        assert_eq!(regions.merge(a, middle), None);
        regions.merge(kept, b);
        let left: Vec<_> = regions.all().map(|(_, r)| (r.area, r.basins.len())).collect();
        assert_eq!((left.len(), left[0].1), (1, cut.basins.count as usize));
        assert!((left[0].0 - total).abs() < 1e-9);
    }
}
