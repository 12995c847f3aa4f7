//! Tests of the whole adapter, from bytes to scenes. Every input is made here.
#![allow(clippy::unwrap_used)]

mod bad_pictures;
mod bad_yaml;
mod bare;
mod never_panics;
mod stated;
mod support;
mod yaml;
