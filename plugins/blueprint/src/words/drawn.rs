//! Masks drawn in tests.

use crate::mask::Mask;

/// The mask of these rows, `#` being set.
pub fn mask(rows: &[&str]) -> Mask {
    let set = rows.iter().flat_map(|r| r.bytes().map(|b| b == b'#')).collect();
    Mask { width: rows[0].len() as u32, height: rows.len() as u32, set }
}
