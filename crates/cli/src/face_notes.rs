//! Messages about the faces found in a photo.

use std::path::Path;

use rosto::{PhotoRemark, Region};
use rosto_landmarks::{Face, FoundFaces};
use rosto_photo::Photo;

/// Notes on a photo whose first face is used; empty if it has one face without remarks.
pub fn notes_on_first(path: &Path, photo: &Photo, found: &FoundFaces) -> Vec<String> {
    let Some(first) = found.faces.first() else { return Vec::new() };
    let count = (found.at_least > 1).then(|| {
        let [left, top, width, height] = bounds_px(first, photo);
        let (path, count, confidence) = (path.display(), counted(found), first.confidence);
        format!(
            "{path}: {count}; used the first, {width:.0} × {height:.0} px at ({left:.0}, {top:.0}), confidence {confidence:.2}"
        )
    });
    count.into_iter().chain(remarks(path, "this face", photo, first)).collect()
}

/// Notes on a photo whose faces are all used: faces beyond the limit, and remarks.
pub fn notes_on_all(path: &Path, photo: &Photo, found: &FoundFaces) -> Vec<String> {
    let count = found.faces.len();
    // A limit of one is intended, so it needs no note.
    let cut = (count > 1 && found.at_least > count).then(|| {
        format!("{}: {count} of {} or more faces returned; raise --max-faces", path.display(), found.at_least)
    });
    let numbered = found.faces.iter().zip(1..);
    let remarks = numbered.flat_map(|(face, number)| remarks(path, &format!("face {number}"), photo, face));
    cut.into_iter().chain(remarks).collect()
}

fn counted(found: &FoundFaces) -> String {
    let more = if found.at_least > found.faces.len() { " or more" } else { "" };
    format!("{}{more} faces found", found.at_least)
}

fn remarks(path: &Path, name: &str, photo: &Photo, face: &Face) -> Vec<String> {
    let remarks = PhotoRemark::of(photo, face).into_iter();
    remarks.map(|remark| format!("{}: {name} {}", path.display(), text(remark))).collect()
}

fn text(remark: PhotoRemark) -> String {
    match remark {
        PhotoRemark::MayNotBeAFace { quality } => format!("may not be a face (quality {quality:.2})"),
        PhotoRemark::TinyFace { width_px } => format!("is only {width_px} px wide: it will look soft"),
        PhotoRemark::CoveredCheek { cheek } => {
            let side = if cheek == Region::LeftCheek { "left" } else { "right" };
            format!("has a {side} cheek that seems to be covered: its shape and colour are guessed")
        }
    }
}

/// Left, top, width and height of the landmarks' bounding box.
fn bounds_px(face: &Face, photo: &Photo) -> [f32; 4] {
    let sides = [photo.width() as f32, photo.height() as f32];
    let along = |axis: usize| face.landmarks.iter().map(move |place| place[axis] * sides[axis]);
    let min = [0, 1].map(|axis| along(axis).fold(f32::INFINITY, f32::min));
    let max = [0, 1].map(|axis| along(axis).fold(f32::NEG_INFINITY, f32::max));
    [min[0], min[1], max[0] - min[0], max[1] - min[1]]
}
