//! Shared handling of standard input and output.

use std::io::{self, Write};
use std::path::Path;

use crate::error::CliError;
use crate::input::is_standard_input;

/// Refuses standard input as more than one input.
pub fn check_standard_input<'a>(inputs: impl IntoIterator<Item = &'a Path>) -> Result<(), CliError> {
    match inputs.into_iter().filter(|input| is_standard_input(input)).count() {
        0 | 1 => Ok(()),
        _ => Err(CliError::StandardInputTwice),
    }
}

/// Writes a line to standard output.
pub fn print(line: &str) -> Result<(), CliError> {
    let mut output = io::stdout().lock();
    writeln!(output, "{line}").and_then(|()| output.flush()).map_err(CliError::Output)
}
