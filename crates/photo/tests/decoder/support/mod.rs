//! Asymmetric test pictures, encoded in each supported format.

use image::codecs::{jpeg::JpegEncoder, png::PngEncoder, webp::WebPEncoder};
use image::metadata::Orientation;
use image::{DynamicImage, ExtendedColorType, ImageEncoder, RgbImage};
use rosto_photo::{Limits, Photo, PhotoError, decode};

/// Formats that the tests can encode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Jpeg,
    Png,
    WebP,
}

pub const FORMATS: [Format; 3] = [Format::Jpeg, Format::Png, Format::WebP];

/// 48 × 32 px in blocks of 16 px with different colours, which JPEG preserves closely.
pub fn blocks() -> RgbImage {
    RgbImage::from_fn(48, 32, |x, y| {
        let (column, row) = (x / 16, y / 16);
        image::Rgb([40 + 80 * column as u8, 60 + 120 * row as u8, 200 - 50 * column as u8])
    })
}

/// Encodes the picture with an EXIF orientation.
pub fn file(picture: &RgbImage, format: Format, orientation: Orientation) -> Vec<u8> {
    file_with_exif(picture, format, exif(orientation))
}

/// Encodes the picture with an EXIF block.
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
    encoder.set_exif_metadata(exif).expect("the format supports EXIF");
    let (width, height) = picture.dimensions();
    encoder.write_image(picture, width, height, ExtendedColorType::Rgb8).expect("the picture can be encoded");
}

/// A little-endian TIFF header and a directory with one entry: tag 0x0112, SHORT, count 1.
pub fn exif(orientation: Orientation) -> Vec<u8> {
    let mut bytes = b"II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0".to_vec();
    bytes.extend([orientation.to_exif(), 0, 0, 0, 0, 0, 0, 0]);
    bytes
}

/// Returns the picture to store so that applying `orientation` yields `picture`.
pub fn stored_for(picture: &RgbImage, orientation: Orientation) -> RgbImage {
    let inverse = match orientation {
        Orientation::Rotate90 => Orientation::Rotate270,
        Orientation::Rotate270 => Orientation::Rotate90,
        self_inverse => self_inverse,
    };
    let mut stored = DynamicImage::from(picture.clone());
    stored.apply_orientation(inverse);
    stored.into_rgb8()
}

/// A grey JPEG without its end marker: a column of 8 × 8 px blocks with restart markers between them.
///
/// The Huffman codes: 0 is a difference of zero or an end of block, 10 is a difference of four bits.
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
        // 10, a difference of 9, end of block, and a padding bit.
        file.push(0b1010_0101);
        if block + 1 < blocks {
            file.extend([0xFF, 0xD0 + block % 8]);
        }
    }
    file
}

/// Inserts a chunk into a PNG file, before its pixels.
pub fn with_chunk(png: &[u8], name: &[u8; 4], content: &[u8]) -> Vec<u8> {
    let at = png.windows(4).position(|window| window == b"IDAT").expect("a PNG file has pixels") - 4;
    let named = [name.as_slice(), content].concat();
    let chunk =
        [&(content.len() as u32).to_be_bytes(), named.as_slice(), &crc32fast::hash(&named).to_be_bytes()].concat();
    [&png[..at], &chunk, &png[at..]].concat()
}

/// Decodes a file within the default limits.
pub fn read(bytes: &[u8]) -> Result<Photo, PhotoError> {
    decode(bytes, &Limits::default())
}

/// Returns the reason why a damaged picture is refused.
pub fn reason(bytes: &[u8]) -> String {
    match read(bytes).expect_err("a damaged picture") {
        PhotoError::Damaged { reason, .. } => reason,
        other => panic!("{other}"),
    }
}
