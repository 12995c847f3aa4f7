//! Every number that the reconstruction depends on. Lengths are in metres and angles in radians, so that a map's
//! resolution changes nothing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The parameters of a reconstruction.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Which method reconstructs: `paper` is Algorithm 1 of the paper to the letter.
    pub method: Method,
}

/// A method of reconstruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// The paper's Algorithm 1.
    #[default]
    Paper,
}

impl Method {
    /// All methods.
    pub const ALL: &[Self] = &[Self::Paper];

    /// The name as the user types it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
        }
    }
}
