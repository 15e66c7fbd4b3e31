//! The face detector: a region of the picture → boxes with six key points each.

use rosto_photo::Photo;

use crate::LandmarksError;
use crate::anchors::{ANCHOR_COUNT, anchors};
use crate::network::Network;
use crate::region_of_interest::{PictureSize, RegionOfInterest, RegionPx};
use crate::suppression;
use crate::warp::{self, Outside};

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

/// The detector network with what surrounds it.
pub(crate) struct Detector {
    network: Network,
    anchors: Vec<[f32; 2]>,
}

/// Width and height of what the network takes in, in px.
pub(crate) const SIDE: usize = 128;
/// Numbers for each anchor: centre, size, six key points, as x, y pairs.
const NUMBERS_PER_BOX: usize = 16;
const MIN_SCORE: f32 = 0.5;
/// u8 to −1..1.
const SCALE_AND_OFFSET: [f32; 2] = [2.0 / 255.0, -1.0];

impl Detector {
    pub(crate) fn new(onnx: &[u8]) -> Result<Self, LandmarksError> {
        let network = Network::of_picture("detector", onnx, SIDE, &["regressors", "classificators"])?;
        Ok(Self { network, anchors: anchors() })
    }

    /// The faces in a region of the picture, best first, normalised to the picture.
    pub(crate) fn detect(&self, photo: &Photo, region: &RegionPx) -> Result<Vec<Detection>, LandmarksError> {
        let [boxes, scores] = self.raw(photo, region)?;
        let matrix = region.picture_from_region(PictureSize::of(photo));
        let found = suppression::weighted(self.decode(&boxes, &scores));
        Ok(found.into_iter().map(|detection| detection.mapped(&matrix)).collect())
    }

    /// The network's outputs, undecoded: boxes `[896, 16]` and score logits `[896]`.
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

/// One box of the raw output, if its score is high enough and it is a box at all.
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

impl Detection {
    /// The square to look for landmarks in, turned so that the line between the eyes is level.
    pub(crate) fn face_region(&self, picture: PictureSize) -> RegionOfInterest {
        let size = [0, 1].map(|axis| self.max[axis] - self.min[axis]);
        let centre = [0, 1].map(|axis| self.min[axis] + size[axis] / 2.0);
        RegionOfInterest::around(centre, size, [self.keypoints[0], self.keypoints[1]], picture)
    }

    /// The same in other coordinates; of a box that gets turned, the box around it.
    fn mapped(&self, matrix: &[[f32; 3]; 2]) -> Self {
        let map = |[x, y]: [f32; 2]| matrix.map(|row| x * row[0] + y * row[1] + row[2]);
        let ([left, top], [right, bottom]) = (self.min, self.max);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]].map(map);
        let extreme = |pick: fn(f32, f32) -> f32| {
            [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).fold(corners[0][axis], pick))
        };
        Self { score: self.score, min: extreme(f32::min), max: extreme(f32::max), keypoints: self.keypoints.map(map) }
    }
}
