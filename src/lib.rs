//! planform turns a document that shows a building into its layout: rooms, walls, doors.

pub mod reconstruct;
