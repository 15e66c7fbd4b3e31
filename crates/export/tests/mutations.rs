//! Files with bytes written anew: read or refused, and what is read can be opened.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;
#[path = "../../../tests/seeded.rs"]
mod seeded;

use common::{face, gradient, model, png, source};
use rosto_export::*;
use rosto_face::{FaceInput, FaceModel, PhotoLens, Triangulation};
use seeded::Seeded;

const CASES: u64 = 3000;

/// A file with a few bytes changed, moved, doubled or left out; half of the changes in the first `text` bytes.
fn mutated(file: &[u8], text: usize, seeded: &mut Seeded) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=seeded.below(6) {
        let within = if seeded.below(2) == 0 { text.min(bytes.len()) } else { bytes.len() };
        let at = seeded.below(within);
        let length = seeded.below(9).min(bytes.len() - at);
        match seeded.below(6) {
            0 => bytes[at] ^= 1 << seeded.below(8),
            1 => bytes[at] = b"0919-.eE\"{}[],:\xFF"[seeded.below(16)],
            2 => bytes[at] = seeded.bits() as u8,
            3 => drop(bytes.drain(at..at + length)),
            4 => {
                let copy = bytes[at..at + length].to_vec();
                bytes.splice(at..at, copy);
            }
            _ => bytes.truncate(bytes.len() - seeded.below(bytes.len()).min(64)),
        }
        if bytes.is_empty() {
            break;
        }
    }
    bytes
}

/// Opens what was read, as the page does.
fn open(reopened: &Reopened<'_>) {
    let [width, height] = reopened.photo_size_px;
    let (landmarks, colours) = (&reopened.landmarks, &reopened.colours_srgb);
    let input = FaceInput { landmarks, width, height, colours, picture: gradient(), lens: PhotoLens::Parallel };
    let model = FaceModel::new(input, reopened.triangulation).unwrap();
    assert!(model.positions_m().iter().all(|position| position.is_finite()));
    assert!(reopened.density <= 4);
    if let Some(texture) = &reopened.texture {
        let sides = texture.picture_size_px.into_iter().chain(texture.size_px);
        assert!(sides.into_iter().all(|side| (1..=8192).contains(&side)) && !texture.encoded.is_empty());
    }
    assert!(reopened.painted().rgba.len() <= 4 * 2048 * 2048);
}

#[test]
fn a_damaged_glb_is_refused_or_opens() {
    let face = face(Triangulation::Tessellation);
    let mut opened = 0;
    for base_colour in BaseColour::ALL {
        let source = Some(source(&face, Some(r#"{"entries":[]}"#)));
        let file = glb(&model(&face), &GlbOptions { base_colour, source, ..GlbOptions::default() }).unwrap();
        let text = 20 + u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
        for seed in 0..CASES / 3 {
            if let Ok(reopened) = reopen(&mutated(&file, text, &mut Seeded::new(seed))) {
                opened += 1;
                if seed % 16 == 0 {
                    open(&reopened);
                }
            }
        }
    }
    assert!(opened > 100, "only {opened} were opened, so that little was tried");
}

#[test]
fn a_damaged_project_is_refused_or_opens() {
    let face = face(Triangulation::Canonical);
    let file = project::write(&source(&face, Some(r#"{"entries":[]}"#)), &png()).unwrap();
    let text = file.iter().position(|&byte| byte == b'\n').unwrap();
    let mut opened = 0;
    for seed in 0..CASES {
        let bytes = mutated(&file, text, &mut Seeded::new(seed));
        let _ = sniff(&bytes);
        if let Ok(reopened) = project::read(&bytes) {
            opened += 1;
            if seed % 16 == 0 {
                open(&reopened);
            }
        }
    }
    assert!(opened > 100, "only {opened} were opened, so that little was tried");
}
