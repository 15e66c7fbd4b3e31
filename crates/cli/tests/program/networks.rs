//! Missing and damaged networks.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use crate::common::*;
use crate::seeded::Seeded;

const NAMES: [&str; 2] = ["face_detector.onnx", "face_landmarks_attention.onnx"];

/// A folder with copies of these networks.
fn copies(folder: &str, names: &[&str]) -> PathBuf {
    let folder = scratch_folder(folder);
    for name in names {
        fs::copy(portrait().with_file_name(name), folder.join(name)).unwrap();
    }
    folder
}

fn landmarks(networks: &Path) -> Output {
    rosto([OsStr::new("landmarks"), portrait().as_os_str(), OsStr::new("--networks"), networks.as_os_str()])
}

#[test]
fn a_missing_network_is_named() {
    for (there, missing) in [(0, 1), (1, 0)] {
        let folder = copies("half-a-pair", &[NAMES[there]]);
        let path = folder.join(NAMES[missing]);
        assert_refused(&landmarks(&folder), 7, &[path.to_str().unwrap(), "network not found", "cargo xtask networks"]);
    }
}

/// A folder whose landmark network has 400 corrupted bytes in the weights of the coordinates. The file still parses,
/// and the network's confidence does not change.
fn with_flipped_weights(name: &str, seed: u64) -> PathBuf {
    let folder = copies(name, &NAMES);
    let path = folder.join(NAMES[1]);
    let mut network = fs::read(&path).unwrap();
    let last = |name: &[u8]| network.windows(name.len()).rposition(|bytes| bytes == name).unwrap();
    // The name is followed by a tag and a three-byte length; the next name is preceded by its tensor's header.
    let (start, end) = (last(b"conv2d_21/Kernel") + 20, last(b"conv2d_21/Bias") - 10);
    let mut random = Seeded::new(seed);
    for _ in 0..400 {
        network[start + random.below(end - start)] ^= 1 + random.below(255) as u8;
    }
    fs::write(path, network).unwrap();
    folder
}

#[test]
fn corrupted_weights_are_reported_as_a_damaged_network() {
    for seed in 1..=4 {
        let folder = with_flipped_weights("flipped-weights", seed);
        assert_refused(&landmarks(&folder), 7, &["cargo xtask networks"]);
        let output = scratch("flipped.json");
        let networks = ["--networks", folder.to_str().unwrap()];
        assert_refused(&mesh(&portrait(), &output, &networks), 7, &["cargo xtask networks"]);
        assert!(!output.exists());
    }
}

#[test]
fn damaged_networks_are_reported_before_photos_are_read() {
    let folder = with_flipped_weights("flipped-for-a-batch", 1);
    let photos = [scratch("nowhere-at-all.png"), portrait()];
    let run = rosto(["landmarks".into(), "--networks".into(), folder].into_iter().chain(photos));
    assert_refused(&run, 7, &["the landmark network is damaged", "cargo xtask networks"]);
    assert!(!String::from_utf8_lossy(&run.stderr).contains("nowhere-at-all.png"));
}
