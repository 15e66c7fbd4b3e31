use crate::outline::Outline;
use crate::region_of_interest::{PictureSize, RegionOfInterest};

/// A face as the detector sees it. Positions are normalised: to the region it was looked for in, or to the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Detection {
    /// In 0..1.
    pub(crate) score: f32,
    /// Left and top.
    pub(crate) min: [f32; 2],
    /// Right and bottom.
    pub(crate) max: [f32; 2],
    /// The eye on the picture's left, the other eye, nose, mouth, and the ears.
    pub(crate) keypoints: [[f32; 2]; 6],
}

impl Detection {
    /// The square to look for landmarks in, turned so that the line between the eyes is level.
    pub(crate) fn face_region(&self, picture: PictureSize) -> RegionOfInterest {
        RegionOfInterest::around(self.outline(), [self.keypoints[0], self.keypoints[1]], picture)
    }

    pub(crate) fn outline(&self) -> Outline {
        Outline { min: self.min, max: self.max }
    }

    /// The same in other coordinates; of a box that gets turned, the box around it.
    pub(crate) fn mapped(&self, matrix: &[[f32; 3]; 2]) -> Self {
        let map = |[x, y]: [f32; 2]| matrix.map(|row| x * row[0] + y * row[1] + row[2]);
        let ([left, top], [right, bottom]) = (self.min, self.max);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let Outline { min, max } = Outline::around(corners.map(map));
        Self { score: self.score, min, max, keypoints: self.keypoints.map(map) }
    }
}
