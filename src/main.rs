//! The program `planform`.

fn main() {}
