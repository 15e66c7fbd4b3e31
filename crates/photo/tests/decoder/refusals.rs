//! Refused files and their error messages.

use crate::support::{FORMATS, Format, blocks, file};
use image::metadata::Orientation;
use proptest::prelude::*;
use rosto_photo::{Limits, Photo, PhotoError, decode};

fn refusal(bytes: &[u8]) -> PhotoError {
    decode(bytes, &Limits::default()).unwrap_err()
}

/// A PNG that ends after its header.
fn png_header(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    bytes.extend(width.to_be_bytes());
    bytes.extend(height.to_be_bytes());
    bytes.extend([8, 2, 0, 0, 0]);
    bytes
}

#[test]
fn a_text_file_is_not_a_picture() {
    assert_eq!(refusal(b"Dear diary, this is not a photo.\n"), PhotoError::NotAPicture);
    assert_eq!(refusal(b""), PhotoError::NotAPicture);
}

#[test]
fn an_oversized_picture_is_refused_from_its_header() {
    let error = refusal(&png_header(20_000, 20_000));
    assert_eq!(error, PhotoError::TooManyPixels { width: 20_000, height: 20_000, max_pixels: 50_000_000 });
    assert_eq!(error.to_string(), "the picture is 20000×20000 px, 400 megapixels; the limit is 50");
}

#[test]
fn the_pixel_limit_is_inclusive_in_each_format() {
    let pixels = u64::from(blocks().width() * blocks().height());
    for format in FORMATS {
        let bytes = file(&blocks(), format, Orientation::NoTransforms);
        let with_limit = |max_pixels| decode(&bytes, &Limits { max_pixels, ..Limits::default() });
        assert!(with_limit(pixels).is_ok(), "{format:?}");
        let error = with_limit(pixels - 1).unwrap_err();
        assert!(matches!(error, PhotoError::TooManyPixels { width: 48, height: 32, .. }), "{format:?}: {error}");
    }
}

#[test]
fn the_byte_limit_is_inclusive() {
    let bytes = file(&blocks(), Format::Png, Orientation::NoTransforms);
    let with_limit = |max_bytes| decode(&bytes, &Limits { max_bytes, ..Limits::default() });
    assert!(with_limit(bytes.len()).is_ok());
    let [found_bytes, max_bytes] = [bytes.len() as u64, bytes.len() as u64 - 1];
    assert_eq!(with_limit(bytes.len() - 1).unwrap_err(), PhotoError::TooManyBytes { found_bytes, max_bytes });
}

#[test]
fn a_file_is_refused_by_its_length_before_it_is_read() {
    let thirty_gigabytes = 30_000_000_000;
    let expected = PhotoError::TooManyBytes { found_bytes: thirty_gigabytes, max_bytes: 40_000_000 };
    assert_eq!(Limits::default().check_length(thirty_gigabytes), Err(expected));
    assert_eq!(Limits::default().check_length(40_000_000), Ok(()));
}

#[test]
fn the_reported_size_exceeds_the_reported_limit() {
    let message = |width, height| refusal(&png_header(width, height)).to_string();
    assert_eq!(message(8400, 6000), "the picture is 8400×6000 px, 50.4 megapixels; the limit is 50");
    assert_eq!(message(50_000_001, 1), "the picture is 50000001×1 px, 50.1 megapixels; the limit is 50");
    assert_eq!(refusal(b"\0\0\0\x1cftypavif\0\0\0\0avifmif1").to_string(), "AVIF pictures are not supported");
}

#[test]
fn a_truncated_file_is_damaged() {
    for format in FORMATS {
        let bytes = file(&blocks(), format, Orientation::NoTransforms);
        let whole = decode(&bytes, &Limits::default()).unwrap();
        // After the pixels come an end marker in JPEG, checksums and an end chunk in PNG, and EXIF in WebP; none is
        // required.
        let last = match format {
            Format::Jpeg => bytes.len() - 2,
            Format::Png => bytes.len() - 20,
            Format::WebP => bytes.windows(4).position(|window| window == b"EXIF").unwrap(),
        };
        for length in (16..last).step_by(7).chain(last - 9..last) {
            match decode(&bytes[..length], &Limits::default()) {
                Err(PhotoError::Damaged { .. }) => {}
                // The last bytes of the compressed pixels only mark their end.
                Ok(photo) if format == Format::Png && length >= last - 9 => assert_eq!(photo, whole, "at {length}"),
                other => panic!("{format:?} at {length} of {last}: {other:?}"),
            }
        }
    }
}

#[test]
fn a_complete_thumbnail_does_not_hide_a_truncated_jpeg() {
    let thumbnail = file(&blocks(), Format::Jpeg, Orientation::NoTransforms);
    let picture = file(&blocks(), Format::Jpeg, Orientation::NoTransforms);
    let mut bytes = vec![0xFF, 0xD8, 0xFF, 0xE1];
    bytes.extend((thumbnail.len() as u16 + 2).to_be_bytes());
    bytes.extend(&thumbnail);
    bytes.extend(&picture[2..]);
    assert!(decode(&bytes, &Limits::default()).is_ok());
    let cut = &bytes[..bytes.len() - 40];
    assert!(matches!(refusal(cut), PhotoError::Damaged { .. }));
}

#[test]
fn errors_report_missing_rows() {
    let png = file(&blocks(), Format::Png, Orientation::NoTransforms);
    let pixels = png.windows(4).position(|window| window == b"IDAT").unwrap() + 4;
    let message = refusal(&png[..pixels]).to_string();
    assert_eq!(message, "this PNG picture is damaged: the data ends after 0 of 32 rows");
    let jpeg = file(&blocks(), Format::Jpeg, Orientation::NoTransforms);
    for cut in [&jpeg[..jpeg.len() - 20], &[&jpeg[..jpeg.len() - 20], &[0; 512]].concat()] {
        assert_eq!(refusal(cut).to_string(), "this JPEG picture is damaged: the data ends before the last row");
    }
}

#[test]
fn unsupported_formats_are_named_with_advice() {
    let cases: [(&[u8], &str, &str); 9] = [
        (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", "HEIC", "JPEG"),
        (b"\0\0\0\x18ftypmif1\0\0\0\0mif1heic", "HEIC", "JPEG"),
        (b"\0\0\0\x1cftypmif1\0\0\0\0miafheix", "HEIC", "JPEG"),
        (b"\0\0\0\x1cftypavif\0\0\0\0avifmif1", "AVIF", "JPEG"),
        (b"\0\0\0\x1cftypmif1\0\0\0\0miafavif", "AVIF", "JPEG"),
        (b"\0\0\0\x18ftypmsf1\0\0\0\0msf1avisheic", "AVIF", "JPEG"),
        (b"GIF89a\x01\0\x01\0", "GIF", "JPEG"),
        (b"II\x2a\0\x08\0\0\0", "TIFF", "JPEG"),
        (b"\xFF\x0A\xFA\x1F", "JPEG XL", "JPEG"),
    ];
    for (bytes, expected, advice) in cases {
        let error = refusal(bytes);
        assert!(matches!(error, PhotoError::UnsupportedFormat { format } if format == expected), "{error}");
        assert!(error.hint().contains(advice), "{expected}");
    }
}

#[test]
fn the_number_of_bytes_has_to_match_the_size() {
    assert!(Photo::from_rgb(0, 5, Vec::new()).is_err());
    assert!(Photo::from_rgb(2, 2, vec![0; 11]).is_err());
    assert!(Photo::from_rgb(u32::MAX, u32::MAX, vec![0; 3]).is_err());
    assert!(Photo::from_rgb(2, 2, vec![0; 12]).is_ok());
    assert!(Photo::from_rgbx(0, 5, &[]).is_err());
    assert!(Photo::from_rgbx(2, 2, &[0; 15]).is_err());
    assert!(Photo::from_rgbx(u32::MAX, u32::MAX, &[0; 4]).is_err());
}

proptest! {
    /// Arbitrary changes yield a picture or an error, not a panic.
    #[test]
    fn damaged_files_do_not_panic(
        format in prop::sample::select(FORMATS.to_vec()),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..12),
        cut in any::<prop::sample::Index>(),
    ) {
        let mut bytes = file(&blocks(), format, Orientation::Rotate90);
        for (at, value) in changes {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        bytes.truncate(bytes.len() - cut.index(bytes.len()) / 4);
        if let Ok(photo) = decode(&bytes, &Limits { max_pixels: 1_000_000, ..Limits::default() }) {
            prop_assert_eq!(photo.pixels().len(), photo.width() as usize * photo.height() as usize * 3);
        }
    }
}
