//! WebP files whose chunks claim more bytes or pixels than they have.

use crate::support::{Format, blocks, file, read, reason, stored_for};
use image::metadata::Orientation;

/// A WebP rotated by EXIF, and the offset of the EXIF chunk, which comes last.
fn webp() -> (Vec<u8>, usize) {
    let bytes = file(&stored_for(&blocks(), Orientation::Rotate90), Format::WebP, Orientation::Rotate90);
    let exif = position_of(&bytes, b"EXIF");
    (bytes, exif)
}

fn position_of(bytes: &[u8], name: &[u8; 4]) -> usize {
    bytes.windows(4).position(|window| window == name).unwrap()
}

fn with_length(bytes: &[u8], chunk: usize, length: u32) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[chunk + 4..chunk + 8].copy_from_slice(&length.to_le_bytes());
    bytes
}

#[test]
fn a_chunk_longer_than_the_file_is_damaged() {
    let (whole, exif) = webp();
    let found = whole.len() - exif - 8;
    for claimed in [found as u32 + 1, 1_000_000, 0x7FFF_FFFF, u32::MAX - 1, u32::MAX] {
        let message = reason(&with_length(&whole, exif, claimed));
        assert_eq!(message, format!("chunk EXIF has {found} of its {claimed} bytes"));
    }
    let pixels = with_length(&whole, position_of(&whole, b"VP8L"), u32::MAX);
    assert!(reason(&pixels).starts_with("chunk VP8L has "));
}

#[test]
fn metadata_in_the_first_animation_frame_is_checked_too() {
    let mut bytes = include_bytes!("../fixtures/animated.webp").to_vec();
    let frame = position_of(&bytes, b"ANMF");
    bytes[frame + 24..frame + 28].copy_from_slice(b"EXIF");
    assert!(reason(&with_length(&bytes, frame + 24, u32::MAX)).ends_with(" of its 4294967295 bytes"));
}

#[test]
fn the_padding_of_the_last_chunk_may_be_missing() {
    let (whole, exif) = webp();
    let odd = whole.len() - exif - 8 - 1;
    let bytes = with_length(&whole, exif, odd as u32);
    let expected = read(&whole).unwrap();
    assert_eq!((expected.width(), expected.height()), (48, 32));
    assert_eq!(read(&bytes).unwrap(), expected);
    assert_eq!(read(&bytes[..bytes.len() - 1]).unwrap(), expected);
}

#[test]
fn unread_chunks_and_trailing_bytes_are_ignored() {
    let (whole, _) = webp();
    let expected = read(&whole).unwrap();
    let claims_much = [b"ABCD".as_slice(), &[0xFF; 4]].concat();
    assert_eq!(read(&[&whole[..], &claims_much].concat()).unwrap(), expected);
    assert_eq!(read(&[&whole[..], b"\0\0\0"].concat()).unwrap(), expected);
}

#[test]
fn a_lossy_picture_larger_than_its_canvas_is_damaged() {
    let whole = include_bytes!("../fixtures/lossy-alpha.webp");
    let photo = read(whole).unwrap();
    let size_at = position_of(whole, b"VP8 ") + 8 + 6;
    for (position, expected) in
        [(size_at, "a picture of 16383 × "), (size_at + 2, " × 16383 px exceeds the canvas of ")]
    {
        let mut bytes = whole.to_vec();
        bytes[position..position + 2].copy_from_slice(&[0xFF; 2]);
        let reason = reason(&bytes);
        assert!(reason.contains(expected), "{reason}");
        assert!(reason.ends_with(&format!("{} × {} px", photo.width(), photo.height())), "{reason}");
    }
}
