use std::fs;

use image::codecs::{jpeg::JpegEncoder, webp::WebPEncoder};
use image::{ExtendedColorType, ImageEncoder};
use png::chunk::ChunkType;
use png::{BitDepth, ColorType, Filter};

const WIDTH: u32 = 19;
const HEIGHT: u32 = 13;
/// A little-endian TIFF header and one directory with one entry: orientation 6.
const EXIF: &[u8] = b"II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../crates/photo/tests/fixtures");

/// JPEG, PNG and WebP in many layouts, written here or, if the encoders do not support them, from the fixtures of `photo`.
pub fn all() -> Vec<Vec<u8>> {
    let fixtures = fs::read_dir(FIXTURES).expect("invariant: the folder is in the repository");
    let pictures = fixtures.filter_map(|entry| Some(entry.ok()?.path()).filter(|path| !path.ends_with("libjpeg.bin")));
    pictures.filter_map(|path| fs::read(path).ok()).chain(jpegs_and_webps()).chain(pngs()).collect()
}

/// A JPEG with this profile, split into as many segments as necessary.
pub fn with_profile(profile: &[u8]) -> Vec<u8> {
    const MOST: usize = 65_535 - 2 - 14;
    let jpeg = include_bytes!("../../../../crates/photo/tests/fixtures/progressive.jpg");
    let count = profile.len().div_ceil(MOST) as u8;
    let segments = profile.chunks(MOST).zip(1..=u8::MAX).flat_map(|(part, number)| {
        let length = (2 + 14 + part.len()) as u16;
        [&[0xFF, 0xE2], length.to_be_bytes().as_slice(), b"ICC_PROFILE\0", &[number, count], part].concat()
    });
    jpeg[..2].iter().copied().chain(segments).chain(jpeg[2..].iter().copied()).collect()
}

fn jpegs_and_webps() -> [Vec<u8>; 5] {
    use ExtendedColorType::{L8, Rgb8, Rgba8};
    let jpeg = |colour, quality| {
        let mut bytes = Vec::new();
        write(JpegEncoder::new_with_quality(&mut bytes, quality), colour);
        bytes
    };
    let webp = |colour| {
        let mut bytes = Vec::new();
        write(WebPEncoder::new_lossless(&mut bytes), colour);
        bytes
    };
    [jpeg(Rgb8, 90), jpeg(L8, 40), webp(Rgb8), webp(Rgba8), webp(L8)]
}

fn write(mut encoder: impl ImageEncoder, colour: ExtendedColorType) {
    encoder.set_exif_metadata(EXIF.to_vec()).expect("invariant: the format knows EXIF");
    let pixels = ramp(WIDTH * HEIGHT * u32::from(colour.channel_count()));
    encoder.write_image(&pixels, WIDTH, HEIGHT, colour).expect("invariant: it can be written");
}

/// All colour types, with several depths, transparency, colour spaces and EXIF.
fn pngs() -> Vec<Vec<u8>> {
    use png::BitDepth::{Eight, Four, One, Sixteen, Two};
    use png::ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
    let depths = [
        (Grayscale, vec![One, Two, Eight, Sixteen]),
        (GrayscaleAlpha, vec![Eight]),
        (Indexed, vec![One, Four, Eight]),
        (Rgb, vec![Eight, Sixteen]),
        (Rgba, vec![Eight, Sixteen]),
    ];
    let plain = depths.iter().flat_map(|(colour, depths)| depths.iter().map(|&depth| png(*colour, depth, &[])));
    let corners = [31_270_u32, 32_900, 64_000, 33_000, 30_000, 60_000, 15_000, 6_000].map(u32::to_be_bytes);
    let tagged = [
        png(Rgb, Eight, &[(*b"gAMA", &45_455_u32.to_be_bytes()), (*b"cHRM", corners.as_flattened())]),
        png(Rgb, Eight, &[(*b"cICP", &[12, 13, 0, 1]), (*b"eXIf", EXIF)]),
        png(Rgb, Eight, &[(*b"tRNS", &[0, 1, 0, 2, 0, 3])]),
    ];
    plain.chain(tagged).collect()
}

fn png(colour: ColorType, depth: BitDepth, chunks: &[([u8; 4], &[u8])]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH, HEIGHT);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder.set_filter(Filter::Adaptive);
    if colour == ColorType::Indexed {
        encoder.set_palette(ramp(3 << depth as u32));
        encoder.set_trns(&[0, 128][..]);
    }
    let row_bytes = (WIDTH * colour.samples() as u32 * depth as u32).div_ceil(8);
    let written = encoder.write_header().and_then(|mut writer| {
        chunks.iter().try_for_each(|(name, data)| writer.write_chunk(ChunkType(*name), data))?;
        writer.write_image_data(&ramp(HEIGHT * row_bytes))
    });
    written.expect("invariant: it can be written");
    bytes
}

fn ramp(length: u32) -> Vec<u8> {
    (0..length).map(|at| (at * 37 % 251) as u8).collect()
}
