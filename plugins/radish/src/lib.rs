//! Input adapter for the laser logs of robots, as the Robotics Data Set Repository (Radish) keeps them.

pub mod log;
mod unpack;
