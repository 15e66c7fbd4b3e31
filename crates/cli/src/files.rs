//! Standard input and output, and names of files.

use std::io::{self, Write};
use std::path::Path;

use rosto::Format;

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

/// Export format for the path's extension, ignoring case.
pub fn format_of(path: &Path) -> Result<Format, CliError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let format = extension.as_deref().and_then(Format::from_id);
    format.ok_or_else(|| CliError::UnknownFormat { path: path.to_owned() })
}

/// File name without its extension, which sidecar files share.
pub fn name_of(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
