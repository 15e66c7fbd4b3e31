//! Remarks on the sample portrait, as the networks find its face.

use crate::pictures;
use std::path::Path;

use rosto::{FaceFinder, FindOptions, LandmarkNetwork, Limits, Photo, PhotoRemark, decode};

fn asset(name: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets").join(name)).unwrap()
}

fn remarks(photo: &Photo) -> Vec<PhotoRemark> {
    let landmarks = asset("face_landmarks_attention.onnx");
    let finder = FaceFinder::new(&asset("face_detector.onnx"), LandmarkNetwork::Attention(&landmarks)).unwrap();
    let options = FindOptions { max_faces: 1, ..FindOptions::default() };
    PhotoRemark::of(photo, &finder.find(photo, &options).unwrap()[0])
}

#[test]
fn doubtful_and_small_faces_have_remarks_the_doubt_first() {
    let photo = decode(&asset("sample.png"), &Limits::default()).unwrap();
    assert_eq!(remarks(&photo), []);
    let [PhotoRemark::TinyFace { width_px }] = remarks(&pictures::scaled(&photo, 160, 160))[..] else { panic!() };
    let [PhotoRemark::TinyFace { width_px: double_px }] = remarks(&pictures::scaled(&photo, 320, 320))[..] else {
        panic!()
    };
    assert!(double_px.abs_diff(2 * width_px) <= 3, "{width_px} and {double_px} px");
    let small = pictures::scaled(&pictures::blurred(&photo, 3), 300, 300);
    assert!(matches!(remarks(&small)[..], [PhotoRemark::MayNotBeAFace { .. }, PhotoRemark::TinyFace { .. }]));
}
