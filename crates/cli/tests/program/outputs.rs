//! Output files: atomic writes, and protection of inputs and foreign files.

#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Output};

use crate::common::*;

const GOOD: &[u8] = b"existing content";

/// Runs `rosto mesh` on the portrait with a limit of 4 blocks per file; `first` is a shell command run before.
fn mesh_cut_short(first: &str, output: &Path, more: &[&str]) -> Output {
    let script = format!("{first} ulimit -f 4; exec \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &script, "sh", env!("CARGO_BIN_EXE_rosto"), "mesh"]).arg(portrait()).arg("-o").arg(output);
    shell.args(more).output().unwrap()
}

#[test]
fn a_kill_during_a_write_leaves_the_existing_file_unchanged() {
    let folder = scratch_folder("killed");
    let file = folder.join("face.glb");
    fs::write(&file, GOOD).unwrap();
    let run = mesh_cut_short("", &file, &[]);
    assert_eq!(run.status.signal(), Some(25), "SIGXFSZ, in the middle of a write");
    assert_eq!(fs::read(&file).unwrap(), GOOD);
    let stray: Vec<String> = names_in(&folder).into_iter().filter(|name| name != "face.glb").collect();
    assert!(stray.iter().all(|name| name.starts_with(".rosto-unfinished-")), "{stray:?}");
}

#[test]
fn a_failed_write_leaves_no_temporary_file() {
    let folder = scratch_folder("failed");
    let file = folder.join("face.glb");
    for before in [None, Some(GOOD)] {
        if let Some(good) = before {
            fs::write(&file, good).unwrap();
        }
        let run = mesh_cut_short("trap '' XFSZ;", &file, &[]);
        assert_refused(&run, 6, &["face.glb", "limit on file sizes"]);
        assert_eq!(fs::read(&file).ok().as_deref(), before);
        assert_eq!(names_in(&folder).len(), usize::from(before.is_some()));
    }
}

#[test]
fn the_papers_figures_are_written_atomically() {
    let folder = scratch_folder("failed-paper");
    let figure = folder.join("figure-3.glb");
    fs::write(&figure, GOOD).unwrap();
    let script = "trap '' XFSZ; ulimit -f 4; exec \"$@\"";
    let mut shell = Command::new("sh");
    shell.args(["-c", script, "sh", env!("CARGO_BIN_EXE_rosto"), "paper", "--runs", "1", "--force"]).arg(portrait());
    let run = shell.arg("-o").arg(&folder).output().unwrap();
    assert_refused(&run, 6, &["figure-3.glb"]);
    assert_eq!((fs::read(&figure).unwrap().as_slice(), names_in(&folder).len()), (GOOD, 1));
}

#[test]
fn a_full_disk_is_reported() {
    let folder = scratch_folder("full");
    let full = folder.join("full.json");
    symlink("/dev/full", &full).unwrap();
    let run = mesh(&portrait(), &full, &[]);
    assert_refused(&run, 6, &["full.json", "The disk is full"]);
    assert!(!said(&run).contains("Check that the folder"), "{}", said(&run));
    let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
    let device = fs::File::create("/dev/full").unwrap();
    let run = program.args([Path::new("landmarks"), &portrait()]).stdout(device).output().unwrap();
    assert_refused(&run, 6, &["standard output", "The disk is full"]);
}

#[test]
fn links_devices_and_pipes_are_written_through() {
    let folder = scratch_folder("links");
    fs::create_dir(folder.join("elsewhere")).unwrap();
    let (link, target) = (folder.join("link.json"), folder.join("elsewhere/face.json"));
    symlink("elsewhere/face.json", &link).unwrap();
    // First a dangling link, then a link to a file.
    for _ in 0..2 {
        assert_eq!(code(&mesh(&portrait(), &link, &[])), 0);
        assert!(link.is_symlink() && fs::read(&target).unwrap().starts_with(b"{\"units\""));
    }
    let out = folder.join("out.json");
    symlink("/dev/stdout", &out).unwrap();
    let run = mesh(&portrait(), &out, &[]);
    assert_eq!((code(&run), run.stdout), (0, fs::read(&target).unwrap()));

    let pipe = folder.join("pipe.json");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read(pipe).unwrap()
    });
    assert_eq!(code(&mesh(&portrait(), &pipe, &[])), 0);
    assert_eq!(reader.join().unwrap(), fs::read(&target).unwrap());
    assert_eq!(names_in(&folder), ["elsewhere", "link.json", "out.json", "pipe.json"]);
}

#[test]
fn existing_files_keep_their_permissions_and_new_files_get_the_default() {
    let folder = scratch_folder("permissions");
    let mode = |name: &str| fs::metadata(folder.join(name)).unwrap().permissions().mode() & 0o777;
    fs::write(folder.join("usual"), GOOD).unwrap();
    let (new, private) = (folder.join("new.json"), folder.join("private.json"));
    fs::write(&private, GOOD).unwrap();
    fs::set_permissions(&private, fs::Permissions::from_mode(0o600)).unwrap();
    for file in [&new, &private] {
        assert_eq!(code(&mesh(&portrait(), file, &[])), 0);
    }
    assert_eq!((mode("new.json"), mode("private.json")), (mode("usual"), 0o600));
}

#[test]
fn outputs_over_inputs_are_refused() {
    let folder = scratch_folder("over");
    let photo = folder.join("photo.glb");
    fs::copy(portrait(), &photo).unwrap();
    symlink("photo.glb", folder.join("link.glb")).unwrap();
    fs::hard_link(&photo, folder.join("hard.glb")).unwrap();
    let same = folder.join("../over/photo.glb");
    for output in [&photo, &same, &folder.join("link.glb"), &folder.join("hard.glb")] {
        assert_refused(&mesh(&photo, output, &[]), 2, &["photo.glb", "would overwrite", "another name"]);
    }
    let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
    program.args(["mesh", "-", "-o"]).arg(&photo).stdin(fs::File::open(&photo).unwrap());
    assert_refused(&program.output().unwrap(), 2, &["standard input", "would overwrite"]);
    assert_eq!(fs::read(&photo).unwrap(), fs::read(portrait()).unwrap());

    let edits = folder.join("edits.json");
    fs::write(&edits, "[]").unwrap();
    let run = mesh(&portrait(), &edits, &["--edits", edits.to_str().unwrap()]);
    assert_refused(&run, 2, &["edits.json", "would overwrite"]);
    fs::copy(&photo, folder.join("figure-4.glb")).unwrap();
    let run = rosto([Path::new("paper"), &folder.join("figure-4.glb"), Path::new("-o"), &folder]);
    assert_refused(&run, 2, &["figure-4.glb", "would overwrite"]);
}

#[test]
fn folders_as_files_and_files_as_folders_are_refused() {
    let folder = scratch_folder("folder.glb");
    assert_refused(&mesh(&portrait(), &folder, &[]), 6, &["folder.glb", "Pass a file in that folder"]);
    let file = scratch_file("no-folder", GOOD);
    let run = rosto([Path::new("paper"), &portrait(), Path::new("-o"), &file]);
    assert_refused(&run, 6, &["no-folder", "Pass a folder"]);
    assert_eq!(fs::read(file).unwrap(), GOOD);
}

#[test]
fn an_obj_is_written_with_its_sidecar_files_or_not_at_all() {
    let folder = scratch_folder("obj");
    let file = folder.join("my face.obj");
    assert_eq!(code(&mesh(&portrait(), &file, &[])), 0);
    assert_eq!(names_in(&folder), ["my face.obj", "my_face.mtl", "my_face.png"]);
    let text = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    assert!(text("my face.obj").contains("mtllib my_face.mtl") && text("my_face.mtl").contains("map_Kd my_face.png"));
    assert!(image::open(folder.join("my_face.png")).is_ok());

    for name in names_in(&folder) {
        fs::write(folder.join(name), GOOD).unwrap();
    }
    let run = mesh_cut_short("trap '' XFSZ;", &file, &["--force"]);
    assert_refused(&run, 6, &["limit on file sizes"]);
    assert!(names_in(&folder).iter().all(|name| fs::read(folder.join(name)).unwrap() == GOOD));
    assert_eq!(names_in(&folder).len(), 3);

    fs::remove_file(&file).unwrap();
    assert_eq!(code(&mesh(&portrait(), &file, &["--base-colour", "colours"])), 0);
    assert_eq!(fs::read(folder.join("my_face.mtl")).unwrap(), GOOD, "vertex colours need no material file");
}

#[test]
fn foreign_sidecar_files_are_not_replaced() {
    let folder = scratch_folder("side");
    let file = folder.join("my face.obj");
    let [material, picture] = ["my_face.mtl", "my_face.png"].map(|name| folder.join(name));
    for mine in [&material, &picture] {
        fs::write(mine, GOOD).unwrap();
        let mine_name = mine.file_name().unwrap().to_str().unwrap();
        assert_refused(&mesh(&portrait(), &file, &[]), 2, &[mine_name, "did not write it", "--force"]);
        assert!(fs::read(mine).unwrap() == GOOD && names_in(&folder).len() == 1, "nothing is written");
        fs::remove_file(mine).unwrap();
    }
    // The second run replaces the files of the first.
    for density in ["0", "1"] {
        assert_eq!(code(&mesh(&portrait(), &file, &["--density", density])), 0);
    }
    // Another output with the same sidecar names.
    let other = folder.join("my_face.obj");
    assert_refused(&mesh(&portrait(), &other, &[]), 2, &["my_face.mtl", "did not write it for"]);
    assert!(!other.exists());
    // A texture that the user changed.
    let painted = [fs::read(&picture).unwrap(), b"painted".to_vec()].concat();
    fs::write(&picture, &painted).unwrap();
    let before = fs::read(&file).unwrap();
    assert_refused(&mesh(&portrait(), &file, &["--density", "0"]), 2, &["did not write it"]);
    assert!(fs::read(&picture).unwrap() == painted && fs::read(&file).unwrap() == before);
    assert_eq!(code(&mesh(&portrait(), &file, &["--density", "0", "--force"])), 0);
    assert!(image::open(&picture).is_ok() && fs::read(&picture).unwrap() != painted);
}

#[test]
#[ignore = "slow; runs at night"]
fn figures_are_replaced_only_if_an_earlier_run_wrote_them() {
    let folder = scratch_folder("figures");
    let paper = |more: &[&str]| {
        let words = ["paper", "--runs", "1", "-o"].map(Path::new).into_iter().chain([folder.as_path()]);
        let portrait = portrait();
        rosto(words.chain([portrait.as_path()]).chain(more.iter().map(Path::new)))
    };
    for name in ["figure-4.glb", "times.svg"] {
        fs::write(folder.join(name), GOOD).unwrap();
        assert_refused(&paper(&[]), 2, &[name, "--force"]);
        assert_eq!((fs::read(folder.join(name)).unwrap().as_slice(), names_in(&folder).len()), (GOOD, 1));
        fs::remove_file(folder.join(name)).unwrap();
    }
    assert_eq!(code(&paper(&[])), 0);
    assert_eq!(code(&paper(&[])), 0);
    fs::write(folder.join("times.svg"), GOOD).unwrap();
    assert_eq!(code(&paper(&["--force"])), 0);
    assert_ne!(fs::read(folder.join("times.svg")).unwrap(), GOOD);
}

#[test]
fn sidecar_files_over_inputs_are_refused() {
    let folder = scratch_folder("sidecar");
    let photo = folder.join("photo.png");
    image::open(portrait()).unwrap().save(&photo).unwrap();
    let before = fs::read(&photo).unwrap();
    let run = mesh(&photo, &folder.join("photo.obj"), &[]);
    assert_refused(&run, 2, &["photo.png", "would overwrite", "another name"]);
    assert_eq!((names_in(&folder).len(), fs::read(&photo).unwrap()), (1, before));
}
