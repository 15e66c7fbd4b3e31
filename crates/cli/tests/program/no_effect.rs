//! Options without effect are refused with a reason before any work is done.

use crate::common::*;

fn refused(output: &str, more: &[&str], words: &[&str]) {
    let target = scratch(output);
    assert_refused(&mesh(&portrait(), &target, more), 2, words);
    assert!(!target.exists(), "nothing is written");
}

#[test]
fn morph_targets_in_other_formats() {
    let edit = ["--morph-targets", "--edit", "4:0,0,1"];
    for extension in ["obj", "ply", "stl", "3mf", "usdz", "png", "json"] {
        refused(&format!("morphs.{extension}"), &edit, &["--morph-targets", ".glb and .gltf"]);
    }
    refused("morphs.glb", &["--morph-targets"], &["--morph-targets", "no edit"]);
}

#[test]
fn image_coordinates_in_other_formats() {
    for extension in ["glb", "gltf", "obj", "ply", "stl", "3mf", "usdz", "png"] {
        let edit = ["--units", "image", "--edit", "4:0,0,-0.05"];
        refused(&format!("image.{extension}"), &edit, &["image coordinates", "only be written as .json", "--units mm"]);
    }
    let output = scratch("image-photo.png");
    assert_refused(&photo(&portrait(), &output, &["--units", "image"]), 2, &["--units"]);
}

#[test]
fn textures_and_materials_in_other_formats() {
    for extension in ["ply", "stl", "3mf", "json"] {
        refused(&format!("paint.{extension}"), &["--base-colour", "photo"], &["--base-colour", ".glb, .gltf, .obj"]);
        refused(&format!("paint.{extension}"), &["--texture-size", "1024"], &["--texture-size", ".glb, .gltf, .obj"]);
        refused(&format!("paint.{extension}"), &["--material", "unlit"], &["--material", ".glb and .gltf"]);
    }
    refused("paint.png", &["--base-colour", "colours"], &["--base-colour", "a .png has no vertex colours"]);
    let size = ["--base-colour", "colours", "--texture-size", "1024"];
    refused("paint.glb", &size, &["--texture-size", "writes no texture"]);
}

#[test]
fn eyes_in_other_formats_and_meshes() {
    for extension in ["stl", "3mf", "png", "json"] {
        refused(&format!("eyes.{extension}"), &["--eyes", "pieces"], &["--eyes", ".glb, .gltf, .obj, .ply and .usdz"]);
    }
    let open = ["--eyes", "pieces", "--topology", "tessellation"];
    refused("eyes.glb", &open, &["--eyes", "has openings for eyes and mouth"]);
    refused("eyes.glb", &["--eyes", "pieces", "--expressions"], &["--eyes", "implies pieces"]);
}

#[test]
fn bodies_in_other_formats() {
    for extension in ["glb", "gltf", "obj", "ply", "usdz", "png", "json"] {
        refused(&format!("solid.{extension}"), &["--solid", "flat:30"], &["--solid", ".stl and .3mf"]);
    }
    refused("solid.3mf", &["--solid", "surface"], &["--solid", "closed body"]);
    refused("height.ply", &["--height-mm", "80"], &["--height-mm", ".stl and .3mf"]);
    refused("height.stl", &["--height-mm", "80", "--solid", "surface"], &["--height-mm", "closed body"]);
    for height in ["0", "-80", "nan", "death"] {
        refused("height.stl", &["--height-mm", height], &[height, "from 10 to 500 mm"]);
    }
    for solid in ["thickness", "thickness:0", "flat:3", "flat:nan", "cube:3"] {
        refused("solid.stl", &["--solid", solid], &[solid, "thickness:MM"]);
    }
}

#[test]
fn settings_without_edits() {
    for flag in [
        &["--operator", "L"][..],
        &["--constraint", "exact"],
        &["--anchors", "oval"],
        &["--seed", "1"],
        &["--pin", "4"],
        &["--radius", "2"],
        &["--mirror"],
        &["--turn-details"],
    ] {
        refused("settings.json", flag, &[flag[0], "it needs --edit"]);
        refused("settings.json", &[flag, &["--slider", "jaw-width:4"]].concat(), &[flag[0]]);
    }
    refused(
        "settings.json",
        &["--seed", "1", "--anchors", "oval", "--edit", "4:0,0,1"],
        &["--seed", "no random vertices"],
    );
    refused("settings.json", &["--seed", "1", "--edit", "4:0,0,1:10,152"], &["--seed", "explicit anchors"]);
    refused("settings.json", &["--anchors", "oval", "--edit", "4:0,0,1:10,152"], &["--anchors", "explicit anchors"]);
}

#[test]
fn numbers_out_of_range() {
    let edit = ["--edit", "4:0,0,1"];
    for radius in ["-5", "0", "nan", "inf", "-inf"] {
        let radius = format!("--radius={radius}");
        refused("numbers.json", &[&edit[..], &[&radius]].concat(), &["--radius", "positive number"]);
    }
    for (flag, number) in
        [("--radius", "-5"), ("--constraint", "-1"), ("--seed", "-1"), ("--pin", "-1"), ("--symmetrise", "-1")]
    {
        let target = scratch("negative.json");
        let run = mesh(&portrait(), &target, &[&edit[..], &[flag, number]].concat());
        assert_refused(&run, 2, &[flag, number]);
        assert!(!said(&run).contains("tip:"), "clap's tip would not help: {}", said(&run));
    }
    refused("numbers.json", &["--symmetrise", "nan"], &["--symmetrise", "0 to 1"]);
    refused("numbers.json", &[&edit[..], &["--anchors", "outside:inf"]].concat(), &["invalid radius"]);
    let photo = portrait();
    let photo = photo.to_str().unwrap();
    assert_refused(&rosto(["landmarks", photo, "--max-faces", "0"]), 2, &["--max-faces", "0 is not in 1.."]);
    let folder = scratch("no-runs");
    let run = rosto(["paper", photo, "-o", folder.to_str().unwrap(), "--runs", "0"]);
    assert_refused(&run, 2, &["--runs", "0 is not in 1.."]);
    assert!(!folder.exists());
}

#[test]
fn pins_add_to_explicit_anchors() {
    let edit = ["--constraint", "exact", "--edit", "4:0,0,20:10,152"];
    let rest = triples(&mesh_json("pin-rest.json", &[])["positions"]);
    let free = triples(&mesh_json("pin-free.json", &edit)["positions"]);
    let pinned =
        triples(&mesh_json("pin-pinned.json", &[&edit[..], &["--pin", "5", "--pin", "10"]].concat())["positions"]);
    assert!(free[5] != rest[5] && pinned[5] == rest[5]);
}

#[test]
fn file_extensions_ignore_case() {
    for (name, start) in [("CAPITALS.GLB", &b"glTF"[..]), ("Capitals.Json", b"{\"units\"")] {
        let path = scratch(name);
        assert_eq!(code(&mesh(&portrait(), &path, &[])), 0);
        assert!(std::fs::read(path).unwrap().starts_with(start), "{name}");
    }
}
