use std::collections::HashSet;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value;

use super::lines::{FoundLine, Lines, Verdict};
use super::{Listing, PhotoName};
use crate::error::CliError;
use crate::input;

/// Start of a line up to the photo's name, and the key that follows a name that is not valid UTF-8.
const BEGINNING: &str = "{\"photo\":\"";
const BYTES: &str = "\",\"photo_bytes\":\"";

/// A file of JSON lines, one per photo, from which a later run resumes.
pub struct Journal {
    lines: Lines,
    done: HashSet<PathBuf>,
}

/// Fields that identify a line of this format.
#[derive(Deserialize)]
struct Entry {
    #[serde(flatten)]
    name: PhotoName<'static>,
    how: Value,
    error: Option<IgnoredAny>,
    faces: Option<IgnoredAny>,
}

impl Journal {
    /// Opens or creates the file and reads which photos are done. Removes an incomplete last line, and lines of failed
    /// photos that are requested again.
    ///
    /// # Errors
    /// [`CliError::OtherOptions`] if a line has other options or another format; the file stays unchanged.
    pub fn open(path: &Path, how: &Value, photos: &Listing) -> Result<Self, CliError> {
        let mut journal = Self { lines: Lines::open(path)?, done: HashSet::new() };
        journal.lines.read(|line| {
            let another = CliError::OtherOptions { path: path.to_owned(), line: line.number };
            let Some((photo, failed)) = entry(&line, how) else {
                return if is_cut_off(&line, how) { Ok(Verdict::Drop) } else { Err(another) };
            };
            if failed && photos.has(&photo) {
                return Ok(Verdict::Drop);
            }
            // Input from standard input cannot be identified.
            if !failed && !input::is_standard_input(&photo) {
                journal.done.insert(photo);
            }
            Ok(Verdict::Keep)
        })?;
        Ok(journal)
    }

    /// Starts an empty file, discarding existing content.
    pub fn create(path: &Path) -> Result<Self, CliError> {
        let mut lines = Lines::open(path)?;
        lines.clear()?;
        Ok(Self { lines, done: HashSet::new() })
    }

    /// Whether the file has the photo's landmarks.
    pub fn has(&self, photo: &Path) -> bool {
        self.done.contains(&input::identity(photo))
    }

    pub fn add(&mut self, line: &str) -> Result<(), CliError> {
        self.lines.add(line)
    }
}

/// The photo's identity and whether it failed; `None` if the line has other options.
fn entry(line: &FoundLine<'_>, how: &Value) -> Option<(PathBuf, bool)> {
    let entry: Entry = serde_json::from_slice(line.bytes).ok()?;
    let is_ours = entry.how == *how && entry.error.is_some() != entry.faces.is_some();
    let photo = is_ours.then(|| entry.name.path())??;
    Some((input::identity(&photo), entry.error.is_some()))
}

/// Whether the line is the beginning of one with these options.
fn is_cut_off(line: &FoundLine<'_>, how: &Value) -> bool {
    let text = String::from_utf8_lossy(line.bytes);
    let Some(name) = text.strip_prefix(BEGINNING) else {
        return !line.is_whole && BEGINNING.starts_with(&*text);
    };
    let mut is_escaped = false;
    let end = name.find(|letter| {
        let ends = letter == '"' && !is_escaped;
        is_escaped = letter == '\\' && !is_escaped;
        ends
    });
    let after_name = &name[end.unwrap_or(name.len())..];
    let after_bytes =
        after_name.strip_prefix(BYTES).map(|digits| digits.trim_start_matches(|digit: char| digit.is_ascii_hexdigit()));
    let (rest, expected) = (after_bytes.unwrap_or(after_name), format!("\",\"how\":{how},"));
    let is_expected = BYTES.starts_with(rest) || expected.starts_with(rest) || rest.starts_with(&expected);
    !line.is_whole && is_expected
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn is_cut_off_line(text: &str) -> bool {
        let line = FoundLine { number: 1, bytes: text.as_bytes(), is_whole: false };
        is_cut_off(&line, &json!({ "max_faces": 20 }))
    }

    #[test]
    fn a_truncated_line_is_recognised_at_any_length() {
        for line in [
            r#"{"photo":"a \"b\\","how":{"max_faces":20},"width":640,"height":480,"faces":[]}"#,
            r#"{"photo":"a","photo_bytes":"61ff","how":{"max_faces":20},"error":"damaged"}"#,
        ] {
            assert!((1..line.len()).all(|end| is_cut_off_line(&line[..end])), "{line}");
        }
    }

    #[test]
    fn other_text_is_not_a_truncated_line() {
        let others = [
            "milk",
            r#"{"units":"image","positions":[[0.5,0.5,0]]}"#,
            r#"{"photo":"a.jpg","caption":"at the sea"#,
            r#"{"photo":"a.jpg","how":{"max_faces":1},"width":640"#,
            r#"{"photos":["a.jpg"#,
        ];
        assert!(!others.into_iter().any(is_cut_off_line));
    }
}
