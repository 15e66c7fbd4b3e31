use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde_json::Value;

use crate::error::CliError;

/// A file of JSON lines, one for each photo, that is gone on with where it stopped.
pub struct Journal {
    path: PathBuf,
    file: File,
    photos: HashSet<String>,
}

/// What a line says of itself.
#[derive(Deserialize)]
struct Head {
    photo: String,
    how: Value,
}

impl Journal {
    /// Makes the file, or reads which photos it tells of. The last line goes if its end is missing: it was being written
    /// when the program ended.
    ///
    /// # Errors
    /// [`CliError::AnotherJournal`] if a line of it is none of these, or was made otherwise than `how`.
    pub fn open(path: &Path, how: &Value) -> Result<Self, CliError> {
        let refused = |reason: io::Error| CliError::Unwritable { path: path.to_owned(), reason };
        let mut options = OpenOptions::new();
        let file = options.read(true).append(true).create(true).open(path).map_err(refused)?;
        let mut journal = Self { path: path.to_owned(), file, photos: HashSet::new() };
        let whole_bytes = journal.read(how)?;
        journal.file.set_len(whole_bytes).map_err(refused)?;
        Ok(journal)
    }

    /// Whether it tells of the photo.
    pub fn has(&self, photo: &Path) -> bool {
        self.photos.contains(&*photo.to_string_lossy())
    }

    /// Adds a line, at once and whole.
    pub fn add(&mut self, line: &str) -> Result<(), CliError> {
        let refused = |reason| CliError::Unwritable { path: self.path.clone(), reason };
        self.file.write_all(format!("{line}\n").as_bytes()).map_err(refused)
    }

    /// Reads line by line; returns how many bytes are whole lines.
    fn read(&mut self, how: &Value) -> Result<u64, CliError> {
        let refused = |reason: io::Error| CliError::Unwritable { path: self.path.clone(), reason };
        if !self.file.metadata().map_err(refused)?.is_file() {
            return Err(refused(ErrorKind::InvalidInput.into()));
        }
        let (mut whole_bytes, mut number, mut line) = (0, 0, Vec::new());
        let mut reader = BufReader::new(&self.file);
        loop {
            line.clear();
            let length = reader.by_ref().read_until(b'\n', &mut line).map_err(refused)?;
            if !line.ends_with(b"\n") {
                return Ok(whole_bytes);
            }
            number += 1;
            whole_bytes += length as u64;
            match serde_json::from_slice::<Head>(&line) {
                Ok(head) if head.how == *how => self.photos.insert(head.photo),
                _ => return Err(CliError::AnotherJournal { path: self.path.clone(), line: number }),
            };
        }
    }
}
