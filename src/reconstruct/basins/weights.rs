//! The weights of the model, fitted to 600 synthetic buildings by `cargo run --release -p planform-training --
//! --write src/reconstruct/basins/weights.rs`; not to be edited.

use super::evidence::COUNT;

/// The log odds where all evidence is 0.
pub const BIAS: f64 = 1.9463;

/// What each number of the evidence adds to the log odds, for each of its units.
pub const WEIGHTS: [f64; COUNT] = [
    0.2876,   // log of the passages' total width
    1.0178,   // passage's clearance over the smaller region's largest
    2.7455,   // passage's clearance over the larger region's largest
    -1.8628,  // wall in line with the passage at the end with less
    -1.4518,  // wall in line with the passage at the end with more
    5.7041,   // wall's share of that wall and the passage
    -6.7300,  // free space around the end with less
    4.7502,   // free space around the end with more
    -7.0343,  // wall's share of the whole boundary
    0.3479,   // boundary's length over the passage's width
    0.8234,   // passage's width over the smaller region's extent along it
    1.3340,   // passage's width over the larger region's extent along it
    16.9004,  // solidity of the two together
    -8.6401,  // solidity of the smaller region
    -13.1437, // solidity of the larger region
    -8.0942,  // solidity lost
    0.7344,   // log of the smaller region's elongation
    0.1632,   // log of the larger region's elongation
    2.8431,   // passage's half width over the clearance around it
    -1.5173,  // passage's clearance over the clearance around it
    1.4285,   // depth's share of depth and width
    -3.2990,  // sharpness of the passage's ends
    3.1805,   // smallness of the smaller region
];
