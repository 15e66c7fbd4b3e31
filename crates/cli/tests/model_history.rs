//! A GLB of edits in image coordinates opens again: its history, over the model, gives the shape that the file shows.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use common::*;
use glam::DVec3;
use rosto_export::{Reopened, reopen};
use rosto_face::{FaceInput, FaceModel, Photo};
use rosto_studio::{CoordinateFrame, Document, Rest, project};

fn face_of(opened: &Reopened<'_>) -> FaceModel {
    let [width, height] = opened.photo_size_px;
    let input = FaceInput {
        landmarks: &opened.landmarks,
        width,
        height,
        colours: &opened.colours_srgb,
        picture: Photo::from_rgb(1, 1, vec![0; 3]).unwrap(),
        lens: opened.lens,
    };
    FaceModel::new(input, opened.triangulation).unwrap()
}

/// The positions that a GLB holds, in metres.
fn positions_m(file: &[u8]) -> Vec<DVec3> {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let accessor = &json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let start = 28 + length + view["byteOffset"].as_u64().unwrap_or(0) as usize;
    assert!(view.get("byteStride").is_none() && accessor.get("byteOffset").is_none());
    let end = start + 12 * accessor["count"].as_u64().unwrap() as usize;
    let numbers = file[start..end].as_chunks::<4>().0.iter().map(|&bytes| f64::from(f32::from_le_bytes(bytes)));
    numbers.collect::<Vec<_>>().as_chunks::<3>().0.iter().copied().map(DVec3::from).collect()
}

/// Writes the same mesh as GLB and as JSON, replays the GLB's history, and compares. Gives the replayed document and what
/// was said on standard error.
fn replayed(name: &str, more: &[&str]) -> (Document, Vec<DVec3>, String) {
    let path = scratch(&format!("{name}.glb"));
    let run = mesh(&portrait(), &path, more);
    assert_eq!(code(&run), 0, "{}", said(&run));
    let file = std::fs::read(path).unwrap();
    let opened = reopen(&file).unwrap();
    let face = face_of(&opened);
    let entries = opened.history.as_deref().map_or(Vec::new(), |history| project::from_json(history).unwrap());
    let mut document = Document::replay(Rest::of_face(&face), entries).unwrap();
    document.set_density(opened.density).unwrap();
    let in_image = triples(&mesh_json(&format!("{name}.json"), more)["positions"]);
    let model_from_image = face.image_from_model().inverse();
    let in_image_rest = face.positions_image().to_vec();
    let in_image_rest = Rest::new(face.topology().clone(), in_image_rest, CoordinateFrame::Other);
    let mut unedited = Document::new(in_image_rest).unwrap();
    unedited.set_density(opened.density).unwrap();
    let shown: Vec<DVec3> = in_image
        .into_iter()
        .zip(unedited.positions().iter().zip(document.rest()))
        .map(|(at, (found, rest))| *rest + model_from_image * (DVec3::from(at) - *found))
        .collect();
    for (held, shown) in positions_m(&file).iter().zip(&shown) {
        assert!(held.distance(*shown) < 2e-8, "{name}: the file holds 32-bit numbers of {shown}, not {held}");
    }
    let is_complaint = |line: &&str| !line.starts_with("rosto: taken from") && *line != "rosto: 1 face found";
    let complaints = said(&run).lines().filter(is_complaint).collect();
    (document, shown, complaints)
}

fn furthest(one: &[DVec3], other: &[DVec3]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

fn assert_opens_again(name: &str, more: &[&str]) -> Document {
    let (document, shown, said) = replayed(name, more);
    assert_eq!(said, "", "{name}");
    assert!(furthest(document.rest(), &shown) > 1e-3, "{name}: the edits move something");
    let off_m = furthest(document.positions(), &shown);
    assert!(off_m < 1e-9, "{name}: {off_m} m off");
    document
}

#[test]
fn edits_whose_weights_know_the_topology_alone_stay_what_they_are() {
    for operator in ["L_s", "L", "degree"] {
        for anchors in [&["--anchors", "oval"][..], &["--seed", "7"], &["--pin", "168"]] {
            let edits = ["--operator", operator, "--edit", "4:0,0,-0.05", "--region", "left-brow:0.01,-0.03,0"];
            let name = format!("image-{operator}-{}", anchors[1]);
            let document = assert_opens_again(&name, &[&edits[..], anchors].concat());
            let labels: Vec<&str> = document.history().entries().iter().map(|entry| &*entry.label).collect();
            assert_eq!(labels, ["upper-nose-tip", "left-brow"], "no entry more than was asked for");
        }
    }
    let exact = ["--hold", "exact", "--density", "2", "--edit", "4:0,0.02,-0.05:10,152", "--edit", "6000@2:0,0,-0.02"];
    assert_eq!(assert_opens_again("image-dense", &exact).history().entries().len(), 2);
}

#[test]
fn edits_that_know_lengths_become_the_way_that_each_landmark_went() {
    for (name, settings) in [
        ("image-lengths", &["--operator", "inverse-length"][..]),
        ("image-cotangent", &["--operator", "cotangent", "--anchors", "oval", "--hold", "exact"]),
        ("image-radius", &["--radius", "0.2"]),
        ("image-outside", &["--anchors", "outside:0.1"]),
        ("image-turned", &["--turn-details", "--anchors", "oval"]),
    ] {
        for topology in ["tessellation", "canonical"] {
            let edits = ["--edit", "4:0,0,-0.05", "--edit", "152:0,0.05,0", "--topology", topology, "--density", "1"];
            assert_opens_again(&format!("{name}-{topology}"), &[&edits[..], settings].concat());
        }
    }
}

#[test]
fn what_no_landmark_can_express_is_told_and_left_to_the_shape() {
    let point = ["--density", "1", "--operator", "cotangent", "--edit", "4:0,0,-0.05", "--edit", "1200@1:0,0,-0.02"];
    let (document, shown, said) = replayed("image-point", &point);
    assert!(said.contains("point-1200@1") && said.contains("opens again without it"), "{said}");
    assert!(document.history().entries().iter().all(|entry| entry.label == "upper-nose-tip"));
    assert!(furthest(document.positions(), &shown) > 1e-4, "the shape has it all the same");
}

#[test]
fn a_face_without_edits_opens_again_without_a_history() {
    let (document, shown, _) = replayed("image-unedited", &[]);
    assert!(document.history().entries().is_empty() && furthest(document.positions(), &shown) < 1e-9);
}
