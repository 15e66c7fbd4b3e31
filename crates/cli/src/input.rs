//! Input from files and standard input, with a size limit.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Reasons why input cannot be read.
#[derive(Debug, Error)]
pub enum ReadError {
    #[error(transparent)]
    Io(#[from] io::Error),
    #[error("the file is empty")]
    Empty,
    /// The size, or one more than the limit if the size is unknown.
    #[error("the file has {found_bytes} bytes or more; the limit is {max_bytes}")]
    TooManyBytes { found_bytes: usize, max_bytes: usize },
}

/// Whether the path is `-`.
pub fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Canonical path of a file: `a.jpg`, `./a.jpg` and `folder/../a.jpg` have the same. Links to folders are resolved,
/// links to files are not. Standard input stays `-`, which cannot equal an absolute path.
pub fn identity(path: &Path) -> PathBuf {
    if is_standard_input(path) {
        return path.to_owned();
    }
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let folder = absolute.parent().and_then(|folder| folder.canonicalize().ok());
    match (folder, absolute.file_name()) {
        (Some(folder), Some(name)) => folder.join(name),
        _ => absolute,
    }
}

/// Reads a whole file, or standard input for `-`. Stops at the first byte beyond the limit.
pub fn read(path: &Path, max_bytes: usize) -> Result<Vec<u8>, ReadError> {
    if is_standard_input(path) {
        return read_at_most(io::stdin().lock(), max_bytes);
    }
    let file = File::open(path)?;
    // Devices and pipes report a size of 0.
    let found_bytes = usize::try_from(file.metadata()?.len()).unwrap_or(usize::MAX);
    if found_bytes > max_bytes {
        return Err(ReadError::TooManyBytes { found_bytes, max_bytes });
    }
    read_at_most(file, max_bytes)
}

fn read_at_most(input: impl Read, max_bytes: usize) -> Result<Vec<u8>, ReadError> {
    let mut bytes = Vec::new();
    input.take(max_bytes as u64 + 1).read_to_end(&mut bytes)?;
    match bytes.len() {
        0 => Err(ReadError::Empty),
        found_bytes if found_bytes > max_bytes => Err(ReadError::TooManyBytes { found_bytes, max_bytes }),
        _ => Ok(bytes),
    }
}
