//! Conversion of embedded ICC profiles to sRGB.

use crate::seeded::Seeded;
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use rosto_photo::{Limits, decode};

/// D50-adapted colorants (red, green, blue) of Display P3 and sRGB.
const DISPLAY_P3: [[f64; 3]; 3] =
    [[0.515_121, 0.241_196, -0.001_053], [0.291_977, 0.692_245, 0.041_885], [0.157_104, 0.066_574, 0.784_073]];
const SRGB: [[f64; 3]; 3] =
    [[0.436_066, 0.222_488, 0.013_916], [0.385_147, 0.716_873, 0.097_076], [0.143_066, 0.060_608, 0.714_096]];
/// Parameters g, a, b, c, d of sRGB's curve.
const SRGB_CURVE: [f64; 5] = [2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045];

fn fixed(value: f64) -> [u8; 4] {
    ((value * 65_536.0).round() as i32).to_be_bytes()
}

fn parametric(values: &[f64], kind: u8) -> Vec<u8> {
    let mut curve = vec![b'p', b'a', b'r', b'a', 0, 0, 0, 0, 0, kind, 0, 0];
    curve.extend(values.iter().flat_map(|&value| fixed(value)));
    curve
}

/// Builds a profile with three colorants and one curve.
fn profile(colorants: [[f64; 3]; 3], curve: &[u8]) -> Vec<u8> {
    let xyz = |colorant: [f64; 3]| [b"XYZ \0\0\0\0".to_vec(), colorant.map(fixed).concat()].concat();
    let contents = [xyz(colorants[0]), xyz(colorants[1]), xyz(colorants[2]), curve.to_vec()];
    let tags = [(b"rXYZ", 0), (b"gXYZ", 1), (b"bXYZ", 2), (b"rTRC", 3), (b"gTRC", 3), (b"bTRC", 3)];
    profile_of(b"RGB XYZ ", &tags, &contents)
}

/// Builds a profile with a curve from grey to luminance (`XYZ `) or lightness (`Lab `).
fn grey_profile(connection: &[u8; 4], curve: Vec<u8>) -> Vec<u8> {
    profile_of(&[*b"GRAY", *connection].concat(), &[(b"kTRC", 0)], &[curve])
}

/// Builds a profile between two colour spaces; tags may share contents.
fn profile_of(spaces: &[u8], tags: &[(&[u8; 4], usize)], contents: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = vec![0; 128];
    bytes[16..24].copy_from_slice(spaces);
    bytes.extend((tags.len() as u32).to_be_bytes());
    for &(signature, content) in tags {
        let start = 132 + 12 * tags.len() + contents[..content].iter().map(Vec::len).sum::<usize>();
        bytes.extend(signature);
        bytes.extend((start as u32).to_be_bytes());
        bytes.extend((contents[content].len() as u32).to_be_bytes());
    }
    bytes.extend(contents.concat());
    bytes
}

fn converted(pixel: [u8; 3], profile: Vec<u8>) -> [u8; 3] {
    read(with_profile(&pixel, ExtendedColorType::Rgb8, profile))
}

fn converted_grey(grey: u8, profile: Vec<u8>) -> [u8; 3] {
    read(with_profile(&[grey], ExtendedColorType::L8, profile))
}

/// Encodes a PNG of one pixel.
fn with_profile(pixel: &[u8], layout: ExtendedColorType, profile: Vec<u8>) -> Vec<u8> {
    let mut png = Vec::new();
    let mut encoder = PngEncoder::new(&mut png);
    encoder.set_icc_profile(profile).unwrap();
    encoder.write_image(pixel, 1, 1, layout).unwrap();
    png
}

fn read(file: Vec<u8>) -> [u8; 3] {
    decode(&file, &Limits::default()).unwrap().pixel(0, 0)
}

/// 8-bit sRGB of linear light.
fn srgb(light: f64) -> u8 {
    let encoded = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
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
fn grey_is_preserved_for_any_primaries() {
    for value in [0, 17, 128, 255] {
        let found = converted([value; 3], profile(DISPLAY_P3, &parametric(&SRGB_CURVE, 3)));
        assert!(close(found, [value; 3]), "{found:?}");
    }
}

#[test]
fn an_srgb_profile_is_a_no_op() {
    for pixel in [[1, 2, 3], [200, 30, 99], [254, 255, 0]] {
        assert_eq!(converted(pixel, profile(SRGB, &parametric(&SRGB_CURVE, 3))), pixel);
    }
}

#[test]
fn a_gamma_is_applied_in_both_notations() {
    // (128/255)^1.8 is 0.289 in linear light, which is 146 in sRGB.
    let table = [b"curv\0\0\0\0\0\0\0\x01".to_vec(), vec![1, 205]].concat();
    for curve in [parametric(&[1.8], 0), table] {
        let found = converted([128; 3], profile(SRGB, &curve));
        assert!(close(found, [146; 3]), "{found:?}");
    }
}

#[test]
fn grey_profiles_preserve_luminance() {
    for value in (0..=255).step_by(5) {
        let signal = f64::from(value) / 255.0;
        let by_gamma = grey_profile(b"XYZ ", parametric(&[1.8], 0));
        assert!(close(converted_grey(value, by_gamma), [srgb(signal.powf(1.8)); 3]), "{value}, gamma 1.8");
        let by_lightness = grey_profile(b"Lab ", parametric(&[1.0], 0));
        let lightness = 100.0 * signal;
        let luminance = if lightness > 8.0 { ((lightness + 16.0) / 116.0).powi(3) } else { lightness / 903.3 };
        assert!(close(converted_grey(value, by_lightness), [srgb(luminance); 3]), "{value}, lightness");
        let by_srgb = grey_profile(b"XYZ ", parametric(&SRGB_CURVE, 3));
        assert_eq!(converted_grey(value, by_srgb), [value; 3]);
    }
}

#[test]
fn a_grey_picture_accepts_an_rgb_profile_but_not_vice_versa() {
    let rgb_profile = profile(DISPLAY_P3, &parametric(&[1.8], 0));
    assert!(close(converted_grey(128, rgb_profile), [146; 3]));
    for connection in [b"XYZ ", b"Lab "] {
        assert_eq!(converted([128, 20, 7], grey_profile(connection, parametric(&[1.8], 0))), [128, 20, 7]);
    }
}

#[test]
fn cmyk_and_lookup_table_profiles_are_ignored() {
    for spaces in [b"CMYKLab ", b"CMYKXYZ ", b"RGB Lab ", b"GRAYHSV "] {
        let profile = profile_of(spaces, &[(b"A2B0", 0), (b"kTRC", 0)], &[parametric(&[1.8], 0)]);
        assert_eq!(converted([128, 20, 7], profile.clone()), [128, 20, 7]);
        assert_eq!(converted_grey(128, profile), [128; 3]);
    }
}

#[test]
fn a_truncated_profile_is_ignored() {
    let whole = profile(DISPLAY_P3, &parametric(&SRGB_CURVE, 3));
    for length in (0..whole.len()).step_by(11) {
        let mut cut = whole[..length].to_vec();
        cut.push(0);
        assert_eq!(converted([204, 153, 128], cut), [204, 153, 128]);
    }
}

#[test]
fn mutated_profiles_decode_deterministically() {
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
    let whole = grey_profile(b"Lab ", parametric(&SRGB_CURVE, 3));
    for _ in 0..500 {
        let mut damaged = whole.clone();
        let at = 128 + seeded.below(damaged.len() - 128);
        damaged[at] = [seeded.bits() as u8, 0, 0xFF, 0x80][seeded.below(4)];
        let [red, green, blue] = converted_grey(128, damaged);
        assert!(close([red; 3], [red, green, blue]), "grey became {red}, {green}, {blue}");
    }
}
