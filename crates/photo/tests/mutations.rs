//! Picture files with bytes written anew: a picture or an error, whatever they say of their colours.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../../tests/seeded.rs"]
mod seeded;
mod support;

use image::metadata::Orientation;
use rosto_photo::{Limits, decode};
use seeded::Seeded;
use support::{FORMATS, blocks, file, with_chunk};

const CASES: u64 = 1000;

/// The file with a few bytes changed, left out or doubled; most of them in its first `head` bytes.
fn mutated(file: &[u8], head: usize, seeded: &mut Seeded) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=seeded.below(8) {
        let within = if seeded.below(4) > 0 { head.min(bytes.len()) } else { bytes.len() };
        let at = seeded.below(within.max(1));
        let length = seeded.below(9).min(bytes.len() - at);
        match seeded.below(5) {
            0 => bytes[at] ^= 1 << seeded.below(8),
            1 => bytes[at] = [0, 0x7F, 0x80, 0xFF][seeded.below(4)],
            2 => bytes[at] = seeded.bits() as u8,
            3 => drop(bytes.drain(at..at + length)),
            _ => bytes.truncate(bytes.len() - seeded.below(40).min(bytes.len() - 1)),
        }
        if bytes.is_empty() {
            break;
        }
    }
    bytes
}

fn try_all(whole: &[u8], head: usize) -> u64 {
    let limits = Limits { max_pixels: 1_000_000, ..Limits::default() };
    let decoded = (0..CASES).filter(|&seed| {
        let Ok(photo) = decode(&mutated(whole, head, &mut Seeded::new(seed)), &limits) else { return false };
        assert_eq!(photo.pixels().len(), photo.width() as usize * photo.height() as usize * 3);
        true
    });
    decoded.count() as u64
}

#[test]
fn damaged_files_of_every_format_are_pictures_or_refused() {
    for format in FORMATS {
        let whole = file(&blocks(), format, Orientation::Rotate90);
        for head in [whole.len(), 64] {
            assert!(try_all(&whole, head) < CASES, "{format:?}: nothing was damaged");
        }
    }
    for fixture in [
        &include_bytes!("fixtures/progressive.jpg")[..],
        include_bytes!("fixtures/refined.jpg"),
        include_bytes!("fixtures/ycck.jpg"),
        include_bytes!("fixtures/interlaced.png"),
    ] {
        try_all(fixture, fixture.len());
    }
}

/// Checksums stand in the way of damage in PNG, so that what is told of the colours is made up beforehand.
#[test]
fn whatever_is_told_of_the_colours_there_is_a_picture() {
    let png = file(&blocks(), support::Format::Png, Orientation::NoTransforms);
    let mut seeded = Seeded::new(7);
    for case in 0..CASES {
        let mut noise = |length: usize| (0..length).map(|_| seeded.bits() as u8).collect::<Vec<u8>>();
        let told = match case % 3 {
            0 => with_chunk(&png, b"cICP", &[noise(1)[0] % 24, noise(1)[0] % 24, 0, noise(1)[0] % 2]),
            1 => with_chunk(&with_chunk(&png, b"gAMA", &noise(4)), b"cHRM", &noise(32)),
            _ => {
                let scaled = noise(32).chunks(4).flat_map(|n| [0, n[1] & 1, n[2], n[3]]).collect::<Vec<u8>>();
                with_chunk(&png, b"cHRM", &scaled)
            }
        };
        decode(&told, &Limits::default()).unwrap();
    }
}
