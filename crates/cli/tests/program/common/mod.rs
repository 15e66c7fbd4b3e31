//! Helpers: the built program, the sample portrait and other pictures.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::time::Duration;

use serde_json::Value;

/// Path of the sample portrait, which `cargo xtask setup` downloads.
pub fn portrait() -> PathBuf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets/sample.png");
    assert!(path.is_file(), "the sample portrait is missing: run `cargo xtask setup`");
    path
}

/// Path of a file in the test's own folder, because tests run in parallel and use the same names.
pub fn scratch(name: &str) -> PathBuf {
    let test = std::thread::current().name().unwrap_or("main").replace(':', "-");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(env!("CARGO_CRATE_NAME")).join(test);
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

pub fn scratch_file(name: &str, content: &[u8]) -> PathBuf {
    let path = scratch(name);
    std::fs::write(&path, content).unwrap();
    path
}

/// A grey picture without a face.
pub fn faceless() -> PathBuf {
    let path = scratch("faceless.png");
    image::GrayImage::from_pixel(96, 96, image::Luma([120])).save(&path).unwrap();
    path
}

pub fn rosto(arguments: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rosto")).args(arguments).env_remove("ROSTO_NETWORKS").output().unwrap()
}

pub fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

pub fn said(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// An empty folder in the test's own folder.
pub fn scratch_folder(name: &str) -> PathBuf {
    let folder = scratch(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).unwrap();
    }
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// File names in a folder, sorted.
pub fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Runs `rosto mesh PHOTO -o OUTPUT MORE...`.
pub fn mesh(photo: &Path, output: &Path, more: &[&str]) -> Output {
    let arguments = [OsStr::new("mesh"), photo.as_os_str(), OsStr::new("-o"), output.as_os_str()];
    rosto(arguments.into_iter().chain(more.iter().map(OsStr::new)))
}

/// Runs `rosto photo PHOTO -o OUTPUT MORE...`.
pub fn photo(photo: &Path, output: &Path, more: &[&str]) -> Output {
    let arguments = [OsStr::new("photo"), photo.as_os_str(), OsStr::new("-o"), output.as_os_str()];
    rosto(arguments.into_iter().chain(more.iter().map(OsStr::new)))
}

/// Waits up to a minute until a running program has created the file.
pub fn wait_for(file: &Path, running: &mut Child) {
    for _ in 0..12_000 {
        if file.exists() {
            return;
        }
        assert!(running.try_wait().unwrap().is_none(), "the program ended before it created {}", file.display());
        std::thread::sleep(Duration::from_millis(5));
    }
    running.kill().unwrap();
    panic!("{} was not created", file.display());
}

/// Checks the exit code and message of a failed run.
pub fn assert_refused(run: &Output, expected: i32, words: &[&str]) {
    let said = said(run);
    assert_eq!(code(run), expected, "{said}");
    assert!(words.iter().all(|word| said.contains(word)), "{words:?} in {said}");
    assert!(run.stdout.is_empty(), "messages go to standard error");
}

/// Runs `rosto mesh` on the portrait and parses its JSON output.
pub fn mesh_json(name: &str, more: &[&str]) -> Value {
    let path = scratch(name);
    let mut arguments = vec!["mesh".into(), portrait().into_os_string(), "-o".into(), path.clone().into_os_string()];
    arguments.extend(more.iter().map(Into::into));
    let output = rosto(arguments);
    assert_eq!(code(&output), 0, "{}", said(&output));
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

pub fn triples(value: &Value) -> Vec<[f64; 3]> {
    let rows = value.as_array().unwrap().iter();
    rows.map(|row| [0, 1, 2].map(|axis| row[axis].as_f64().unwrap())).collect()
}
