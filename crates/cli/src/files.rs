use std::io::{Read, Write};
use std::path::Path;
use std::{fs, io};

use crate::error::CliError;

/// The whole file; `-` is standard input.
pub fn read(path: &Path) -> Result<Vec<u8>, CliError> {
    let bytes = if path.as_os_str() == "-" { read_input() } else { fs::read(path) };
    bytes.map_err(|reason| CliError::Unreadable { path: path.to_owned(), reason })
}

fn read_input() -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::stdin().read_to_end(&mut bytes)?;
    Ok(bytes)
}

pub fn write(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    fs::write(path, bytes).map_err(|reason| CliError::Unwritable { path: path.to_owned(), reason })
}

/// Writes a line to standard output.
pub fn print(line: &str) -> Result<(), CliError> {
    let mut output = io::stdout().lock();
    writeln!(output, "{line}").and_then(|()| output.flush()).map_err(CliError::Output)
}
