//! WebP files: chunks of a name, a length and as many bytes, each begun at an even place.

use std::iter::successors;

use crate::PhotoError;
use crate::decode::damaged;
use crate::format::Format;

/// Where the first chunk begins, behind `RIFF`, a length and `WEBP`.
const FIRST: u64 = 12;
const HEADER_BYTES: u64 = 8;
/// What stands in a frame of an animation before its own chunks: place, size, duration and flags.
const FRAME_BYTES: u64 = 16;

/// Refuses a file that ends within a chunk of the picture or its metadata, because the decoder allocates what a chunk
/// claims before it looks how much there is. What it does not read may be missing: the byte that pads the last chunk,
/// later frames of an animation, and chunks of unknown names.
///
/// # Errors
/// [`PhotoError::Damaged`].
pub(crate) fn check_chunks(bytes: &[u8]) -> Result<(), PhotoError> {
    let whole_file = bytes.len() as u64;
    match read(bytes).find(|chunk| chunk.is_known() && chunk.end() > whole_file) {
        None => Ok(()),
        Some(chunk) => {
            let there = whole_file - chunk.start - HEADER_BYTES;
            let name = chunk.name.escape_ascii();
            Err(damaged(Format::WebP, format!("{there} of the {} bytes of its chunk {name} are there", chunk.length)))
        }
    }
}

/// The chunks that the decoder looks at: the first, all others if the first announces them, and two of the first frame.
fn read(bytes: &[u8]) -> impl Iterator<Item = Chunk> {
    let extended = Chunk::at(bytes, FIRST).is_some_and(|chunk| &chunk.name == b"VP8X");
    let outer = move || chunks(bytes, FIRST).take(if extended { usize::MAX } else { 1 });
    let frame = outer().find(|chunk| &chunk.name == b"ANMF");
    let in_frame = frame.into_iter().flat_map(move |frame| chunks(bytes, frame.start + HEADER_BYTES + FRAME_BYTES));
    outer().chain(in_frame.take(2))
}

/// One chunk behind the other, up to the end of the file.
fn chunks(bytes: &[u8], start: u64) -> impl Iterator<Item = Chunk> {
    successors(Chunk::at(bytes, start), |chunk| Chunk::at(bytes, chunk.end().next_multiple_of(2)))
}

/// The header of a chunk, whole as its content may not be.
struct Chunk {
    start: u64,
    name: [u8; 4],
    /// Bytes of the content, as claimed.
    length: u32,
}

impl Chunk {
    fn at(bytes: &[u8], start: u64) -> Option<Self> {
        let [a, b, c, d, length @ ..] = *bytes.get(usize::try_from(start).ok()?..)?.first_chunk::<8>()?;
        Some(Self { start, name: [a, b, c, d], length: u32::from_le_bytes(length) })
    }

    /// Where the content ends.
    fn end(&self) -> u64 {
        self.start + HEADER_BYTES + u64::from(self.length)
    }

    fn is_known(&self) -> bool {
        const KNOWN: [&[u8; 4]; 8] = [b"VP8 ", b"VP8L", b"VP8X", b"ALPH", b"ANIM", b"ICCP", b"EXIF", b"XMP "];
        KNOWN.contains(&&self.name)
    }
}
