//! From something that may be a face to a face, or to none: the landmark network again and again on its own region, and
//! the detector as the second witness.
//!
//! The landmark network draws a face into whatever it is shown: on a head that stands upside down its mesh is as well
//! shaped as any, and it may be sure of it (0.99) and repeat it, as it may of folds of cloth. Measured on the scenes of
//! docs/detection.md, the misfit of the best similarity between a mesh and the average face does not tell wrong meshes
//! from right ones. What does: that passes agree; that the detector, looking closely along the mesh, is sure of a face and
//! sees eyes, nose and mouth where the mesh has them; and that it does not see a better one when it looks the other way
//! round.

use std::f32::consts::PI;

use crate::LandmarksError;
use crate::detection::Detection;
use crate::detector::{self, Detector};
use crate::face::Face;
use crate::mesh::{EYE_CORNERS, Mesh, MeshNetwork, region_of};
use crate::pyramid::Pyramid;
use crate::raw_mesh::SIDE;
use crate::region_of_interest::{PictureSize, RegionOfInterest, RegionPx};

/// The two networks, and the picture that they look at.
pub(crate) struct Verifier<'a> {
    pub(crate) detector: &'a Detector,
    pub(crate) mesh: &'a MeshNetwork,
    pub(crate) pyramid: &'a Pyramid<'a>,
}

/// Passes of the landmark network, at most.
const MAX_PASSES: usize = 4;
/// Passes that differ by less than this share of the distance between the eyes have settled.
const SETTLED: f32 = 0.03;
/// Where the landmark network is less sure than this twice, it will not become so.
const HOPELESS: f32 = 0.02;
/// How often the detector's closer look may send the landmark network elsewhere.
const MAX_STARTS: usize = 3;
/// A closer look at a face the right way up has a score above this, and one at a face on its head has not.
const UPRIGHT: f32 = 0.85;
/// Where the detector sees eyes, nose and mouth within this share of the distance between the eyes of where a mesh has them,
/// it sees the same face.
const ALONG: f32 = 0.3;
/// A detector that is not surer of a face by this much than of one the other way round leaves a doubt.
const DOUBT: f32 = 0.1;
/// The landmark network is surer than 0.999 of right meshes, and of cloth up to 0.99; what it lacks counts by this width.
const UNSURE: f32 = 0.1;
/// The detector's closer look gives faces more than 0.8, those that the border cuts in half 0.66, and folds of cloth up to
/// 0.65: its score counts half at this one, not at all below it by the width, and fully above it by as much.
const HALF_SURE: f32 = 0.55;
const HALF_SURE_WIDTH: f32 = 0.15;
/// A face of this confidence is not looked at again.
const CERTAIN: f32 = 0.8;
/// How much wider than the region of the landmarks a closer look is: then a face takes a third of it, which suits the
/// detector best.
const CLOSER: f32 = 2.0;

/// What the landmark network says when it is left to itself.
struct Settled {
    mesh: Mesh,
    region: RegionOfInterest,
    /// The lesser one of the last two passes.
    presence: f32,
    /// Between the last two passes: mean distance as a share of the distance between the eyes.
    change: f32,
}

impl Verifier<'_> {
    /// The face of a detection with its confidence, if it can be one at all.
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

    /// A face from one detection, and a better detection to start from if there seems to be one.
    fn attempt(&self, start: &Detection) -> Result<(Face, Option<Detection>), LandmarksError> {
        let settled = self.settled(start)?;
        let upright = self.closer(&settled.region, 0.0)?;
        let is_upright = upright.is_some_and(|seen| seen.score > UPRIGHT);
        let inverse = if is_upright { None } else { self.closer(&settled.region, -PI)? };
        let distance = |seen: &Detection| self.distance(seen, &settled.mesh.landmarks);
        let witnesses = || upright.iter().chain([start]);
        let aside = witnesses().map(distance).fold(f32::INFINITY, f32::min);
        let along = witnesses().filter(|seen| distance(seen) < ALONG).map(|seen| seen.score).fold(0.0, f32::max);
        let advantage = along - inverse.map_or(0.0, |seen| seen.score);
        let confidence = bell(1.0 - settled.presence, UNSURE)
            * bell(settled.change, 0.1)
            * bell(aside, 0.2)
            * ramp(along - HALF_SURE, HALF_SURE_WIDTH)
            * ramp(advantage, DOUBT);
        let next = if advantage < DOUBT { inverse } else { upright.filter(|_| confidence < CERTAIN) };
        let Settled { mesh: Mesh { landmarks, .. }, region, presence, .. } = settled;
        Ok((Face { score: start.score.max(along), presence, confidence, landmarks, region }, next))
    }

    /// Passes of the landmark network, each on the region of the one before, until they agree.
    fn settled(&self, start: &Detection) -> Result<Settled, LandmarksError> {
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
            let is_hopeless = last.presence.max(mesh.presence) < HOPELESS;
            if change < SETTLED || is_hopeless || passes == MAX_PASSES {
                return Ok(Settled { mesh, region, presence, change });
            }
            last = mesh;
        }
    }

    /// The landmark network on the copy of the picture that suits the size of the region.
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

    /// What the detector sees in the middle when it looks at a face from near, along its eyes or turned from there.
    fn closer(&self, region: &RegionOfInterest, turn_rad: f32) -> Result<Option<Detection>, LandmarksError> {
        let picture = PictureSize::of(self.pyramid.photo);
        let near = region.px(picture);
        let share = CLOSER * near.size[0] / picture.width.max(picture.height);
        let copy = self.pyramid.fitting(share, detector::SIDE);
        let wide =
            RegionOfInterest { size: region.size.map(|side| CLOSER * side), ..*region }.px(PictureSize::of(copy));
        let seen = self.detector.detect(copy, &RegionPx { rotation_rad: region.rotation_rad + turn_rad, ..wide })?;
        Ok(seen.into_iter().find(|seen| {
            let from_centre = [0, 1].map(|axis| (seen.min[axis] + seen.max[axis]) / 2.0 - region.centre[axis]);
            (from_centre[0] * picture.width).hypot(from_centre[1] * picture.height) < 0.3 * near.size[0]
        }))
    }

    /// How far the detector's eyes, nose and mouth are from those of a mesh, as a share of the distance between the eyes.
    fn distance(&self, seen: &Detection, landmarks: &[[f32; 3]]) -> f32 {
        const PLACES: [[usize; 2]; 4] = [[33, 133], [362, 263], [1, 1], [13, 14]];
        let middle = |[a, b]: [usize; 2]| [0, 1].map(|axis| (landmarks[a][axis] + landmarks[b][axis]) / 2.0);
        let apart = PLACES.iter().zip(&seen.keypoints).map(|(&place, &point)| self.px_between(middle(place), point));
        apart.sum::<f32>() / PLACES.len() as f32 / self.eye_distance_px(landmarks)
    }

    fn change(&self, before: &[[f32; 3]], after: &[[f32; 3]]) -> f32 {
        let apart = before.iter().zip(after).map(|(a, b)| self.px_between([a[0], a[1]], [b[0], b[1]]));
        apart.sum::<f32>() / after.len() as f32 / self.eye_distance_px(after)
    }

    /// Between the outer corners of the eyes.
    fn eye_distance_px(&self, landmarks: &[[f32; 3]]) -> f32 {
        let [left, right] = EYE_CORNERS.map(|corner| [landmarks[corner][0], landmarks[corner][1]]);
        self.px_between(left, right).max(f32::MIN_POSITIVE)
    }

    fn px_between(&self, a: [f32; 2], b: [f32; 2]) -> f32 {
        let PictureSize { width, height } = PictureSize::of(self.pyramid.photo);
        ((a[0] - b[0]) * width).hypot((a[1] - b[1]) * height)
    }
}

/// From where a place has in a copy to where it has in the picture, both normalised. Networks count from the middle of the
/// first pixel, which in a copy lies further in.
fn shift(picture: PictureSize, copy: PictureSize) -> [f32; 2] {
    let half_pixel = |full: f32, reduced: f32| 0.5 / reduced - 0.5 / full;
    [half_pixel(picture.width, copy.width), half_pixel(picture.height, copy.height)]
}

/// 1 at 0, 1/e at `width`.
fn bell(value: f32, width: f32) -> f32 {
    (-(value / width).powi(2)).exp()
}

/// 0 up to −`width`, 1 from `width` on.
fn ramp(value: f32, width: f32) -> f32 {
    ((value / width + 1.0) / 2.0).clamp(0.0, 1.0)
}
