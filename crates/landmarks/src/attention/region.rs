use super::parts::Part;
use crate::outline::Outline;
use crate::raw_mesh::SIDE;

/// Channels of the feature map.
pub(crate) const FEATURE_CHANNELS: usize = 32;
/// Rows and columns of the feature map: one for every four px of the picture.
pub(crate) const FEATURE_SIDE: usize = 48;
/// Rows and columns of a head's crop.
pub(crate) const CROP_SIDE: usize = 16;

/// Size of a feature map cell in px of the picture.
const PX_PER_FEATURE: f32 = (SIDE / FEATURE_SIDE) as f32;
/// Scale of the crop relative to the points' bounding box.
const ENLARGEMENT: f32 = 1.5;

/// A rotated rectangle of the feature map, as the affine map from a head's crop (0..16) to the feature map (0..48): two
/// rows `[per x, per y, constant]`.
pub(crate) struct FeatureRegion {
    features_from_crop: [[f32; 3]; 2],
}

impl FeatureRegion {
    /// Returns the enlarged bounding box of a part, rotated so that its ends are level. `points` are in px of the
    /// picture.
    pub(crate) fn around(part: &Part, points: &[[f32; 3]]) -> Self {
        let at = |index: u16| [0, 1].map(|axis| points[usize::from(index)][axis] / PX_PER_FEATURE);
        let [left, right] = part.ends.map(at);
        let rotation_rad = (right[1] - left[1]).atan2(right[0] - left[0]);
        let (sin, cos) = rotation_rad.sin_cos();
        let levelled = part.points.iter().map(|&index| at(index)).map(|[x, y]| [x * cos + y * sin, y * cos - x * sin]);
        let Outline { min, max } = Outline::around(levelled);
        let [x, y] = [0, 1].map(|axis| (min[axis] + max[axis]) / 2.0);
        let centre = [x * cos - y * sin, x * sin + y * cos];
        let [wide, high] = [0, 1].map(|axis| (max[axis] - min[axis]) * ENLARGEMENT / CROP_SIDE as f32);
        let rows = [[cos * wide, -sin * high], [sin * wide, cos * high]];
        let middle = CROP_SIDE as f32 / 2.0;
        let row = |axis: usize| {
            let [per_x, per_y] = rows[axis];
            [per_x, per_y, centre[axis] - middle * (per_x + per_y)]
        };
        Self { features_from_crop: [row(0), row(1)] }
    }

    /// Writes a head's input, plane by plane: bilinear between the cell centres, 0 beyond the outermost ones.
    pub(crate) fn cut(&self, features: &[f32], crop: &mut [f32]) {
        let taps: [Option<Taps>; CROP_SIDE * CROP_SIDE] = std::array::from_fn(|index| {
            let [x, y] = [index % CROP_SIDE, index / CROP_SIDE].map(|at| at as f32 + 0.5);
            let [x, y] = self.features_from_crop.map(|[per_x, per_y, constant]| per_x * x + per_y * y + constant - 0.5);
            Taps::at(x, y)
        });
        let planes = features.chunks_exact(FEATURE_SIDE * FEATURE_SIDE);
        for (plane, crop) in planes.zip(crop.chunks_exact_mut(CROP_SIDE * CROP_SIDE)) {
            for (value, taps) in crop.iter_mut().zip(&taps) {
                *value = taps.as_ref().map_or(0.0, |taps| taps.bilinear(plane));
            }
        }
    }

    /// Maps a head's output, pairs in units of a quarter of a crop cell, to px of the picture.
    pub(crate) fn in_picture(&self, answer: &[f32]) -> impl Iterator<Item = [f32; 2]> {
        let pairs = answer.as_chunks::<2>().0.iter();
        pairs.map(|&[x, y]| {
            self.features_from_crop.map(|[per_x, per_y, constant]| per_x * x + per_y * y + constant * PX_PER_FEATURE)
        })
    }
}

/// The cells around a position of the feature map, and the position between them.
struct Taps {
    /// Indices of the top left, top right, bottom left and bottom right cell.
    cells: [usize; 4],
    fraction: [f32; 2],
}

impl Taps {
    /// `None` beyond the centres of the outermost cells.
    fn at(x: f32, y: f32) -> Option<Self> {
        const LAST: usize = FEATURE_SIDE - 1;
        let inside = 0.0..=LAST as f32;
        if !inside.contains(&x) || !inside.contains(&y) {
            return None;
        }
        let (left, top) = (x as usize, y as usize);
        let cell = |row: usize, column: usize| row.min(LAST) * FEATURE_SIDE + column.min(LAST);
        let cells = [cell(top, left), cell(top, left + 1), cell(top + 1, left), cell(top + 1, left + 1)];
        Some(Self { cells, fraction: [x - left as f32, y - top as f32] })
    }

    fn bilinear(&self, plane: &[f32]) -> f32 {
        let [fx, fy] = self.fraction;
        let [top_left, top_right, bottom_left, bottom_right] = self.cells.map(|cell| plane[cell]);
        let row = |left: f32, right: f32| (1.0 - fx) * left + fx * right;
        (1.0 - fy) * row(top_left, top_right) + fy * row(bottom_left, bottom_right)
    }
}

#[cfg(test)]
mod tests {
    use super::super::parts::{LEFT_EYE, LIPS, RIGHT_EYE};
    use super::*;
    use crate::LANDMARK_COUNT;

    /// Deterministic points spread over a picture.
    fn points() -> Vec<[f32; 3]> {
        (0..LANDMARK_COUNT)
            .map(|i| [5.0 + (i * 37 % 101) as f32 * 1.6, 9.0 + (i * 53 % 89) as f32 * 1.8, 0.0])
            .collect()
    }

    #[test]
    fn a_region_translates_with_its_points() {
        for part in [&LIPS, &RIGHT_EYE, &LEFT_EYE] {
            let shifted: Vec<_> = points().iter().map(|&[x, y, z]| [x + 8.0, y - 4.0, z]).collect();
            let (here, there) = (FeatureRegion::around(part, &points()), FeatureRegion::around(part, &shifted));
            for (answer, by) in [([3.0, 60.0], [8.0, -4.0]), ([30.0, 1.0], [8.0, -4.0])] {
                let moved: Vec<_> = here.in_picture(&answer).zip(there.in_picture(&answer)).collect();
                let [(from, to)] = moved[..] else { panic!("one pair in, {} out", moved.len()) };
                assert!((0..2).all(|axis| (to[axis] - from[axis] - by[axis]).abs() < 1e-3), "{from:?} {to:?}");
            }
        }
    }

    #[test]
    fn cropping_a_feature_map_of_positions_gives_the_regions_positions() {
        let middle = |at: usize| at as f32 + 0.5;
        let plane = |value: fn(usize) -> usize| (0..FEATURE_SIDE * FEATURE_SIDE).map(move |index| middle(value(index)));
        let features: Vec<f32> =
            plane(|index| index % FEATURE_SIDE).chain(plane(|index| index / FEATURE_SIDE)).collect();
        let region = FeatureRegion::around(&LIPS, &points());
        let mut crop = vec![0.0; 2 * CROP_SIDE * CROP_SIDE];
        region.cut(&features, &mut crop);
        let (xs, ys) = crop.split_at(CROP_SIDE * CROP_SIDE);
        let mut inside = 0;
        for (index, (&x, &y)) in xs.iter().zip(ys).enumerate() {
            let [u, v] = [middle(index % CROP_SIDE), middle(index / CROP_SIDE)];
            let expected = region.features_from_crop.map(|[per_x, per_y, constant]| per_x * u + per_y * v + constant);
            let is_inside = expected.iter().all(|at| (0.5..=FEATURE_SIDE as f32 - 0.5).contains(at));
            inside += usize::from(is_inside);
            let expected = if is_inside { expected } else { [0.0; 2] };
            assert!((x - expected[0]).abs() < 1e-3 && (y - expected[1]).abs() < 1e-3, "{index}: {x} {y} {expected:?}");
        }
        assert!(inside > 50 && inside < CROP_SIDE * CROP_SIDE, "{inside} of the crop are inside");
    }
}
