use image::codecs::{jpeg::JpegEncoder, webp::WebPEncoder};
use image::{ExtendedColorType, ImageEncoder};

use crate::anatomy::png_chunks;

const WIDTH: u32 = 19;
const HEIGHT: u32 = 13;
/// A little-endian TIFF header and one directory with one entry: orientation 6.
const EXIF: &[u8] = b"II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
const PNG_SIGNATURE: [u8; 8] = *b"\x89PNG\r\n\x1a\n";

/// Baseline in colour and grey, progressive, CMYK, with EXIF and without.
pub fn jpegs() -> Vec<Vec<u8>> {
    let written = |colour, exif, quality| {
        let mut bytes = Vec::new();
        let mut encoder = JpegEncoder::new_with_quality(&mut bytes, quality);
        if exif {
            encoder.set_exif_metadata(EXIF.to_vec()).expect("invariant: JPEG knows EXIF");
        }
        encoder.write_image(&pixels(colour), WIDTH, HEIGHT, colour).expect("invariant: it can be written");
        bytes
    };
    let fixtures: [&[u8]; 2] = [
        include_bytes!("../../../crates/photo/tests/fixtures/progressive.jpg"),
        include_bytes!("../../../crates/photo/tests/fixtures/cmyk.jpg"),
    ];
    let own = [
        written(ExtendedColorType::Rgb8, true, 90),
        written(ExtendedColorType::Rgb8, false, 40),
        written(ExtendedColorType::L8, false, 75),
    ];
    own.into_iter().chain(fixtures.map(<[u8]>::to_vec)).collect()
}

/// Every colour type and depth, interlaced and not, with transparency, a palette, colour spaces and an animation.
pub fn pngs() -> Vec<Vec<u8>> {
    const KINDS: [(u8, u8); 12] =
        [(0, 1), (0, 2), (0, 8), (0, 16), (2, 8), (2, 16), (3, 1), (3, 4), (3, 8), (4, 8), (6, 8), (6, 16)];
    let plain = KINDS.into_iter().map(|(colour, depth)| png(colour, depth, 0, &[]));
    let interlaced = [(0, 8), (2, 8), (3, 4), (6, 16)].map(|(colour, depth)| png(colour, depth, 1, &[]));
    let gamma = (b"gAMA", 45_455_u32.to_be_bytes().to_vec());
    let space = (b"cICP", vec![12, 13, 0, 1]);
    let corners = [31_270_u32, 32_900, 64_000, 33_000, 30_000, 60_000, 15_000, 6_000];
    let corners = (b"cHRM", corners.iter().flat_map(|number| number.to_be_bytes()).collect());
    let exif = (b"eXIf", EXIF.to_vec());
    let animated = (b"acTL", [0, 0, 0, 1, 0, 0, 0, 0].to_vec());
    let frame = [0_u32, WIDTH, HEIGHT, 0, 0].iter().flat_map(|number| number.to_be_bytes());
    let frame = (b"fcTL", frame.chain([0, 1, 0, 10, 0, 0]).collect());
    let clear = (b"tRNS", vec![0, 1, 0, 2, 0, 3]);
    let told = [
        png(2, 8, 0, &[gamma, corners]),
        png(2, 8, 0, &[space, exif]),
        png(2, 8, 0, &[clear]),
        png(6, 8, 0, &[animated, frame]),
    ];
    plain.chain(interlaced).chain(told).collect()
}

/// Lossless in every layout, with EXIF and without; an animation; lossy with a profile, with alpha and without, as
/// Chromium wrote them.
pub fn webps() -> Vec<Vec<u8>> {
    let written = |colour, exif| {
        let mut bytes = Vec::new();
        let mut encoder = WebPEncoder::new_lossless(&mut bytes);
        if exif {
            encoder.set_exif_metadata(EXIF.to_vec()).expect("invariant: WebP knows EXIF");
        }
        encoder.write_image(&pixels(colour), WIDTH, HEIGHT, colour).expect("invariant: it can be written");
        bytes
    };
    vec![
        written(ExtendedColorType::Rgb8, true),
        written(ExtendedColorType::Rgba8, false),
        written(ExtendedColorType::L8, false),
        include_bytes!("lossy.webp").to_vec(),
        include_bytes!("lossy-alpha.webp").to_vec(),
        include_bytes!("../../../crates/photo/tests/fixtures/animated.webp").to_vec(),
    ]
}

/// The first JPEG with this profile in it, whole however long the profile is.
pub fn with_profile(jpeg: &[u8], profile: &[u8]) -> Vec<u8> {
    const MOST: usize = 65_535 - 2 - 14;
    let count = profile.len().div_ceil(MOST) as u8;
    let segments = profile.chunks(MOST).zip(1..=u8::MAX).flat_map(|(part, number)| {
        let length = (2 + 14 + part.len()) as u16;
        [&[0xFF, 0xE2], length.to_be_bytes().as_slice(), b"ICC_PROFILE\0", &[number, count], part].concat()
    });
    jpeg[..2].iter().copied().chain(segments).chain(jpeg[2..].iter().copied()).collect()
}

/// Puts the checksums of a PNG right, so that a change is not refused for them alone.
pub fn with_checksums(png: &mut [u8]) {
    for chunk in png_chunks(png) {
        let sum = crc(&png[chunk.start + 4..chunk.end - 4]);
        png[chunk.end - 4..chunk.end].copy_from_slice(&sum.to_be_bytes());
    }
}

/// A ramp in whatever channels.
fn pixels(colour: ExtendedColorType) -> Vec<u8> {
    let channels = u32::from(colour.channel_count());
    (0..WIDTH * HEIGHT * channels).map(|at| (at * 37 % 251) as u8).collect()
}

fn png(colour: u8, depth: u8, interlace: u8, told: &[(&[u8; 4], Vec<u8>)]) -> Vec<u8> {
    let header = [WIDTH.to_be_bytes().as_slice(), &HEIGHT.to_be_bytes(), &[depth, colour, 0, 0, interlace]].concat();
    let mut bytes = [PNG_SIGNATURE.as_slice(), &chunk(b"IHDR", &header)].concat();
    if colour == 3 {
        let palette: Vec<u8> = (0..3 << depth).map(|at| (at * 5) as u8).collect();
        bytes.extend(chunk(b"PLTE", &palette));
        bytes.extend(chunk(b"tRNS", &[0, 128]));
    }
    bytes.extend(told.iter().flat_map(|(name, data)| chunk(name, data)));
    let channels = [1, 0, 3, 1, 2, 0, 4][usize::from(colour)];
    let rows = rows(channels * u32::from(depth), interlace);
    let (first, second) = rows.split_at(rows.len() / 2);
    let data = stored(&[first, second]);
    let (head, tail) = data.split_at(data.len() / 3);
    bytes.extend([chunk(b"IDAT", head), chunk(b"IDAT", tail), chunk(b"IEND", &[])].concat());
    bytes
}

/// Filtered rows, a filter each; of all seven passes where interlaced.
fn rows(bits: u32, interlace: u8) -> Vec<u8> {
    const PASSES: [[u32; 4]; 7] =
        [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];
    let whole = [[0, 0, 1, 1]];
    let passes = if interlace == 0 { whole.as_slice() } else { PASSES.as_slice() };
    let mut rows = Vec::new();
    for &[left, top, across, down] in passes {
        let width = (WIDTH - left).div_ceil(across);
        for row in 0..(HEIGHT - top).div_ceil(down) {
            rows.push((row % 5) as u8);
            rows.extend((0..(width * bits).div_ceil(8)).map(|at| (at * 41 + row * 7) as u8));
        }
    }
    rows
}

/// A zlib stream of blocks that are not compressed.
fn stored(blocks: &[&[u8]]) -> Vec<u8> {
    let mut stream = vec![0x78, 0x01];
    for (at, block) in blocks.iter().enumerate() {
        let length = block.len() as u16;
        stream.push(u8::from(at + 1 == blocks.len()));
        stream.extend([length.to_le_bytes(), (!length).to_le_bytes()].concat());
        stream.extend(*block);
    }
    let (low, high) = blocks.concat().iter().fold((1_u32, 0_u32), |(low, high), &byte| {
        let low = (low + u32::from(byte)) % 65_521;
        (low, (high + low) % 65_521)
    });
    stream.extend((high << 16 | low).to_be_bytes());
    stream
}

fn chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body = [name.as_slice(), data].concat();
    [&(data.len() as u32).to_be_bytes(), body.as_slice(), &crc(&body).to_be_bytes()].concat()
}

/// CRC-32 as in PNG and zlib.
fn crc(bytes: &[u8]) -> u32 {
    let step = |sum: u32| if sum & 1 == 1 { 0xEDB8_8320 ^ sum >> 1 } else { sum >> 1 };
    !bytes.iter().fold(u32::MAX, |sum, &byte| (0..8).fold(sum ^ u32::from(byte), |sum, _| step(sum)))
}
