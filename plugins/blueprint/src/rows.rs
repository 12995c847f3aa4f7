//! Work on the rows of a picture.

pub use planform_sdk::parallel::{for_each, for_each_band, map};

/// Of every item of a row the least within `reach` to both sides.
pub fn least_within(row: &[u8], reach: usize) -> Vec<u8> {
    let mut out = row.to_vec();
    for shift in 1..=reach.min(row.len()) {
        lower(&mut out[shift..], row);
        lower(&mut out, &row[shift..]);
    }
    out
}

/// Takes from each pair of items the lesser one.
pub fn lower(row: &mut [u8], by: &[u8]) {
    row.iter_mut().zip(by).for_each(|(r, &b)| *r = b.min(*r));
}
