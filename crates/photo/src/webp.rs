//! WebP container checks. A chunk is a name, a length and its content, and starts at an even offset.

use std::iter::successors;

use crate::PhotoError;
use crate::format::Format;

/// Offset of the first chunk, after `RIFF`, a length and `WEBP`.
const FIRST: u64 = 12;
const HEADER_BYTES: u64 = 8;
/// Bytes of an animation frame before its own chunks: position, size, duration and flags.
const FRAME_BYTES: u64 = 16;

/// Refuses a file that ends within a picture or metadata chunk, or whose picture is larger than its canvas.
///
/// The decoder allocates the claimed length of a chunk before it checks it. Data that it does not read may be missing:
/// the padding byte of the last chunk, later animation frames, and chunks with unknown names.
///
/// # Errors
/// [`PhotoError::Damaged`].
pub(crate) fn check_chunks(bytes: &[u8]) -> Result<(), PhotoError> {
    check_lengths(bytes)?;
    check_sizes(bytes)
}

fn check_lengths(bytes: &[u8]) -> Result<(), PhotoError> {
    let whole_file = bytes.len() as u64;
    match read(bytes).find(|chunk| chunk.is_known() && chunk.end() > whole_file) {
        None => Ok(()),
        Some(chunk) => {
            let found = whole_file - chunk.start - HEADER_BYTES;
            let name = chunk.name.escape_ascii();
            Err(Format::WebP.damaged(format!("chunk {name} has {found} of its {} bytes", chunk.length)))
        }
    }
}

/// A lossy picture stores its own size; an extended file also stores the canvas size.
fn check_sizes(bytes: &[u8]) -> Result<(), PhotoError> {
    let Some((width, height)) = Chunk::at(bytes, FIRST).and_then(|chunk| chunk.canvas_size(bytes)) else {
        return Ok(());
    };
    match read(bytes).filter_map(|chunk| chunk.lossy_size(bytes)).find(|&(w, h)| w > width || h > height) {
        None => Ok(()),
        Some((w, h)) => {
            Err(Format::WebP.damaged(format!("a picture of {w} × {h} px exceeds the canvas of {width} × {height} px")))
        }
    }
}

/// Chunks that the decoder reads: the first one, all others in an extended file, and two of the first frame.
fn read(bytes: &[u8]) -> impl Iterator<Item = Chunk> {
    let extended = Chunk::at(bytes, FIRST).is_some_and(|chunk| &chunk.name == b"VP8X");
    let outer = move || chunks(bytes, FIRST).take(if extended { usize::MAX } else { 1 });
    let frame = outer().find(|chunk| &chunk.name == b"ANMF");
    let in_frame = frame.into_iter().flat_map(move |frame| chunks(bytes, frame.start + HEADER_BYTES + FRAME_BYTES));
    outer().chain(in_frame.take(2))
}

/// Consecutive chunks, up to the end of the file.
fn chunks(bytes: &[u8], start: u64) -> impl Iterator<Item = Chunk> {
    successors(Chunk::at(bytes, start), |chunk| Chunk::at(bytes, chunk.end().next_multiple_of(2)))
}

/// A chunk header. The content may be truncated.
struct Chunk {
    start: u64,
    name: [u8; 4],
    /// Claimed length of the content, in bytes.
    length: u32,
}

impl Chunk {
    fn at(bytes: &[u8], start: u64) -> Option<Self> {
        let [a, b, c, d, length @ ..] = *bytes.get(usize::try_from(start).ok()?..)?.first_chunk::<8>()?;
        Some(Self { start, name: [a, b, c, d], length: u32::from_le_bytes(length) })
    }

    /// Offset of the end of the content.
    fn end(&self) -> u64 {
        self.start + HEADER_BYTES + u64::from(self.length)
    }

    /// Canvas size in px, if this is the header of an extended file.
    fn canvas_size(&self, bytes: &[u8]) -> Option<(u32, u32)> {
        let [_, _, _, _, a, b, c, d, e, f] = *self.content(bytes, b"VP8X")?;
        Some((u32::from_le_bytes([a, b, c, 0]) + 1, u32::from_le_bytes([d, e, f, 0]) + 1))
    }

    /// Size in px, if this is a lossy picture: a frame tag and start code, then 14 bits each for width and height.
    fn lossy_size(&self, bytes: &[u8]) -> Option<(u32, u32)> {
        let [.., a, b, c, d] = *self.content::<10>(bytes, b"VP8 ")?;
        let size = |low, high| u32::from(u16::from_le_bytes([low, high]) & 0x3FFF);
        Some((size(a, b), size(c, d)))
    }

    /// First `N` bytes of the content, if the chunk has this name and enough bytes.
    fn content<'a, const N: usize>(&self, bytes: &'a [u8], name: &[u8; 4]) -> Option<&'a [u8; N]> {
        let start = usize::try_from(self.start + HEADER_BYTES).ok()?;
        if &self.name == name { bytes.get(start..)?.first_chunk() } else { None }
    }

    fn is_known(&self) -> bool {
        const KNOWN: [&[u8; 4]; 8] = [b"VP8 ", b"VP8L", b"VP8X", b"ALPH", b"ANIM", b"ICCP", b"EXIF", b"XMP "];
        KNOWN.contains(&&self.name)
    }
}
