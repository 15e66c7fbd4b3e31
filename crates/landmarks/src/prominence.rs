//! Which faces come first, and which are one and the same.

use crate::detection::Detection;
use crate::face::Face;
use crate::outline::Outline;
use crate::region_of_interest::PictureSize;

/// Two faces whose outlines share more than this (intersection over union) are one.
const MAX_OVERLAP: f32 = 0.3;

impl Face {
    /// Around all landmarks.
    pub(crate) fn outline(&self) -> Outline {
        Outline::around(self.landmarks.iter().map(|&[x, y, _]| [x, y]))
    }
}

impl Outline {
    /// Whether this is a face of which the other one shows the same or a part.
    fn covers(&self, other: &Self) -> bool {
        self.holds(other.centre()) || self.overlap(other) > MAX_OVERLAP
    }

    /// The longer side in px, down to half of it at the corners of the picture.
    fn prominence(&self, picture: PictureSize) -> f32 {
        let size = [picture.width, picture.height];
        let side = |axis: usize| (self.max[axis] - self.min[axis]) * size[axis];
        let aside = |axis: usize| (self.centre()[axis] - 0.5) * size[axis];
        let share = aside(0).hypot(aside(1)) / (size[0].hypot(size[1]) / 2.0);
        side(0).max(side(1)) * (1.0 - share.min(1.0) / 2.0)
    }
}

/// The most prominent first: large ones, and of those of one size, those near the middle.
pub(crate) fn sort<T>(all: &mut [T], picture: PictureSize, outline: impl Fn(&T) -> Outline) {
    all.sort_by(|a, b| outline(b).prominence(picture).total_cmp(&outline(a).prominence(picture)));
}

/// Whether a detection is one of the faces or a part of one.
pub(crate) fn is_among(detection: &Detection, faces: &[Face]) -> bool {
    faces.iter().any(|face| face.outline().covers(&detection.outline()))
}

/// The faces and another one, if there is one; of two that are the same the more certain one stays.
pub(crate) fn with(mut faces: Vec<Face>, face: Option<Face>) -> Vec<Face> {
    let Some(face) = face else { return faces };
    let outline = face.outline();
    let same = |other: &Face| other.outline().covers(&outline) || outline.covers(&other.outline());
    if faces.iter().all(|other| !same(other) || other.confidence < face.confidence) {
        faces.retain(|other| !same(other));
        faces.push(face);
    }
    faces
}
