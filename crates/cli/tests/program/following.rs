//! `rosto mesh`: operators, constraints, anchors, radius, mirror, regions, sliders, density, formats.

use crate::common::*;
use glam::DVec3;
use rosto_face::{Region, mirror_of};

fn positions(name: &str, more: &[&str]) -> Vec<DVec3> {
    let more = [&["--topology", "canonical"], more].concat();
    triples(&mesh_json(name, &more)["positions"]).into_iter().map(DVec3::from).collect()
}

fn displacements(name: &str, more: &[&str]) -> Vec<DVec3> {
    let rest = positions(&format!("rest-of-{name}"), &[]);
    positions(name, more).iter().zip(rest).map(|(to, from)| *to - from).collect()
}

#[test]
#[ignore = "slow; runs at night"]
fn with_hard_constraints_handles_reach_their_targets_and_anchors_stay() {
    for operator in ["L_s", "L", "degree", "inverse-length", "cotangent"] {
        let edit =
            ["--operator", operator, "--constraint", "exact", "--anchors", "oval", "--pin", "168", "--edit", "4:1,2,8"];
        let displacements = displacements(&format!("exact-{operator}.json"), &edit);
        assert!(displacements[4].distance(DVec3::new(1.0, 2.0, 8.0)) < 1e-9, "{operator}: {}", displacements[4]);
        assert!([10, 152, 234, 454, 168].iter().all(|&anchor| displacements[anchor].length() < 1e-9), "{operator}");
        assert!(displacements[5].length() > 1.0, "{operator}: the neighbour follows");
    }
}

#[test]
fn a_mirrored_region_moves_both_sides_within_its_radius() {
    let edit = [
        "--constraint",
        "exact",
        "--anchors",
        "outside:25",
        "--radius",
        "25",
        "--mirror",
        "--region",
        "left-brow:1,3,0",
    ];
    let displacements = displacements("brows.json", &edit);
    for vertex in Region::LeftBrow.vertices() {
        let (left, right) = (displacements[vertex as usize], displacements[mirror_of(vertex) as usize]);
        assert!(left.distance(DVec3::new(1.0, 3.0, 0.0)) < 1e-9 && right.distance(DVec3::new(-1.0, 3.0, 0.0)) < 1e-9);
    }
    assert!([152, 61, 17, 200].iter().all(|&far| displacements[far] == DVec3::ZERO), "the mouth is outside the radius");
}

#[test]
fn sliders_and_symmetry_apply_their_amount() {
    let jaw = displacements("jaw.json", &["--slider", "jaw-width:4"]);
    assert!((jaw[172].x + 4.0).abs() < 1e-9 && (jaw[397].x - 4.0).abs() < 1e-9);
    let even = positions("even.json", &["--symmetrise", "1"]);
    let asymmetry = (0..468).map(|v| even[v].distance(even[mirror_of(v as u32) as usize] * DVec3::new(-1.0, 1.0, 1.0)));
    assert!(asymmetry.fold(0.0, f64::max) < 1e-9);
}

#[test]
fn rotating_details_changes_the_mesh_and_reaches_the_target() {
    let edit = |name, more: &[&str]| {
        displacements(name, &[&["--constraint", "exact", "--anchors", "oval", "--edit", "4:0,10,20"], more].concat())
    };
    let (kept, turned) = (edit("kept.json", &[]), edit("turned.json", &["--turn-details"]));
    assert!(turned[4].distance(DVec3::new(0.0, 10.0, 20.0)) < 1e-9);
    assert!(kept.iter().zip(&turned).any(|(kept, turned)| kept.distance(*turned) > 0.1));
}

#[test]
fn a_denser_mesh_has_the_edit_and_the_colours_of_the_photo() {
    let dense = mesh_json("dense.json", &["--topology", "canonical", "--density", "2", "--edit", "4:0,0,8"]);
    for (field, count) in [("positions", 7_257), ("colours", 7_257), ("triangles", 14_368)] {
        assert_eq!(dense[field].as_array().unwrap().len(), count, "{field}");
    }
    let photo = image::open(portrait()).unwrap().to_rgb8();
    let plain = mesh_json("dense-plain.json", &["--units", "image", "--topology", "canonical", "--density", "2"]);
    let (positions, colours) = (triples(&plain["positions"]), triples(&plain["colours"]));
    // Subdivision moves some landmarks at the corners of the mouth, but keeps their colours.
    let crowded = rosto_face::crowded_landmarks();
    let exact = |vertex: &usize| !crowded.contains(&(*vertex as u32));
    for vertex in (0..colours.len()).filter(exact) {
        let (position, colour) = (positions[vertex], colours[vertex]);
        let pixel = photo.get_pixel((position[0] * 512.0) as u32, (position[1] * 512.0) as u32);
        assert_eq!(colour, pixel.0.map(f64::from));
    }
}

#[test]
fn an_edit_can_move_a_vertex_of_a_denser_mesh() {
    let dense = ["--density", "2"];
    let rest = positions("dense-rest.json", &dense);
    let exact = ["--constraint", "exact", "--anchors", "oval", "--mirror"];
    let by_option = positions("dense-moved.json", &[&dense[..], &exact, &["--edit", "7000@2:1,0,2"]].concat());
    assert!((by_option[7_000] - rest[7_000]).distance(DVec3::new(1.0, 0.0, 2.0)) < 1e-9);
    let mirrored = DVec3::new(-1.0, 0.0, 2.0);
    let is_partner = |(to, from): (&DVec3, &DVec3)| (*to - *from).distance(mirrored) < 1e-9;
    assert_eq!(by_option.iter().zip(&rest).filter(|pair| is_partner(*pair)).count(), 1);

    let file = scratch("dense-edits.json");
    std::fs::write(&file, r#"[{"vertex": 7000, "level": 2, "offset": [1, 0, 2]}]"#).unwrap();
    let by_file = positions("dense-by-file.json", &[&dense[..], &exact, &["--edits", file.to_str().unwrap()]].concat());
    assert_eq!(by_option, by_file);
}

#[test]
fn a_vertex_of_a_level_above_the_density_is_refused() {
    let path = scratch("too-coarse.json");
    let edit = ["--density", "1", "--edit", "4:0,0,0.01", "--edit", "7000@2:0,0,0.01"];
    let output = rosto(["mesh", portrait().to_str().unwrap(), "-o", path.to_str().unwrap()].iter().chain(&edit));
    assert_eq!(code(&output), 5);
    assert!(
        said(&output).contains("edit 2 (vertex 7000@2)") && said(&output).contains("--density"),
        "{}",
        said(&output)
    );
}

#[test]
fn each_format_starts_with_its_signature() {
    for (extension, start) in
        [("glb", "glTF"), ("gltf", "{"), ("obj", "# Rosto"), ("ply", "ply\n"), ("stl", "Rosto"), ("json", "{\"units\"")]
    {
        let path = scratch(&format!("format.{extension}"));
        let output = rosto(["mesh", portrait().to_str().unwrap(), "-o", path.to_str().unwrap(), "--density", "1"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        assert!(std::fs::read(path).unwrap().starts_with(start.as_bytes()), "{extension}");
    }
}

#[test]
fn each_edit_becomes_a_named_morph_target() {
    let path = scratch("layers.glb");
    let photo = portrait();
    let arguments = ["mesh", photo.to_str().unwrap(), "-o", path.to_str().unwrap(), "--morph-targets"];
    let edits = ["--slider", "jaw-width:4", "--edit", "4:0,0,10:10,152"];
    let output = rosto(arguments.iter().chain(&edits));
    assert_eq!(code(&output), 0, "{}", said(&output));
    let file = std::fs::read(path).unwrap();
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let mesh = &json["meshes"][0];
    assert_eq!(mesh["extras"]["targetNames"], serde_json::json!(["upper-nose-tip", "jaw-width"]));
    assert_eq!(mesh["weights"], serde_json::json!([1.0, 1.0]));
    assert_eq!(mesh["primitives"][0]["targets"].as_array().unwrap().len(), 2);
    assert_eq!(
        json["scenes"][0]["extras"]["history"]["entries"].as_array().unwrap().len(),
        2,
        "the file contains the history"
    );
}

#[test]
fn edits_that_need_millimetres_are_refused_in_image_coordinates() {
    for more in [&["--mirror", "--edit", "4:0,0,0.1"][..], &["--slider", "jaw-width:4"], &["--symmetrise", "0.5"]] {
        let more = [&["--units", "image"], more].concat();
        assert_refused(&mesh(&portrait(), &scratch("refused.json"), &more), 5, &["mirror", "--units mm"]);
    }
}
