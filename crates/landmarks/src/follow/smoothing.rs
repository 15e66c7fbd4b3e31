use super::one_euro::OneEuro;
use crate::region_of_interest::PictureSize;

/// A filter for every number of a face's landmarks.
#[derive(Debug, Clone)]
pub(super) struct Smoother {
    filters: Vec<[OneEuro; 3]>,
}

/// A face of no size has no speed to speak of.
const SMALLEST_PX: f64 = 1e-6;

impl Smoother {
    /// From the landmarks (x/W, y/H, z/W) of a first frame.
    pub(super) fn new(landmarks: &[[f32; 3]], picture: PictureSize) -> Self {
        let filters = in_px(landmarks, px_per(picture)).map(|landmark| landmark.map(OneEuro::new)).collect();
        Self { filters }
    }

    /// As many landmarks, `elapsed_s` after the last ones, smoothed in px.
    pub(super) fn next(&mut self, landmarks: &[[f32; 3]], picture: PictureSize, elapsed_s: f64) -> Vec<[f32; 3]> {
        let px = px_per(picture);
        let per_px = 1.0 / size_px(landmarks, px).max(SMALLEST_PX);
        let raw = in_px(landmarks, px);
        let next = |(filters, raw): (&mut [OneEuro; 3], [f64; 3])| {
            [0, 1, 2].map(|axis| (filters[axis].next(raw[axis], elapsed_s, per_px) / px[axis]) as f32)
        };
        self.filters.iter_mut().zip(raw).map(next).collect()
    }
}

/// What x, y and z are in units of.
fn px_per(picture: PictureSize) -> [f64; 3] {
    [picture.width, picture.height, picture.width].map(f64::from)
}

fn in_px(landmarks: &[[f32; 3]], px: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    landmarks.iter().map(move |landmark| [0, 1, 2].map(|axis| f64::from(landmark[axis]) * px[axis]))
}

/// The mean of width and height of the landmarks' box.
fn size_px(landmarks: &[[f32; 3]], px: [f64; 3]) -> f64 {
    let along = |axis: usize| landmarks.iter().map(move |landmark| f64::from(landmark[axis]));
    let extent = |axis: usize| {
        (along(axis).fold(f64::NEG_INFINITY, f64::max) - along(axis).fold(f64::INFINITY, f64::min)) * px[axis]
    };
    (extent(0) + extent(1)) / 2.0
}
