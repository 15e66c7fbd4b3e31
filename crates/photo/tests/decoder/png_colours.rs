//! PNG colour encodings without a profile: code points, gamma and primaries.

use crate::support::with_chunk;
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use proptest::prelude::*;
use rosto_photo::{Limits, PhotoError, decode};

/// Primaries and transfer characteristics as numbered by H.273; RGB, full range.
const DISPLAY_P3: [u8; 4] = [12, 13, 0, 1];
const SRGB: [u8; 4] = [1, 13, 0, 1];
const UNSPECIFIED: [u8; 4] = [2, 2, 0, 1];
/// From CSS Color 4: `color(display-p3 …)` in sRGB.
const P3_TO_SRGB: [([u8; 3], [u8; 3]); 3] =
    [([204, 153, 128], [213, 150, 124]), ([90, 120, 60], [81, 121, 51]), ([255, 0, 0], [255, 0, 0])];

type Chunk<'a> = (&'a [u8; 4], Vec<u8>);

fn described(pixel: [u8; 3], chunks: &[Chunk<'_>]) -> Vec<u8> {
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(&pixel, 1, 1, ExtendedColorType::Rgb8).unwrap();
    chunks.iter().fold(png, |file, (name, content)| with_chunk(&file, name, content))
}

fn converted(pixel: [u8; 3], chunks: &[Chunk<'_>]) -> [u8; 3] {
    decode(&described(pixel, chunks), &Limits::default()).unwrap().pixel(0, 0)
}

fn cicp(points: [u8; 4]) -> Chunk<'static> {
    (b"cICP", points.to_vec())
}

fn gama(gamma: u32) -> Chunk<'static> {
    (b"gAMA", gamma.to_be_bytes().to_vec())
}

/// White point and primaries of Display P3.
fn chrm() -> Chunk<'static> {
    let numbers = [31_270_u32, 32_900, 68_000, 32_000, 26_500, 69_000, 15_000, 6_000];
    (b"cHRM", numbers.into_iter().flat_map(u32::to_be_bytes).collect())
}

fn assert_close(found: [u8; 3], expected: [u8; 3], levels: u8) {
    let worst = found.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    assert!(worst <= levels, "{found:?}, expected {expected:?}");
}

#[test]
fn display_p3_code_points_are_converted_to_srgb() {
    for (p3, srgb) in P3_TO_SRGB {
        assert_close(converted(p3, &[cicp(DISPLAY_P3)]), srgb, 1);
    }
}

#[test]
fn srgb_descriptions_leave_pixels_unchanged() {
    for value in 0..=255 {
        let pixel = [value, 255 - value, value / 2];
        for chunks in [vec![cicp(SRGB)], vec![gama(45_455)], vec![gama(45_000)], vec![(b"sRGB", vec![0]), gama(45_455)]]
        {
            assert_eq!(converted(pixel, &chunks), pixel, "{chunks:?}");
        }
    }
}

#[test]
fn code_points_take_precedence_over_srgb_and_srgb_over_gamma() {
    let pixel = [204, 153, 128];
    assert_close(converted(pixel, &[cicp(DISPLAY_P3), (b"sRGB", vec![0])]), P3_TO_SRGB[0].1, 1);
    assert_eq!(converted(pixel, &[cicp(SRGB), gama(100_000), chrm()]), pixel);
    assert_eq!(converted(pixel, &[(b"sRGB", vec![0]), gama(100_000), chrm()]), pixel);
    assert_close(converted(pixel, &[cicp(UNSPECIFIED), gama(45_455), chrm()]), P3_TO_SRGB[0].1, 1);
}

#[test]
fn gamma_and_primaries_are_applied() {
    // 128/255 as linear light is 188 in sRGB; (128/255)^1.8 is 146.
    assert_close(converted([128; 3], &[gama(100_000)]), [188; 3], 1);
    assert_close(converted([128; 3], &[gama(55_556)]), [146; 3], 1);
    for (p3, srgb) in P3_TO_SRGB {
        assert_close(converted(p3, &[gama(45_455), chrm()]), srgb, 1);
        assert_close(converted(p3, &[chrm()]), srgb, 1);
    }
}

#[test]
fn implausible_values_are_ignored() {
    let pixel = [204, 153, 128];
    let zeros = (b"cHRM", vec![0; 32]);
    let one_point = (b"cHRM", [30_000_u32; 8].into_iter().flat_map(u32::to_be_bytes).collect());
    for chunks in [vec![gama(1)], vec![gama(u32::MAX)], vec![zeros], vec![one_point], vec![cicp(UNSPECIFIED)]] {
        assert_eq!(converted(pixel, &chunks), pixel, "{chunks:?}");
    }
}

#[test]
fn an_unsupported_transfer_curve_is_refused_without_a_fallback() {
    let p3 = P3_TO_SRGB[0];
    for transfer in [7, 16, 17, 18] {
        let code_points = cicp([9, transfer, 0, 1]);
        match decode(&described(p3.0, std::slice::from_ref(&code_points)), &Limits::default()) {
            Err(PhotoError::UnsupportedFeature { reason, .. }) => assert!(reason.contains(&transfer.to_string())),
            other => panic!("{transfer}: {other:?}"),
        }
        assert_close(converted(p3.0, &[code_points, gama(45_455), chrm()]), p3.1, 1);
    }
}

#[test]
fn narrow_range_is_expanded() {
    let narrow = |value| converted([value; 3], &[cicp([1, 13, 0, 0])]);
    assert_eq!([narrow(0), narrow(16), narrow(235), narrow(255)], [[0; 3], [0; 3], [255; 3], [255; 3]]);
    assert_close(narrow(126), [128; 3], 1);
}

proptest! {
    #[test]
    fn any_colour_description_decodes_or_is_unsupported(
        points in [0..24_u8, 0..24, 0..1, 0..2], gamma: u32, corners: [u32; 8], is_small: bool,
    ) {
        let corners = corners.map(|corner| if is_small { corner & 0x1_FFFF } else { corner }.to_be_bytes());
        let corners: Chunk<'_> = (b"cHRM", corners.as_flattened().to_vec());
        for chunks in [vec![gama(gamma), corners.clone()], vec![corners.clone()]] {
            converted([128; 3], &chunks);
        }
        for chunks in [vec![cicp(points)], vec![cicp(points), corners]] {
            let decoded = decode(&described([128; 3], &chunks), &Limits::default());
            prop_assert!(matches!(decoded, Ok(_) | Err(PhotoError::UnsupportedFeature { .. })), "{decoded:?}");
        }
    }
}
