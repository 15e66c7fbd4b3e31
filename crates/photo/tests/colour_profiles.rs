//! Embedded profiles become sRGB.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../../tests/seeded.rs"]
mod seeded;

use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use rosto_photo::{Limits, decode};
use seeded::Seeded;

/// D50-adapted colorants of Display P3 and of sRGB, red, green, blue.
const DISPLAY_P3: [[f64; 3]; 3] =
    [[0.515_121, 0.241_196, -0.001_053], [0.291_977, 0.692_245, 0.041_885], [0.157_104, 0.066_574, 0.784_073]];
const SRGB: [[f64; 3]; 3] =
    [[0.436_066, 0.222_488, 0.013_916], [0.385_147, 0.716_873, 0.097_076], [0.143_066, 0.060_608, 0.714_096]];
/// g, a, b, c, d of sRGB's curve.
const SRGB_CURVE: [f64; 5] = [2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045];

fn fixed(value: f64) -> [u8; 4] {
    ((value * 65_536.0).round() as i32).to_be_bytes()
}

fn parametric(values: &[f64], kind: u8) -> Vec<u8> {
    let mut curve = vec![b'p', b'a', b'r', b'a', 0, 0, 0, 0, 0, kind, 0, 0];
    curve.extend(values.iter().flat_map(|&value| fixed(value)));
    curve
}

/// A profile of three colorants and one curve.
fn profile(colorants: [[f64; 3]; 3], curve: &[u8]) -> Vec<u8> {
    let xyz = |colorant: [f64; 3]| [b"XYZ \0\0\0\0".to_vec(), colorant.map(fixed).concat()].concat();
    let contents = [xyz(colorants[0]), xyz(colorants[1]), xyz(colorants[2]), curve.to_vec()];
    let tags: [(&[u8; 4], usize); 6] =
        [(b"rXYZ", 0), (b"gXYZ", 1), (b"bXYZ", 2), (b"rTRC", 3), (b"gTRC", 3), (b"bTRC", 3)];
    let mut bytes = vec![0; 128];
    bytes[16..24].copy_from_slice(b"RGB XYZ ");
    bytes.extend(6_u32.to_be_bytes());
    for (signature, content) in tags {
        let start = 132 + 12 * tags.len() + contents[..content].iter().map(Vec::len).sum::<usize>();
        bytes.extend(signature);
        bytes.extend((start as u32).to_be_bytes());
        bytes.extend((contents[content].len() as u32).to_be_bytes());
    }
    bytes.extend(contents.concat());
    bytes
}

fn converted(pixel: [u8; 3], profile: Vec<u8>) -> [u8; 3] {
    let mut png = Vec::new();
    let mut encoder = PngEncoder::new(&mut png);
    encoder.set_icc_profile(profile).unwrap();
    encoder.write_image(&pixel, 1, 1, ExtendedColorType::Rgb8).unwrap();
    decode(&png, &Limits::default()).unwrap().pixel(0, 0)
}

fn close(a: [u8; 3], b: [u8; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1)
}

#[test]
fn display_p3_becomes_srgb() {
    // Reference values: CSS Color 4, color(display-p3 …) as sRGB.
    for (p3, srgb) in [([204, 153, 128], [213, 150, 124]), ([90, 120, 60], [81, 121, 51]), ([255, 0, 0], [255, 0, 0])] {
        let found = converted(p3, profile(DISPLAY_P3, &parametric(&SRGB_CURVE, 3)));
        assert!(close(found, srgb), "{p3:?} became {found:?}, expected {srgb:?}");
    }
}

#[test]
fn grey_stays_grey_whatever_the_primaries() {
    for value in [0, 17, 128, 255] {
        let found = converted([value; 3], profile(DISPLAY_P3, &parametric(&SRGB_CURVE, 3)));
        assert!(close(found, [value; 3]), "{found:?}");
    }
}

#[test]
fn a_profile_that_is_srgb_changes_nothing() {
    for pixel in [[1, 2, 3], [200, 30, 99], [254, 255, 0]] {
        assert_eq!(converted(pixel, profile(SRGB, &parametric(&SRGB_CURVE, 3))), pixel);
    }
}

#[test]
fn a_plain_gamma_is_applied_in_either_notation() {
    // (128/255)^1.8 is 0.289 of the light, which sRGB writes as 146.
    let table = [b"curv\0\0\0\0\0\0\0\x01".to_vec(), vec![1, 205]].concat();
    for curve in [parametric(&[1.8], 0), table] {
        let found = converted([128; 3], profile(SRGB, &curve));
        assert!(close(found, [146; 3]), "{found:?}");
    }
}

#[test]
fn a_broken_profile_is_ignored() {
    let whole = profile(DISPLAY_P3, &parametric(&SRGB_CURVE, 3));
    for length in (0..whole.len()).step_by(11) {
        let mut cut = whole[..length].to_vec();
        cut.push(0);
        assert_eq!(converted([204, 153, 128], cut), [204, 153, 128]);
    }
}

#[test]
fn mutated_profiles_are_applied_or_ignored() {
    let whole = profile(DISPLAY_P3, &parametric(&SRGB_CURVE, 3));
    let mut seeded = Seeded::new(3);
    for _ in 0..2000 {
        let mut damaged = whole.clone();
        for _ in 0..=seeded.below(6) {
            let at = seeded.below(damaged.len());
            damaged[at] = [seeded.bits() as u8, 0, 0xFF, 0x80][seeded.below(4)];
        }
        let found = [converted([128; 3], damaged.clone()), converted([128; 3], damaged)];
        assert_eq!(found[0], found[1]);
    }
}
