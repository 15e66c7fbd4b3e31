use std::borrow::Cow;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// A photo's path in JSON: as text and, if it is not valid UTF-8, also as hexadecimal bytes.
#[derive(Debug, Serialize, Deserialize)]
pub struct PhotoName<'a> {
    photo: Cow<'a, str>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    photo_bytes: Option<String>,
}

impl<'a> PhotoName<'a> {
    pub fn new(path: &'a Path) -> Self {
        let photo_bytes = path.to_str().is_none().then(|| hex(path.as_os_str().as_encoded_bytes()));
        Self { photo: path.to_string_lossy(), photo_bytes }
    }

    /// The path; `None` if the bytes are not hexadecimal digits.
    pub fn path(&self) -> Option<PathBuf> {
        match &self.photo_bytes {
            None => Some(PathBuf::from(&*self.photo)),
            Some(digits) => bytes(digits).map(|bytes| path_of(bytes, &self.photo)),
        }
    }
}

pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn bytes(digits: &str) -> Option<Vec<u8>> {
    let pairs = digits.as_bytes().chunks(2).map(|pair| std::str::from_utf8(pair).ok());
    pairs.map(|pair| u8::from_str_radix(pair.filter(|pair| pair.len() == 2)?, 16).ok()).collect()
}

#[cfg(unix)]
fn path_of(bytes: Vec<u8>, _: &str) -> PathBuf {
    use std::os::unix::ffi::OsStringExt;
    std::ffi::OsString::from_vec(bytes).into()
}

/// Other systems cannot build a path from bytes, so such a photo is not recognised when a batch resumes.
#[cfg(not(unix))]
fn path_of(_: Vec<u8>, text: &str) -> PathBuf {
    text.into()
}

#[cfg(all(test, unix))]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    #[test]
    fn paths_survive_a_round_trip_through_json() {
        let names: [&[u8]; 5] = [b"a.jpg", b"\xff.jpg", b"\xfe.jpg", b"%ff\\\"\n.jpg", "São/\u{fffd}.jpg".as_bytes()];
        for name in names {
            let path = Path::new(OsStr::from_bytes(name));
            let line = serde_json::to_string(&PhotoName::new(path)).unwrap();
            let read: PhotoName<'_> = serde_json::from_str(&line).unwrap();
            assert_eq!(read.path().as_deref(), Some(path), "{line}");
        }
        for broken in ["f", "fg", "é0"] {
            let name = PhotoName { photo: "a".into(), photo_bytes: Some(broken.to_owned()) };
            assert_eq!(name.path(), None, "{broken}");
        }
    }
}
