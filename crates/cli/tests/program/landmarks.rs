//! `rosto landmarks`: JSON lines, and batches with unreadable files.

use std::path::PathBuf;

use crate::common::*;
use image::imageops::FilterType;
use serde_json::Value;

fn lines(output: &std::process::Output) -> Vec<Value> {
    let text = std::str::from_utf8(&output.stdout).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn the_portraits_landmarks_match_mediapipe() {
    let output = rosto(["landmarks".into(), portrait(), "--mediapipe".into()]);
    assert_eq!((code(&output), said(&output).as_str()), (0, ""));
    let lines = lines(&output);
    let [photo] = lines.as_slice() else { panic!("expected one line, found {}", lines.len()) };
    assert_eq!(photo["photo"].as_str(), portrait().to_str());
    assert_eq!((photo["width"].as_u64(), photo["height"].as_u64()), (Some(512), Some(512)));
    let faces = photo["faces"].as_array().unwrap();
    assert_eq!(faces.len(), 1);
    assert!((faces[0]["score"].as_f64().unwrap() - 0.921_738).abs() < 1e-3);
    let golden = include_str!("../../../../tests/golden/portrait_landmarks.json");
    let golden: Value = serde_json::from_str(golden).unwrap();
    let (found, expected) = (triples(&faces[0]["landmarks"]), triples(&golden["landmarks"]));
    assert_eq!(found.len(), 468);
    for (landmark, (a, b)) in found.iter().zip(expected).enumerate() {
        let off_px = a.iter().zip(b).map(|(a, b)| (a - b).abs() * 512.0).fold(0.0, f64::max);
        assert!(off_px < 0.05, "landmark {landmark} is {off_px} px off");
    }
}

#[test]
fn an_upside_down_portrait_is_found_except_with_mediapipe() {
    let path = scratch("upside-down.png");
    image::open(portrait()).unwrap().rotate180().save(&path).unwrap();
    let chin_above_forehead = |output: &std::process::Output| {
        let line = lines(output).remove(0);
        let landmarks = triples(&line["faces"][0]["landmarks"]);
        assert!(line["faces"][0]["confidence"].as_f64().unwrap() > 0.5);
        landmarks[152][1] < landmarks[10][1]
    };
    assert!(chin_above_forehead(&rosto(["landmarks".into(), path.clone()])));
    assert!(
        !chin_above_forehead(&rosto(["landmarks".into(), path, "--mediapipe".into()])),
        "MediaPipe returns an upright face"
    );
}

#[test]
fn a_batch_continues_after_a_bad_file_and_reports_it() {
    let text = scratch_file("notes.jpg", b"these are notes, not a picture");
    let missing = scratch("nowhere.png");
    let output = rosto(["landmarks".into(), text, faceless(), missing, portrait()]);
    assert_eq!(code(&output), 3);
    let lines = lines(&output);
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0]["faces"], Value::Array(vec![]), "a photo without a face has a line");
    assert_eq!(lines[1]["faces"].as_array().unwrap().len(), 1);
    let said = said(&output);
    assert!(said.contains("notes.jpg: this is not a picture") && said.contains("nowhere.png"), "{said}");
    assert!(said.contains("photos failed: 2"), "{said}");
}

#[test]
fn a_photo_can_be_read_from_standard_input() {
    let input = std::fs::File::open(portrait()).unwrap();
    let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_rosto"));
    let output = program.args(["landmarks", "-"]).stdin(input).output().unwrap();
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert_eq!(lines(&output)[0]["faces"].as_array().unwrap().len(), 1);
}

/// A grey picture with the portrait, `side_px` wide, at the given positions.
fn collage(name: &str, [width, height]: [u32; 2], side_px: u32, positions: impl Iterator<Item = [i64; 2]>) -> PathBuf {
    let portrait = image::open(portrait()).unwrap().resize_exact(side_px, side_px, FilterType::Lanczos3).to_rgb8();
    let mut picture = image::RgbImage::from_pixel(width, height, image::Rgb([120, 130, 140]));
    positions.for_each(|[left, top]| image::imageops::replace(&mut picture, &portrait, left, top));
    let path = scratch(name);
    picture.save(&path).unwrap();
    path
}

#[test]
#[ignore = "slow; runs at night"]
fn more_faces_than_the_limit_are_reported() {
    let sheet = collage("sheet.png", [2048, 1280], 256, (0..40).map(|face| [face % 8 * 256, face / 8 * 256]));
    let output = rosto(["landmarks".into(), sheet]);
    let found = &lines(&output)[0];
    assert_eq!(found["faces"].as_array().unwrap().len(), 20);
    assert_eq!(found["faces_at_least"], 40);
    assert!(said(&output).contains("20 of 40 or more faces returned; raise --max-faces"), "{}", said(&output));
}

#[test]
fn a_mesh_uses_the_most_prominent_face_and_doubtful_faces_are_reported() {
    let photo = collage("suit.png", [1600, 900], 850, [[700, 0]].into_iter());
    let output = rosto(["landmarks".into(), photo.clone()]);
    assert!(said(&output).contains("face 2 may not be a face (quality 0.7"), "{}", said(&output));
    let output = mesh(&photo, &scratch("face.glb"), &["--density", "0"]);
    assert_eq!(code(&output), 0);
    assert!(said(&output).contains("2 faces found; used the first"), "{}", said(&output));
    assert!(!said(&output).contains("may not be a face"), "{}", said(&output));
    let blurred = scratch("blurred.png");
    image::open(portrait()).unwrap().blur(5.0).save(&blurred).unwrap();
    let output = mesh(&blurred, &scratch("blurred.glb"), &["--density", "0"]);
    assert!(said(&output).contains("this face may not be a face (quality 0."), "{}", said(&output));
}
