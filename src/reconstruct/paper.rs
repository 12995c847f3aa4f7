//! Algorithm 1 of the paper, step after step.

use super::arrangement::{Arrangement, Edge};
use super::boundary::{self, Run};
use super::drawings::{self, Scale};
use super::lines::Line;
use super::openings::{self, Gap};
use super::outline::{self, Outline};
use super::raster::{Extent, Mask};
use super::walls::{Profile, Seen};
use super::{Drawing, Observer, Params, ReconstructError, Step};
use super::{
    affinity, clutter, collinear, contour, directions, edges, faces, finish, lines, partial, rooms, segments,
};
use planform_sdk::{Cell, Grid, Layout, Point, Polygon, Scene, Segment};

/// Runs all steps.
pub fn reconstruct(
    scene: &Scene,
    params: &Params,
    observer: &mut dyn Observer,
) -> Result<Layout, ReconstructError> {
    let mut run = Paper { params, observer, resolution: scene.grid.resolution() };
    let map = run.map(&scene.grid)?;
    let segments = run.segments(&map)?;
    let lines = run.lines(&segments);
    let division = run.faces(&map, lines, &segments)?;
    let rooms = run.rooms(&division);
    Ok(run.layout(scene, &map, &division, rooms))
}

struct Paper<'a> {
    params: &'a Params,
    observer: &'a mut dyn Observer,
    resolution: f64,
}

/// The map without clutter.
pub struct Map {
    /// The walls' cells.
    pub walls: Mask,
    /// The free cells, those under clutter included.
    pub free: Mask,
    /// The inner area.
    pub inner: Mask,
    /// The box around the inner area.
    pub extent: Extent,
}

/// The area divided into faces.
pub struct Division {
    /// The lines, the representative ones first, then those that close partial rooms.
    pub lines: Vec<Line>,
    /// How many of the lines are representative.
    pub representative: usize,
    /// The faces.
    pub arrangement: Arrangement,
    /// The edges between them.
    pub edges: Vec<Edge>,
    /// The weight of each edge.
    pub weights: Vec<f64>,
    /// For each face whether it is internal or partial, not external.
    pub member: Vec<bool>,
    /// Corners of the area.
    pub bounds: (Point, Point),
}

/// The faces clustered to rooms.
pub struct Clusters {
    /// The room of each face.
    pub of: Vec<Option<usize>>,
    /// The outline of each room.
    pub outlines: Vec<Outline>,
    /// For each face whether it is partial.
    pub partial: Vec<bool>,
}

/// The rooms as built.
pub struct Built {
    /// The rooms' faces and outlines.
    pub clusters: Clusters,
    /// The boundaries between them.
    pub runs: Vec<Run>,
    /// What the map shows along each boundary.
    pub profiles: Vec<Profile>,
    /// The floor of each room.
    pub floors: Vec<Polygon>,
}

impl Paper<'_> {
    fn begin(&mut self, step: Step) {
        self.observer.step(step);
    }

    fn draw(&mut self, step: Step, drawing: impl FnOnce() -> Drawing) {
        if self.observer.wants_drawings() {
            self.observer.drawing(step, drawing());
        }
    }

    fn map(&mut self, grid: &Grid) -> Result<Map, ReconstructError> {
        self.begin(Step::Clutter);
        let limits = &self.params.contour;
        let occupancy = |c: Cell, is: &dyn Fn(u8) -> bool| c.occupancy().is_some_and(is);
        let obstacles = Mask::of_grid(grid, |c| occupancy(c, &|o| o >= limits.obstacle));
        let free = Mask::of_grid(grid, |c| occupancy(c, &|o| o <= limits.free));
        let walls = clutter::remove(&obstacles, self.resolution, &self.params.clutter)?;
        let free = free.or(&obstacles.without(&walls));
        self.draw(Step::Clutter, || drawings::cleared(&obstacles, &walls));
        let inner = contour::inner_area(&free, self.resolution, limits);
        let extent = inner.extent().ok_or(ReconstructError::NoFreeSpace)?;
        Ok(Map { walls, free, inner, extent })
    }

    fn segments(&mut self, map: &Map) -> Result<Vec<Segment>, ReconstructError> {
        self.begin(Step::Edges);
        let edges = edges::detect(&map.walls, &self.params.edges);
        self.draw(Step::Edges, || drawings::edges(&edges));
        self.begin(Step::Segments);
        let segments = segments::detect(&edges, self.resolution, &self.params.segments);
        let scale = Scale(self.resolution);
        self.draw(Step::Segments, || scale.segments(&segments));
        self.begin(Step::Contour);
        self.draw(Step::Contour, || drawings::area(&map.inner));
        if segments.is_empty() { Err(ReconstructError::NoWalls) } else { Ok(segments) }
    }

    fn lines(&mut self, segments: &[Segment]) -> Vec<Line> {
        let scale = Scale(self.resolution);
        self.begin(Step::Directions);
        let directions = directions::cluster(segments, &self.params.directions);
        self.draw(Step::Directions, || scale.directions(&directions));
        self.begin(Step::Collinear);
        let clusters = collinear::cluster(&directions, &self.params.collinear);
        self.draw(Step::Collinear, || scale.collinears(&clusters));
        self.begin(Step::Lines);
        lines::represent(&clusters, &self.params.lines)
    }

    fn faces(
        &mut self,
        map: &Map,
        mut lines: Vec<Line>,
        segments: &[Segment],
    ) -> Result<Division, ReconstructError> {
        let (scale, limits) = (Scale(self.resolution), &self.params.faces);
        let bounds = corners(map.extent, self.resolution, limits.margin);
        let clipped = || lines.iter().filter_map(|l| l.within(bounds.0, bounds.1)).collect::<Vec<_>>();
        self.draw(Step::Lines, || scale.lines(&clipped()));
        self.begin(Step::Faces);
        let representative = lines.len();
        let arrangement = Arrangement::of_lines(bounds.0, bounds.1, &lines, limits.max_count);
        let mut arrangement = arrangement.ok_or(ReconstructError::TooManyFaces(limits.max_count))?;
        let share = faces::shares(&arrangement, &map.inner, self.resolution);
        let seen = |f: usize| share[f] >= limits.inner_share;
        partial::close(&mut arrangement, &mut lines, segments, &map.inner, self.resolution, seen);
        let share = faces::shares(&arrangement, &map.inner, self.resolution);
        let member: Vec<bool> = share.iter().map(|&s| s >= limits.inner_share).collect();
        let edges = arrangement.edges();
        let weights = affinity::weights(&arrangement, &edges, &lines);
        self.draw(Step::Faces, || scale.faces(&arrangement, &edges, |f| member[f], |_| false));
        Ok(Division { lines, representative, arrangement, edges, weights, member, bounds })
    }

    fn rooms(&mut self, d: &Division) -> Clusters {
        let (scale, member) = (Scale(self.resolution), |f: usize| d.member[f]);
        self.begin(Step::Affinity);
        let count = d.arrangement.count();
        let a = affinity::local_affinity(count, &d.edges, &d.weights, &self.params.affinity, member);
        self.draw(Step::Affinity, || scale.weights(&d.arrangement, &d.edges, &d.weights, member));
        self.begin(Step::Rooms);
        let of = self.with_walls(d, rooms::cluster(&a, &self.params.rooms, member));
        let outlines = outline::outlines(&d.arrangement, &d.edges, &of);
        let polygons: Vec<_> = outlines.iter().map(Outline::polygon).collect();
        self.draw(Step::Rooms, || scale.rooms(polygons.iter().map(|p| (p, false))));
        self.begin(Step::Partial);
        let partial =
            partial::partial_faces(&d.arrangement, &d.edges, &d.weights, &self.params.partial, member);
        self.draw(Step::Partial, || scale.faces(&d.arrangement, &d.edges, member, |f| partial[f]));
        Clusters { of, outlines, partial }
    }

    /// The clusters with the faces that lie within walls given to the rooms beside.
    fn with_walls(&self, d: &Division, mut of: Vec<Option<usize>>) -> Vec<Option<usize>> {
        let rooms = of.iter().flatten().max().map_or(0, |m| m + 1);
        let width = self.params.walls.reach;
        let faces = faces::within_walls(&d.arrangement, &d.edges, width, |f| d.member[f]);
        for (i, &face) in faces.iter().enumerate() {
            of[face] = Some(rooms + i);
        }
        let is_wall: Vec<bool> = (0..rooms + faces.len()).map(|r| r >= rooms).collect();
        let runs = boundary::runs(&d.arrangement, &d.edges, &d.weights, &d.lines, &of);
        rooms::absorb(&of, &is_wall, &runs)
    }

    /// The rooms' boundaries and floors. What has no floor between its walls is a wall, and goes to a neighbour.
    fn built(&self, map: &Map, d: &Division, mut clusters: Clusters) -> Built {
        let seen = Seen { obstacles: &map.walls, free: &map.free, resolution: self.resolution };
        loop {
            let runs = boundary::runs(&d.arrangement, &d.edges, &d.weights, &d.lines, &clusters.of);
            let profiles: Vec<Profile> = runs.iter().map(|r| seen.profile(r, &self.params.walls)).collect();
            let floors = finish::floors(&clusters.outlines, &d.lines, &runs, &profiles);
            let is_wall =
                |f: &Option<Polygon>| f.as_ref().is_none_or(|f| f.area() < self.params.walls.min_floor);
            let walls: Vec<bool> = floors.iter().map(is_wall).collect();
            if !walls.contains(&true) {
                let floors = floors.into_iter().flatten().collect();
                return Built { clusters, runs, profiles, floors };
            }
            clusters.of = rooms::absorb(&clusters.of, &walls, &runs);
            clusters.outlines = outline::outlines(&d.arrangement, &d.edges, &clusters.of);
        }
    }

    fn layout(&mut self, scene: &Scene, map: &Map, d: &Division, clusters: Clusters) -> Layout {
        self.begin(Step::Walls);
        let built = self.built(map, d, clusters);
        let walls = &self.params.walls;
        let along = built.runs.iter().zip(&built.profiles);
        let gaps: Vec<Gap> = along.flat_map(|(r, p)| openings::openings(r, p, walls)).collect();
        let partial = partial::partial_rooms(&built.clusters, &built.runs, &self.params.partial);
        let scale = Scale(self.resolution);
        self.draw(Step::Walls, || {
            let rooms = built.floors.iter().zip(partial.iter().copied());
            scale.layout(rooms, &built.runs, gaps.iter().map(|g| g.segment))
        });
        finish::layout(scene, self.params, &finish::Found { division: d, built: &built, gaps, partial })
    }
}

/// The corners of a box of cells with a margin around it; metres.
fn corners(extent: Extent, resolution: f64, margin: f64) -> (Point, Point) {
    let Extent { low, high } = extent;
    let at = |column: usize, row: usize, m: f64| {
        Point::new(column as f64 * resolution + m, row as f64 * resolution + m)
    };
    (at(low.0, low.1, -margin), at(high.0 + 1, high.1 + 1, margin))
}
