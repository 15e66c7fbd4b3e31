//! `rosto`: photos of faces to landmarks and edited, coloured meshes, on the command line.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(rosto_cli::command_line(std::env::args_os()))
}
