//! `rosto mesh`: output, edits and reproducibility.

use crate::common::*;
use glam::DVec3;
use rosto_face::Triangulation;
use rosto_laplacian::{Constraints, LaplacianSystem, Operator};

/// The paper's mesh: the landmarks alone, with openings for eyes and mouth.
const PAPERS_MESH: [&str; 6] = ["--units", "image", "--topology", "tessellation", "--density", "0"];

fn vectors(rows: &[[f64; 3]]) -> Vec<DVec3> {
    rows.iter().copied().map(DVec3::from).collect()
}

#[test]
fn json_contains_landmarks_colours_and_triangles() {
    let mesh = mesh_json("plain.json", &["--units", "image"]);
    assert_eq!(mesh["units"], "image");
    let output = rosto(["landmarks".into(), portrait()]);
    let line: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let (positions, expected) = (triples(&mesh["positions"]), triples(&line["faces"][0]["landmarks"]));
    // Subdivision moves some landmarks at the corners of the mouth.
    let crowded = rosto_face::crowded_landmarks();
    let exact: Vec<usize> = (0..468).filter(|landmark| !crowded.contains(&(*landmark as u32))).collect();
    let coordinates = |&landmark: &usize| (0..3).map(move |axis| (landmark, axis));
    assert!(
        exact
            .iter()
            .flat_map(coordinates)
            .all(|(landmark, axis)| (positions[landmark][axis] - expected[landmark][axis]).abs() < 1e-6)
    );
    let counts = |mesh: &serde_json::Value| ["colours", "triangles"].map(|of| mesh[of].as_array().unwrap().len());
    assert_eq!(counts(&mesh), [7_257, 14_368], "smooth, with the landmarks first");
    assert_eq!(counts(&mesh_json("paper.json", &PAPERS_MESH)), [468, 852]);
    // The paper's colour: the pixel at the landmark.
    let photo = image::open(portrait()).unwrap().to_rgb8();
    for vertex in exact {
        let position = positions[vertex];
        let pixel = photo.get_pixel((position[0] * 512.0) as u32, (position[1] * 512.0) as u32);
        let colour = triples(&mesh["colours"])[vertex];
        assert_eq!(colour, pixel.0.map(f64::from), "landmark {vertex}");
    }
}

#[test]
fn millimetre_axes_point_left_up_and_forward() {
    let mesh = mesh_json("mm.json", &[]);
    let positions = triples(&mesh["positions"]);
    assert_eq!(mesh["units"], "mm");
    assert!(positions[10][1] - positions[152][1] > 150.0, "the forehead is above the chin");
    assert!(positions[4][2] - positions[234][2] > 50.0, "the nose is in front of the ear");
    assert!(positions[263][0] > 30.0 && positions[33][0] < -30.0, "the subject's left is towards +X");
    assert_eq!(
        mesh["about"],
        mesh_json("image.json", &["--units", "image"])["about"],
        "measures do not depend on the units"
    );
}

#[test]
fn edits_accumulate_as_in_the_paper() {
    let rest = vectors(&triples(&mesh_json("rest.json", &PAPERS_MESH)["positions"]));
    for (name, operator) in [("L_s", Operator::UniformSymmetric), ("L", Operator::Uniform)] {
        let file = scratch_file(
            "first.json",
            br#"[{"vertex": 163, "offset": [-0.005, -0.005, -0.005], "anchors": [16, 443]}]"#,
        );
        let edits = ["--operator", name, "--edits", file.to_str().unwrap(), "--edit", "235:0.1,0.1,-0.1:443,384"];
        let made = mesh_json(&format!("edited-{name}.json"), &[&edits[..], &PAPERS_MESH].concat());
        let edited = vectors(&triples(&made["positions"]));
        let system = LaplacianSystem::new(&Triangulation::Tessellation.topology(), &rest, operator).unwrap();
        let mut expected = rest.clone();
        for (handle, anchors, offset) in
            [(163, [16, 443], DVec3::splat(-0.005)), (235, [443, 384], DVec3::new(0.1, 0.1, -0.1))]
        {
            let before = expected.clone();
            let constraints = Constraints { handles: &[handle], anchors: &anchors, ..Constraints::default() };
            system.respond(&constraints).unwrap().displace(&before, &[offset], &mut expected);
        }
        assert!(edited.iter().zip(&expected).all(|(a, b)| a.distance(*b) < 1e-12), "{name}");
        assert!(edited[235].distance(rest[235]) > 0.05, "the handle follows");
    }
}

#[test]
fn output_is_reproducible_and_depends_on_the_seed() {
    let edit = ["--edit", "4:0,0,20", "--seed"];
    let with_seed = |name, seed| mesh_json(name, &[&edit[..], &[seed]].concat());
    let bytes = |name: &str| std::fs::read(scratch(name)).unwrap();
    with_seed("seed-1.json", "1");
    with_seed("seed-1-again.json", "1");
    with_seed("seed-2.json", "2");
    assert_eq!(bytes("seed-1.json"), bytes("seed-1-again.json"));
    assert_ne!(bytes("seed-1.json"), bytes("seed-2.json"));
}

#[test]
fn a_glb_contains_the_edited_face_in_metres() {
    let write = |name: &str, more: &[&str]| {
        let path = scratch(name);
        let output = mesh(&portrait(), &path, more);
        assert_eq!(code(&output), 0, "{}", said(&output));
        bounds_m(&std::fs::read(path).unwrap())
    };
    let [plain, edited] = [write("plain.glb", &[]), write("edited.glb", &["--edit", "4:0,0,20:10,152"])];
    for [low, high] in [plain, edited] {
        assert!(high[1] - low[1] > 0.15 && high[1] - low[1] < 0.3, "a head is {} m high", high[1] - low[1]);
    }
    assert!(edited[1][2] > plain[1][2] + 0.005, "the nose moves forward");
}

/// Minimum and maximum position in a GLB.
fn bounds_m(file: &[u8]) -> [[f64; 3]; 2] {
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let accessor = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].as_u64().unwrap() as usize;
    ["min", "max"].map(|end| [0, 1, 2].map(|axis| json["accessors"][accessor][end][axis].as_f64().unwrap()))
}
