//! Reads written drawings back with readers that know nothing of this crate.

mod audit;
mod read_back;
mod support;
