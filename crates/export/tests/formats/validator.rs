//! Khronos' glTF validator, run on each kind of GLB. Requires Node.js and the packages that `cargo xtask setup`
//! installs.

use std::path::Path;
use std::process::Command;

use crate::common::{edits, face, model};
use glam::DVec3;
use rosto_export::*;
use rosto_face::Triangulation;

#[test]
fn the_khronos_validator_reports_no_issues() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let moved = vec![DVec3::new(0.0, 0.001, -0.002); 468];
    let morphs = [Morph { name: "olá \"aspas\"", displacements_m: &moved, weight: 0.0 }];
    let mut paths = Vec::new();
    for triangulation in [Triangulation::Tessellation, Triangulation::Canonical] {
        let face = face(triangulation);
        let edits = edits(&face, Some(r#"{"a":[1,null]}"#));
        for (base_colour, material) in [
            (BaseColour::Whole, Material::Lit),
            (BaseColour::Photo, Material::Lit),
            (BaseColour::VertexColours, Material::Unlit),
        ] {
            for morphs in [&[][..], &morphs] {
                let source = Some(Source { face: &face, edits: &edits });
                let options = GlbOptions { base_colour, material, morphs, source, ..GlbOptions::default() };
                let path = folder.join(format!("{}.glb", paths.len()));
                std::fs::write(&path, glb(&model(&face), &options).unwrap()).unwrap();
                paths.push(path);
            }
        }
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/e2e/validate-glb.mjs");
    let run =
        Command::new("node").arg(script).args(&paths).output().expect("Node.js is missing: run `cargo xtask setup`");
    let output = [run.stdout, run.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    assert!(!output.contains("Cannot find module"), "the validator is missing: run `cargo xtask setup`\n{output}");
    assert!(run.status.success(), "{output}");
    assert_eq!(output.matches("0/0/0/0").count(), paths.len(), "{output}");
}
