//! Focal length from EXIF.

use crate::seeded::Seeded;
use crate::support::{FORMATS, Format, blocks, file_with_exif, read, stored_for};
use image::RgbImage;
use image::metadata::Orientation;
use proptest::prelude::*;
use rosto_photo::Photo;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Endian {
    Little,
    Big,
}

/// The value of an entry.
#[derive(Clone, Copy)]
enum Value {
    Short(u16),
    Long(u32),
}

use Value::{Long, Short};

const FOCAL_LENGTH_IN_35MM_FILM: u16 = 0xA405;

impl Endian {
    fn u16(self, value: u16) -> [u8; 2] {
        if self == Self::Big { value.to_be_bytes() } else { value.to_le_bytes() }
    }

    fn u32(self, value: u32) -> [u8; 4] {
        if self == Self::Big { value.to_be_bytes() } else { value.to_le_bytes() }
    }

    fn directory(self, entries: &[(u16, Value)]) -> Vec<u8> {
        let entry = |&(tag, value): &(u16, Value)| match value {
            Short(value) => [&self.u16(tag)[..], &self.u16(3), &self.u32(1), &self.u16(value), &[0; 2]].concat(),
            Long(value) => [&self.u16(tag)[..], &self.u16(4), &self.u32(1), &self.u32(value)].concat(),
        };
        let entries = [self.u16(entries.len() as u16).to_vec(), entries.iter().flat_map(entry).collect()].concat();
        [entries.as_slice(), &[0; 4]].concat()
    }

    /// Builds an EXIF block with the orientation in the first directory and the other entries in a second.
    fn exif(self, orientation: Orientation, entries: &[(u16, Value)]) -> Vec<u8> {
        let first = [(0x0112, Short(orientation.to_exif().into())), (0x8769, Long(38))];
        let mark: &[u8; 2] = if self == Self::Big { b"MM" } else { b"II" };
        [mark, &self.u16(42)[..], &self.u32(8), &self.directory(&first), &self.directory(entries)].concat()
    }
}

/// Builds EXIF with a focal length and the size at which the picture was taken.
fn taken_with(focal_length: u16, taken_px: [u32; 2]) -> Vec<u8> {
    let size = [(0xA002, Long(taken_px[0])), (0xA003, Long(taken_px[1]))];
    let entries = [size.as_slice(), &[(FOCAL_LENGTH_IN_35MM_FILM, Short(focal_length))]].concat();
    Endian::Little.exif(Orientation::NoTransforms, &entries)
}

fn focal_length(stored_px: [u32; 2], exif: Vec<u8>) -> Option<f64> {
    let picture = RgbImage::new(stored_px[0], stored_px[1]);
    read(&file_with_exif(&picture, Format::Png, exif)).unwrap().focal_length_35mm()
}

#[test]
fn the_focal_length_is_read_in_all_formats_byte_orders_and_orientations() {
    for (format, endian) in FORMATS.into_iter().flat_map(|format| [Endian::Little, Endian::Big].map(|e| (format, e))) {
        for orientation in (1..=8).map(|exif| Orientation::from_exif(exif).unwrap()) {
            let stored = stored_for(&blocks(), orientation);
            let size = [(0xA002, Short(stored.width() as u16)), (0xA003, Short(stored.height() as u16))];
            let entries = [size.as_slice(), &[(FOCAL_LENGTH_IN_35MM_FILM, Short(26))]].concat();
            let photo = read(&file_with_exif(&stored, format, endian.exif(orientation, &entries))).unwrap();
            assert_eq!((photo.width(), photo.height()), blocks().dimensions(), "{format:?} {endian:?}");
            assert_eq!(photo.focal_length_35mm(), Some(26.0), "{format:?} {endian:?} {orientation:?}");
            assert_eq!(photo.scaled_down(24).focal_length_35mm(), Some(26.0), "a smaller copy keeps the focal length");
        }
    }
}

#[test]
fn an_implausible_focal_length_is_ignored() {
    let found = |mm| focal_length([4, 3], taken_with(mm, [4, 3]));
    assert_eq!([0, 1, 7, 401, u16::MAX].map(found), [None; 5]);
    assert_eq!([8, 13, 400].map(found), [Some(8.0), Some(13.0), Some(400.0)]);
}

#[test]
fn a_cropped_picture_has_no_focal_length() {
    for cropped in [[4032, 2900], [2900, 4032], [3024, 3024], [4032, 2268], [403, 2000], [0, 3024]] {
        assert_eq!(focal_length([96, 72], taken_with(28, cropped)), None, "{cropped:?}");
    }
    assert_eq!(focal_length([96, 72], taken_with(28, [0, 0])), Some(28.0), "the size is unknown");
}

#[test]
fn an_edited_picture_has_no_focal_length() {
    let made_by = |software: &[u8]| {
        let mut exif = taken_with(28, [4032, 3024]);
        // The orientation's entry becomes the software's, with its text at the end.
        let entry = [&0x0131_u16.to_le_bytes()[..], &[2, 0], &(software.len() as u32).to_le_bytes()].concat();
        let start = (exif.len() as u32).to_le_bytes();
        exif.splice(10..22, [entry, start.to_vec()].concat());
        focal_length([96, 72], [exif.as_slice(), software].concat())
    };
    for editor in [&b"Adobe Photoshop 25.1 (Macintosh)\0"[..], b"GIMP 2.10.34\0", b"Snapseed 2.19\0"] {
        assert_eq!(made_by(editor), None);
    }
    for firmware in [&b"17.1.2\0"[..], b"HDR+ 1.0.585804376zd\0", b"G991BXXU5CVF3\0", b"\0"] {
        assert_eq!(made_by(firmware), Some(28.0));
    }
}

#[test]
fn a_losslessly_rotated_picture_keeps_its_focal_length() {
    assert_eq!(focal_length([72, 96], taken_with(28, [4032, 3024])), Some(28.0));
    assert_eq!(focal_length([96, 72], taken_with(28, [3024, 4032])), Some(28.0));
}

#[test]
fn a_photo_without_exif_has_no_focal_length() {
    let bare = Endian::Big.exif(Orientation::Rotate90, &[]);
    assert_eq!(focal_length([4, 3], bare), None);
    assert_eq!(Photo::from_rgb(1, 1, vec![0; 3]).unwrap().focal_length_35mm(), None);
}

#[test]
fn the_focal_length_is_found_in_a_heic_container() {
    let photo = || Photo::from_rgb(30, 40, vec![9; 3600]).unwrap();
    let in_container = |exif: &[u8]| {
        let container = [b"\0\0\0\x18ftypheic\0\0\0\0mif1heic MM II*", exif, &[0x9E; 99]].concat();
        photo().with_lens_of(&container).focal_length_35mm()
    };
    // Taken in landscape and rotated by the container, so EXIF's orientation has no effect.
    for endian in [Endian::Little, Endian::Big] {
        let size = [(0xA002, Long(4032)), (0xA003, Long(3024))];
        let entries = [size.as_slice(), &[(FOCAL_LENGTH_IN_35MM_FILM, Short(23))]].concat();
        let block = endian.exif(Orientation::Rotate90, &entries);
        assert_eq!(in_container(&[b"\0\0\0\x06Exif\0\0", &block[..]].concat()), Some(23.0), "{endian:?}");
        assert_eq!(in_container(&[&[0; 4], &block[..]].concat()), Some(23.0), "{endian:?}");
        assert_eq!(in_container(&block[..30]), None, "{endian:?}");
    }
    assert_eq!(in_container(&[&[0; 4], &taken_with(23, [3000, 3000])[..]].concat()), None, "cropped");
    assert_eq!(photo().with_lens_of(b"").focal_length_35mm(), None);
}

#[test]
fn invalid_or_cyclic_directory_offsets_are_ignored() {
    for (position, offset) in [(4, u32::MAX), (4, 4), (4, 0), (30, u32::MAX), (30, 8), (30, 0), (30, 1 << 20)] {
        let mut exif = taken_with(28, [4, 3]);
        exif[position..position + 4].copy_from_slice(&offset.to_le_bytes());
        assert_eq!(focal_length([4, 3], exif), None, "{offset} at {position}");
    }
}

#[test]
fn a_damaged_exif_block_does_not_make_the_picture_invalid() {
    let whole = Endian::Little.exif(Orientation::Rotate90, &[(FOCAL_LENGTH_IN_35MM_FILM, Short(28))]);
    for length in 0..whole.len() {
        let found = focal_length([4, 3], whole[..length].to_vec());
        assert!(found.is_none_or(|mm| mm == 28.0), "{found:?} of the first {length} bytes");
    }
    let mut seeded = Seeded::new(11);
    for _ in 0..3000 {
        let mut altered = whole.clone();
        for _ in 0..=seeded.below(6) {
            let at = seeded.below(altered.len());
            altered[at] = [seeded.bits() as u8, 0, 0xFF, 0x80, 1][seeded.below(5)];
        }
        let found = focal_length([4, 3], altered);
        assert!(found.is_none_or(|mm| (8.0..=400.0).contains(&mm)), "{found:?}");
    }
}

proptest! {
    /// Programs that scale a picture down either round or truncate both sides.
    #[test]
    fn a_scaled_copy_keeps_the_focal_length(
        taken_px in [500_u32..9000, 500_u32..9000], scale in 0.01_f64..0.1, truncated: bool,
    ) {
        let side = |axis: usize| {
            let side = f64::from(taken_px[axis]) * scale;
            (if truncated { side.floor() } else { side.round() }).max(1.0) as u32
        };
        prop_assert_eq!(focal_length([side(0), side(1)], taken_with(24, taken_px)), Some(24.0));
    }
}
