//! A request of the page gives the same bytes as in the worker.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../../tests/page_request.rs"]
mod request;

use rosto::{BaseColour, EditsAs, FaceMesh, FileOptions, Format, Limits, SavedFace, decode};

#[test]
fn the_glb_of_a_request_has_the_workers_bytes() {
    let photo = decode(request::PICTURE, &Limits::default()).unwrap();
    let found = SavedFace { photos: vec![request::observation()], edits: None }.photos_json();
    let mut saved = SavedFace::from_json(&found, Some(request::EDITS)).unwrap();
    assert_eq!(saved.edits.as_ref().unwrap().to_json().unwrap(), request::EDITS);
    saved.photos[0].picture = Some(photo);
    let options =
        FileOptions { base_colour: BaseColour::Photo, edits: EditsAs::MorphTargets, ..FileOptions::default() };
    let glb = FaceMesh::reopen(saved).unwrap().write(Format::Glb, &options, "face").unwrap().bytes;
    assert_eq!(request::fnv1a(&glb), request::GLB_FNV1A, "{} bytes", glb.len());
}
