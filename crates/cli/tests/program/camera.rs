//! Camera distance: estimated, and given on the command line.

use crate::common::*;
use serde_json::Value;

/// The `about` field of the portrait's JSON mesh, and the messages.
fn about(name: &str, more: &[&str]) -> (Value, String) {
    let path = scratch(&format!("{name}.json"));
    let run = mesh(&portrait(), &path, more);
    assert_eq!(code(&run), 0, "{}", said(&run));
    let json: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    (json["about"].clone(), said(&run))
}

fn number(about: &Value, name: &str) -> f64 {
    about[name].as_f64().unwrap_or_else(|| panic!("{name} in {about}"))
}

/// A measure in mm and its 95 % interval.
fn measure(about: &Value, name: &str) -> [f64; 3] {
    [0, 1, 2].map(|at| about["measures_mm"][name][at].as_f64().unwrap_or_else(|| panic!("{name} in {about}")))
}

#[test]
fn without_lens_data_the_distance_is_estimated_from_the_face() {
    let (about, said) = about("by-the-face", &[]);
    assert!(said.contains("taken from") && said.contains("estimated from the face"), "{said}");
    assert_eq!(about["lens"], "estimated");
    // The sample is a studio portrait, taken from further away than a selfie.
    assert!(number(&about, "distance_m") > 0.8, "{about}");
    assert!(number(&about, "yaw_deg").abs() < 15.0 && number(&about, "roll_deg").abs() < 15.0);
    let [height_mm, low_mm, high_mm] = measure(&about, "face-height");
    assert!((140.0..200.0).contains(&height_mm) && low_mm < height_mm && height_mm < high_mm, "{about}");
    let [nearest, farthest] = [0, 1].map(|end| about["distance_interval_m"][end].as_f64().unwrap());
    assert!(nearest < number(&about, "distance_m") && number(&about, "distance_m") < farthest, "{about}");
    assert_eq!(about["irises_mm"].as_object().unwrap().len(), 10);
}

#[test]
fn given_camera_options_are_used() {
    let (near, said) = about("near", &["--distance", "35"]);
    assert!((number(&near, "distance_m") - 0.35).abs() < 0.005, "{near}");
    assert!(said.contains("taken from 35 cm"), "{said}");
    let (long_lens, _) = about("long-lens", &["--focal-35mm", "100"]);
    let focal_px = 100.0 * 512.0 * 2_f64.sqrt() / 36_f64.hypot(24.0);
    assert!((number(&long_lens, "focal_px") - focal_px).abs() < 0.01, "{long_lens}");
    let width = |about: &Value| measure(about, "jaw-width")[0];
    assert!(width(&near) > 1.01 * width(&long_lens), "the perspective correction widens the jaw of a near photo");
}

#[test]
fn a_card_measures_the_face() {
    // Two sizes of a card in front of the chin.
    let [near, far] = ["150,230 290,230 290,318 150,318", "190,250 260,250 260,294 190,294"].map(|corners| {
        let (about, _) = about("card", &["--card-px", corners]);
        assert_eq!((&about["size_from"], &about["size_error"]), (&"card".into(), &0.01.into()), "{about}");
        assert_eq!(about["measures_mm"].as_object().unwrap().len(), 10);
        measure(&about, "jaw-width")[0]
    });
    assert!((far / near / 2.0 - 1.0).abs() < 0.1, "{near} {far} mm");
    let square = ["--card-px", "150,230 250,230 250,330 150,330"];
    assert_refused(&mesh(&portrait(), &scratch("square.json"), &square), 2, &["bank card"]);
    let three = ["--card-px", "150,230 250,230 250,330"];
    assert_refused(&mesh(&portrait(), &scratch("three.json"), &three), 2, &["four corners"]);
}

#[test]
fn invalid_camera_options_are_refused() {
    for more in [["--distance", "5"], ["--distance", "far"], ["--focal-35mm", "0"], ["--focal-35mm", "nan"]] {
        assert_refused(&mesh(&portrait(), &scratch("nowhere.json"), &more), 2, &[more[0]]);
    }
    let both = ["--distance", "50", "--focal-35mm", "26"];
    assert_refused(&mesh(&portrait(), &scratch("nowhere.json"), &both), 2, &["--distance", "--focal-35mm"]);
}

#[test]
fn refinement_follows_the_options() {
    for (flags, expected) in [(&["--mediapipe"][..], 468), (&["--mediapipe", "--refine"], 478), (&[], 478)] {
        let run = rosto(["landmarks"].into_iter().chain(flags.iter().copied()).chain([portrait().to_str().unwrap()]));
        let line: Value = serde_json::from_slice(&run.stdout).unwrap();
        assert_eq!(triples(&line["faces"][0]["landmarks"]).len(), expected, "{flags:?}");
    }
}
