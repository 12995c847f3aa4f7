//! Work on many buildings at once.

use planform_sdk::parallel;

/// Applies `work` to every item, on all processors; the results in the items' order.
///
/// # Panics
/// As `work` does.
pub fn parallel_map<'a, T: Sync, R: Send>(items: &'a [T], work: impl Fn(&'a T) -> R + Sync) -> Vec<R> {
    parallel::map(items.len(), |i| work(&items[i]))
}
