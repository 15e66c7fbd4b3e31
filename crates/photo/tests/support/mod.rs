//! Pictures with no symmetry, and their files in every format that is read.

#![allow(dead_code, reason = "each test file is a program of its own and uses its part of this")]

use image::codecs::{jpeg::JpegEncoder, png::PngEncoder, webp::WebPEncoder};
use image::metadata::Orientation;
use image::{DynamicImage, ExtendedColorType, ImageEncoder, RgbImage};
use rosto_photo::{Limits, Photo, PhotoError, decode};

/// Formats that are written for the tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Jpeg,
    Png,
    WebP,
}

pub const FORMATS: [Format; 3] = [Format::Jpeg, Format::Png, Format::WebP];

/// 48 × 32 px in blocks of 16, each of its own colour, so that JPEG keeps it nearly as it is.
pub fn blocks() -> RgbImage {
    RgbImage::from_fn(48, 32, |x, y| {
        let (column, row) = (x / 16, y / 16);
        image::Rgb([40 + 80 * column as u8, 60 + 120 * row as u8, 200 - 50 * column as u8])
    })
}

/// The picture as a file that asks its reader to apply `orientation`.
pub fn file(picture: &RgbImage, format: Format, orientation: Orientation) -> Vec<u8> {
    file_with_exif(picture, format, exif(orientation))
}

/// The picture as a file with an EXIF block.
pub fn file_with_exif(picture: &RgbImage, format: Format, exif: Vec<u8>) -> Vec<u8> {
    let mut bytes = Vec::new();
    match format {
        Format::Jpeg => write(JpegEncoder::new_with_quality(&mut bytes, 100), picture, exif),
        Format::Png => write(PngEncoder::new(&mut bytes), picture, exif),
        Format::WebP => write(WebPEncoder::new_lossless(&mut bytes), picture, exif),
    }
    bytes
}

fn write(mut encoder: impl ImageEncoder, picture: &RgbImage, exif: Vec<u8>) {
    encoder.set_exif_metadata(exif).expect("the format knows EXIF");
    let (width, height) = picture.dimensions();
    encoder.write_image(picture, width, height, ExtendedColorType::Rgb8).expect("the picture can be written");
}

/// A little-endian TIFF header and one directory with one entry: 0x0112, SHORT, count 1.
pub fn exif(orientation: Orientation) -> Vec<u8> {
    let mut bytes = b"II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0".to_vec();
    bytes.extend([orientation.to_exif(), 0, 0, 0, 0, 0, 0, 0]);
    bytes
}

/// What has to be stored for `picture` to appear when `orientation` is applied.
pub fn stored_for(picture: &RgbImage, orientation: Orientation) -> RgbImage {
    let inverse = match orientation {
        Orientation::Rotate90 => Orientation::Rotate270,
        Orientation::Rotate270 => Orientation::Rotate90,
        its_own => its_own,
    };
    let mut stored = DynamicImage::from(picture.clone());
    stored.apply_orientation(inverse);
    stored.into_rgb8()
}

/// A grey JPEG, one block of 8 × 8 px above the other, a restart marker between any two; without its end mark. Of the
/// Huffman codes, 0 is "no difference" and "no more", and 10 is "a difference of four bits".
pub fn blocks_with_restarts(blocks: u8) -> Vec<u8> {
    let table = |class: u8, second: u8| {
        let counts = [1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        [&[0xFF, 0xC4, 0, 21, class], counts.as_slice(), &[0, second]].concat()
    };
    let mut file = vec![0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0];
    file.extend([16; 64]);
    file.extend([0xFF, 0xC0, 0, 11, 8, 0, 8 * blocks, 0, 8, 1, 1, 0x11, 0]);
    file.extend([table(0x00, 4), table(0x10, 1)].concat());
    file.extend([0xFF, 0xDD, 0, 4, 0, 1, 0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 63, 0]);
    for block in 0..blocks {
        // 10, a difference of 9, "no more", and a bit to fill the byte.
        file.push(0b1010_0101);
        if block + 1 < blocks {
            file.extend([0xFF, 0xD0 + block % 8]);
        }
    }
    file
}

/// A PNG file with another chunk before its pixels.
pub fn with_chunk(png: &[u8], name: &[u8; 4], content: &[u8]) -> Vec<u8> {
    let at = png.windows(4).position(|window| window == b"IDAT").expect("a PNG file has pixels") - 4;
    let named = [name.as_slice(), content].concat();
    let chunk =
        [&(content.len() as u32).to_be_bytes(), named.as_slice(), &crc32fast::hash(&named).to_be_bytes()].concat();
    [&png[..at], &chunk, &png[at..]].concat()
}

/// The picture in a file, within the usual limits.
pub fn read(bytes: &[u8]) -> Result<Photo, PhotoError> {
    decode(bytes, &Limits::default())
}

/// Why a damaged picture is refused.
pub fn reason(bytes: &[u8]) -> String {
    match read(bytes).expect_err("a damaged picture") {
        PhotoError::Damaged { reason, .. } => reason,
        other => panic!("{other}"),
    }
}
