use super::one_euro::OneEuro;
use crate::region_of_interest::PictureSize;

/// One filter per landmark coordinate.
#[derive(Debug, Clone)]
pub(super) struct Smoother {
    filters: Vec<[OneEuro; 3]>,
}

/// Lower bound on a face's size, to avoid division by zero.
const MIN_SIZE_PX: f64 = 1e-6;

impl Smoother {
    /// Starts from the landmarks (x/W, y/H, z/W) of the first frame.
    pub(super) fn new(landmarks: &[[f32; 3]], picture: PictureSize) -> Self {
        let filters = in_px(landmarks, px_per(picture)).map(|landmark| landmark.map(OneEuro::new)).collect();
        Self { filters }
    }

    /// Smooths the landmarks in px, `elapsed_s` after the previous ones.
    pub(super) fn next(&mut self, landmarks: &[[f32; 3]], picture: PictureSize, elapsed_s: f64) -> Vec<[f32; 3]> {
        let px = px_per(picture);
        let per_px = 1.0 / size_px(landmarks, px).max(MIN_SIZE_PX);
        let raw = in_px(landmarks, px);
        let next = |(filters, raw): (&mut [OneEuro; 3], [f64; 3])| {
            [0, 1, 2].map(|axis| (filters[axis].next(raw[axis], elapsed_s, per_px) / px[axis]) as f32)
        };
        self.filters.iter_mut().zip(raw).map(next).collect()
    }
}

/// The px per unit of x, y and z.
fn px_per(picture: PictureSize) -> [f64; 3] {
    [picture.width, picture.height, picture.width].map(f64::from)
}

fn in_px(landmarks: &[[f32; 3]], px: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    landmarks.iter().map(move |landmark| [0, 1, 2].map(|axis| f64::from(landmark[axis]) * px[axis]))
}

/// The mean of the width and height of the landmarks' bounding box.
fn size_px(landmarks: &[[f32; 3]], px: [f64; 3]) -> f64 {
    let along = |axis: usize| landmarks.iter().map(move |landmark| f64::from(landmark[axis]));
    let extent = |axis: usize| {
        (along(axis).fold(f64::NEG_INFINITY, f64::max) - along(axis).fold(f64::INFINITY, f64::min)) * px[axis]
    };
    (extent(0) + extent(1)) / 2.0
}
