//! Implementation of the command line, `rosto`: landmarks and edited, coloured meshes from photos of faces. It is a
//! library, so that the Python package contains it.

mod args;
mod batch;
mod choices;
mod edits;
mod effect;
mod error;
mod face_notes;
mod faces;
mod files;
mod input;
mod landmarks;
mod mesh;
mod networks;
mod output;
mod paper;
mod photo;
mod settings;
mod terminal;
mod view_notes;

use std::ffi::OsString;
use std::io::{self, Write};

use clap::{ArgMatches, CommandFactory, FromArgMatches};

use crate::args::{Arguments, Task};
use crate::effect::Given;
use crate::error::CliError;

/// Runs a command line, given with the program's name, and returns its exit code.
pub fn command_line(words: impl IntoIterator<Item = OsString>) -> u8 {
    let understood = Arguments::command().try_get_matches_from(words).and_then(|matches| {
        let arguments = Arguments::from_arg_matches(&matches)?;
        Ok((matches, arguments))
    });
    let outcome = match understood {
        Ok((matches, arguments)) => run(&arguments, &matches),
        Err(error) => return not_understood(&error),
    };
    match outcome {
        Ok(()) => 0,
        // The reader closed the pipe, as `head` does.
        Err(error) if error.is_broken_pipe() => 0,
        Err(error) => {
            error.report();
            error.exit_code()
        }
    }
}

fn run(arguments: &Arguments, matches: &ArgMatches) -> Result<(), CliError> {
    let networks = arguments.networks.as_deref();
    let given = Given(matches.subcommand().map_or(matches, |(_, given)| given));
    match &arguments.task {
        Task::Landmarks(task) => landmarks::run(task, networks),
        Task::Mesh(task) => mesh::run(task, &given, networks),
        Task::Photo(task) => photo::run(task, &given, networks),
        Task::Paper(task) => paper::run(task, networks),
    }
}

/// Prints clap's help or error. Errors repeat the user's words, so their control characters are escaped.
fn not_understood(error: &clap::Error) -> u8 {
    let shown = match error.use_stderr() {
        true => io::stderr().write_all(terminal::escaped_lines(&error.to_string()).as_bytes()),
        false => error.print(),
    };
    // The exit code still reports the failure.
    drop(shown);
    u8::try_from(error.exit_code()).unwrap_or(2)
}
