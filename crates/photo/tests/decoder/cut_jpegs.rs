//! Truncated JPEG files.

use crate::support::{blocks_with_restarts, read, reason};
use image::RgbImage;
use image::codecs::jpeg::JpegEncoder;
use rosto_photo::Photo;

const REFUSED: &str = "the data ends before the last row";
/// Length of the end-of-image marker.
const END_BYTES: usize = 2;

/// A picture whose rows all differ, so that a copied row can be recognised.
fn waves() -> RgbImage {
    RgbImage::from_fn(40, 400, |x, y| {
        let wave = |period: f32, phase: f32| (127.0 + 100.0 * ((x * x + 3 * y) as f32 / period + phase).sin()) as u8;
        image::Rgb([wave(9.0, 0.0), wave(23.0, 1.0), wave(40.0, 2.0)])
    })
}

fn jpeg(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, 90).encode_image(picture).unwrap();
    bytes
}

fn row(photo: &Photo, y: u32) -> &[u8] {
    let bytes = photo.width() as usize * 3;
    &photo.pixels()[y as usize * bytes..][..bytes]
}

/// Number of rows, from the top, that equal those of the whole picture.
fn rows_like(photo: &Photo, whole: &Photo) -> u32 {
    (0..whole.height()).take_while(|&y| row(photo, y) == row(whole, y)).count() as u32
}

#[test]
fn up_to_a_twentieth_of_the_rows_may_be_missing_and_repeat_the_last_intact_row() {
    let bytes = jpeg(&waves());
    let whole = read(&bytes).unwrap();
    let mut rows_of_accepted = Vec::new();
    for length in (bytes.len() / 2..bytes.len()).step_by(11) {
        let Ok(photo) = read(&bytes[..length]) else {
            assert_eq!(reason(&bytes[..length]), REFUSED, "the first {length} bytes");
            assert!(rows_of_accepted.is_empty(), "a shorter file was already accepted");
            continue;
        };
        let rows = rows_like(&photo, &whole);
        assert!((rows..400).all(|y| row(&photo, y) == row(&photo, rows - 1)), "the first {length} bytes");
        rows_of_accepted.push(rows);
    }
    assert!(rows_of_accepted.is_sorted(), "{rows_of_accepted:?}");
    // A row of blocks is 8 px high: the first accepted file lacks 16 rows.
    assert_eq!(rows_of_accepted[0], 384);
    assert_eq!(read(&bytes[..bytes.len() - END_BYTES]).unwrap(), whole);
}

#[test]
fn the_last_restart_interval_may_be_missing() {
    let unmarked = blocks_with_restarts(25);
    let whole = read(&unmarked).unwrap();
    assert_eq!((whole.width(), whole.height()), (8, 200));
    // The last block takes one byte, after a two-byte marker.
    for missing in 1..=3 {
        let photo = read(&unmarked[..unmarked.len() - missing]).unwrap();
        assert_eq!(rows_like(&photo, &whole), 200, "all blocks have the same colour");
    }
    assert_eq!(reason(&unmarked[..unmarked.len() - 4]), REFUSED);
}

#[test]
fn a_progressive_jpeg_may_lack_the_last_refinement_bits() {
    let bytes = include_bytes!("../fixtures/refined.jpg");
    let whole = read(bytes).unwrap();
    let scans = bytes.windows(2).enumerate().filter(|(_, two)| *two == [0xFF, 0xDA]).map(|(at, _)| at);
    let &[_, _, _, _, _, luminance_but_last_bit, first_last_bits, ..] = &*scans.collect::<Vec<usize>>() else {
        panic!("the usual ten scans");
    };
    for length in (luminance_but_last_bit / 2..=luminance_but_last_bit + 100).step_by(3) {
        assert_eq!(reason(&bytes[..length]), REFUSED, "the first {length} bytes");
    }
    for length in (first_last_bits + 2..bytes.len() - END_BYTES).step_by(3) {
        let photo = read(&bytes[..length]).unwrap();
        let differences = photo.pixels().iter().zip(whole.pixels()).map(|(a, b)| f64::from(a.abs_diff(*b)));
        let mean = differences.sum::<f64>() / whole.pixels().len() as f64;
        assert!(mean < 6.0, "{mean} levels in the first {length} bytes");
    }
}

#[test]
fn segments_that_overwrite_the_end_of_a_jpeg_are_not_decoded() {
    let bytes = jpeg(&waves());
    for share in [4, 2] {
        let retained = &bytes[..bytes.len() - bytes.len() / share];
        for foreign in [&b"\xFF\xFE\0\x04text"[..], b"\xFF\xC4\0\x02", b"\xFF\xE1\0\x08morexx"] {
            assert_eq!(reason(&[retained, foreign].concat()), REFUSED);
        }
    }
}
