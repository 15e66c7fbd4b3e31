//! WebP files whose chunks claim more than there is, or more than can be.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use image::metadata::Orientation;
use support::{Format, blocks, file, read, reason, stored_for};

/// A WebP of the blocks, turned by EXIF, and where that chunk begins: it is the last.
fn webp() -> (Vec<u8>, usize) {
    let bytes = file(&stored_for(&blocks(), Orientation::Rotate90), Format::WebP, Orientation::Rotate90);
    let exif = place_of(&bytes, b"EXIF");
    (bytes, exif)
}

fn place_of(bytes: &[u8], name: &[u8; 4]) -> usize {
    bytes.windows(4).position(|window| window == name).unwrap()
}

fn with_length(bytes: &[u8], chunk: usize, length: u32) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[chunk + 4..chunk + 8].copy_from_slice(&length.to_le_bytes());
    bytes
}

#[test]
fn a_webp_chunk_that_claims_more_than_the_file_has_is_damaged() {
    let (whole, exif) = webp();
    let there = whole.len() - exif - 8;
    for claimed in [there as u32 + 1, 1_000_000, 0x7FFF_FFFF, u32::MAX - 1, u32::MAX] {
        let said = reason(&with_length(&whole, exif, claimed));
        assert_eq!(said, format!("{there} of the {claimed} bytes of its chunk EXIF are there"));
    }
    let pixels = with_length(&whole, place_of(&whole, b"VP8L"), u32::MAX);
    assert!(reason(&pixels).ends_with("chunk VP8L are there"));
}

#[test]
fn metadata_in_the_first_frame_of_an_animation_does_not_claim_more_than_there_is_either() {
    let mut bytes = include_bytes!("fixtures/animated.webp").to_vec();
    let frame = place_of(&bytes, b"ANMF");
    bytes[frame + 24..frame + 28].copy_from_slice(b"EXIF");
    assert!(reason(&with_length(&bytes, frame + 24, u32::MAX)).contains("4294967295 bytes of its chunk EXIF"));
}

#[test]
fn a_webp_may_lack_the_byte_that_pads_its_last_chunk() {
    let (whole, exif) = webp();
    let odd = whole.len() - exif - 8 - 1;
    let bytes = with_length(&whole, exif, odd as u32);
    let expected = read(&whole).unwrap();
    assert_eq!((expected.width(), expected.height()), (48, 32));
    assert_eq!(read(&bytes).unwrap(), expected);
    assert_eq!(read(&bytes[..bytes.len() - 1]).unwrap(), expected);
}

#[test]
fn chunks_that_nobody_reads_and_what_comes_behind_the_file_may_claim_anything() {
    let (whole, _) = webp();
    let expected = read(&whole).unwrap();
    let claims_much = [b"ABCD".as_slice(), &[0xFF; 4]].concat();
    assert_eq!(read(&[&whole[..], &claims_much].concat()).unwrap(), expected);
    assert_eq!(read(&[&whole[..], b"\0\0\0"].concat()).unwrap(), expected);
}

#[test]
fn a_lossy_picture_that_claims_to_be_larger_than_its_file_is_damaged() {
    let whole = include_bytes!("fixtures/lossy-alpha.webp");
    let photo = read(whole).unwrap();
    let size_at = place_of(whole, b"VP8 ") + 8 + 6;
    for (place, said) in [(size_at, "its picture is 16383 × "), (size_at + 2, " × 16383 px in a file of ")] {
        let mut bytes = whole.to_vec();
        bytes[place..place + 2].copy_from_slice(&[0xFF; 2]);
        let reason = reason(&bytes);
        assert!(reason.contains(said), "{reason}");
        assert!(reason.ends_with(&format!("{} × {} px", photo.width(), photo.height())), "{reason}");
    }
}
