//! Following edits in a 12-megapixel photo, and baking the whole-face texture, on one thread.
//!
//! The landmarks are those of the sample portrait, enlarged to half the photo's width, so that most of the photo moves.
//! The photo's content does not affect the times.
#![allow(clippy::unwrap_used, reason = "a benchmark fails by panicking")]
#![allow(missing_docs, reason = "Criterion's macros make public functions")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::DVec3;
use rosto_face::{FaceModel, Observation, Photo, Triangulation};
use rosto_studio::{DEFAULT_FALLOFF_BAND, Document, FaceSlider, PhotoWarp, Rest, whole_texture};
use rosto_warp::drawn;
use serde_json::Value;

const SIDE_PX: u32 = 3464;
/// Centre of the face in the portrait and in the photo, and the scale between them.
const PORTRAIT_CENTRE: [f32; 3] = [0.43, 0.24, 0.0];
const PHOTO_CENTRE: [f32; 3] = [0.5, 0.5, 0.0];
const SCALE: f32 = 2.7;

fn in_the_photo(criterion: &mut Criterion) {
    let photo = photo();
    let face = face(&photo);
    let camera = face.camera();
    let mut group = criterion.benchmark_group("photo edit");
    group.sample_size(10);
    for density in [0, 3] {
        let document = document(&face, density);
        let (rest_m, size) = (document.rest(), format!("{} vertices", document.rest().len()));
        let id = |what: &str| BenchmarkId::new(what, &size);
        let made = || PhotoWarp::new(&face, &document, DEFAULT_FALLOFF_BAND, &[]).unwrap();
        let mut photo_warp = made();
        group.bench_function(id("prepare"), |bencher| bencher.iter(made));
        for (what, share) in [("slider tick", 1.0), ("slider tick that prevents folds", 4.0)] {
            let moved = |(rest, now): (&DVec3, &DVec3)| rest.lerp(*now, share);
            let now_m: Vec<DVec3> = rest_m.iter().zip(document.positions()).map(moved).collect();
            group.bench_function(id(what), |bencher| {
                bencher.iter(|| photo_warp.follow(rest_m, black_box(&now_m), camera, camera));
            });
        }
        photo_warp.follow(rest_m, document.positions(), camera, camera);
        group.bench_function(id("render at full size"), |bencher| {
            bencher.iter(|| drawn(&photo, photo_warp.warp_mesh()))
        });
    }
}

fn texture(criterion: &mut Criterion) {
    let face = face(&photo());
    let mut group = criterion.benchmark_group("texture");
    group.sample_size(10);
    for side_px in [1024, 2048, 4096] {
        let id = BenchmarkId::new("whole-face texture from one photo", format!("{side_px} px"));
        group.bench_function(id, |bencher| bencher.iter(|| whole_texture(&face, side_px).unwrap()));
    }
}

/// A synthetic photo of gradients and an XOR pattern.
fn photo() -> Photo {
    let pixel = |i: u32| [i % SIDE_PX / 16, i / SIDE_PX / 16, (i % SIDE_PX) ^ (i / SIDE_PX)].map(|value| value as u8);
    Photo::from_rgb(SIDE_PX, SIDE_PX, (0..SIDE_PX * SIDE_PX).flat_map(pixel).collect()).unwrap()
}

fn face(photo: &Photo) -> FaceModel {
    let golden: Value = serde_json::from_str(include_str!("../../../tests/golden/portrait_landmarks.json")).unwrap();
    let number = |value: &Value| value.as_f64().unwrap() as f32;
    let scaled =
        |row: &Value| [0, 1, 2].map(|axis| SCALE * (number(&row[axis]) - PORTRAIT_CENTRE[axis]) + PHOTO_CENTRE[axis]);
    let landmarks: Vec<[f32; 3]> = golden["landmarks"].as_array().unwrap().iter().map(scaled).collect();
    let observation = Observation { picture: Some(photo.scaled_down(1024)), ..Observation::in_photo(photo, landmarks) };
    FaceModel::new(observation, Triangulation::Canonical).unwrap()
}

/// A narrower jaw and a wider nose, without folds.
fn document(face: &FaceModel, density: u32) -> Document {
    let mut document = Document::new(Rest::of_face(face)).unwrap();
    document.set_density(density).unwrap();
    for (slider, amount_m) in [(FaceSlider::JawWidth, -0.004), (FaceSlider::NoseWidth, 0.002)] {
        document.apply(slider.id(), slider.command(amount_m)).unwrap();
    }
    document
}

criterion_group!(benches, in_the_photo, texture);
criterion_main!(benches);
