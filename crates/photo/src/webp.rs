//! WebP files: chunks of a name, a length and as many bytes, each begun at an even place.

use std::iter::successors;

use crate::PhotoError;
use crate::format::Format;

/// Where the first chunk begins, behind `RIFF`, a length and `WEBP`.
const FIRST: u64 = 12;
const HEADER_BYTES: u64 = 8;
/// What stands in a frame of an animation before its own chunks: place, size, duration and flags.
const FRAME_BYTES: u64 = 16;

/// Refuses a file that ends within a chunk of the picture or its metadata, or whose picture is larger than the file says
/// it is, because the decoder allocates what a chunk claims before it looks whether that can be. What it does not read
/// may be missing: the byte that pads the last chunk, later frames of an animation, and chunks of unknown names.
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
            let there = whole_file - chunk.start - HEADER_BYTES;
            let name = chunk.name.escape_ascii();
            Err(Format::WebP.damaged(format!("{there} of the {} bytes of its chunk {name} are there", chunk.length)))
        }
    }
}

/// A lossy picture has its size at its head, and an extended file its own before it.
fn check_sizes(bytes: &[u8]) -> Result<(), PhotoError> {
    let Some((width, height)) = Chunk::at(bytes, FIRST).and_then(|chunk| chunk.canvas_size(bytes)) else {
        return Ok(());
    };
    match read(bytes).filter_map(|chunk| chunk.lossy_size(bytes)).find(|&(w, h)| w > width || h > height) {
        None => Ok(()),
        Some((w, h)) => {
            Err(Format::WebP.damaged(format!("its picture is {w} × {h} px in a file of {width} × {height} px")))
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

    /// Of the whole picture in px, if this is the head of an extended file.
    fn canvas_size(&self, bytes: &[u8]) -> Option<(u32, u32)> {
        let [_, _, _, _, a, b, c, d, e, f] = *self.content(bytes, b"VP8X")?;
        Some((u32::from_le_bytes([a, b, c, 0]) + 1, u32::from_le_bytes([d, e, f, 0]) + 1))
    }

    /// In px, if this is a lossy picture: behind a tag and a mark, 14 bits of width and of height.
    fn lossy_size(&self, bytes: &[u8]) -> Option<(u32, u32)> {
        let [.., a, b, c, d] = *self.content::<10>(bytes, b"VP8 ")?;
        let size = |low, high| u32::from(u16::from_le_bytes([low, high]) & 0x3FFF);
        Some((size(a, b), size(c, d)))
    }

    /// What the content begins with, if the chunk has this name and there is so much.
    fn content<'a, const N: usize>(&self, bytes: &'a [u8], name: &[u8; 4]) -> Option<&'a [u8; N]> {
        let start = usize::try_from(self.start + HEADER_BYTES).ok()?;
        if &self.name == name { bytes.get(start..)?.first_chunk() } else { None }
    }

    fn is_known(&self) -> bool {
        const KNOWN: [&[u8; 4]; 8] = [b"VP8 ", b"VP8L", b"VP8X", b"ALPH", b"ANIM", b"ICCP", b"EXIF", b"XMP "];
        KNOWN.contains(&&self.name)
    }
}
