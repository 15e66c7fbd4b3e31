//! Inputs: size limits, standard input, and error messages.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::common::*;

/// Runs `rosto landmarks` on one photo.
fn landmarks(photo: &Path) -> Output {
    rosto([OsStr::new("landmarks"), photo.as_os_str()])
}

/// Runs the program with a limit on its memory.
#[cfg(target_os = "linux")]
fn with_memory_kb(kilobytes: u32, arguments: &[&OsStr], input: Stdio) -> Output {
    let script = format!("ulimit -v {kilobytes}; exec \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &script, "sh", env!("CARGO_BIN_EXE_rosto")]).args(arguments).stdin(input).output().unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn endless_input_stops_at_the_limit() {
    let zeros = || fs::File::open("/dev/zero").unwrap();
    let target = scratch("endless.json");
    let of = |words: &[&'static str]| words.iter().map(|word| OsStr::new(*word)).collect::<Vec<_>>();
    let photo = ["mesh".into(), portrait().into_os_string(), "-o".into(), target.clone().into_os_string()];
    let with = |more: [&'static str; 2]| -> Vec<&OsStr> {
        photo.iter().map(|word| &**word).chain(more.map(OsStr::new)).collect()
    };
    let cases: [(Vec<&OsStr>, i32, &str); 5] = [
        (of(&["landmarks", "/dev/zero"]), 3, "the limit is 40000000"),
        (of(&["landmarks", "-"]), 3, "the limit is 40000000"),
        (with(["--edits", "/dev/zero"]), 2, "the limit is 16000000"),
        (with(["--edits", "-"]), 2, "the limit is 16000000"),
        (of(&["mesh", "/dev/zero", "-o", "endless.json"]), 3, "the limit is 40000000"),
    ];
    for (arguments, expected, words) in cases {
        // Enough for the program and its networks, but little more.
        let run = with_memory_kb(400_000, &arguments, zeros().into());
        assert_refused(&run, expected, &[words]);
    }
    assert!(!target.exists() && !Path::new("endless.json").exists());
}

#[test]
fn a_file_beyond_the_limit_is_refused_by_its_size() {
    let folder = scratch_folder("giants");
    let giant = |name: &str| {
        let path = folder.join(name);
        fs::File::create(&path).unwrap().set_len(30_000_000_000).unwrap();
        path
    };
    assert_refused(&landmarks(&giant("giant.jpg")), 3, &["giant.jpg", "30000000000", "Scale the picture down"]);
    fs::copy(portrait().with_file_name("face_detector.onnx"), folder.join("face_detector.onnx")).unwrap();
    giant("face_landmarks_attention.onnx");
    let networks = ["--networks", folder.to_str().unwrap()];
    let run = mesh(&portrait(), &scratch("giant.json"), &networks);
    assert_refused(&run, 7, &["face_landmarks_attention.onnx", "the limit is 64000000"]);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn folders_and_empty_files_are_refused() {
    let folder = scratch_folder("photos");
    assert_refused(&mesh(&folder, &scratch("one.ply"), &[]), 3, &["photos", "Pass a file in that folder"]);
    assert_refused(&landmarks(&scratch_file("empty.jpg", b"")), 3, &["empty.jpg: the file is empty", "Choose"]);
    assert_refused(&landmarks(Path::new("-")), 3, &["standard input: the file is empty"]);
}

#[test]
fn standard_input_can_be_given_once() {
    let target = scratch("twice.json");
    let words = ["standard input", "more than once"];
    assert_refused(&rosto(["landmarks", "-", "-"]), 2, &words);
    assert_refused(&mesh(Path::new("-"), &target, &["--edits", "-"]), 2, &words);
}

#[test]
fn unreadable_edits_files_are_refused_and_a_byte_order_mark_is_ignored() {
    let target = scratch("edits-out.json");
    let run = |file: &Path| mesh(&portrait(), &target, &["--edits", file.to_str().unwrap()]);
    assert_refused(&run(&scratch("missing-edits.json")), 2, &["missing-edits.json", "Check the path"]);
    assert_refused(&run(&scratch_folder("edits-folder")), 2, &["edits-folder", "Pass a file"]);
    assert_refused(&run(&scratch_file("empty-edits.json", b"")), 2, &["empty-edits.json: the file is empty"]);
    for start in [b"\xff\xfe", b"\xfe\xff"] {
        let file = scratch_file("utf16.json", &[&start[..], b"[\0]\0"].concat());
        assert_refused(&run(&file), 2, &["utf16.json: the file is UTF-16", "UTF-8"]);
    }
    assert!(!target.exists());
    let plain = br#"[{"vertex": 4, "offset": [0, 0, -0.05]}]"#;
    let marked = scratch_file("marked.json", &[&b"\xef\xbb\xbf"[..], plain].concat());
    let by_marked = mesh_json("by-marked.json", &["--edits", marked.to_str().unwrap()]);
    let plain = scratch_file("unmarked.json", plain);
    assert_eq!(by_marked, mesh_json("by-unmarked.json", &["--edits", plain.to_str().unwrap()]));
}

#[cfg(unix)]
#[test]
fn control_characters_are_escaped_in_messages() {
    let name = "\u{1b}]0;owned\u{7}\u{1b}[2J\u{9b}1m.jpg";
    let file = scratch_file("colourful.json", "[{\"vertex\": 4, \"\\u001b[31m\": 1}]".as_bytes());
    let folder = format!("no-{name}");
    let runs = [
        landmarks(Path::new(name)),
        mesh(&portrait(), Path::new(&format!("{name}.stp")), &[]),
        mesh(&portrait(), &scratch("controlled.json"), &["--networks", &folder]),
        mesh(&portrait(), &scratch("controlled.json"), &["--edits", file.to_str().unwrap()]),
        mesh(&portrait(), &scratch("controlled.json"), &["--region", &format!("{name}:0,0,1")]),
        rosto([name]),
    ];
    for run in runs {
        assert_ne!(code(&run), 0);
        let said = said(&run);
        assert!(said.chars().all(|character| character == '\n' || !character.is_control()), "{said:?}");
    }
    assert!(said(&landmarks(Path::new(name))).contains(r"\u{1b}]0;owned\u{7}"));
}

#[test]
fn the_exit_code_does_not_depend_on_standard_error() {
    let Ok(full) = fs::File::create("/dev/full") else { return };
    let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
    let status = program.args(["landmarks", "nowhere.jpg"]).stderr(Stdio::from(full)).status().unwrap();
    assert_eq!(status.code(), Some(3));
}
