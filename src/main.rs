//! The program `planform`.

use std::process::ExitCode;

fn main() -> ExitCode {
    planform::cli::main(std::env::args_os())
}
