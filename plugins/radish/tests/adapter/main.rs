//! Tests of the whole adapter, from bytes to scenes. Every log is made here.
#![allow(clippy::unwrap_used)]

mod bad_logs;
mod mapped;
mod never_panics;
mod packed;
mod poses;
mod support;
