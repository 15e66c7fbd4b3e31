//! Decoding of a 12-megapixel JPEG to an upright sRGB picture.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]
#![allow(missing_docs, reason = "Criterion's macros make public functions")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use image::{ExtendedColorType, codecs::jpeg::JpegEncoder};
use rosto_photo::{Limits, decode};

const SIZE_PX: [u32; 2] = [4000, 3000];

fn decoding(criterion: &mut Criterion) {
    let jpeg = jpeg();
    assert_eq!(decode(&jpeg, &Limits::default()).unwrap().width(), SIZE_PX[0]);
    let mut group = criterion.benchmark_group("decode");
    group.sample_size(10);
    let id = BenchmarkId::new("JPEG", "12 megapixels");
    group.bench_function(id, |bencher| bencher.iter(|| decode(&jpeg, &Limits::default()).unwrap()));
}

/// Gradients, waves and fine grain.
fn jpeg() -> Vec<u8> {
    let [width, height] = SIZE_PX;
    let pixel = |i: u32| [i % width / 16, i / width / 16, (i % width) ^ (i / width)].map(|value| value as u8);
    let pixels: Vec<u8> = (0..width * height).flat_map(pixel).collect();
    let mut bytes = Vec::new();
    JpegEncoder::new_with_quality(&mut bytes, 90).encode(&pixels, width, height, ExtendedColorType::Rgb8).unwrap();
    bytes
}

criterion_group!(benches, decoding);
criterion_main!(benches);
