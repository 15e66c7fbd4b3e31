/// What a file is, by how it begins; a name says nothing about a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// Binary glTF, of whatever program: for [`reopen`](crate::reopen).
    Glb,
    /// A project: for [`project::read`](crate::project::read).
    Project,
    /// Anything else, such as a photo.
    Other,
}

/// As much of a file's start as [`sniff`] looks at.
pub const SNIFFED_BYTES: usize = 4096;

/// Tells what a file is by its first bytes, of which [`SNIFFED_BYTES`] are enough.
///
/// A project is a JSON object that says so in whatever order, or that holds edits: behind a long list of those the rest
/// of the object may be out of sight.
pub fn sniff(start_of_file: &[u8]) -> FileKind {
    let start = &start_of_file[..start_of_file.len().min(SNIFFED_BYTES)];
    if start.starts_with(b"glTF") {
        return FileKind::Glb;
    }
    let text = without_bom(start).trim_ascii_start();
    let holds = |word: &str| text.windows(word.len()).any(|window| window == word.as_bytes());
    if text.starts_with(b"{") && (holds("\"rosto-project\"") || holds("\"edits\"")) {
        return FileKind::Project;
    }
    FileKind::Other
}

/// Without the mark that some editors put before text in UTF-8.
pub(crate) fn without_bom(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text)
}
