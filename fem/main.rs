//! `fem`: see the library for how it is built.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(fem::command(std::env::args_os()))
}
