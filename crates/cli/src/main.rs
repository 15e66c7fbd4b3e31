//! `rosto`: photos of faces to landmarks and edited, coloured meshes, on the command line.

mod args;
mod edits;
mod encode;
mod error;
mod files;
mod follow;
mod landmarks;
mod mesh;
mod networks;
mod paper;
mod portrait;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Arguments, Task};

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let networks = arguments.networks.as_deref();
    let outcome = match &arguments.task {
        Task::Landmarks(task) => landmarks::run(task, networks),
        Task::Mesh(task) => mesh::run(task, networks),
        Task::Paper(task) => paper::run(task, networks),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever reads our output has seen enough, as `head` does.
        Err(error) if error.is_broken_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            error.report();
            error.exit_code()
        }
    }
}
