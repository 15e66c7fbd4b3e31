/// An axis-aligned box, normalised to the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Outline {
    /// Left and top.
    pub(crate) min: [f32; 2],
    /// Right and bottom.
    pub(crate) max: [f32; 2],
}

impl Outline {
    /// The bounding box of the points.
    pub(crate) fn around(points: impl IntoIterator<Item = [f32; 2]>) -> Self {
        let nothing = Self { min: [f32::INFINITY; 2], max: [f32::NEG_INFINITY; 2] };
        points.into_iter().fold(nothing, |Self { min, max }, point| Self {
            min: [0, 1].map(|axis| f32::min(min[axis], point[axis])),
            max: [0, 1].map(|axis| f32::max(max[axis], point[axis])),
        })
    }

    pub(crate) fn centre(&self) -> [f32; 2] {
        [0, 1].map(|axis| (self.min[axis] + self.max[axis]) / 2.0)
    }

    pub(crate) fn contains(&self, [x, y]: [f32; 2]) -> bool {
        (self.min[0]..=self.max[0]).contains(&x) && (self.min[1]..=self.max[1]).contains(&y)
    }

    /// Intersection over union; 0 if neither box has an area.
    pub(crate) fn overlap(&self, other: &Self) -> f32 {
        let area = |[width, height]: [f32; 2]| width.max(0.0) * height.max(0.0);
        let extent = |outline: &Self| [0, 1].map(|axis| outline.max[axis] - outline.min[axis]);
        let shared = area([0, 1].map(|axis| self.max[axis].min(other.max[axis]) - self.min[axis].max(other.min[axis])));
        let either = area(extent(self)) + area(extent(other)) - shared;
        if either > 0.0 { shared / either } else { 0.0 }
    }
}
