//! The work of the command line, `rosto`: photos of faces to landmarks and edited, coloured meshes. A library beside the
//! program, so that other shells over the same core, Python's say, do exactly as it does.

mod args;
mod choices;
mod edits;
mod encode;
mod error;
mod face_mesh;
mod files;
mod found;
mod input;
mod landmarks;
mod many;
mod mesh;
mod model_history;
mod networks;
mod output;
mod paper;
mod photo;
mod portrait;
mod request;
mod settings;
mod several;
mod terminal;

use std::ffi::OsString;
use std::io::{self, Write};

use clap::{ArgMatches, CommandFactory, FromArgMatches};

use crate::args::{Arguments, Task};
use crate::error::CliError;
use crate::networks::Networks;
use crate::request::Given;

pub use face_mesh::{FaceMesh, Refused};
pub use networks::EmbeddedNetworks;

/// Does what the words of a command line ask for, the program's name first; returns its exit code.
pub fn command_line(words: impl IntoIterator<Item = OsString>) -> u8 {
    command_line_with(words, &[])
}

/// The same for a program that holds the networks, which serve unless the user names a folder of others.
pub fn command_line_with(words: impl IntoIterator<Item = OsString>, embedded: EmbeddedNetworks) -> u8 {
    let understood = Arguments::command().try_get_matches_from(words).and_then(|matches| {
        let arguments = Arguments::from_arg_matches(&matches)?;
        Ok((matches, arguments))
    });
    let outcome = match understood {
        Ok((matches, arguments)) => run(&arguments, &matches, embedded),
        Err(error) => return not_understood(&error),
    };
    match outcome {
        Ok(()) => 0,
        // Whoever reads our output has seen enough, as `head` does.
        Err(error) if error.is_broken_pipe() => 0,
        Err(error) => {
            error.report();
            error.exit_code()
        }
    }
}

fn run(arguments: &Arguments, matches: &ArgMatches, embedded: EmbeddedNetworks) -> Result<(), CliError> {
    let networks = Networks { named: arguments.networks.as_deref(), embedded };
    let given = Given(matches.subcommand().map_or(matches, |(_, given)| given));
    match &arguments.task {
        Task::Landmarks(task) => landmarks::run(task, networks),
        Task::Mesh(task) => mesh::run(task, &given, networks),
        Task::Photo(task) => photo::run(task, &given, networks),
        Task::Paper(task) => paper::run(task, networks),
    }
}

/// Help and version as they are; what cannot be understood without what a terminal would obey, since it is repeated.
fn not_understood(error: &clap::Error) -> u8 {
    let shown = match error.use_stderr() {
        true => io::stderr().write_all(terminal::escaped_lines(&error.to_string()).as_bytes()),
        false => error.print(),
    };
    // Where nobody can be told, the exit code still tells.
    drop(shown);
    u8::try_from(error.exit_code()).unwrap_or(2)
}
