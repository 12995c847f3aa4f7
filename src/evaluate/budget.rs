//! A limit to the work that one comparison may take.

use super::error::limit;
use planform_sdk::PluginError;

/// Steps that are left: a step is a pixel covered or an edge crossed.
#[derive(Debug)]
pub(super) struct Budget(u64);

impl Budget {
    /// Eight rooms that each cover the largest image, or a million edges across two thousand rows.
    pub(super) const STEPS: u64 = 1 << 31;

    pub(super) fn new(steps: u64) -> Self {
        Self(steps)
    }

    pub(super) fn spend(&mut self, steps: usize) -> Result<(), PluginError> {
        match self.0.checked_sub(steps as u64) {
            Some(rest) => {
                self.0 = rest;
                Ok(())
            }
            None => Err(limit("its rooms overlap too often or have too many corners to be drawn")
                .advise("simplify the polygons, or check the resolution")),
        }
    }
}
