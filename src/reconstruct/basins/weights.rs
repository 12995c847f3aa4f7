//! The weights of the model, fitted to 600 synthetic buildings by `cargo run --release -p planform-training --
//! --write src/reconstruct/basins/weights.rs`; not to be edited.

use super::evidence::COUNT;

/// The log odds where all evidence is 0.
pub const BIAS: f64 = 1.9443;

/// What each number of the evidence adds to the log odds, for each of its units.
pub const WEIGHTS: [f64; COUNT] = [
    0.2135,   // log of the passages' total width
    1.0171,   // passage's clearance over the smaller region's largest
    2.7098,   // passage's clearance over the larger region's largest
    -1.8498,  // wall in line with the passage at the end with less
    -1.4429,  // wall in line with the passage at the end with more
    5.5189,   // wall's share of that wall and the passage
    -6.6331,  // free space around the end with less
    4.8779,   // free space around the end with more
    -7.0503,  // wall's share of the whole boundary
    0.3278,   // boundary's length over the passage's width
    0.8514,   // passage's width over the smaller region's extent along it
    1.4631,   // passage's width over the larger region's extent along it
    16.6129,  // solidity of the two together
    -8.7006,  // solidity of the smaller region
    -12.8844, // solidity of the larger region
    -7.9994,  // solidity lost
    0.7357,   // log of the smaller region's elongation
    0.1835,   // log of the larger region's elongation
    2.6124,   // passage's half width over the clearance around it
    -1.2847,  // passage's clearance over the clearance around it
    1.3848,   // depth's share of depth and width
    -2.9344,  // sharpness of the passage's ends
    3.1552,   // smallness of the smaller region
];
