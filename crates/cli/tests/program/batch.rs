//! Batches: folders, threads, resuming, and one mesh per photo.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use crate::common::*;
use image::imageops::FilterType;

/// A folder of different photos, one of them in a subfolder, and of other files.
fn album(photos: u32) -> PathBuf {
    let folder = scratch_folder("album");
    fs::create_dir(folder.join("more")).unwrap();
    let sample = image::open(portrait()).unwrap();
    for number in 0..photos {
        let side = 256 + 8 * number;
        let parent = if number == 1 { folder.join("more") } else { folder.clone() };
        let extension = ["png", "JPG", "jpeg", "webp"][number as usize % 4];
        let photo = sample.resize_exact(side, side, FilterType::Triangle).to_rgb8();
        photo.save(parent.join(format!("{number:03}.{extension}"))).unwrap();
    }
    fs::write(folder.join("notes.txt"), "no photo").unwrap();
    fs::write(folder.join(".hidden.png"), "no photo either").unwrap();
    folder
}

fn landmarks(arguments: &[&Path], more: &[&str]) -> Output {
    let paths = arguments.iter().map(|path| OsString::from(*path));
    rosto(["landmarks".into()].into_iter().chain(paths).chain(more.iter().map(OsString::from)))
}

fn in_file(folder: &Path, file: &Path, more: &[&str]) -> Output {
    landmarks(&[folder, Path::new("--output"), file], more)
}

fn lines_of(text: &[u8]) -> Vec<String> {
    std::str::from_utf8(text).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn a_folder_gives_its_photos_and_the_output_does_not_depend_on_jobs() {
    let album = album(6);
    let alone = landmarks(&[&album], &["--mediapipe"]);
    assert_eq!(code(&alone), 0);
    let said = said(&alone);
    let are_soft = said.lines().filter(|line| line.ends_with("px wide: it will look soft")).count();
    assert_eq!((are_soft, said.lines().count()), (6, 6), "{said}");
    let order = ["000.png", "002.jpeg", "003.webp", "004.png", "005.JPG", "more/001.JPG"];
    let photos: Vec<PathBuf> = order.iter().map(|name| album.join(name)).collect();
    let one_by_one = photos.iter().flat_map(|photo| landmarks(&[photo], &["--mediapipe"]).stdout);
    assert_eq!(lines_of(&alone.stdout), lines_of(&one_by_one.collect::<Vec<_>>()));
    for jobs in ["2", "5", "64"] {
        assert_eq!(landmarks(&[&album], &["--mediapipe", "--jobs", jobs]).stdout, alone.stdout, "{jobs} jobs");
    }
}

#[test]
fn a_folder_without_photos_is_refused() {
    let folder = scratch_folder("empty");
    fs::write(folder.join("notes.txt"), "no photo").unwrap();
    assert_refused(&landmarks(&[&folder], &[]), 3, &["no photos in this folder", ".webp"]);
}

#[test]
fn a_bad_photo_gets_an_error_line_and_does_not_stop_the_batch() {
    let album = album(3);
    fs::write(album.join("001-bad.png"), b"these are notes").unwrap();
    let file = scratch("faces.jsonl");
    let _ = fs::remove_file(&file);
    let first = in_file(&album, &file, &["--mediapipe", "--jobs", "2"]);
    assert_refused(&first, 3, &["001-bad.png: this is not a picture", "3 photos with a face, 0 without, 1 failed"]);
    let lines = lines_of(&fs::read(&file).unwrap());
    let values: Vec<serde_json::Value> = lines.iter().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(values.len(), 4);
    assert!(values[1]["error"].as_str().unwrap().contains("not a picture"));
    assert!(values.iter().all(|value| value["how"]["search"] == "mediapipe"));
    let again = in_file(&album, &file, &["--mediapipe"]);
    assert_refused(&again, 3, &["001-bad.png: this is not a picture", "3 already done"]);
    let mut sorted = [lines, lines_of(&fs::read(&file).unwrap())];
    sorted.iter_mut().for_each(|lines| lines.sort());
    assert_eq!(sorted[0], sorted[1], "the failed photo's line moved to the end");
}

#[test]
fn a_killed_batch_can_be_resumed() {
    let album = album(24);
    let (whole, torn) = (scratch("whole.jsonl"), scratch("torn.jsonl"));
    [&whole, &torn].into_iter().for_each(|file| drop(fs::remove_file(file)));
    assert_eq!(code(&in_file(&album, &whole, &["--mediapipe"])), 0);
    let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
    let program = program.arg("landmarks").arg(&album).args(["--mediapipe", "--jobs", "2", "--output"]).arg(&torn);
    let mut running = program.stderr(Stdio::null()).spawn().unwrap();
    while fs::metadata(&torn).map_or(0, |there| there.len()) < 60_000 {
        assert!(running.try_wait().unwrap().is_none(), "the program ended before it was killed");
        std::thread::sleep(Duration::from_millis(1));
    }
    running.kill().unwrap();
    running.wait().unwrap();
    let written = fs::read(&torn).unwrap();
    assert!(lines_of(&written).len() < 24);
    // As if killed in the middle of a line.
    fs::write(&torn, &written[..written.len() - 100]).unwrap();
    assert_eq!(code(&in_file(&album, &torn, &["--mediapipe", "--jobs", "3"])), 0);
    assert_eq!(lines_of(&fs::read(&torn).unwrap()), lines_of(&fs::read(&whole).unwrap()));
}

/// Sixty photos of 12 MB decoded, with a memory limit of 400 MB.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "slow; runs at night"]
fn memory_does_not_grow_with_photos() {
    let folder = scratch_folder("large");
    let large = image::open(portrait()).unwrap().resize_exact(2048, 2048, FilterType::Nearest).to_rgb8();
    large.save(folder.join("0.jpg")).unwrap();
    (1..60).for_each(|number| fs::hard_link(folder.join("0.jpg"), folder.join(format!("{number}.jpg"))).unwrap());
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -v 400000; exec \"$@\"", "sh", env!("CARGO_BIN_EXE_rosto"), "landmarks"]);
    let output = shell.arg(&folder).args(["--mediapipe", "--jobs", "2"]).output().unwrap();
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert_eq!(lines_of(&output.stdout).len(), 60);
}

#[test]
fn a_batch_makes_the_same_meshes_and_keeps_existing_ones() {
    let album = album(3);
    fs::write(album.join("001-bad.png"), b"these are notes").unwrap();
    let meshes = scratch_folder("meshes").join("made");
    let pattern = meshes.join("{}.ply");
    let options = ["--density", "0", "--slider", "nose-width:4"];
    let each = |more: &[&str]| mesh(&album, &pattern, &[&options, more].concat());
    assert_refused(&each(&["--jobs", "2"]), 3, &["001-bad.png", "3 photos with a face, 0 without, 1 failed"]);
    assert_eq!(names_in(&meshes), [".rosto-{}.ply.jsonl", "000.ply", "002.ply", "more"]);
    for (photo, made) in [("000.png", "000.ply"), ("002.jpeg", "002.ply"), ("more/001.JPG", "more/001.ply")] {
        let alone = scratch("alone.ply");
        assert_eq!(code(&mesh(&album.join(photo), &alone, &options)), 0);
        assert!(fs::read(&alone).unwrap() == fs::read(meshes.join(made)).unwrap(), "{made} differs");
    }
    fs::write(meshes.join("000.ply"), "mine").unwrap();
    fs::remove_file(meshes.join("002.ply")).unwrap();
    assert_refused(&each(&[]), 3, &["1 photos with a face", "2 already done"]);
    assert_eq!(fs::read(meshes.join("000.ply")).unwrap(), b"mine");
    assert!(meshes.join("002.ply").exists());
}

#[test]
fn coinciding_outputs_and_outputs_over_photos_are_refused() {
    let album = album(1);
    fs::copy(album.join("000.png"), album.join("000.jpg")).unwrap();
    let pattern = scratch_folder("meshes").join("{}.ply");
    assert_refused(&mesh(&album, &pattern, &[]), 2, &["000.jpg", "000.png", "000.ply"]);
    fs::remove_file(album.join("000.jpg")).unwrap();
    let sidecar = mesh(&album, &album.join("{}.obj"), &["--base-colour", "photo"]);
    assert_refused(&sidecar, 2, &["000.png", "would overwrite"]);
    assert_eq!(names_in(&album), [".hidden.png", "000.png", "more", "notes.txt"]);
}
