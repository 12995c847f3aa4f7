//! Reads written drawings back with readers that know nothing of this crate.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod audit;
mod read_back;
mod support;
