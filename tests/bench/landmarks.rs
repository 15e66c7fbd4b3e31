//! How long it takes from a photo's bytes to its landmarks, on one thread of this machine.
//!
//! Prints one JSON object a line, as `peers.py` does. Takes the folder with the networks and the sample portrait.

use rosto_landmarks::{FaceFinder, FindOptions, LandmarkNetwork};
use rosto_photo::{Limits, decode};
use std::path::Path;
use std::time::Instant;

const RUNS: usize = 40;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: landmarks FOLDER")?;
    let read = |name: &str| std::fs::read(Path::new(&folder).join(name));
    let (detector, landmarks, photo) =
        (read("face_detector.onnx")?, read("face_landmarks_attention.onnx")?, read("sample.png")?);
    let mut finder = None;
    report("networks-start", 5, || finder = Some(FaceFinder::new(&detector, LandmarkNetwork::Attention(&landmarks))));
    let finder = finder.ok_or("invariant: the finder was made at least once")??;
    for (task, options) in [
        ("photo-to-landmarks", FindOptions { max_faces: 1, ..FindOptions::default() }),
        ("photo-to-landmarks-once", FindOptions::mediapipe()),
    ] {
        let mut faces = 0;
        report(task, RUNS, || {
            let found = decode(&photo, &Limits::default()).map(|photo| finder.find(&photo, &options));
            faces += found.is_ok_and(|found| found.is_ok_and(|found| found.len() == 1)) as usize;
        });
        if faces < RUNS {
            return Err(format!("the face was found {faces} of {RUNS} times").into());
        }
    }
    Ok(())
}

fn report(task: &str, runs: usize, mut action: impl FnMut()) {
    let mut times_ms: Vec<f64> = (0..runs)
        .map(|_| {
            let started = Instant::now();
            action();
            started.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times_ms.sort_by(f64::total_cmp);
    let median_ms = times_ms[runs / 2];
    println!(r#"{{"task": "{task}-native", "peer": "rosto", "ms": {median_ms}, "runs": {runs}}}"#);
}
