//! `rosto mesh` of several photos of one face: which leads, what is said of each, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use std::path::{Path, PathBuf};
use std::process::Output;

use common::*;
use serde_json::Value;

fn several(photos: &[&Path], output: &Path, more: &[&str]) -> Output {
    let photos = photos.iter().map(|photo| photo.as_os_str());
    let more = more.iter().map(std::ffi::OsStr::new);
    rosto(std::iter::once("mesh".as_ref()).chain(photos).chain(["-o".as_ref(), output.as_os_str()]).chain(more))
}

/// The portrait as a mirror shows it: to the network another photo of a face turned the other way.
fn mirrored() -> PathBuf {
    let path = scratch("mirrored.png");
    image::open(portrait()).unwrap().fliph().save(&path).unwrap();
    path
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

#[test]
fn one_photo_leads_and_each_is_told_of() {
    let (photo, other, output) = (portrait(), mirrored(), scratch("several.json"));
    let run = several(&[&photo, &other, &photo], &output, &["--distance", "90"]);
    let said = said(&run);
    assert_eq!(code(&run), 0, "{said}");
    assert_eq!(said.matches(" leads").count(), 1, "{said}");
    assert!(
        said.contains("mirrored.png: ") && said.contains("foreseen within") && said.contains("agrees within"),
        "{said}"
    );
    assert!(said.contains("turned to its left by 20 to 60°") && said.contains("turned to its right by 20"), "{said}");
    assert!(!said.contains("looking at the camera"), "the front is there: {said}");
    assert!(said.contains("taken from 90 cm, as given"), "{said}");
    let about = &json(&output)["about"];
    assert!((about["distance_m"].as_f64().unwrap() - 0.9).abs() < 0.01, "{about}");
}

#[test]
fn the_same_photo_twice_is_that_photo() {
    let (photo, output) = (portrait(), scratch("twice.json"));
    assert_eq!(code(&several(&[&photo, &photo], &output, &[])), 0);
    let once = triples(&mesh_json("once.json", &[])["positions"]);
    let twice = triples(&json(&output)["positions"]);
    let apart_mm = once.iter().flatten().zip(twice.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart_mm < 1e-6, "{apart_mm} mm");
}

#[test]
fn another_view_makes_another_depth_and_edits_go_on_it() {
    let (photo, other, output) = (portrait(), mirrored(), scratch("two.json"));
    let edit = ["--constraint", "exact", "--edit", "1:0,0,5"];
    assert_eq!(code(&several(&[&photo, &other], &output, &[])), 0);
    let unedited = triples(&json(&output)["positions"]);
    let alone = triples(&mesh_json("alone.json", &[])["positions"]);
    let deeper = unedited.iter().zip(&alone).map(|(a, b)| (a[2] - b[2]).abs()).fold(0.0, f64::max);
    assert!(deeper > 0.05, "{deeper} mm");
    assert_eq!(code(&several(&[&photo, &other], &output, &edit)), 0);
    let edited = triples(&json(&output)["positions"]);
    assert!((edited[1][2] - unedited[1][2] - 5.0).abs() < 1e-6, "the nose is 5 mm longer");
}

#[test]
fn what_shows_no_face_is_named_and_what_would_change_nothing_refused() {
    let (photo, other, output) = (portrait(), mirrored(), scratch("no.json"));
    let refused = |photos: &[&Path], more: &[&str], expected, words: &[&str]| {
        assert_refused(&several(photos, &output, more), expected, words);
        assert!(!output.exists(), "nothing is written");
    };
    refused(&[&photo, &faceless()], &[], 4, &["faceless.png: no face found"]);
    refused(&[&photo, &other], &["--units", "image"], 2, &["a further photo", "--units mm"]);
    refused(&[photo.as_path(); 6], &[], 2, &["at most five photos of one face", "6 are given"]);
    refused(&["-".as_ref(), "-".as_ref()], &[], 2, &["standard input is asked for twice"]);
}
