//! What kind of building to make.

use crate::variety::Variety;

/// How large a building is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Size {
    /// A dwelling of 5 to 8 rooms.
    House,
    /// An office floor of 10 to 20 rooms.
    Office,
    /// A school floor of 20 to 60 rooms, 40 to 90 m long, with a gym at times.
    #[default]
    School,
}

impl Size {
    /// The fewest and the most rooms, corridors included.
    pub const fn rooms(self) -> (usize, usize) {
        match self {
            Self::House => (5, 8),
            Self::Office => (10, 20),
            Self::School => (20, 60),
        }
    }

    /// The longest that a building may be along its axes, between the centre lines of its outer walls, metres.
    pub const fn longest(self) -> f64 {
        match self {
            Self::House => 20.0,
            Self::Office => 50.0,
            Self::School => 90.0,
        }
    }
}

/// What a building shall be like. A pair is the smallest and the largest value, drawn uniformly.
#[derive(Debug, Clone, PartialEq)]
pub struct BuildingParams {
    /// How large it is.
    pub size: Size,
    /// Thickness of outer walls, metres.
    pub outer_wall: (f64, f64),
    /// Thickness of inner walls, metres.
    pub inner_wall: (f64, f64),
    /// Clear width of a single door, metres.
    pub single_door: (f64, f64),
    /// Clear width of a double door, metres.
    pub double_door: (f64, f64),
    /// Clear width of a passage, metres.
    pub passage: (f64, f64),
    /// Probability that an outer corner is cut off at an angle.
    pub chamfers: f64,
    /// Probability that a long outer wall has a round bay or apse.
    pub bays: f64,
    /// Probability that a building with a straight corridor has a wing at another angle.
    pub wings: f64,
    /// Direction of the building's axes in the map frame, radians; `None` draws any.
    pub yaw: Option<f64>,
    /// Irregularities; by default there are none.
    pub variety: Variety,
}

impl BuildingParams {
    /// The usual building of this size, turned at random.
    pub fn of_size(size: Size) -> Self {
        Self {
            size,
            outer_wall: (0.2, 0.45),
            inner_wall: (0.1, 0.3),
            single_door: (0.8, 1.2),
            double_door: (1.6, 2.0),
            passage: (2.2, 4.0),
            chamfers: 0.06,
            bays: 0.06,
            wings: 0.35,
            yaw: None,
            variety: Variety::default(),
        }
    }
}

impl Default for BuildingParams {
    fn default() -> Self {
        Self::of_size(Size::default())
    }
}

/// What a room is for, as far as its shape and furniture depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoomKind {
    /// A way to other rooms: corridor or foyer.
    Corridor,
    /// A class room, an office, a dwelling room.
    Room,
    /// A toilet, a cupboard, a store.
    Small,
    /// A gym or an assembly hall.
    Hall,
}
