//! Damaged network files give finite output or an error.

use crate::support::assets;
use crate::support::seeded::Seeded;
use rosto_landmarks::{Face, FaceFinder, FindOptions, LandmarkNetwork, LandmarksError};

/// Overwrites 400 bytes of the weights with random ones.
fn flipped(mut onnx: Vec<u8>, seeded: &mut Seeded) -> Vec<u8> {
    for _ in 0..400 {
        let at = onnx.len() / 4 + seeded.below(onnx.len() / 2);
        onnx[at] = seeded.bits() as u8;
    }
    onnx
}

fn faces(detector: &[u8], landmarks: &[u8]) -> Result<Vec<Face>, LandmarksError> {
    let finder = FaceFinder::new(detector, LandmarkNetwork::Plain(landmarks))?;
    let mut faces = finder.find(&assets::portrait(), &FindOptions::mediapipe())?;
    faces.extend(finder.find(&assets::portrait(), &FindOptions { max_faces: 3, ..FindOptions::default() })?);
    Ok(faces)
}

#[test]
fn a_network_with_changed_bytes_is_rejected_or_gives_finite_output() {
    let (detector, landmarks) = (assets::detector_onnx(), assets::landmarks_onnx());
    let mut refused = 0;
    for seed in 0..6 {
        let mut seeded = Seeded::new(seed);
        let found = match seed % 2 {
            0 => faces(&flipped(detector.clone(), &mut seeded), &landmarks),
            _ => faces(&detector, &flipped(landmarks.clone(), &mut seeded)),
        };
        match found {
            Ok(faces) => {
                let numbers = faces.iter().flat_map(|face| face.landmarks.as_flattened());
                assert!(numbers.into_iter().all(|number| number.is_finite()), "seed {seed}");
                assert!(faces.iter().all(|face| face.confidence.is_finite() && face.score.is_finite()), "seed {seed}");
            }
            Err(LandmarksError::NetworkDamaged { .. }) => refused += 1,
            Err(other) => panic!("seed {seed}: {other}"),
        }
    }
    assert!(refused >= 3, "only {refused} of 6 were refused");
}

#[test]
fn a_non_finite_weight_is_reported_on_loading() {
    let mut landmarks = assets::landmarks_onnx();
    let at = landmarks.len() / 2;
    // In either byte alignment, one of the two half-precision numbers becomes infinite or NaN.
    landmarks[at..at + 4].fill(0x7C);
    let error = FaceFinder::new(&assets::detector_onnx(), LandmarkNetwork::Plain(&landmarks)).err().unwrap();
    let LandmarksError::NetworkDamaged { network, reason } = error else { panic!("{error}") };
    assert_eq!(network, "landmark");
    assert!(reason.contains("weight"), "{reason}");
}

#[test]
fn a_network_with_a_misspelt_output_name_is_rejected() {
    let (detector, landmarks) = (assets::detector_onnx(), assets::landmarks_onnx());
    // The output name in the node that produces it: field 2 of a node, 9 letters.
    let output = b"\x12\x09conv2d_31";
    let at = landmarks.windows(output.len()).position(|window| window == output).unwrap();
    let mut renamed = landmarks;
    renamed[at + 5] = b'w';
    let error = FaceFinder::new(&detector, LandmarkNetwork::Plain(&renamed)).err().unwrap();
    let LandmarksError::NetworkDamaged { network, reason } = error else { panic!("{error}") };
    assert_eq!(network, "landmark");
    assert!(reason.contains("conv2d_31"), "{reason}");
}
