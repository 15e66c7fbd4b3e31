//! EXIF metadata: CIPA DC-008 (Exif 3.0), stored in the directories of a TIFF 6.0 file.
//!
//! Unreadable metadata is ignored; it does not make a picture invalid.

use image::metadata::Orientation;

const ORIENTATION: u16 = 0x0112;
const SOFTWARE: u16 = 0x0131;
const EXIF_DIRECTORY: u16 = 0x8769;
const PIXEL_X_DIMENSION: u16 = 0xA002;
const PIXEL_Y_DIMENSION: u16 = 0xA003;
const FOCAL_LENGTH_IN_35MM_FILM: u16 = 0xA405;

/// Parts of the names of programs that crop, in lower case. Cameras and phones name their firmware.
const EDITORS: [&str; 22] = [
    "acdsee",
    "affinity",
    "canva",
    "capture one",
    "darktable",
    "facetune",
    "gimp",
    "imagemagick",
    "instagram",
    "lightroom",
    "luminar",
    "meitu",
    "paint",
    "photo editor",
    "photoscape",
    "photoshop",
    "picasa",
    "picsart",
    "pixelmator",
    "rawtherapee",
    "snapseed",
    "vsco",
];

/// EXIF fields that Rosto uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Exif {
    /// Transform that turns the stored picture upright.
    pub(crate) orientation: Orientation,
    /// 35-mm-equivalent focal length in mm: the same diagonal field of view on a 36 × 24 mm frame.
    pub(crate) focal_length_35mm: Option<u16>,
}

impl Exif {
    /// Reads the EXIF block of a stored picture of `width` × `height` px, before its orientation is applied.
    ///
    /// The focal length describes the whole frame. It is `None` if it is implausible (0 means unknown), or if the file
    /// shows that it may be cropped: its aspect ratio differs from EXIF's, or it names an editor. Lossless rotation leaves EXIF's width and height
    /// unchanged, so either side may be the width.
    pub(crate) fn read(block: &[u8], width: u32, height: u32) -> Self {
        let tiff = Tiff::new(block);
        let orientation = tiff.as_ref().and_then(|tiff| tiff.number(tiff.first, ORIENTATION));
        Self {
            orientation: orientation
                .and_then(|value| Orientation::from_exif(value.try_into().ok()?))
                .unwrap_or(Orientation::NoTransforms),
            focal_length_35mm: tiff.and_then(|tiff| tiff.focal_length_35mm([width, height])),
        }
    }

    /// Returns the focal length that a HEIC or AVIF file gives for a picture of `width` × `height` px, which is already
    /// upright.
    pub(crate) fn focal_length_35mm_in_container(file: &[u8], width: u32, height: u32) -> Option<u16> {
        Self::read(block_in_container(file)?, width, height).focal_length_35mm
    }
}

/// Returns the EXIF block of a HEIC or AVIF file, with all bytes after it.
///
/// The block is an item (ISO/IEC 23008-12, A.2.1): a 4-byte length, a header of that length (6 bytes or none), then the
/// TIFF data. It is found by its signature, which is unlikely to occur in compressed pixels.
fn block_in_container(file: &[u8]) -> Option<&[u8]> {
    let begins = |bytes: &[u8; 10]| match bytes {
        [before @ .., b'I', b'I', 42, 0] | [before @ .., b'M', b'M', 0, 42] => {
            before == b"Exif\0\0" || before.ends_with(&[0; 4])
        }
        _ => false,
    };
    let position = file.array_windows().position(begins)?;
    file.get(position + 6..)
}

/// Directories of a TIFF file.
struct Tiff<'a> {
    bytes: &'a [u8],
    big_endian: bool,
    /// Offset of the first directory.
    first: u32,
}

impl<'a> Tiff<'a> {
    fn new(block: &'a [u8]) -> Option<Self> {
        // Some WebP and PNG encoders keep the header that only JPEG uses.
        let bytes = block.strip_prefix(b"Exif\0\0").unwrap_or(block);
        let big_endian = match bytes.get(..4)? {
            b"II\x2a\0" => false,
            b"MM\0\x2a" => true,
            _ => return None,
        };
        let tiff = Self { bytes, big_endian, first: 0 };
        Some(Self { first: tiff.u32_at(bytes, 4)?, ..tiff })
    }

    fn focal_length_35mm(&self, stored_px: [u32; 2]) -> Option<u16> {
        const PLAUSIBLE_MM: std::ops::RangeInclusive<u16> = 8..=400;
        let directory = self.number(self.first, EXIF_DIRECTORY)?;
        let number = |tag| self.number(directory, tag);
        let taken_px = number(PIXEL_X_DIMENSION).zip(number(PIXEL_Y_DIMENSION)).map(<[u32; 2]>::from);
        let focal_length = u16::try_from(number(FOCAL_LENGTH_IN_35MM_FILM)?).ok()?;
        let whole = taken_px
            .is_none_or(|[w, h]| [[w, h], [h, w]].iter().any(|&px| px == [0; 2] || same_proportions(px, stored_px)));
        (whole && !self.is_edited() && PLAUSIBLE_MM.contains(&focal_length)).then_some(focal_length)
    }

    fn is_edited(&self) -> bool {
        let software = self.text(self.first, SOFTWARE).unwrap_or_default().to_ascii_lowercase();
        EDITORS.iter().any(|editor| software.windows(editor.len()).any(|part| part == editor.as_bytes()))
    }

    /// Value of a directory entry that holds a single SHORT or LONG.
    fn number(&self, directory: u32, tag: u16) -> Option<u32> {
        const SHORT: u16 = 3;
        const LONG: u16 = 4;
        let entry = self.entry(directory, tag)?;
        match (self.u16_at(entry, 2)?, self.u32_at(entry, 4)?) {
            (SHORT, 1) => self.u16_at(entry, 8).map(u32::from),
            (LONG, 1) => self.u32_at(entry, 8),
            _ => None,
        }
    }

    /// Value of a directory entry that holds more than four characters.
    fn text(&self, directory: u32, tag: u16) -> Option<&'a [u8]> {
        const ASCII: u16 = 2;
        let entry = self.entry(directory, tag)?;
        let [count, start] = [4, 8].map(|at| self.u32_at(entry, at).and_then(|number| usize::try_from(number).ok()));
        let (count, start) = (count?, start?);
        (self.u16_at(entry, 2)? == ASCII).then(|| self.bytes.get(start..start.checked_add(count)?))?
    }

    fn entry(&self, directory: u32, tag: u16) -> Option<&'a [u8; 12]> {
        let directory = self.bytes.get(usize::try_from(directory).ok()?..)?;
        let count = usize::from(self.u16_at(directory, 0)?);
        let entries = directory.get(2..)?.as_chunks::<12>().0;
        entries.iter().take(count).find(|entry| self.u16_at(*entry, 0) == Some(tag))
    }

    fn u16_at(&self, bytes: &[u8], at: usize) -> Option<u16> {
        let bytes = *bytes.get(at..)?.first_chunk()?;
        Some(if self.big_endian { u16::from_be_bytes(bytes) } else { u16::from_le_bytes(bytes) })
    }

    fn u32_at(&self, bytes: &[u8], at: usize) -> Option<u32> {
        let bytes = *bytes.get(at..)?.first_chunk()?;
        Some(if self.big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) })
    }
}

/// Whether the two sizes have the same aspect ratio, up to rounding or truncation of both sides to whole pixels.
fn same_proportions(one_px: [u32; 2], other_px: [u32; 2]) -> bool {
    let [[width, height], [other_width, other_height]] = [one_px, other_px].map(|size_px| size_px.map(u64::from));
    let one_px_of_the_longest = width.max(height).max(other_width).max(other_height);
    (width * other_height).abs_diff(height * other_width) <= one_px_of_the_longest
}
