//! The face detector: maps a region of the picture to boxes with six key points each.

use rosto_photo::Photo;

use crate::LandmarksError;
use crate::anchors::{ANCHOR_COUNT, anchors};
use crate::detection::Detection;
use crate::network::Network;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::suppression;
use crate::warp::{self, Outside};

/// The detector network with its pre- and post-processing.
pub(crate) struct Detector {
    network: Network,
    anchors: Vec<[f32; 2]>,
}

/// Width and height of the network's input, px.
pub(crate) const SIDE: usize = 128;
/// Outputs per anchor: centre, size and six key points, as x, y pairs.
const NUMBERS_PER_BOX: usize = 16;
const MIN_SCORE: f32 = 0.5;
/// Scale and offset from u8 to −1..1.
const SCALE_AND_OFFSET: [f32; 2] = [2.0 / 255.0, -1.0];

impl Detector {
    pub(crate) fn new(onnx: &[u8]) -> Result<Self, LandmarksError> {
        let network = Network::of_picture("detector", onnx, SIDE, &["regressors", "classificators"])?;
        Ok(Self { network, anchors: anchors() })
    }

    /// Returns the faces in a region, highest score first, normalised to the picture.
    pub(crate) fn detect(&self, photo: &Photo, region: &RegionPx) -> Result<Vec<Detection>, LandmarksError> {
        let [boxes, scores] = self.raw(photo, region)?;
        let matrix = region.picture_from_region(PictureSize::of(photo));
        let found = suppression::weighted(self.decode(&boxes, &scores));
        Ok(found.into_iter().map(|detection| detection.mapped(&matrix)).collect())
    }

    /// Returns the network's raw outputs: boxes `[896, 16]` and score logits `[896]`.
    pub(crate) fn raw(&self, photo: &Photo, region: &RegionPx) -> Result<[Vec<f32>; 2], LandmarksError> {
        let fill = |_, planes: &mut [f32]| warp::fill_planes(planes, photo, region, Outside::Zero, SCALE_AND_OFFSET);
        self.network.run(fill, [ANCHOR_COUNT * NUMBERS_PER_BOX, ANCHOR_COUNT])
    }

    fn decode(&self, boxes: &[f32], logits: &[f32]) -> Vec<Detection> {
        let numbers = boxes.as_chunks::<NUMBERS_PER_BOX>().0;
        let candidates = numbers.iter().zip(logits).zip(&self.anchors);
        candidates.filter_map(|((numbers, &logit), &anchor)| decode_one(numbers, logit, anchor)).collect()
    }
}

/// Decodes one anchor's outputs. `None` if the score is low or the size is negative.
fn decode_one(numbers: &[f32; NUMBERS_PER_BOX], logit: f32, anchor: [f32; 2]) -> Option<Detection> {
    let score = sigmoid(logit.clamp(-100.0, 100.0));
    let offset = |at: usize| numbers[at] / SIDE as f32;
    let position = |at: usize| [offset(at) + anchor[0], offset(at + 1) + anchor[1]];
    let (centre, size) = (position(0), [offset(2), offset(3)]);
    let min = [0, 1].map(|axis| centre[axis] - size[axis] / 2.0);
    let max = [0, 1].map(|axis| centre[axis] + size[axis] / 2.0);
    let is_box = [0, 1].iter().all(|&axis| max[axis] - min[axis] >= 0.0);
    let keypoints = std::array::from_fn(|k| position(4 + 2 * k));
    (score >= MIN_SCORE && is_box).then_some(Detection { score, min, max, keypoints })
}

/// The logistic function.
pub(crate) fn sigmoid(logit: f32) -> f32 {
    1.0 / (1.0 + (-logit).exp())
}

impl PictureSize {
    pub(crate) fn of(photo: &Photo) -> Self {
        Self { width: photo.width() as f32, height: photo.height() as f32 }
    }
}
