//! The files that belong to a document, such as the picture of a robot's map.

use super::Listed;
use crate::host::Registry;
use planform_sdk::Source;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

/// Documents that name others are texts, and small.
const LARGEST: u64 = 1 << 16;

/// The siblings of the document, as the built-in adapters know them.
pub fn of(document: &Listed, registry: &Registry) -> Vec<PathBuf> {
    // What cannot be read is told when its turn comes.
    let Ok(source) = Source::open(&document.input, LARGEST) else { return vec![] };
    // A document that finds a bug here is told of in a process of its own, where it finds it again.
    let named = |adapter: &dyn planform_sdk::InputAdapter| {
        catch_unwind(AssertUnwindSafe(|| adapter.siblings(&source))).unwrap_or_default()
    };
    let names = registry.builtin_adapters().flat_map(named);
    names.map(|name| source.resolve(&name)).collect()
}
