//! What sets real buildings apart from rooms in rows: how much of each kind of irregularity a building has.

use crate::params::{BuildingParams, Size};
use crate::rng::Rng;
use crate::scan_params::{Noise, ScanParams};

/// How irregular a building is. Every field is a share or a probability from 0 to 1; 0 leaves the kind out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Variety {
    /// Probability that the plan is blocks of rooms inside a ring of corridor, in place of wings along corridors.
    pub blocks: f64,
    /// Probability that a corridor widens into a bay where a room would be.
    pub alcoves: f64,
    /// Probability that a room reaches behind its neighbour, which makes an L of it.
    pub l_shapes: f64,
    /// Probability that two rooms are joined by a passage that takes most of their common wall.
    pub open_fronts: f64,
    /// Probability that a corridor's end has a large room, into which it then opens in its whole width.
    pub open_ends: f64,
    /// Share of the rooms and corridors with pilasters along a wall.
    pub pilasters: f64,
    /// Share of the large rooms with free-standing columns.
    pub columns: f64,
    /// Share of the rooms and corridors that short walls narrow from one side or from both.
    pub narrowings: f64,
    /// Share of the large rooms with a row of partitions: bays that are open along a whole side.
    pub partitions: f64,
    /// Share of the wide rooms and corridors with a closed box, such as a lift or a shaft, inside.
    pub shafts: f64,
    /// Share of the doors whose open leaf stands in a room.
    pub leaves: f64,
}

impl Variety {
    /// Draws what one building has: most have some kinds only.
    fn draw(rng: &mut Rng) -> Self {
        let mut some =
            |chance: f64, most: f64| if rng.chance(chance) { rng.range((0.1, 1.0)) * most } else { 0.0 };
        Self {
            blocks: some(1.0, 0.75),
            alcoves: some(0.5, 0.3),
            l_shapes: some(0.5, 0.4),
            open_fronts: some(0.6, 0.35),
            open_ends: some(0.5, 0.9),
            pilasters: some(0.6, 0.5),
            columns: some(0.6, 0.8),
            narrowings: some(0.7, 0.4),
            partitions: some(0.5, 0.6),
            shafts: some(0.5, 0.3),
            leaves: some(0.35, 0.9),
        }
    }
}

impl BuildingParams {
    /// A building of any kind, for training: size, walls, doors and irregularities differ from seed to seed.
    ///
    /// ```
    /// # use planform_synth::{Building, BuildingParams};
    /// let params = BuildingParams::varied(3);
    /// assert_eq!(Building::generate(3, &params), Building::generate(3, &BuildingParams::varied(3)));
    /// ```
    pub fn varied(seed: u64) -> Self {
        let mut rng = Rng::new(seed, 200);
        let size = match rng.index(10) {
            0 => Size::House,
            1..=3 => Size::Office,
            _ => Size::School,
        };
        let inner: (f64, f64) = [(0.06, 0.15), (0.1, 0.3), (0.15, 0.45), (0.4, 0.75)][rng.index(4)];
        let door = rng.range((0.72, 1.0));
        Self {
            outer_wall: (inner.0.max(0.15), inner.1.max(0.5)),
            inner_wall: inner,
            single_door: (door, door + rng.range((0.05, 0.4))),
            double_door: (1.2, 2.0),
            passage: (1.2, 3.2),
            chamfers: rng.range((0.0, 0.12)),
            bays: rng.range((0.0, 0.1)),
            // Most maps are turned so that the walls are parallel to the axes.
            yaw: rng.chance(0.6).then_some(0.0),
            variety: Variety::draw(&mut rng),
            ..Self::of_size(size)
        }
    }
}

impl ScanParams {
    /// A robot of any kind, for training: its noise, the furniture and the windows differ from seed to seed.
    pub fn varied(seed: u64) -> Self {
        let mut rng = Rng::new(seed, 201);
        let mut some =
            |chance: f64, most: f64| if rng.chance(chance) { rng.range((0.1, 1.0)) * most } else { 0.0 };
        let (furniture, clutter, glass) = (some(0.5, 0.8), some(0.45, 1.0), some(0.4, 0.5));
        let noise = [Noise::none(), Noise::default(), Noise::default(), Noise::heavy()][rng.index(4)];
        let unexplored = if rng.chance(0.2) { rng.range((0.1, 0.5)) } else { 0.0 };
        let closed_doors = rng.unit();
        Self { seed, furniture, clutter, glass, noise, unexplored, closed_doors, ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_is_drawn_and_left_out() {
        let drawn: Vec<Variety> = (0..60).map(|seed| BuildingParams::varied(seed).variety).collect();
        let kinds: [fn(&Variety) -> f64; 10] = [
            |v| v.open_ends,
            |v| v.open_fronts,
            |v| v.alcoves,
            |v| v.l_shapes,
            |v| v.pilasters,
            |v| v.columns,
            |v| v.narrowings,
            |v| v.partitions,
            |v| v.shafts,
            |v| v.leaves,
        ];
        for (i, kind) in kinds.into_iter().enumerate() {
            assert!(drawn.iter().any(|v| kind(v) > 0.0) && drawn.iter().any(|v| kind(v) == 0.0), "{i}");
        }
        assert!(drawn.iter().all(|v| v.blocks > 0.0));
    }

    #[test]
    fn robots_differ() {
        let robots: Vec<ScanParams> = (0..40).map(ScanParams::varied).collect();
        assert!(robots.iter().any(|r| r.clutter > 0.0) && robots.iter().any(|r| r.furniture == 0.0));
        assert!(robots.iter().any(|r| r.noise == Noise::none()) && robots.iter().any(|r| r.glass > 0.0));
    }
}
