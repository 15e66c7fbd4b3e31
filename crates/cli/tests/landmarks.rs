//! `rosto landmarks`: a line of JSON per photo, and a batch that bad files do not stop.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::*;
use serde_json::Value;

fn lines(output: &std::process::Output) -> Vec<Value> {
    let text = std::str::from_utf8(&output.stdout).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn the_portrait_has_the_landmarks_that_mediapipe_finds() {
    let output = rosto(["landmarks".into(), portrait(), "--mediapipe".into()]);
    assert_eq!((code(&output), said(&output).as_str()), (0, ""));
    let lines = lines(&output);
    let [photo] = lines.as_slice() else { panic!("one line, not {}", lines.len()) };
    assert_eq!(photo["photo"].as_str(), portrait().to_str());
    assert_eq!((photo["width"].as_u64(), photo["height"].as_u64()), (Some(512), Some(512)));
    let faces = photo["faces"].as_array().unwrap();
    assert_eq!(faces.len(), 1);
    assert!((faces[0]["score"].as_f64().unwrap() - 0.921_738).abs() < 1e-3);
    let golden = include_str!("../../../tests/golden/portrait_landmarks.json");
    let golden: Value = serde_json::from_str(golden).unwrap();
    let (found, expected) = (triples(&faces[0]["landmarks"]), triples(&golden["landmarks"]));
    assert_eq!(found.len(), 468);
    for (landmark, (a, b)) in found.iter().zip(expected).enumerate() {
        let off_px = a.iter().zip(b).map(|(a, b)| (a - b).abs() * 512.0).fold(0.0, f64::max);
        assert!(off_px < 0.05, "landmark {landmark} is {off_px} px off");
    }
}

#[test]
fn a_portrait_on_its_head_is_found_unless_mediapipe_is_asked() {
    let path = scratch("on-its-head.png");
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
        "that is MediaPipe's answer"
    );
}

#[test]
fn a_batch_goes_on_after_a_bad_file_and_says_so_at_the_end() {
    let text = scratch_file("notes.jpg", b"these are notes, not a picture");
    let missing = scratch("nowhere.png");
    let output = rosto(["landmarks".into(), text, faceless(), missing, portrait()]);
    assert_eq!(code(&output), 3);
    let lines = lines(&output);
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0]["faces"], Value::Array(vec![]), "no face is an answer");
    assert_eq!(lines[1]["faces"].as_array().unwrap().len(), 1);
    let said = said(&output);
    assert!(said.contains("notes.jpg: this is not a picture") && said.contains("nowhere.png"), "{said}");
    assert!(said.contains("2 of the photos"), "{said}");
}

#[test]
fn a_photo_can_come_through_standard_input() {
    let input = std::fs::File::open(portrait()).unwrap();
    let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_rosto"));
    let output = program.args(["landmarks", "-"]).stdin(input).output().unwrap();
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert_eq!(lines(&output)[0]["faces"].as_array().unwrap().len(), 1);
}
