//! Record of the files that a batch has written, used to resume it and to protect other files.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};
use std::sync::Mutex;

use rosto_export::ExportedFile;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::batch::{Lines, PhotoName, Verdict, hex};
use crate::error::CliError;
use crate::input;
use crate::output;

/// JSON lines next to the meshes: for each mesh its photo, a hash of the request, and a hash of each file.
///
/// A line is written before its files. The last line of a photo is the valid one.
pub struct Ledger {
    lines: Mutex<Lines>,
    path: PathBuf,
    request: String,
    by_photo: HashMap<PathBuf, Vec<Record>>,
}

#[derive(Serialize, Deserialize)]
struct Line<'a> {
    #[serde(flatten)]
    name: PhotoName<'a>,
    #[serde(flatten)]
    record: Record,
}

/// Hashes of the mesh and then of its sidecar files.
#[derive(Serialize, Deserialize)]
struct Record {
    request: String,
    sha256: Vec<String>,
}

/// State of a photo's output files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Written by this request.
    Done,
    /// Missing, or written by another request.
    ToDo,
}

impl Ledger {
    /// Opens and locks the ledger of an output pattern. `request` identifies the options and edits.
    ///
    /// # Errors
    /// [`CliError::InUse`] if another process is writing these meshes.
    pub fn open(pattern: &Path, request: &str) -> Result<Self, CliError> {
        let path = path_for(pattern);
        let folder = path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder).map_err(|reason| CliError::Unwritable { path: folder.to_owned(), reason })?;
        let (mut lines, mut by_photo) = (Lines::open(&path)?, HashMap::<_, Vec<_>>::new());
        lines.read(|line| match serde_json::from_slice::<Line<'static>>(line.bytes) {
            Ok(Line { name, record }) => {
                if let Some(photo) = name.path() {
                    by_photo.entry(input::identity(&photo)).or_default().push(record);
                }
                Ok(Verdict::Keep)
            }
            Err(_) if !line.is_whole => Ok(Verdict::Drop),
            Err(_) => Err(CliError::OtherOptions { path: path.clone(), line: line.number }),
        })?;
        let request = hex(&Sha256::digest(request));
        Ok(Self { lines: Mutex::new(lines), path, request, by_photo })
    }

    /// Whether the photo's files are complete.
    ///
    /// # Errors
    /// [`CliError::Foreign`] if a file exists that Rosto did not write for this photo.
    pub fn status(&self, photo: &Path, outputs: &[PathBuf]) -> Result<Status, CliError> {
        let there = outputs.iter().map(|output| is_there(output)).collect::<Result<Vec<bool>, _>>()?;
        let records = self.by_photo.get(&input::identity(photo)).map_or(&[][..], Vec::as_slice);
        let is_current = |record: &Record| record.request == self.request && record.sha256.len() == outputs.len();
        // Files that the user changed later count as done. A mesh that matches an older record does not: the last run
        // was killed before it put the new files in place.
        if records.last().is_some_and(is_current)
            && there.iter().all(|&there| there)
            && !input::is_standard_input(photo)
        {
            let is_old = records.len() > 1
                && self.is_of(&records[..records.len() - 1], 0, &outputs[0])?
                && !self.is_of(&records[records.len() - 1..], 0, &outputs[0])?;
            return Ok(if is_old { Status::ToDo } else { Status::Done });
        }
        for (index, output) in outputs.iter().enumerate().filter(|(index, _)| there[*index]) {
            if !self.is_of(records, index, output)? {
                return Err(CliError::Foreign { path: output.clone(), for_file: photo.to_owned() });
            }
        }
        Ok(Status::ToDo)
    }

    /// Whether one of the records matches the file's current content.
    fn is_of(&self, records: &[Record], index: usize, output: &Path) -> Result<bool, CliError> {
        if records.is_empty() {
            return Ok(false);
        }
        let bytes = fs::read(output).map_err(|reason| CliError::Unwritable { path: output.to_owned(), reason })?;
        let hash = hex(&Sha256::digest(bytes));
        Ok(records.iter().any(|record| record.sha256.get(index) == Some(&hash)))
    }

    /// Records the files that are about to be written for the photo.
    pub fn add(&self, photo: &Path, written: &ExportedFile) -> Result<(), CliError> {
        let contents = [&written.bytes].into_iter().chain(written.sidecars.iter().map(|file| &file.bytes));
        let sha256 = contents.map(|bytes| hex(&Sha256::digest(bytes))).collect();
        let record = Record { request: self.request.clone(), sha256 };
        let line = serde_json::to_string(&Line { name: PhotoName::new(photo), record });
        let line = line.expect("invariant: text is JSON");
        // A panic in another thread leaves no partial line, because each line is written by one call.
        self.lines.lock().unwrap_or_else(std::sync::PoisonError::into_inner).add(&line)
    }

    /// Deletes the ledger if it is empty.
    pub fn discard_empty(self) -> Result<(), CliError> {
        let lines = self.lines.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        match lines.is_empty()? {
            true => fs::remove_file(&self.path).map_err(|reason| CliError::Unwritable { path: self.path, reason }),
            false => Ok(()),
        }
    }
}

/// `meshes/.rosto-{}.glb.jsonl` for `meshes/{}.glb`. If folders contain `{}`, the ledger is in the last folder without
/// it.
fn path_for(pattern: &Path) -> PathBuf {
    let is_fixed = |part: &Component<'_>| !part.as_os_str().to_string_lossy().contains(output::PHOTO_NAME);
    let parts: Vec<Component<'_>> = pattern.components().collect();
    let fixed = parts.iter().take_while(|part| is_fixed(part)).count();
    let mut name = OsString::from(".rosto");
    for part in &parts[fixed..] {
        name.push("-");
        name.push(part.as_os_str());
    }
    name.push(".jsonl");
    parts[..fixed].iter().collect::<PathBuf>().join(name)
}

fn is_there(output: &Path) -> Result<bool, CliError> {
    let refused = |reason| Err(CliError::Unwritable { path: output.to_owned(), reason });
    match fs::metadata(output) {
        Ok(there) if there.is_dir() => refused(ErrorKind::IsADirectory.into()),
        Ok(_) => Ok(true),
        Err(reason) if reason.kind() == ErrorKind::NotFound => Ok(false),
        Err(reason) => refused(reason),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ledger_is_in_the_last_folder_without_a_placeholder() {
        let of = |pattern: &str| path_for(Path::new(pattern));
        assert_eq!(of("meshes/{}.glb"), Path::new("meshes/.rosto-{}.glb.jsonl"));
        assert_eq!(of("{}.glb"), Path::new(".rosto-{}.glb.jsonl"));
        assert_eq!(of("a/{}/b/{}.glb"), Path::new("a/.rosto-{}-b-{}.glb.jsonl"));
    }
}
