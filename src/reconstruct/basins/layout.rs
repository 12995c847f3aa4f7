//! From a scene to a layout: the steps in their order.

use super::super::doors::{self, Door};
use super::super::drawings::{self, Scale};
use super::super::finish::{self, Frame};
use super::super::names::{self, Called};
use super::super::openings::Gap;
use super::super::raster::Mask;
use super::super::shown::Shown;
use super::super::straight::{self, Labelled, Plan, RoomPlan, Straight, StraightWall};
use super::super::{Drawing, Observer, Params, ReconstructError, Step};
use super::explored::{self, Border, Explored, Knowledge};
use super::model::Model;
use super::space::Space;
use super::{Cut, aligned, merge, pockets};
use planform_sdk::{Frontier, Grid, Layout, Opening, Room, RoomId, RoomState, Scene, StatedOpening, Wall};

/// Runs all steps.
pub fn reconstruct(
    scene: &Scene,
    params: &Params,
    observer: &mut dyn Observer,
) -> Result<Layout, ReconstructError> {
    let mut run = Run { params, observer };
    let map = Map::of(&scene.grid, params);
    let shown = Shown::of_scene(scene);
    let cut = run.cut(&scene.grid, &map, &shown)?;
    if !map.obstacles.bits().contains(&true) {
        return Err(ReconstructError::NoWalls);
    }
    let rooms = run.rooms(&cut, &scene.grid, &map);
    // It is as large as all the rest.
    drop(cut);
    let stated = shown.openings.as_deref().unwrap_or_default();
    let (known, main) = run.known(&map, &rooms, scene.grid.resolution(), stated);
    // Rooms that were not completed run as they did.
    let main = Some(main).filter(|_| known.label == rooms.label && stated.is_empty());
    let plan = run.plan(&map, &known, main, scene.grid.resolution(), stated);
    Ok(layout(
        params,
        &Found {
            scene,
            frame: Frame(&scene.grid),
            plan: &plan,
            known: &known,
            doors: &shown.doors,
            ids: ids(&plan),
        },
    ))
}

struct Run<'a> {
    params: &'a Params,
    observer: &'a mut dyn Observer,
}

/// What the grid shows.
struct Map {
    free: Mask,
    obstacles: Mask,
}

impl Map {
    fn of(grid: &Grid, params: &Params) -> Self {
        let limits = &params.contour;
        Self {
            free: Mask::of_grid(grid, |c| c.occupancy().is_some_and(|o| o <= limits.free)),
            obstacles: Mask::of_grid(grid, |c| c.occupancy().is_some_and(|o| o >= limits.obstacle)),
        }
    }

    /// The cells that are neither free nor occupied.
    fn closed(&self) -> Mask {
        let bits = self.free.bits().iter().zip(self.obstacles.bits()).map(|(f, o)| !f && !o).collect();
        self.free.with_bits(bits)
    }
}

/// The room of each cell of the grid, from 1, and how many there are.
struct Rooms {
    label: Vec<u32>,
    count: usize,
}

impl Run<'_> {
    fn draw(&mut self, step: Step, drawing: impl FnOnce() -> Drawing) {
        if self.observer.wants_drawings() {
            self.observer.drawing(step, drawing());
        }
    }

    fn cut(&mut self, grid: &Grid, map: &Map, shown: &Shown) -> Result<Cut, ReconstructError> {
        self.observer.step(Step::Clutter);
        let fixed = shown.jambs();
        let space = Space::of_mask(&map.free, grid.resolution(), &self.params.furniture, &fixed)
            .ok_or(ReconstructError::NoFreeSpace)?;
        self.observer.step(Step::Basins);
        let cut = Cut::of_shown(space, shown);
        self.draw(Step::Clutter, || {
            let free = cut.on_grid(grid, |i| u32::from(cut.space.free[i]));
            let free = map.free.with_bits(free.iter().map(|&f| f == 1).collect());
            drawings::cleared(&map.obstacles, &map.obstacles.without(&free))
        });
        self.draw(Step::Basins, || drawings::labels(&map.free, &cut.on_grid(grid, |i| cut.basins.label[i])));
        Ok(cut)
    }

    fn rooms(&mut self, cut: &Cut, grid: &Grid, map: &Map) -> Rooms {
        self.observer.step(Step::Rooms);
        let view = cut.view();
        let mut regions = cut.regions(&view);
        merge::rooms(&mut regions, &Model::default(), &self.params.merge);
        let mut label = cut.rooms(&regions, grid);
        pockets::fill(&mut label, &map.closed(), grid.resolution(), &self.params.furniture);
        let count = label.iter().max().map_or(0, |&m| m as usize);
        self.draw(Step::Rooms, || drawings::labels(&everywhere(&map.free), &label));
        Rooms { label, count }
    }

    /// A map that states its openings was drawn of floors that were completed before.
    fn explored(&self, stated: &[StatedOpening]) -> Explored {
        let params = self.params.explored.clone();
        if stated.is_empty() { params } else { Explored { reach: 0.0, ..params } }
    }

    /// A map that states its openings was drawn of straight walls: what is left to smooth are its cells.
    fn straight(&self, stated: &[StatedOpening]) -> Straight {
        let params = self.params.straight.clone();
        if stated.is_empty() { params } else { Straight { tolerance: 0.0, ..params } }
    }

    /// Which rooms are partial, and all completed; and the building's directions.
    fn known(
        &mut self,
        map: &Map,
        rooms: &Rooms,
        resolution: f64,
        stated: &[StatedOpening],
    ) -> (Knowledge, Vec<f64>) {
        self.observer.step(Step::Partial);
        let Map { free, obstacles } = map;
        let labelled =
            Labelled { resolution, label: &rooms.label, rooms: rooms.count, free, obstacles, stated };
        let straight = &self.params.straight;
        let main = straight::directions(&labelled, straight);
        let known = explored::explore(&labelled, &main, straight, &self.explored(stated));
        self.draw(Step::Partial, || drawings::labels(&everywhere(free), &known.label));
        (known, main)
    }

    /// `main` are the building's directions if they are known.
    fn plan(
        &mut self,
        map: &Map,
        known: &Knowledge,
        main: Option<Vec<f64>>,
        resolution: f64,
        stated: &[StatedOpening],
    ) -> Plan {
        self.observer.step(Step::Walls);
        let Map { free, obstacles } = map;
        let labelled =
            Labelled { resolution, label: &known.label, rooms: known.partial.len(), free, obstacles, stated };
        let straight = self.straight(stated);
        let main = main.unwrap_or_else(|| straight::directions(&labelled, &straight));
        let plan = straight::plan(&labelled, &main, &straight);
        self.draw(Step::Walls, || {
            let rooms = plan.rooms.iter().zip(&known.partial);
            let floors: Vec<_> =
                rooms.filter_map(|(r, partial)| Some((&r.as_ref()?.floor, *partial))).collect();
            let walls = plan.walls.iter().map(|w| (w.line, w.weight));
            Scale(resolution).plan(floors.into_iter(), walls, plan.openings.iter().map(|g| g.segment))
        });
        plan
    }
}

/// All cells of the map.
fn everywhere(map: &Mask) -> Mask {
    map.with_bits(vec![true; map.bits().len()])
}

fn layout(params: &Params, found: &Found<'_>) -> Layout {
    let scene = found.scene;
    Layout {
        rooms: found.rooms(),
        walls: found.walls(),
        openings: found.openings(),
        frontiers: found.frontiers(),
        lines: aligned::lines(&found.plan.walls, params, &found.frame),
        texts: scene.texts.clone(),
        symbols: scene.symbols.clone(),
        anchor: scene.anchor,
        scale: scene.scale.clone(),
        provenance: scene.provenance.clone(),
        method: params.method.name().into(),
    }
}

/// For each room of a plan its id. Rooms without a floor have none, and leave no gap.
fn ids(plan: &Plan) -> Vec<Option<RoomId>> {
    let mut drawn = 0;
    let mut id = |room: &Option<_>| {
        drawn += usize::from(room.is_some());
        room.as_ref().map(|_| finish::id(drawn - 1))
    };
    plan.rooms.iter().map(&mut id).collect()
}

/// All that a layout is made of.
struct Found<'a> {
    scene: &'a Scene,
    frame: Frame<'a>,
    plan: &'a Plan,
    known: &'a Knowledge,
    doors: &'a [Door],
    ids: Vec<Option<RoomId>>,
}

impl Found<'_> {
    fn id(&self, room: usize) -> Option<RoomId> {
        self.ids.get(room).copied().flatten()
    }

    fn rooms(&self) -> Vec<Room> {
        let room = |(i, room): (usize, &Option<RoomPlan>)| {
            let room = room.as_ref()?;
            let inner = self.frame.polygon(&room.floor);
            let Called { name, stated_area } = names::of_room(&self.scene.texts, &inner);
            Some(Room {
                id: self.id(i)?,
                name,
                stated_area,
                state: if self.known.partial[i] { RoomState::Partial } else { RoomState::Complete },
                centre: self.frame.polygon(&room.centre),
                inner,
            })
        };
        self.plan.rooms.iter().enumerate().filter_map(room).collect()
    }

    fn walls(&self) -> Vec<Wall> {
        let wall = |w: &StraightWall| Wall {
            line: self.frame.segment(w.line),
            // Outlines that meet in the midst of a thin wall leave it at least a cell.
            thickness: w.thickness.max(self.scene.grid.resolution()),
            weight: w.weight,
            rooms: w.rooms.map(|r| r.and_then(|r| self.id(r))),
        };
        self.plan.walls.iter().map(wall).collect()
    }

    fn openings(&self) -> Vec<Opening> {
        let opening = |gap: &Gap| {
            let [a, b] = [self.id(gap.rooms[0])?, self.id(gap.rooms[1])?];
            let gap = doors::settled(gap, self.doors);
            Some(Opening { rooms: [a.min(b), a.max(b)], ..finish::opening(&self.frame, &gap) })
        };
        self.plan.openings.iter().filter_map(opening).collect()
    }

    fn frontiers(&self) -> Vec<Frontier> {
        let frontier = |f: &Border| {
            let segment = self.frame.segment(f.segment);
            Some(Frontier { segment, room: self.id(f.room)?, leads: f.leads, area: f.area })
        };
        self.known.frontiers.iter().filter_map(frontier).collect()
    }
}
