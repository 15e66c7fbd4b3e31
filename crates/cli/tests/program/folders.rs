//! Folders as inputs, and the count of skipped files.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::common::*;

#[test]
fn all_jpeg_extensions_are_read_and_other_files_are_counted() {
    let folder = scratch_folder("photos");
    let photo = image::open(portrait()).unwrap().to_rgb8();
    photo.save(folder.join("a.jpg")).unwrap();
    for name in ["b.jfif", "c.JPE", "d.pjpeg", "e.Jpeg"] {
        fs::copy(folder.join("a.jpg"), folder.join(name)).unwrap();
    }
    fs::create_dir(folder.join("more.jpg")).unwrap();
    for name in ["f.heic", "more.jpg/g.HEIC", "notes.txt", "README", ".hidden.heic"] {
        fs::write(folder.join(name), "no photo").unwrap();
    }
    let file = scratch_folder("out").join("faces.jsonl");
    let words = ["landmarks", "--mediapipe", "-o"].map(Path::new).into_iter().chain([file.as_path(), &folder]);
    let run = rosto(words);
    assert_eq!(code(&run), 0, "{}", said(&run));
    let expected = "4 other files skipped (1 without an extension, 2 .heic, 1 .txt)";
    assert!(said(&run).contains("5 photos with a face") && said(&run).contains(expected), "{}", said(&run));
    let pattern = scratch_folder("meshes").join("{}.ply");
    assert!(said(&mesh(&folder, &pattern, &["--mediapipe"])).contains(expected));
    fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).for_each(|path| {
        if path.is_file() && path.extension().is_none_or(|extension| extension != "heic") {
            fs::remove_file(path).unwrap();
        }
    });
    assert_refused(&rosto([Path::new("landmarks"), &folder]), 3, &["no photos", "2 other files"]);
}

#[cfg(unix)]
#[test]
fn pipes_devices_and_broken_links_in_a_folder_are_skipped() {
    use std::os::unix::fs::symlink;
    let folder = scratch_folder("photos");
    fs::copy(portrait(), folder.join("a.png")).unwrap();
    assert!(Command::new("mkfifo").arg(folder.join("b.jpg")).status().unwrap().success());
    symlink("b.jpg", folder.join("c.jpg")).unwrap();
    symlink("/dev/zero", folder.join("d.jpg")).unwrap();
    symlink("nowhere.jpg", folder.join("e.jpg")).unwrap();
    symlink("a.png", folder.join("f.png")).unwrap();
    let file = scratch_folder("out").join("faces.jsonl");
    let words = ["landmarks", "--mediapipe", "-o"].map(Path::new).into_iter().chain([file.as_path(), &folder]);
    let run = rosto(words);
    assert_eq!(code(&run), 0, "{}", said(&run));
    assert!(said(&run).contains("2 photos with a face") && said(&run).contains("4 other files skipped (4 .jpg)"));
}

#[test]
fn duplicate_folders_are_read_once() {
    let parent = scratch_folder("parent");
    fs::create_dir_all(parent.join("dp/deeper")).unwrap();
    for name in ["dp/a.png", "dp/deeper/b.png"] {
        fs::copy(portrait(), parent.join(name)).unwrap();
    }
    let lines = |photos: &[&str]| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_rosto"));
        let run = program.current_dir(&parent).args(["landmarks", "--mediapipe"]).args(photos).output().unwrap();
        assert_eq!(code(&run), 0, "{}", said(&run));
        String::from_utf8(run.stdout).unwrap().lines().count()
    };
    let absolute = parent.join("dp");
    for photos in [
        &["dp", "./dp"][..],
        &["dp", "dp/", "dp/../dp", "dp/.", absolute.to_str().unwrap()],
        &["dp/deeper", "dp"],
        &["dp/a.png", "./dp/a.png", "dp/deeper/b.png", "dp"],
    ] {
        assert_eq!(lines(photos), 2, "{photos:?}");
    }
}
