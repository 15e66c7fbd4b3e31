/// Kind of a file, detected from its first bytes, since a file name can be wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// Binary glTF from any program; see [`reopen`](crate::reopen).
    Glb,
    /// A Rosto project; see [`project::read`](crate::project::read).
    Project,
    /// Any other file, such as a photo.
    Other,
}

/// Number of bytes that [`sniff`] examines.
pub const SNIFFED_BYTES: usize = 4096;

/// Detects the kind of a file from its first [`SNIFFED_BYTES`] bytes.
///
/// A project is a JSON object that names its format first.
pub fn sniff(start_of_file: &[u8]) -> FileKind {
    let start = &start_of_file[..start_of_file.len().min(SNIFFED_BYTES)];
    if start.starts_with(b"glTF") {
        return FileKind::Glb;
    }
    let text = without_bom(start).trim_ascii_start();
    let holds = |word: &str| text.windows(word.len()).any(|window| window == word.as_bytes());
    if text.starts_with(b"{") && holds("\"rosto-project\"") {
        return FileKind::Project;
    }
    FileKind::Other
}

/// Strips the byte order mark that some editors put before UTF-8 text.
pub(crate) fn without_bom(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text)
}
