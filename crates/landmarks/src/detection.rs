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
        let size = [0, 1].map(|axis| self.max[axis] - self.min[axis]);
        let centre = [0, 1].map(|axis| self.min[axis] + size[axis] / 2.0);
        RegionOfInterest::around(centre, size, [self.keypoints[0], self.keypoints[1]], picture)
    }

    /// The same in other coordinates; of a box that gets turned, the box around it.
    pub(crate) fn mapped(&self, matrix: &[[f32; 3]; 2]) -> Self {
        let map = |[x, y]: [f32; 2]| matrix.map(|row| x * row[0] + y * row[1] + row[2]);
        let ([left, top], [right, bottom]) = (self.min, self.max);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]].map(map);
        let extreme = |pick: fn(f32, f32) -> f32| {
            [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).fold(corners[0][axis], pick))
        };
        Self { score: self.score, min: extreme(f32::min), max: extreme(f32::max), keypoints: self.keypoints.map(map) }
    }
}
