use serde::Deserialize;
use sha2::{Digest, Sha256};

use crate::ImportError;

/// The package's assets and their byte ranges.
pub(crate) struct Package<'a> {
    files: Vec<PackedFile>,
    packed: &'a [u8],
}

#[derive(Deserialize)]
struct FileList {
    files: Vec<PackedFile>,
}

#[derive(Deserialize)]
struct PackedFile {
    filename: String,
    start: usize,
    end: usize,
}

impl<'a> Package<'a> {
    /// Parses the JSON list of files that the loader script passes to `loadPackage`.
    pub(crate) fn new(loader_js: &str, packed: &'a [u8]) -> Result<Self, ImportError> {
        const CALL: &str = "loadPackage({";
        let call = loader_js.rfind(CALL).ok_or_else(|| no_list("it does not call loadPackage".to_owned()))?;
        let json = &loader_js[call + CALL.len() - 1..];
        let mut lists = serde_json::Deserializer::from_str(json).into_iter::<FileList>();
        let list = lists.next().ok_or_else(|| no_list("the list is empty".to_owned()))?;
        Ok(Self { files: list.map_err(|error| no_list(error.to_string()))?.files, packed })
    }

    /// Returns the bytes of the named file (without folder) after verifying their SHA-256.
    pub(crate) fn file(&self, name: &str, expected_sha256: &str) -> Result<&'a [u8], ImportError> {
        let is_named = |file: &&PackedFile| file.filename.rsplit('/').next() == Some(name);
        let file = self.files.iter().find(is_named).ok_or_else(|| ImportError::NoSuchFile { name: name.to_owned() })?;
        let bytes = self.packed.get(file.start..file.end).ok_or_else(|| ImportError::OutsidePackage {
            name: name.to_owned(),
            start: file.start,
            end: file.end,
            available: self.packed.len(),
        })?;
        let found = sha256_hex(bytes);
        if found == expected_sha256 {
            return Ok(bytes);
        }
        Err(ImportError::OtherFile { name: name.to_owned(), expected: expected_sha256.to_owned(), found })
    }
}

fn no_list(reason: String) -> ImportError {
    ImportError::NoFileList { reason }
}

fn sha256_hex(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
