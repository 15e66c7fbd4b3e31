//! The command line `rosto`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(rosto_cli::command_line(std::env::args_os()))
}
