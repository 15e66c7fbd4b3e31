//! Conversion of the npm package, and rejection of damaged input.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use proptest::prelude::*;
use rosto_model_import::{ImportError, import, onnx_from_tflite};
use support::package;

/// Byte range of the detector in the packed assets.
const DETECTOR: std::ops::Range<usize> = 3_757_224..3_986_256;

#[test]
fn detector_and_landmarks_fit_in_1_5_megabytes() {
    let (loader_js, packed) = package();
    let networks = import(&loader_js, &packed).unwrap();
    assert!(networks.detector_onnx.len() + networks.landmarks_onnx.len() <= 1_500_000);
}

#[test]
fn conversion_is_deterministic() {
    let (loader_js, packed) = package();
    assert_eq!(import(&loader_js, &packed).unwrap(), import(&loader_js, &packed).unwrap());
}

#[test]
fn a_modified_network_is_rejected() {
    let (loader_js, mut packed) = package();
    packed[DETECTOR.start + 5000] ^= 1;
    let error = import(&loader_js, &packed).unwrap_err();
    assert!(matches!(error, ImportError::OtherFile { name, .. } if name == "face_detection_short_range.tflite"));
}

#[test]
fn truncated_assets_are_rejected_with_their_length() {
    let (loader_js, packed) = package();
    let error = import(&loader_js, &packed[..DETECTOR.end - 1]).unwrap_err();
    assert!(matches!(error, ImportError::OutsidePackage { end, available, .. } if end == available + 1), "{error}");
}

#[test]
fn a_missing_list_or_file_is_rejected() {
    assert!(matches!(import("const x = 1;", &[]), Err(ImportError::NoFileList { .. })));
    assert!(matches!(import("loadPackage({\"files\": 3});", &[]), Err(ImportError::NoFileList { .. })));
    assert!(matches!(import("loadPackage({\"files\": []});", &[]), Err(ImportError::NoSuchFile { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Damaged bytes give a file or an error.
    #[test]
    fn a_damaged_tflite_file_does_not_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..40),
        from_end in any::<bool>(),
        truncated_length in any::<prop::sample::Index>(),
    ) {
        // The tables are at both ends of the file; changing the weights between them cannot cause an error.
        const TABLES: usize = 20_000;
        let mut bytes = package().1[DETECTOR].to_vec();
        for (at, value) in changes {
            let at = at.index(TABLES);
            let length = bytes.len();
            bytes[if from_end { length - 1 - at } else { at }] = value;
        }
        let _ = onnx_from_tflite(&bytes);
        bytes.truncate(truncated_length.index(bytes.len()));
        prop_assert!(onnx_from_tflite(&bytes).is_err());
    }
}
