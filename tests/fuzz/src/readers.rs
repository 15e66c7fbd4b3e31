//! Rosto's readers, called in the same order as in Rosto, with assertions on their results.

use std::sync::LazyLock;

use rosto::PhotoEdit;
use rosto_export::{Reopened, SavedFace, reopen, sniff};
use rosto_face::{FaceModel, MAX_PICTURE_SIDE_PX};
use rosto_photo::{Limits, Photo, decode};
use rosto_studio::{Document, Rest, project};

use crate::seeds::{faces::canonical_rest, pictures::with_profile};

/// Smaller than the defaults, so that a reader that ignores them exceeds the memory limit.
const LIMITS: Limits = Limits { max_bytes: 40_000_000, max_pixels: 1 << 18 };

/// Decodes a photo and scales it down.
pub fn picture(bytes: &[u8]) -> bool {
    let decoded = decode(bytes, &LIMITS);
    match &decoded {
        Ok(photo) => assert_sound(photo),
        Err(error) => {
            assert!(!error.to_string().is_empty() && !error.hint().is_empty(), "an error without a message or hint")
        }
    }
    decoded.is_ok()
}

/// Decodes an intact JPEG that contains this colour profile.
pub fn profile(bytes: &[u8]) -> bool {
    assert!(picture(&with_profile(bytes)), "a damaged profile makes the picture unreadable");
    true
}

/// Reopens a GLB: face, texture and history.
pub fn glb(bytes: &[u8]) -> bool {
    reopen(bytes).is_ok_and(|opened| face(&opened))
}

/// Opens a project: face, picture and history.
pub fn project(bytes: &[u8]) -> bool {
    let _ = sniff(bytes);
    rosto_export::project::read(bytes).is_ok_and(|opened| face(&opened))
}

/// Replays a history on the canonical face.
pub fn edits(bytes: &[u8]) -> bool {
    static REST: LazyLock<Rest> = LazyLock::new(canonical_rest);
    std::str::from_utf8(bytes).is_ok_and(|text| history(text, REST.clone()))
}

fn face(opened: &Reopened) -> bool {
    let SavedFace { photos, edits } = &opened.face;
    assert!(photos.iter().all(|photo| photo.picture.as_ref().is_some_and(is_small)), "a photo without a small picture");
    let edits = edits.as_ref().expect("invariant: a file has edits");
    assert!(edits.density <= 4);
    let texts = (opened.face.photos_json(), edits.to_json().expect("invariant: the edits were read from JSON"));
    let again = SavedFace::from_json(&texts.0, Some(&texts.1)).map(|again| (again.photos_json(), again.edits));
    assert_eq!(again, Ok((texts.0, Some(edits.clone()))), "a face changes as texts");
    if let Some(photo_edit) = &edits.photo_edit
        && let Ok(photo_edit) = PhotoEdit::from_json(photo_edit)
    {
        assert_eq!(PhotoEdit::from_json(&photo_edit.to_json()), Ok(photo_edit));
    }
    let Ok(model) = FaceModel::from_photos(photos.clone(), edits.triangulation) else { return false };
    assert!(model.positions_m().iter().all(|position| position.is_finite()), "a face with an infinite position");
    edits.history.as_ref().is_none_or(|text| history(text, Rest::of_face(&model)))
}

fn is_small(picture: &Photo) -> bool {
    picture.width().max(picture.height()) <= MAX_PICTURE_SIDE_PX
}

fn history(text: &str, rest: Rest) -> bool {
    let Ok(entries) = project::from_json(text) else { return false };
    let again = project::from_json(&project::to_json(&entries));
    assert_eq!(again.as_ref(), Ok(&entries), "a history changes when it is written and read");
    let Ok(document) = Document::replay(rest, entries) else { return false };
    assert!(document.positions().iter().all(|position| position.is_finite()), "a history with an infinite position");
    true
}

fn assert_sound(photo: &Photo) {
    let pixels = u64::from(photo.width()) * u64::from(photo.height());
    assert_eq!(photo.pixels().len() as u64, pixels * 3, "a photo without three bytes for each pixel");
    assert!((1..=LIMITS.max_pixels).contains(&pixels), "a photo beyond its limit");
    assert!(photo.focal_length_35mm().is_none_or(|mm| (8.0..=400.0).contains(&mm)), "a focal length out of range");
    let small = photo.scaled_down(8);
    assert!(small.width().max(small.height()) <= 8, "a photo that was not scaled down");
}
