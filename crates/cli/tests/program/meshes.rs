//! One mesh per photo: resumed batches, replaced files, and errors that end the batch.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::common::*;

const QUICK: [&str; 3] = ["--mediapipe", "--density", "0"];

/// A folder with copies of the portrait, and an empty folder for meshes.
fn photos(names: &[&str]) -> (PathBuf, PathBuf) {
    let folder = scratch_folder("photos");
    for name in names {
        fs::copy(portrait(), folder.join(name)).unwrap();
    }
    (folder, scratch_folder("meshes"))
}

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&QUICK[..], more].concat()
}

fn alone(more: &[&str]) -> Vec<u8> {
    let file = scratch("alone.ply");
    assert_eq!(code(&mesh(&portrait(), &file, &with(more))), 0);
    fs::read(file).unwrap()
}

#[test]
fn meshes_are_made_again_only_for_other_edits() {
    let (folder, meshes) = photos(&["a.png", "b.png"]);
    let pattern = meshes.join("{}.ply");
    let file = scratch_file("edits.json", br#"[{"vertex": 4, "offset": [0, 0, 2]}]"#);
    let by_file = ["--edits", file.to_str().unwrap()];
    let requests: [&[&str]; 6] =
        [&[], &["--slider", "nose-width:4"], &["--slider", "nose-width:8"], &["--distance", "60"], &by_file, &[]];
    for request in requests {
        let run = mesh(&folder, &pattern, &with(request));
        assert!(said(&run).contains("2 photos with a face"), "{request:?}: {}", said(&run));
        let again = mesh(&folder, &pattern, &with(request));
        assert!(said(&again).contains("0 photos with a face") && said(&again).contains("2 already done"));
        assert!(fs::read(meshes.join("b.ply")).unwrap() == alone(request), "{request:?}");
    }
    // A change in the edits file is another request.
    assert!(said(&mesh(&folder, &pattern, &with(&by_file))).contains("2 photos with a face"));
    fs::write(&file, r#"[{"vertex": 4, "offset": [0, 0, 3]}]"#).unwrap();
    assert!(said(&mesh(&folder, &pattern, &with(&by_file))).contains("2 photos with a face"));
    assert!(said(&mesh(&folder, &pattern, &with(&["--force"]))).contains("2 photos with a face"));
}

#[test]
fn foreign_files_are_replaced_only_with_force() {
    let (folder, meshes) = photos(&["a.png", "b.png"]);
    let pattern = meshes.join("{}.ply");
    fs::write(meshes.join("b.ply"), "mine").unwrap();
    assert_refused(&mesh(&folder, &pattern, &QUICK), 2, &["b.ply", "did not write it for", "b.png", "--force"]);
    assert_eq!(names_in(&meshes), ["b.ply"], "nothing is written before the checks");
    assert_eq!(fs::read(meshes.join("b.ply")).unwrap(), b"mine");
    assert_eq!(code(&mesh(&folder, &pattern, &with(&["--force"]))), 0);
    assert!(fs::read(meshes.join("b.ply")).unwrap() == alone(&[]));
    // A mesh that the user changed counts as done.
    fs::write(meshes.join("a.ply"), "sculpted").unwrap();
    assert_eq!(code(&mesh(&folder, &pattern, &QUICK)), 0);
    assert_refused(&mesh(&folder, &pattern, &with(&["--slider", "nose-width:4"])), 2, &["a.ply"]);
    assert_eq!(fs::read(meshes.join("a.ply")).unwrap(), b"sculpted");
}

#[test]
fn a_batch_killed_before_its_mesh_was_in_place_is_resumed() {
    let (folder, meshes) = photos(&["a.png"]);
    let (pattern, file) = (meshes.join("{}.ply"), meshes.join("a.ply"));
    let other = with(&["--slider", "nose-width:4"]);
    assert_eq!(code(&mesh(&folder, &pattern, &QUICK)), 0);
    let first = fs::read(&file).unwrap();
    assert_eq!(code(&mesh(&folder, &pattern, &other)), 0);
    let second = fs::read(&file).unwrap();
    // As if the second run had been killed between ledger line and mesh.
    fs::write(&file, &first).unwrap();
    assert!(said(&mesh(&folder, &pattern, &other)).contains("1 photos with a face"));
    assert!(fs::read(&file).unwrap() == second);
    fs::remove_file(&file).unwrap();
    assert!(said(&mesh(&folder, &pattern, &other)).contains("1 photos with a face"));
    let ledger = meshes.join(".rosto-{}.ply.jsonl");
    let torn = fs::read(&ledger).unwrap();
    fs::write(&ledger, &torn[..torn.len() - 20]).unwrap();
    assert_eq!(code(&mesh(&folder, &pattern, &other)), 0);
    assert!(fs::read(&file).unwrap() == second);
}

#[test]
fn coinciding_files_are_refused_before_anything_is_written() {
    let (folder, meshes) = photos(&["IMG 1.png", "IMG_1.png", "a.png"]);
    let run = mesh(&folder, &meshes.join("{}.obj"), &QUICK);
    assert_refused(&run, 2, &["IMG 1.png", "IMG_1.png", "IMG_1.mtl"]);
    assert!(names_in(&meshes).is_empty());
    // Without textures their sidecar files do not coincide.
    let colours = with(&["--base-colour", "colours"]);
    assert_eq!(code(&mesh(&folder, &meshes.join("{}.obj"), &colours)), 0);
    let over = mesh(&folder, &folder.join("{}.png"), &["--mediapipe", "--force"]);
    assert_refused(&over, 2, &["would overwrite the input"]);
    fs::remove_file(folder.join("IMG_1.png")).unwrap();
    fs::write(meshes.join("IMG_1.png"), "mine").unwrap();
    assert_refused(&mesh(&folder, &meshes.join("{}.obj"), &QUICK), 2, &["IMG_1.png", "did not write it"]);
    assert!(!meshes.join("IMG_1.mtl").exists() && fs::read(meshes.join("IMG_1.png")).unwrap() == b"mine");
}

#[test]
fn a_batch_can_have_more_than_five_photos() {
    let (folder, meshes) = photos(&["1.png", "2.png", "3.png", "4.png", "5.png", "6.png"]);
    let photos = (1..=6).map(|number| folder.join(format!("{number}.png")).into_os_string());
    let output = meshes.join("{}.json").into_os_string();
    let words = ["mesh".into()].into_iter().chain(photos).chain(["-o".into(), output, "--mediapipe".into()]);
    let run = rosto(words);
    assert_eq!(code(&run), 0, "{}", said(&run));
    assert_eq!(names_in(&meshes).iter().filter(|name| name.ends_with(".json")).count(), 6);
}

#[cfg(target_os = "linux")]
#[test]
fn a_write_error_ends_the_batch() {
    let (folder, meshes) = photos(&["a.png", "b.png", "c.png", "d.png"]);
    let mut shell = Command::new("sh");
    let script = "trap '' XFSZ; ulimit -f 4; exec \"$@\"";
    shell.args(["-c", script, "sh", env!("CARGO_BIN_EXE_rosto"), "mesh", "--jobs", "2"]).args(QUICK);
    let run = shell.arg(&folder).arg("-o").arg(meshes.join("{}.ply")).output().unwrap();
    assert_refused(&run, 6, &[".ply", "limit"]);
    assert!(!said(&run).contains("photos failed") && !said(&run).contains("d.ply"), "{}", said(&run));
    assert!(names_in(&meshes).iter().all(|name| !name.ends_with(".ply")));
    // The next run writes the missing meshes.
    assert_eq!(code(&mesh(&folder, &meshes.join("{}.ply"), &QUICK)), 0);

    fs::copy(portrait(), folder.join(format!("{}.png", "n".repeat(250)))).unwrap();
    let run = mesh(&folder, &meshes.join("{}-edited.ply"), &QUICK);
    assert_refused(&run, 6, &["shorter name"]);
    assert!(!said(&run).contains("photos failed"));
    let missing = mesh(&portrait(), Path::new("/proc/nowhere/{}.ply"), &QUICK);
    assert_refused(&missing, 6, &["/proc/nowhere"]);
}

#[cfg(target_os = "linux")]
#[test]
fn non_utf8_names_that_print_alike_are_distinct() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let (folder, meshes) = photos(&[]);
    for name in [&b"\xfe.png"[..], b"\xff.png"] {
        fs::copy(portrait(), folder.join(OsStr::from_bytes(name))).unwrap();
    }
    let run = mesh(&folder, &meshes.join("{}.ply"), &QUICK);
    assert!(said(&run).contains("2 photos with a face"), "{}", said(&run));
    assert!([&b"\xfe.ply"[..], b"\xff.ply"].iter().all(|name| meshes.join(OsStr::from_bytes(name)).is_file()));
    assert!(said(&mesh(&folder, &meshes.join("{}.ply"), &QUICK)).contains("2 already done"));
}

#[test]
fn a_second_process_on_the_same_meshes_is_refused_and_standard_input_is_always_a_new_photo() {
    let (_, meshes) = photos(&[]);
    let pattern = meshes.join("{}.ply");
    let start = || {
        let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
        program.args(["mesh", "-", "-o"]).arg(&pattern).args(QUICK).stdin(Stdio::piped()).stderr(Stdio::piped());
        program.spawn().unwrap()
    };
    let mut first = start();
    wait_for(&meshes.join(".rosto-{}.ply.jsonl"), &mut first);
    assert_refused(&mesh(&portrait(), &pattern, &QUICK), 6, &["another process"]);
    let feed = |child: &mut std::process::Child| {
        std::io::copy(&mut File::open(portrait()).unwrap(), child.stdin.as_mut().unwrap()).unwrap();
        drop(child.stdin.take());
    };
    feed(&mut first);
    assert!(first.wait().unwrap().success());
    let mut second = start();
    feed(&mut second);
    let run = second.wait_with_output().unwrap();
    assert!(said(&run).contains("1 photos with a face"), "{}", said(&run));
}
