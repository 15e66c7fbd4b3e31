//! How long a photo of 12 megapixels takes to follow an edit of its face, on one thread of this machine.
//!
//! Prints one JSON object a line, as `peers.py` does. The face is MediaPipe's of the sample portrait, half as wide as the
//! picture, so that nearly all of it moves: what is in it does not matter.

use std::hint::black_box;
use std::time::{Duration, Instant};

use glam::DVec3;
use rosto_face::{FaceInput, FaceModel, LANDMARK_COUNT, Photo, PhotoLens, Triangulation};
use rosto_studio::{DEFAULT_RING, Document, FaceSlider, InPhoto, Rest};
use rosto_warp::drawn;
use serde_json::{Value, json};

const SIZE_PX: [u32; 2] = [3464, 3464];
/// Of the face in the portrait, and in the picture; and how many times as large it is there.
const MIDDLE: [f32; 3] = [0.43, 0.24, 0.0];
const PLACE: [f32; 3] = [0.5, 0.5, 0.0];
const LARGER: f32 = 2.7;
const BUDGET: Duration = Duration::from_secs(3);
const FEWEST_RUNS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let photo = photo()?;
    let face = face(&photo)?;
    for density in [0, 3] {
        let document = document(&face, density)?;
        let (rest_m, vertices) = (document.rest(), document.rest().len());
        report("photo-warp", vertices, || black_box(InPhoto::new(&face, &document, DEFAULT_RING, &[])).is_ok());
        let mut in_photo = InPhoto::new(&face, &document, DEFAULT_RING, &[])?;
        let camera = face.camera();
        for (task, share) in [("photo-tick", 1.0), ("photo-tick-folds", 4.0)] {
            let now_m: Vec<DVec3> =
                rest_m.iter().zip(document.positions()).map(|(rest, now)| rest.lerp(*now, share)).collect();
            report(task, vertices, || {
                in_photo.follow(rest_m, black_box(&now_m), camera, camera);
                in_photo.limited_px() >= 0.0
            });
        }
        in_photo.follow(rest_m, document.positions(), camera, camera);
        report("photo-drawn", vertices, || drawn(&photo, black_box(in_photo.patch())).width() == SIZE_PX[0]);
    }
    Ok(())
}

/// Slopes and waves.
fn photo() -> Result<Photo, Box<dyn std::error::Error>> {
    let [width, height] = SIZE_PX;
    let pixel = |i: u32| [i % width / 16, i / width / 16, (i % width) ^ (i / width)].map(|value| value as u8);
    Ok(Photo::from_rgb(width, height, (0..width * height).flat_map(pixel).collect())?)
}

fn face(photo: &Photo) -> Result<FaceModel, Box<dyn std::error::Error>> {
    let golden: Value = serde_json::from_str(include_str!("../golden/portrait_landmarks.json"))?;
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN) as f32;
    let rows = golden["landmarks"].as_array().ok_or("invariant: the golden file lists landmarks")?;
    let larger = |row: &Value| [0, 1, 2].map(|axis| LARGER * (number(&row[axis]) - MIDDLE[axis]) + PLACE[axis]);
    let landmarks: Vec<[f32; 3]> = rows.iter().map(larger).collect();
    let colours = [[0; 3]; LANDMARK_COUNT];
    let (width, height, picture) = (photo.width(), photo.height(), photo.scaled_down(64));
    let input =
        FaceInput { landmarks: &landmarks, width, height, colours: &colours, picture, lens: PhotoLens::Estimated };
    Ok(FaceModel::new(input, Triangulation::Canonical)?)
}

/// A narrower jaw and a wider nose, which fold nothing.
fn document(face: &FaceModel, density: u32) -> Result<Document, Box<dyn std::error::Error>> {
    let mut document = Document::new(Rest::of_face(face))?;
    document.set_density(density)?;
    for (slider, amount_m) in [(FaceSlider::JawWidth, -0.004), (FaceSlider::NoseWidth, 0.002)] {
        document.apply(slider.id(), slider.command(amount_m))?;
    }
    Ok(document)
}

/// Prints the median of as many runs as fit the budget, after one that is not counted.
fn report(task: &str, vertices: usize, mut action: impl FnMut() -> bool) {
    assert!(action(), "{task} gives what it should");
    let (mut times_ms, start) = (Vec::new(), Instant::now());
    while times_ms.len() < FEWEST_RUNS || start.elapsed() < BUDGET {
        let run = Instant::now();
        black_box(action());
        times_ms.push(run.elapsed().as_secs_f64() * 1e3);
    }
    times_ms.sort_by(f64::total_cmp);
    let (ms, runs) = (times_ms[times_ms.len() / 2], times_ms.len());
    println!("{}", json!({"task": task, "peer": "rosto", "vertices": vertices, "ms": ms, "runs": runs}));
}
