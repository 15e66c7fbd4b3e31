//! Benchmarks from a photo's bytes to its landmarks, on one thread.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]
#![allow(missing_docs, reason = "Criterion's macros make public functions")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use rosto_landmarks::{FaceFinder, FindOptions, LandmarkNetwork};
use rosto_photo::{Limits, decode};

fn landmarks(criterion: &mut Criterion) {
    let [detector, attention, photo] = ["face_detector.onnx", "face_landmarks_attention.onnx", "sample.png"].map(asset);
    let load = || FaceFinder::new(&detector, LandmarkNetwork::Attention(&attention)).unwrap();
    let finder = load();
    let mut group = criterion.benchmark_group("landmarks");
    group.sample_size(20);
    group.bench_function("load networks", |bencher| bencher.iter(load));
    for (what, options) in [
        ("photo to landmarks", FindOptions { max_faces: 1, ..FindOptions::default() }),
        ("photo to landmarks, one detector and one landmark pass", FindOptions::mediapipe()),
    ] {
        let find = || finder.find(&decode(&photo, &Limits::default()).unwrap(), &options).unwrap();
        assert_eq!(find().len(), 1);
        group.bench_function(BenchmarkId::new(what, "512 px PNG"), |bencher| bencher.iter(find));
    }
}

fn asset(name: &str) -> Vec<u8> {
    let path = format!("{}/../../web/assets/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("{path}: {error}; run `cargo xtask setup`"))
}

criterion_group!(benches, landmarks);
criterion_main!(benches);
