//! Resuming a file of landmarks, and refusal of other files.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use crate::common::*;
use serde_json::Value;

/// Runs `rosto landmarks --mediapipe PHOTOS... -o FILE MORE...`.
fn landmarks(photos: &[&Path], file: &Path, more: &[&str]) -> Output {
    let photos = photos.iter().map(|photo| photo.as_os_str());
    let options = ["--mediapipe", "-o"].map(OsStr::new).into_iter().chain([file.as_os_str()]);
    rosto([OsStr::new("landmarks")].into_iter().chain(photos).chain(options).chain(more.iter().map(OsStr::new)))
}

/// A folder with copies of the portrait, and the path of a landmarks file that does not exist yet.
fn photos(names: &[&str]) -> (PathBuf, PathBuf) {
    let folder = scratch_folder("photos");
    for name in names {
        fs::copy(portrait(), folder.join(name)).unwrap();
    }
    (folder, scratch_folder("out").join("faces.jsonl"))
}

fn lines(file: &Path) -> Vec<Value> {
    fs::read_to_string(file).unwrap().lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn names(file: &Path) -> Vec<String> {
    let name =
        |line: Value| Path::new(line["photo"].as_str().unwrap()).file_name().unwrap().to_str().unwrap().to_owned();
    lines(file).into_iter().map(name).collect()
}

#[test]
fn other_options_and_foreign_files_are_refused_and_unchanged() {
    let (folder, file) = photos(&["a.png"]);
    assert_eq!(code(&landmarks(&[&folder], &file, &[])), 0);
    let ours = fs::read_to_string(&file).unwrap();
    let with_notes = format!("{ours}see also page 3");
    let of_other_options = ours.replace("\"max_faces\":1", "\"max_faces\":7");
    let ours_cut = &of_other_options[..of_other_options.len() / 2];
    let both = format!("{ours}{{\"photo\":\"b.jpg\",\"how\":{{}}}}\n");
    let captions = "{\"photo\":\"a.jpg\",\"caption\":\"at the sea\"}";
    for (name, content) in [
        ("text", "milk\nbread\n"),
        ("text without an end", "milk"),
        ("captions", captions),
        ("captions cut off", &captions[..30]),
        ("two requests", &both),
        ("ours and notes", &with_notes),
        ("other options", &of_other_options),
        ("other options cut off", ours_cut),
        ("no text", "\0\0\0\0"),
        ("a blank line", "\n"),
    ] {
        fs::write(&file, content).unwrap();
        assert_refused(
            &landmarks(&[&folder], &file, &[]),
            2,
            &["line ", "not written with these options", "unchanged"],
        );
        assert_eq!(fs::read_to_string(&file).unwrap(), content, "{name}");
    }
    let mesh_file = file.with_extension("json");
    assert_eq!(code(&mesh(&portrait(), &mesh_file, &[])), 0);
    let before = fs::read(&mesh_file).unwrap();
    assert_refused(&landmarks(&[&portrait()], &mesh_file, &[]), 2, &["line 1"]);
    assert!(fs::read(&mesh_file).unwrap() == before, "the mesh is unchanged");
    assert_eq!(code(&landmarks(&[&folder], &mesh_file, &["--force"])), 0);
    assert_eq!(fs::read_to_string(&mesh_file).unwrap(), ours);
}

#[test]
fn a_file_truncated_anywhere_is_resumed() {
    let (folder, file) = photos(&["a.png", "b.png"]);
    assert_eq!(code(&landmarks(&[&folder], &file, &[])), 0);
    let whole = fs::read(&file).unwrap();
    let first = whole.iter().position(|&byte| byte == b'\n').unwrap() + 1;
    for length in [0, 1, 9, 15, 60, first - 2, first - 1, first, first + 40, whole.len() - 1, whole.len()] {
        fs::write(&file, &whole[..length]).unwrap();
        let run = landmarks(&[&folder], &file, &[]);
        assert_eq!(code(&run), 0, "{length} bytes: {}", said(&run));
        assert!(fs::read(&file).unwrap() == whole, "{length} bytes");
    }
}

#[test]
fn failed_photos_are_tried_again() {
    let (folder, file) = photos(&["a.png", "c.png"]);
    let bad = folder.join("b.png");
    fs::write(&bad, "notes").unwrap();
    for _ in 0..3 {
        assert_refused(&landmarks(&[&folder], &file, &[]), 3, &["b.png: this is not a picture"]);
        let failed: Vec<bool> = lines(&file).iter().map(|line| line["error"].is_string()).collect();
        assert_eq!(failed.iter().filter(|failed| **failed).count(), 1, "one line per photo");
        assert_eq!(failed.len(), 3);
    }
    // A run over another folder keeps the line.
    let (elsewhere, other) = (scratch_folder("elsewhere"), "d.png");
    fs::copy(portrait(), elsewhere.join(other)).unwrap();
    assert_eq!(code(&landmarks(&[&elsewhere], &file, &[])), 0);
    assert!(lines(&file).iter().any(|line| line["error"].is_string()));
    fs::copy(portrait(), &bad).unwrap();
    let run = landmarks(&[&folder], &file, &[]);
    assert_eq!(code(&run), 0, "{}", said(&run));
    assert!(said(&run).contains("1 photos with a face") && said(&run).contains("2 already done"));
    assert_eq!(names(&file), ["a.png", "c.png", "d.png", "b.png"]);
    assert!(lines(&file).iter().all(|line| line["error"].is_null()));
}

#[cfg(target_os = "linux")]
#[test]
fn non_utf8_names_that_print_alike_are_distinct() {
    use std::os::unix::ffi::OsStrExt;
    let (folder, file) = photos(&["\u{fffd}.png"]);
    for byte in [0xfe_u8, 0xff] {
        fs::copy(portrait(), folder.join(OsStr::from_bytes(&[byte, b'.', b'p', b'n', b'g']))).unwrap();
    }
    let run = landmarks(&[&folder], &file, &["--jobs", "2"]);
    assert_eq!((code(&run), lines(&file).len()), (0, 3), "{}", said(&run));
    let before = fs::read(&file).unwrap();
    // Given one by one or together, each photo is recognised as done.
    for name in [&b"\xff.png"[..], b"\xfe.png", "\u{fffd}.png".as_bytes(), b""] {
        let run = landmarks(&[&folder.join(OsStr::from_bytes(name))], &file, &[]);
        assert_eq!(code(&run), 0);
        assert!(said(&run).contains("0 photos with a face"), "{}", said(&run));
    }
    assert!(fs::read(&file).unwrap() == before);
    fs::write(&file, &before[..before.iter().position(|&byte| byte == b'\n').unwrap() + 1]).unwrap();
    assert!(said(&landmarks(&[&folder], &file, &[])).contains("2 photos with a face"));
    assert_eq!(lines(&file).len(), 3);
}

#[test]
fn a_photo_is_recognised_under_any_path() {
    let (folder, file) = photos(&["a.png", "b.png"]);
    let run = |photos: &[&str]| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
        program.current_dir(folder.parent().unwrap()).arg("landmarks").args(photos).args(["--mediapipe", "-o"]);
        program.arg(&file).output().unwrap()
    };
    assert!(said(&run(&["photos", "./photos", "photos/", "photos/../photos/a.png"])).contains("2 photos with a face"));
    let absolute = folder.to_str().unwrap();
    for path in ["photos", "./photos", "photos/", "photos/../photos", absolute, "photos/a.png", "./photos/./a.png"] {
        let run = run(&[path]);
        assert!(said(&run).contains("0 photos with a face"), "{path}: {}", said(&run));
    }
    assert_eq!(names(&file), ["a.png", "b.png"]);
}

#[test]
fn standard_input_is_always_a_new_photo() {
    let (_, file) = photos(&[]);
    let run = || {
        let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
        program.args(["landmarks", "-", "--mediapipe", "-o"]).arg(&file).stdin(File::open(portrait()).unwrap());
        program.output().unwrap()
    };
    for photos in 1..=2 {
        assert_eq!(code(&run()), 0);
        assert_eq!(lines(&file).len(), photos);
    }
}

#[test]
fn a_second_process_on_the_same_file_is_refused() {
    let (_, file) = photos(&[]);
    let mut first = Command::new(env!("CARGO_BIN_EXE_rosto"));
    let first = first.args(["landmarks", "-", "--mediapipe", "-o"]).arg(&file).stdin(Stdio::piped());
    let mut first = first.stderr(Stdio::null()).spawn().unwrap();
    wait_for(&file, &mut first);
    assert_refused(&landmarks(&[&portrait()], &file, &[]), 6, &["faces.jsonl", "another process", "Wait"]);
    assert_refused(&landmarks(&[&portrait()], &file, &["--force"]), 6, &["another process"]);
    std::io::copy(&mut File::open(portrait()).unwrap(), first.stdin.as_mut().unwrap()).unwrap();
    assert!(first.wait().unwrap().success());
    assert_eq!(names(&file), ["-"]);
    assert_eq!(code(&landmarks(&[&portrait()], &file, &[])), 0);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_ends_the_batch_and_leaves_complete_lines() {
    let (folder, file) = photos(&["a.png", "b.png", "c.png"]);
    let run = landmarks(&[&folder], Path::new("/dev/full"), &[]);
    assert_refused(&run, 6, &["/dev/full", "The disk is full"]);
    assert!(!said(&run).contains("photos"), "{}", said(&run));
    let mut shell = Command::new("sh");
    let script = "trap '' XFSZ; ulimit -f 50; exec \"$@\"";
    shell.args(["-c", script, "sh", env!("CARGO_BIN_EXE_rosto"), "landmarks", "--mediapipe", "-o"]);
    let run = shell.args([&file, &folder]).output().unwrap();
    assert_refused(&run, 6, &["faces.jsonl", "limit on file sizes"]);
    assert!(fs::read(&file).unwrap().last().is_none_or(|&byte| byte == b'\n'));
    assert_eq!(code(&landmarks(&[&folder], &file, &[])), 0);
    assert_eq!(names(&file), ["a.png", "b.png", "c.png"]);
}
