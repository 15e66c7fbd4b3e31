//! From the npm package to the two files, and what is refused on the way.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use proptest::prelude::*;
use rosto_model_import::{ImportError, import, onnx_from_tflite};
use support::package;

/// Where the detector lies in the packed assets.
const DETECTOR: std::ops::Range<usize> = 3_757_224..3_986_256;

#[test]
fn the_pair_of_networks_takes_no_more_than_one_and_a_half_megabytes() {
    let (loader_js, packed) = package();
    let networks = import(&loader_js, &packed).unwrap();
    assert!(networks.detector_onnx.len() + networks.landmarks_onnx.len() <= 1_500_000);
}

#[test]
fn the_same_package_gives_the_same_bytes() {
    let (loader_js, packed) = package();
    assert_eq!(import(&loader_js, &packed).unwrap(), import(&loader_js, &packed).unwrap());
}

#[test]
fn another_network_under_the_same_name_is_refused() {
    let (loader_js, mut packed) = package();
    packed[DETECTOR.start + 5000] ^= 1;
    let error = import(&loader_js, &packed).unwrap_err();
    assert!(matches!(error, ImportError::OtherFile { name, .. } if name == "face_detection_short_range.tflite"));
}

#[test]
fn assets_cut_short_are_refused_with_the_missing_bytes() {
    let (loader_js, packed) = package();
    let error = import(&loader_js, &packed[..DETECTOR.end - 1]).unwrap_err();
    assert!(matches!(error, ImportError::OutsidePackage { end, available, .. } if end == available + 1), "{error}");
}

#[test]
fn a_script_without_a_list_and_a_list_without_the_file_are_refused() {
    assert!(matches!(import("const x = 1;", &[]), Err(ImportError::NoFileList { .. })));
    assert!(matches!(import("loadPackage({\"files\": 3});", &[]), Err(ImportError::NoFileList { .. })));
    assert!(matches!(import("loadPackage({\"files\": []});", &[]), Err(ImportError::NoSuchFile { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Whatever the bytes, the answer is a file or an error.
    #[test]
    fn a_broken_tflite_file_never_panics(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..40),
        from_end in any::<bool>(),
        kept in any::<prop::sample::Index>(),
    ) {
        // The tables stand at the two ends of the file; the weights between them can hardly be wrong.
        const TABLES: usize = 20_000;
        let mut bytes = package().1[DETECTOR].to_vec();
        for (at, value) in changes {
            let at = at.index(TABLES);
            let length = bytes.len();
            bytes[if from_end { length - 1 - at } else { at }] = value;
        }
        let _ = onnx_from_tflite(&bytes);
        bytes.truncate(kept.index(bytes.len()));
        prop_assert!(onnx_from_tflite(&bytes).is_err());
    }
}
