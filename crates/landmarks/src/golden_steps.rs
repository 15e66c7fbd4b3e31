//! Comparison of each stage with the tensors of MediaPipe's graph, on the portrait.

use rosto_photo::Photo;
use sha2::{Digest, Sha256};

use crate::assets;
use crate::detector::Detector;
use crate::mesh::{LandmarkNetwork, MeshNetwork, region_of};
use crate::raw_mesh::RawMesh;
use crate::region_of_interest::{PictureSize, RegionOfInterest, RegionPx};
use crate::warp::{self, Outside};

const PORTRAIT: PictureSize = PictureSize { width: 512.0, height: 512.0 };
const FACE_REGION: RegionOfInterest =
    RegionOfInterest { centre: [0.439_916_9, 0.254_967_36], size: [0.279_328_8, 0.279_328_8], rotation_rad: 0.094_389 };
const REGION_FROM_LANDMARKS: RegionOfInterest = RegionOfInterest {
    centre: [0.439_605_77, 0.241_679_16],
    size: [0.303_203_05, 0.303_203_05],
    rotation_rad: 0.050_527_338,
};
/// Tolerance on raw outputs, whose magnitude is up to 170.
const TOLERANCE: f32 = 2e-4;

fn golden(bytes: &[u8]) -> Vec<f32> {
    bytes.as_chunks::<4>().0.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect()
}

fn largest_difference(found: &[f32], golden: &[f32]) -> f32 {
    assert_eq!(found.len(), golden.len());
    found.iter().zip(golden).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// SHA-256 of a warped region as interleaved RGB bytes.
fn crop_sha256(portrait: &Photo, region: &RegionPx, side: usize, outside: Outside) -> String {
    let mut planes = vec![0.0; side * side * 3];
    warp::fill_planes(&mut planes, portrait, region, outside, [1.0, 0.0]);
    let value = |index: usize| planes[(index % 3) * side * side + index / 3] as u8;
    let bytes: Vec<u8> = (0..planes.len()).map(value).collect();
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn assert_same_region(found: &RegionOfInterest, expected: &RegionOfInterest) {
    let numbers = |r: &RegionOfInterest| [r.centre[0], r.centre[1], r.size[0], r.size[1], r.rotation_rad];
    assert!(largest_difference(&numbers(found), &numbers(expected)) < 1e-5, "{found:?}, expected {expected:?}");
}

#[test]
fn the_detectors_input_equals_mediapipes_bit_for_bit() {
    let sha256 = crop_sha256(&assets::portrait(), &RegionPx::whole(PORTRAIT), 128, Outside::Zero);
    assert_eq!(sha256, "c02cec35dbda5ce044a528ff1d79a4cd26e4565e702a9a2821df375837359f57");
}

#[test]
fn the_landmark_networks_input_equals_mediapipes_bit_for_bit() {
    let sha256 = crop_sha256(&assets::portrait(), &FACE_REGION.px(PORTRAIT), 192, Outside::NearestEdge);
    assert_eq!(sha256, "de740ec56f59ccc9dbc58fd771cb20997ba5cad98414e367f3fb2d68085bfb5b");
}

#[test]
fn the_detectors_raw_outputs_match_mediapipes() {
    let detector = Detector::new(&assets::detector_onnx()).unwrap();
    let [boxes, logits] = detector.raw(&assets::portrait(), &RegionPx::whole(PORTRAIT)).unwrap();
    let golden_boxes = golden(include_bytes!("../../../tests/golden/stages/detector_boxes_896x16.f32"));
    let golden_logits = golden(include_bytes!("../../../tests/golden/stages/detector_logits_896.f32"));
    let errors = [largest_difference(&boxes, &golden_boxes), largest_difference(&logits, &golden_logits)];
    assert!(errors.iter().all(|&error| error < TOLERANCE), "{errors:?}");
}

#[test]
fn the_landmark_networks_raw_outputs_match_mediapipes() {
    let network = MeshNetwork::new(LandmarkNetwork::Plain(&assets::landmarks_onnx())).unwrap();
    let RawMesh { points, flag } = network.raw(&assets::portrait(), &FACE_REGION).unwrap();
    let golden_points = golden(include_bytes!("../../../tests/golden/stages/mesh_points_468x3.f32"));
    let golden_flag = golden(include_bytes!("../../../tests/golden/stages/mesh_flag_logit_1.f32"));
    let errors = [largest_difference(points.as_flattened(), &golden_points), largest_difference(&[flag], &golden_flag)];
    assert!(errors.iter().all(|&error| error < TOLERANCE), "{errors:?}");
}

#[test]
fn the_face_region_matches_mediapipes() {
    let detector = Detector::new(&assets::detector_onnx()).unwrap();
    let found = detector.detect(&assets::portrait(), &RegionPx::whole(PORTRAIT)).unwrap();
    assert_same_region(&found[0].face_region(PORTRAIT), &FACE_REGION);
}

#[test]
fn the_region_from_landmarks_matches_mediapipes() {
    let network = MeshNetwork::new(LandmarkNetwork::Plain(&assets::landmarks_onnx())).unwrap();
    let mesh = network.look(&assets::portrait(), &FACE_REGION).unwrap();
    assert_same_region(&region_of(&mesh.landmarks, PORTRAIT), &REGION_FROM_LANDMARKS);
}
