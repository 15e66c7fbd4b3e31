//! `rosto mesh` with several photos of one face: the lead photo, messages and refusals.

use std::path::{Path, PathBuf};
use std::process::Output;

use crate::common::*;
use serde_json::Value;

fn mesh_of(photos: &[&Path], output: &Path, more: &[&str]) -> Output {
    let photos = photos.iter().map(|photo| photo.as_os_str());
    let more = more.iter().map(std::ffi::OsStr::new);
    rosto(std::iter::once("mesh".as_ref()).chain(photos).chain(["-o".as_ref(), output.as_os_str()]).chain(more))
}

/// The mirrored portrait, which the networks see as a face turned to the other side.
fn mirrored() -> PathBuf {
    let path = scratch("mirrored.png");
    image::open(portrait()).unwrap().fliph().save(&path).unwrap();
    path
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

#[test]
fn one_photo_leads_and_each_is_reported() {
    let (photo, other, output) = (portrait(), mirrored(), scratch("several.json"));
    let run = mesh_of(&[&photo, &other, &photo], &output, &["--distance", "90"]);
    let said = said(&run);
    assert_eq!(code(&run), 0, "{said}");
    assert_eq!(said.matches(" leads").count(), 1, "{said}");
    assert!(
        said.contains("mirrored.png: ") && said.contains("prediction error") && said.contains("agrees within"),
        "{said}"
    );
    assert!(said.contains("turned to its left by 20 to 60°") && said.contains("turned to its right by 20"), "{said}");
    assert!(!said.contains("looking at the camera"), "a frontal photo is given: {said}");
    assert!(said.contains("taken from 90 cm, as given"), "{said}");
    let about = &json(&output)["about"];
    assert!((about["distance_m"].as_f64().unwrap() - 0.9).abs() < 0.01, "{about}");
}

#[test]
fn a_duplicate_photo_does_not_change_the_mesh() {
    let (photo, output) = (portrait(), scratch("twice.json"));
    assert_eq!(code(&mesh_of(&[&photo, &photo], &output, &[])), 0);
    let once = triples(&mesh_json("once.json", &[])["positions"]);
    let twice = triples(&json(&output)["positions"]);
    let apart_mm = once.iter().flatten().zip(twice.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart_mm < 1e-6, "{apart_mm} mm");
}

#[test]
fn a_second_view_changes_the_depth_and_edits_apply() {
    let (photo, other, output) = (portrait(), mirrored(), scratch("two.json"));
    let edit = ["--constraint", "exact", "--edit", "1:0,0,5"];
    assert_eq!(code(&mesh_of(&[&photo, &other], &output, &[])), 0);
    let unedited = triples(&json(&output)["positions"]);
    let alone = triples(&mesh_json("alone.json", &[])["positions"]);
    let change_mm = unedited.iter().zip(&alone).map(|(a, b)| (a[2] - b[2]).abs()).fold(0.0, f64::max);
    assert!(change_mm > 0.05, "{change_mm} mm");
    assert_eq!(code(&mesh_of(&[&photo, &other], &output, &edit)), 0);
    let edited = triples(&json(&output)["positions"]);
    assert!((edited[1][2] - unedited[1][2] - 5.0).abs() < 1e-6, "the nose is 5 mm longer");
}

#[test]
fn invalid_sets_of_photos_are_refused() {
    let (photo, other, output) = (portrait(), mirrored(), scratch("no.json"));
    let refused = |photos: &[&Path], more: &[&str], expected, words: &[&str]| {
        assert_refused(&mesh_of(photos, &output, more), expected, words);
        assert!(!output.exists(), "nothing is written");
    };
    refused(&[&photo, &faceless()], &[], 4, &["faceless.png: no face found"]);
    refused(&[&photo, &other], &["--units", "image"], 2, &["a second photo", "--units mm"]);
    refused(&[photo.as_path(); 6], &[], 2, &["at most five photos of one face", "6 were given"]);
    refused(&["-".as_ref(), "-".as_ref()], &[], 2, &["standard input (-) is given more than once"]);
}
