//! Failed requests: documented exit codes and messages with a hint.

use std::path::Path;

use crate::common::*;

/// Runs `rosto mesh PHOTO -o FILE MORE...` and checks exit code and message.
fn refused(photo: &Path, output: &str, more: &[&str], expected: i32, words: &[&str]) {
    let target = scratch(output);
    assert_refused(&mesh(photo, &target, more), expected, words);
    assert!(!target.exists(), "nothing is written");
}

#[test]
fn unreadable_photos() {
    refused(&scratch("missing.jpg"), "a.json", &[], 3, &["missing.jpg", "Check the path"]);
    let text = scratch_file("text.jpg", b"just text");
    refused(&text, "a.json", &[], 3, &["text.jpg: this is not a picture", "Choose a JPEG"]);
    let whole = std::fs::read(portrait()).unwrap();
    let cut = scratch_file("cut.png", &whole[..whole.len() / 2]);
    refused(&cut, "a.json", &[], 3, &["cut.png", "damaged"]);
}

#[test]
fn no_face() {
    refused(&faceless(), "a.glb", &[], 4, &["faceless.png: no face found", "fills at least a tenth"]);
}

#[test]
fn edits_that_cannot_be_made() {
    let edit = |edit, words: &[&str]| refused(&portrait(), "a.json", &["--edit", edit], 5, words);
    edit("468:0,0,0.1", &["edit 1 (vertex 468)", "vertex 468 does not exist", "are 0 to 467"]);
    edit("4:0,0,0.1:4,10", &["edit 1 (vertex 4)", "handle and an anchor", "other than the moved vertex"]);
    edit("4:0,0,0.1:10,10", &["vertex 10 is listed twice"]);
    edit("4:0,0,0.1:10,9999", &["vertex 9999 does not exist"]);
    let dense = ["--density", "1", "--edit", "9999@1:0,0,0.1"];
    refused(&portrait(), "a.json", &dense, 5, &["vertex 9999 does not exist", "are 0 to 1"]);
    let far = ["--units", "image", "--constraint", "exact", "--edit", "4:0,0,0.1", "--edit", "4:0,0,1e308"];
    refused(&portrait(), "a.json", &far, 5, &["edit 2 (vertex 4)", "non-finite", "smaller offsets"]);
}

#[test]
fn invalid_options_and_edits_files() {
    let request = |more: &[&str], words: &[&str]| refused(&portrait(), "a.json", more, 2, words);
    request(&["--edit", "4:0,0"], &["three numbers"]);
    request(&["--edit", "nose:0,0,1"], &["invalid vertex"]);
    request(&["--operator", "M"], &["L_s"]);
    request(&["--units", "inches"], &["image"]);
    let file = scratch_file("broken.json", br#"[{"vertex": 4}]"#);
    request(&["--edits", file.to_str().unwrap()], &["broken.json", "offset", "Expected a list"]);
    refused(&portrait(), "a.stp", &[], 2, &["a.stp: unknown file extension", ".glb"]);
}

#[test]
fn a_missing_output_folder() {
    refused(&portrait(), "no-such-folder/a.json", &[], 6, &["no-such-folder", "Check that the folder"]);
}

#[test]
fn missing_and_damaged_networks() {
    let empty = scratch("empty-folder");
    std::fs::create_dir_all(&empty).unwrap();
    refused(
        &portrait(),
        "a.json",
        &["--networks", empty.to_str().unwrap()],
        7,
        &["empty-folder", "cargo xtask networks"],
    );
    let broken = scratch("broken-networks");
    std::fs::create_dir_all(&broken).unwrap();
    for name in ["face_detector.onnx", "face_landmarks_attention.onnx"] {
        std::fs::write(broken.join(name), b"no network").unwrap();
    }
    refused(&portrait(), "a.json", &["--networks", broken.to_str().unwrap()], 7, &["damaged", "cargo xtask networks"]);
}

#[test]
fn help_lists_the_exit_codes() {
    for arguments in
        [&["--help"][..], &["mesh", "--help"], &["photo", "--help"], &["landmarks", "--help"], &["paper", "--help"]]
    {
        let run = rosto(arguments);
        let text = String::from_utf8(run.stdout.clone()).unwrap();
        assert_eq!(code(&run), 0);
        assert!(text.contains("Exit codes:") && text.contains("no face in the photo"), "{text}");
    }
}
