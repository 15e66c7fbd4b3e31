use super::ReopenError;

const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;

/// The chunks of a binary glTF file.
pub(super) struct Chunks<'a> {
    pub json: &'a [u8],
    /// Empty if the chunk is missing.
    pub binary: &'a [u8],
}

impl<'a> Chunks<'a> {
    /// Splits a file. Bytes beyond the header's length and unknown chunks are ignored, as the standard requires.
    pub fn of(bytes: &'a [u8]) -> Result<Self, ReopenError> {
        if bytes.get(..4) != Some(b"glTF") || word(bytes, 4) != Some(2) {
            return Err(ReopenError::NotGlb);
        }
        let expected = word(bytes, 8).ok_or(ReopenError::NotGlb)?;
        let truncated = ReopenError::Truncated { expected, found: bytes.len() };
        let file = bytes.get(..expected).ok_or(truncated.clone())?;
        let (kind, json, rest) = chunk(file.get(HEADER_BYTES..).unwrap_or_default()).ok_or(truncated)?;
        if kind != b"JSON" {
            return Err(ReopenError::NotGlb);
        }
        let binary = match chunk(rest) {
            Some((b"BIN\0", binary, _)) => binary,
            _ => &[],
        };
        Ok(Self { json, binary })
    }
}

/// Kind and content of the first chunk, and the rest.
fn chunk(bytes: &[u8]) -> Option<(&[u8], &[u8], &[u8])> {
    let (header, rest) = bytes.split_at_checked(CHUNK_HEADER_BYTES)?;
    let (content, rest) = rest.split_at_checked(word(header, 0)?)?;
    Some((&header[4..], content, rest))
}

/// Reads a little-endian 32-bit number.
fn word(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes = bytes.get(at..)?.first_chunk::<4>()?;
    usize::try_from(u32::from_le_bytes(*bytes)).ok()
}
