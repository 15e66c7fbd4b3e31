use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use same_file::Handle;

use crate::error::CliError;
use crate::output;

/// A file of lines that one process at a time reads once and adds to. A device or a pipe is written to only.
pub struct Lines {
    path: PathBuf,
    file: File,
}

/// A line of the file as it was found. The last one may lack its end: it was being written when the program stopped.
pub struct FoundLine<'a> {
    pub number: usize,
    pub bytes: &'a [u8],
    pub is_whole: bool,
}

/// What becomes of a line that was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Keep,
    Drop,
}

impl Lines {
    /// Opens the file, or makes it, and locks it until the value is dropped.
    ///
    /// # Errors
    /// [`CliError::InUse`] while another process has it.
    pub fn open(path: &Path) -> Result<Self, CliError> {
        let refused = |reason: io::Error| CliError::Unwritable { path: path.to_owned(), reason };
        if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
            let file = OpenOptions::new().write(true).open(path).map_err(refused)?;
            return Ok(Self { path: path.to_owned(), file });
        }
        let file = OpenOptions::new().read(true).append(true).create(true).open(path).map_err(refused)?;
        let in_use = || CliError::InUse { path: path.to_owned() };
        if !lock(&file).map_err(refused)? {
            return Err(in_use());
        }
        // The process that had it may have put another file in its place meanwhile.
        let ours = file.try_clone().and_then(Handle::from_file).map_err(refused)?;
        match Handle::from_path(path).is_ok_and(|there| there == ours) {
            true => Ok(Self { path: path.canonicalize().map_err(refused)?, file }),
            false => Err(in_use()),
        }
    }

    /// Shows each line to `judge`, and then drops those that it does not want. If it refuses one, the file stays as it was.
    pub fn read(&mut self, mut judge: impl FnMut(FoundLine<'_>) -> Result<Verdict, CliError>) -> Result<(), CliError> {
        if !self.is_regular()? {
            return Ok(());
        }
        let mut kept: Vec<Range<u64>> = Vec::new();
        let (mut number, mut end, mut line, mut is_whole) = (0, 0, Vec::new(), true);
        let mut reader = BufReader::new(&self.file);
        loop {
            line.clear();
            let length = reader.by_ref().read_until(b'\n', &mut line).map_err(|reason| self.refused(reason))?;
            if length == 0 {
                break;
            }
            number += 1;
            let start = end;
            end += length as u64;
            is_whole = line.ends_with(b"\n");
            match (judge(FoundLine { number, bytes: &line, is_whole })?, kept.last_mut()) {
                (Verdict::Drop, _) => is_whole = true,
                (Verdict::Keep, Some(last)) if last.end == start => last.end = end,
                (Verdict::Keep, _) => kept.push(start..end),
            }
        }
        let kept_bytes: u64 = kept.iter().map(|range| range.end - range.start).sum();
        if kept_bytes < end {
            self.rewrite(&kept).map_err(|reason| self.refused(reason))?;
        }
        if is_whole { Ok(()) } else { self.add("") }
    }

    /// Adds a line at once. If there is no room for all of it, none of it stays.
    pub fn add(&mut self, line: &str) -> Result<(), CliError> {
        let before = self.file.metadata().map_err(|reason| self.refused(reason))?;
        self.file.write_all(format!("{line}\n").as_bytes()).map_err(|reason| {
            if before.is_file() {
                // If that fails too, the rest of the line is dropped when the file is read again.
                let _ = self.file.set_len(before.len());
            }
            self.refused(reason)
        })
    }

    pub fn is_empty(&self) -> Result<bool, CliError> {
        self.file.metadata().map(|there| there.len() == 0).map_err(|reason| self.refused(reason))
    }

    pub fn clear(&mut self) -> Result<(), CliError> {
        match self.is_regular()? {
            true => self.file.set_len(0).map_err(|reason| self.refused(reason)),
            false => Ok(()),
        }
    }

    fn is_regular(&self) -> Result<bool, CliError> {
        self.file.metadata().map(|there| there.is_file()).map_err(|reason| self.refused(reason))
    }

    /// Puts a copy with these bytes alone in the place of the file, locked before it is there.
    fn rewrite(&mut self, kept: &[Range<u64>]) -> io::Result<()> {
        let mut copy = output::unfinished_beside(&self.path)?;
        for range in kept {
            self.file.seek(SeekFrom::Start(range.start))?;
            io::copy(&mut Read::by_ref(&mut self.file).take(range.end - range.start), &mut copy)?;
        }
        copy.as_file().set_permissions(self.file.metadata()?.permissions())?;
        copy.as_file().sync_all()?;
        if !lock(copy.as_file())? {
            return Err(ErrorKind::ResourceBusy.into());
        }
        self.file = copy.persist(&self.path).map_err(|unmoved| unmoved.error)?;
        Ok(())
    }

    fn refused(&self, reason: io::Error) -> CliError {
        CliError::Unwritable { path: self.path.clone(), reason }
    }
}

/// Returns false if another process has the lock. A file system without locks grants it.
fn lock(file: &File) -> io::Result<bool> {
    match file.try_lock() {
        Ok(()) => Ok(true),
        Err(TryLockError::WouldBlock) => Ok(false),
        Err(TryLockError::Error(reason)) if reason.kind() == ErrorKind::Unsupported => Ok(true),
        Err(TryLockError::Error(reason)) => Err(reason),
    }
}
