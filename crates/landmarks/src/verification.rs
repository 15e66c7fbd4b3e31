//! Verification of detections: iterates the landmark network on its own region, and cross-checks with the detector.
//!
//! The landmark network outputs a well-shaped mesh for any input. For an upside-down head or folds of cloth it can do
//! so repeatedly, with a presence of 0.99. On the scenes of docs/accuracy.md, the residual of the best similarity
//! transform between a mesh and the average face does not separate wrong meshes from correct ones. Three checks do:
//! successive passes agree; the detector, on a close-up aligned with the mesh, has a high score and its key points
//! match the mesh; and its score on the close-up rotated by 180° is lower.

use std::f32::consts::PI;

use crate::LandmarksError;
use crate::detection::Detection;
use crate::detector::{self, Detector};
use crate::face::Face;
use crate::mesh::{EYE_CORNERS, Mesh, MeshNetwork, region_of};
use crate::pyramid::Pyramid;
use crate::raw_mesh::SIDE;
use crate::region_of_interest::{PictureSize, RegionOfInterest, RegionPx};

/// The two networks, and the picture to run them on.
pub(crate) struct Verifier<'a> {
    pub(crate) detector: &'a Detector,
    pub(crate) mesh: &'a MeshNetwork,
    pub(crate) pyramid: &'a Pyramid<'a>,
}

/// Maximum number of passes of the landmark network.
const MAX_PASSES: usize = 4;
/// Change between passes, relative to the distance between the eyes, below which they have converged.
const CONVERGED_CHANGE: f32 = 0.03;
/// Presence below which two passes are not continued. In the scenes of docs/accuracy.md, one of the first two passes on
/// a face reaches 0.999.
const HOPELESS_PRESENCE: f32 = 0.5;
/// Maximum number of starting detections per proposal.
const MAX_STARTS: usize = 3;
/// Close-up score above which the face is upright; upside-down faces have lower scores.
const UPRIGHT_SCORE: f32 = 0.85;
/// Greatest distance between the detector's key points and the mesh, relative to the distance between the eyes, for
/// both to show the same face.
const MAX_KEYPOINT_DISTANCE: f32 = 0.3;
/// Score advantage over the rotated close-up below which the orientation is doubtful.
const MIN_ADVANTAGE: f32 = 0.1;
/// Width of the weight of `1 − presence`. Correct meshes have a presence above 0.999, cloth up to 0.99.
const PRESENCE_WIDTH: f32 = 0.1;
/// Close-up score with a weight of one half, and the distance from it to weights of 0 and 1. Faces reach more than 0.8,
/// faces cut in half by the border 0.66, folds of cloth up to 0.65.
const HALF_WEIGHT_SCORE: f32 = 0.55;
const SCORE_WIDTH: f32 = 0.15;
/// Confidence from which another start is not tried.
const SUFFICIENT_CONFIDENCE: f32 = 0.8;
/// Size of the close-up relative to the landmarks' region. A face then fills a third of it, which suits the detector
/// best.
const CLOSE_UP_SCALE: f32 = 2.0;

/// Result of iterating the landmark network.
struct Converged {
    mesh: Mesh,
    region: RegionOfInterest,
    /// The lower presence of the last two passes.
    presence: f32,
    /// Mean distance between the landmarks of the last two passes, relative to the distance between the eyes.
    change: f32,
}

impl Verifier<'_> {
    /// Returns the face of a detection with its confidence; `None` if its landmarks are not finite.
    pub(crate) fn face(&self, proposal: &Detection) -> Result<Option<Face>, LandmarksError> {
        let mut best: Option<Face> = None;
        let mut start = *proposal;
        for _ in 0..MAX_STARTS {
            let (face, next) = self.attempt(&start)?;
            if best.as_ref().is_none_or(|best| best.confidence < face.confidence) {
                best = Some(face);
            }
            let Some(next) = next else { break };
            start = next;
        }
        Ok(best.filter(|face| face.landmarks.as_flattened().iter().all(|number| number.is_finite())))
    }

    /// Returns the face for a starting detection, and a better start if the close-up gives one.
    fn attempt(&self, start: &Detection) -> Result<(Face, Option<Detection>), LandmarksError> {
        let converged = self.converged(start)?;
        let upright = self.close_up(&converged.region, 0.0)?;
        let is_upright = upright.is_some_and(|seen| seen.score > UPRIGHT_SCORE);
        let inverse = if is_upright { None } else { self.close_up(&converged.region, -PI)? };
        let distance = |seen: &Detection| self.distance(seen, &converged.mesh.landmarks);
        let detections = || upright.iter().chain([start]);
        let keypoint_distance = detections().map(distance).fold(f32::INFINITY, f32::min);
        let score_along = detections()
            .filter(|seen| distance(seen) < MAX_KEYPOINT_DISTANCE)
            .map(|seen| seen.score)
            .fold(0.0, f32::max);
        let advantage = score_along - inverse.map_or(0.0, |seen| seen.score);
        let confidence = bell(1.0 - converged.presence, PRESENCE_WIDTH)
            * bell(converged.change, 0.1)
            * bell(keypoint_distance, 0.2)
            * ramp(score_along - HALF_WEIGHT_SCORE, SCORE_WIDTH)
            * ramp(advantage, MIN_ADVANTAGE);
        let next =
            if advantage < MIN_ADVANTAGE { inverse } else { upright.filter(|_| confidence < SUFFICIENT_CONFIDENCE) };
        let Converged { mesh: Mesh { landmarks, .. }, region, presence, .. } = converged;
        Ok((Face { score: start.score.max(score_along), presence, confidence, landmarks, region }, next))
    }

    /// Repeats the landmark network, each pass on the region of the previous one, until two passes agree.
    fn converged(&self, start: &Detection) -> Result<Converged, LandmarksError> {
        let picture = PictureSize::of(self.pyramid.photo);
        let first = start.face_region(picture);
        let mut last = self.look(&first)?;
        let mut passes = 1;
        loop {
            let region = region_of(&last.landmarks, picture);
            let mesh = self.look(&region)?;
            passes += 1;
            let change = self.change(&last.landmarks, &mesh.landmarks);
            let presence = last.presence.min(mesh.presence);
            let is_hopeless = last.presence.max(mesh.presence) < HOPELESS_PRESENCE;
            if change < CONVERGED_CHANGE || is_hopeless || passes == MAX_PASSES {
                return Ok(Converged { mesh, region, presence, change });
            }
            last = mesh;
        }
    }

    /// Runs the landmark network on the copy of the picture that matches the region's size.
    fn look(&self, region: &RegionOfInterest) -> Result<Mesh, LandmarksError> {
        let picture = PictureSize::of(self.pyramid.photo);
        let share = region.px(picture).size[0] / picture.width.max(picture.height);
        let copy = self.pyramid.fitting(share, SIDE);
        let shift = shift(picture, PictureSize::of(copy));
        let [x, y] = region.centre;
        let mut mesh = self.mesh.look(copy, &RegionOfInterest { centre: [x - shift[0], y - shift[1]], ..*region })?;
        for [x, y, _] in &mut mesh.landmarks {
            (*x, *y) = (*x + shift[0], *y + shift[1]);
        }
        Ok(mesh)
    }

    /// The central detection in a close-up of a region, rotated by `turn_rad` from its orientation.
    fn close_up(&self, region: &RegionOfInterest, turn_rad: f32) -> Result<Option<Detection>, LandmarksError> {
        let picture = PictureSize::of(self.pyramid.photo);
        let near = region.px(picture);
        let share = CLOSE_UP_SCALE * near.size[0] / picture.width.max(picture.height);
        let copy = self.pyramid.fitting(share, detector::SIDE);
        let wide = RegionOfInterest { size: region.size.map(|side| CLOSE_UP_SCALE * side), ..*region }
            .px(PictureSize::of(copy));
        let seen = self.detector.detect(copy, &RegionPx { rotation_rad: region.rotation_rad + turn_rad, ..wide })?;
        Ok(seen.into_iter().find(|seen| {
            let from_centre = [0, 1].map(|axis| (seen.min[axis] + seen.max[axis]) / 2.0 - region.centre[axis]);
            (from_centre[0] * picture.width).hypot(from_centre[1] * picture.height) < 0.3 * near.size[0]
        }))
    }

    /// Mean distance between the detector's and the mesh's eyes, nose and mouth, relative to the distance between the
    /// eyes.
    fn distance(&self, seen: &Detection, landmarks: &[[f32; 3]]) -> f32 {
        const KEYPOINT_LANDMARKS: [[usize; 2]; 4] = [[33, 133], [362, 263], [1, 1], [13, 14]];
        let middle = |[a, b]: [usize; 2]| [0, 1].map(|axis| (landmarks[a][axis] + landmarks[b][axis]) / 2.0);
        let apart =
            KEYPOINT_LANDMARKS.iter().zip(&seen.keypoints).map(|(&pair, &point)| self.px_between(middle(pair), point));
        apart.sum::<f32>() / KEYPOINT_LANDMARKS.len() as f32 / self.eye_distance_px(landmarks)
    }

    fn change(&self, before: &[[f32; 3]], after: &[[f32; 3]]) -> f32 {
        let apart = before.iter().zip(after).map(|(a, b)| self.px_between([a[0], a[1]], [b[0], b[1]]));
        apart.sum::<f32>() / after.len() as f32 / self.eye_distance_px(after)
    }

    /// Distance between the outer corners of the eyes.
    fn eye_distance_px(&self, landmarks: &[[f32; 3]]) -> f32 {
        let [left, right] = EYE_CORNERS.map(|corner| [landmarks[corner][0], landmarks[corner][1]]);
        self.px_between(left, right).max(f32::MIN_POSITIVE)
    }

    fn px_between(&self, a: [f32; 2], b: [f32; 2]) -> f32 {
        let PictureSize { width, height } = PictureSize::of(self.pyramid.photo);
        ((a[0] - b[0]) * width).hypot((a[1] - b[1]) * height)
    }
}

/// Offset from normalised positions in a copy to those in the picture. The networks place the origin at the centre of
/// the first pixel, whose offset depends on the pixel size.
fn shift(picture: PictureSize, copy: PictureSize) -> [f32; 2] {
    let half_pixel = |full: f32, reduced: f32| 0.5 / reduced - 0.5 / full;
    [half_pixel(picture.width, copy.width), half_pixel(picture.height, copy.height)]
}

/// Gaussian weight: 1 at 0, 1/e at `width`.
fn bell(value: f32, width: f32) -> f32 {
    (-(value / width).powi(2)).exp()
}

/// Linear weight: 0 up to −`width`, 1 from `width` on.
fn ramp(value: f32, width: f32) -> f32 {
    ((value / width + 1.0) / 2.0).clamp(0.0, 1.0)
}
