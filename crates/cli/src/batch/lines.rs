use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use same_file::Handle;

use crate::error::CliError;
use crate::output;

/// A file of lines, locked by one process, that is read once and then appended to. Devices and pipes are only written
/// to.
pub struct Lines {
    path: PathBuf,
    file: File,
}

/// Existing line. The last one is incomplete if the program was killed while writing it.
pub struct FoundLine<'a> {
    pub number: usize,
    pub bytes: &'a [u8],
    pub is_whole: bool,
}

/// Decision of [`Lines::read`]'s callback about a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Keep,
    Drop,
}

impl Lines {
    /// Opens or creates the file and locks it until the value is dropped.
    ///
    /// # Errors
    /// [`CliError::InUse`] if another process holds the lock.
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
        // The previous owner may have replaced the file before it released the lock.
        let ours = file.try_clone().and_then(Handle::from_file).map_err(refused)?;
        match Handle::from_path(path).is_ok_and(|there| there == ours) {
            true => Ok(Self { path: path.canonicalize().map_err(refused)?, file }),
            false => Err(in_use()),
        }
    }

    /// Passes each line to `judge` and removes those it drops. If `judge` fails, the file stays unchanged.
    pub fn read(
        &mut self,
        mut verdict_of: impl FnMut(FoundLine<'_>) -> Result<Verdict, CliError>,
    ) -> Result<(), CliError> {
        if !self.is_regular()? {
            return Ok(());
        }
        let mut retained: Vec<Range<u64>> = Vec::new();
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
            match (verdict_of(FoundLine { number, bytes: &line, is_whole })?, retained.last_mut()) {
                (Verdict::Drop, _) => is_whole = true,
                (Verdict::Keep, Some(last)) if last.end == start => last.end = end,
                (Verdict::Keep, _) => retained.push(start..end),
            }
        }
        let retained_bytes: u64 = retained.iter().map(|range| range.end - range.start).sum();
        if retained_bytes < end {
            self.rewrite(&retained).map_err(|reason| self.refused(reason))?;
        }
        if is_whole { Ok(()) } else { self.add("") }
    }

    /// Appends a line. If the disk is full, no part of it remains.
    pub fn add(&mut self, line: &str) -> Result<(), CliError> {
        let before = self.file.metadata().map_err(|reason| self.refused(reason))?;
        self.file.write_all(format!("{line}\n").as_bytes()).map_err(|reason| {
            if before.is_file() {
                // If this fails too, the next `read` drops the incomplete line.
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

    /// Replaces the file by a copy of these byte ranges, locked before it is in place.
    fn rewrite(&mut self, retained: &[Range<u64>]) -> io::Result<()> {
        let mut copy = output::unfinished_for(&self.path)?;
        for range in retained {
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

/// Returns false if another process holds the lock, and true on file systems without locks.
fn lock(file: &File) -> io::Result<bool> {
    match file.try_lock() {
        Ok(()) => Ok(true),
        Err(TryLockError::WouldBlock) => Ok(false),
        Err(TryLockError::Error(reason)) if reason.kind() == ErrorKind::Unsupported => Ok(true),
        Err(TryLockError::Error(reason)) => Err(reason),
    }
}
