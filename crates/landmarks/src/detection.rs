use crate::outline::Outline;
use crate::region_of_interest::{PictureSize, RegionOfInterest};

/// A detected face. Positions are normalised to the searched region or to the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Detection {
    /// Score, 0..1.
    pub(crate) score: f32,
    /// Left and top.
    pub(crate) min: [f32; 2],
    /// Right and bottom.
    pub(crate) max: [f32; 2],
    /// Eye on the picture's left, other eye, nose, mouth, ears.
    pub(crate) keypoints: [[f32; 2]; 6],
}

impl Detection {
    /// The region for the landmark network, rotated so that the eyes are level.
    pub(crate) fn face_region(&self, picture: PictureSize) -> RegionOfInterest {
        RegionOfInterest::around(self.outline(), [self.keypoints[0], self.keypoints[1]], picture)
    }

    pub(crate) fn outline(&self) -> Outline {
        Outline { min: self.min, max: self.max }
    }

    /// Applies an affine map. The box becomes the bounding box of its mapped corners.
    pub(crate) fn mapped(&self, matrix: &[[f32; 3]; 2]) -> Self {
        let map = |[x, y]: [f32; 2]| matrix.map(|row| x * row[0] + y * row[1] + row[2]);
        let ([left, top], [right, bottom]) = (self.min, self.max);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let Outline { min, max } = Outline::around(corners.map(map));
        Self { score: self.score, min, max, keypoints: self.keypoints.map(map) }
    }
}
