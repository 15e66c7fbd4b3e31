//! Order of faces, and detection of duplicates.

use crate::detection::Detection;
use crate::face::Face;
use crate::outline::Outline;
use crate::region_of_interest::PictureSize;

/// Intersection over union above which two outlines belong to one face.
const MAX_OVERLAP: f32 = 0.3;

impl Face {
    /// The bounding box of the landmarks.
    pub(crate) fn outline(&self) -> Outline {
        Outline::around(self.landmarks.iter().map(|&[x, y, _]| [x, y]))
    }
}

impl Outline {
    /// Whether `other` shows this face or a part of it.
    fn covers(&self, other: &Self) -> bool {
        self.contains(other.centre()) || self.overlap(other) > MAX_OVERLAP
    }

    /// The longer side in px, reduced by up to half towards the corners of the picture.
    fn prominence(&self, picture: PictureSize) -> f32 {
        let size = [picture.width, picture.height];
        let side = |axis: usize| (self.max[axis] - self.min[axis]) * size[axis];
        let offset = |axis: usize| (self.centre()[axis] - 0.5) * size[axis];
        let share = offset(0).hypot(offset(1)) / (size[0].hypot(size[1]) / 2.0);
        side(0).max(side(1)) * (1.0 - share.min(1.0) / 2.0)
    }
}

/// Sorts by prominence, highest first: large faces, and near the centre among equal sizes.
pub(crate) fn sort<T>(all: &mut [T], picture: PictureSize, outline: impl Fn(&T) -> Outline) {
    all.sort_by(|a, b| outline(b).prominence(picture).total_cmp(&outline(a).prominence(picture)));
}

/// Whether a detection shows one of the faces or a part of one.
pub(crate) fn is_known(detection: &Detection, faces: &[Face]) -> bool {
    faces.iter().any(|face| face.outline().covers(&detection.outline()))
}

/// Adds a face, if any, and retains the duplicate with the highest confidence.
pub(crate) fn add(mut faces: Vec<Face>, face: Option<Face>) -> Vec<Face> {
    let Some(face) = face else { return faces };
    let outline = face.outline();
    let same = |other: &Face| other.outline().covers(&outline) || outline.covers(&other.outline());
    if faces.iter().all(|other| !same(other) || other.confidence < face.confidence) {
        faces.retain(|other| !same(other));
        faces.push(face);
    }
    faces
}
