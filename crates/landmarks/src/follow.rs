//! Follows a face from frame to frame, as MediaPipe's Face Mesh does in video mode: the landmarks of a frame give the
//! region for the next one, and the detector runs only while no face is followed.

mod one_euro;
mod smoothing;

use rosto_photo::Photo;

use crate::detection::Detection;
use crate::finder::{FaceFinder, MIN_PRESENCE};
use crate::mesh::{Mesh, region_of};
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::{LandmarksError, RegionOfInterest, prominence};
use smoothing::Smoother;

/// State of following a face: region, smoothing filters and time of the previous frame. The default follows no face.
#[derive(Debug, Clone, Default)]
pub struct Follower {
    previous: Option<Previous>,
}

/// The face in the previous frame.
#[derive(Debug, Clone)]
struct Previous {
    time_ms: f64,
    picture: PictureSize,
    /// Region for the next frame, from the unsmoothed landmarks.
    region: RegionOfInterest,
    smoother: Smoother,
}

/// A face in a video frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowedFace {
    /// Face flag of the landmark network, 0.5..1.
    pub presence: f32,
    /// Landmarks in the convention of [`Face::landmarks`](crate::Face::landmarks), smoothed over time.
    pub landmarks: Vec<[f32; 3]>,
    /// The region that the landmark network processed.
    pub region: RegionOfInterest,
    /// Source of the region.
    pub origin: Origin,
}

/// Source of a face's region.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The previous frame's landmarks.
    Followed,
    /// The detector, because no face was followed or it left its region.
    Detected,
}

/// Longest gap between frames, after which the detector runs again.
const MAX_GAP_MS: f64 = 1000.0;
/// Maximum number of detections processed per frame, which bounds its time.
const MAX_CANDIDATES: usize = 2;
/// Least width of a region. Landmarks of smaller faces are meaningless.
const MIN_WIDTH_PX: f32 = 8.0;

/// Shift of the region, relative to its width, above which the landmark network runs a second time. The network biases
/// off-centre faces by some px towards the centre of the region.
const MAX_SHIFT: f32 = 0.1;
/// Least contrast of a region, 0..255, to reject a covered camera. The landmark network is certain of a face in pure
/// black.
const MIN_CONTRAST: f32 = 6.0;
/// Blocks per axis of a region, and samples per axis of a block.
const BLOCKS: u8 = 8;
const SAMPLES: u8 = 4;

/// A face in this frame, and the state for the next one.
type Found = (FollowedFace, Previous);

impl FaceFinder {
    /// Follows a face into the next frame of a video. Returns `None` if there is no face.
    ///
    /// The landmark network runs on the region given by the previous frame's landmarks: their bounding box × 1.5,
    /// square, rotated so that the outer eye corners are level. It runs again if the face has moved far. If it finds no
    /// face there, the detector runs once and the landmark network twice, on the most prominent face, which is followed
    /// from then on. A region with little contrast, as of a covered camera, contains no face. Landmarks are smoothed by
    /// the one-euro filter with MediaPipe's settings; regions use the unsmoothed ones.
    ///
    /// `time_ms` is the time of the frame, from any origin. A frame with the same time as the previous one does not
    /// move the face. The detector runs again after a gap of more than a second, if time decreases or is NaN, and if
    /// the frame size changes.
    ///
    /// # Errors
    /// The errors of [`Self::find`], after which no face is followed.
    pub fn follow(
        &self,
        follower: &mut Follower,
        frame: &Photo,
        time_ms: f64,
    ) -> Result<Option<FollowedFace>, LandmarksError> {
        let picture = PictureSize::of(frame);
        let previous = follower.previous.take().filter(|previous| previous.can_continue_to(picture, time_ms));
        let followed = previous.map(|previous| self.track(previous, frame, time_ms)).transpose()?.flatten();
        let found = match followed {
            Some(found) => Some(found),
            None => self.detect_face(frame, time_ms)?,
        };
        Ok(found.map(|(face, previous)| {
            follower.previous = Some(previous);
            face
        }))
    }

    /// Finds the previous frame's face in this frame.
    fn track(&self, previous: Previous, frame: &Photo, time_ms: f64) -> Result<Option<Found>, LandmarksError> {
        let picture = PictureSize::of(frame);
        let Some(mut mesh) = self.mesh_in(previous.region, frame)? else { return Ok(None) };
        let (mut region, mut next_region) = (previous.region, region_of(&mesh.landmarks, picture));
        if shift(region.px(picture), next_region.px(picture)) > MAX_SHIFT {
            let Some(second) = self.mesh_in(next_region, frame)? else { return Ok(None) };
            (mesh, region) = (second, next_region);
            next_region = region_of(&mesh.landmarks, picture);
        }
        let mut smoother = previous.smoother;
        let landmarks = smoother.next(&mesh.landmarks, picture, (time_ms - previous.time_ms) / 1000.0);
        let face = FollowedFace { presence: mesh.presence, landmarks, region, origin: Origin::Followed };
        Ok(Some((face, Previous { time_ms, picture, region: next_region, smoother })))
    }

    /// Detects a face without a previous frame. The landmark network runs twice, because its output on the detector's
    /// region is off by a px, which smoothing would remove only slowly.
    fn detect_face(&self, frame: &Photo, time_ms: f64) -> Result<Option<Found>, LandmarksError> {
        let picture = PictureSize::of(frame);
        let mut detections = self.detector.detect(frame, &RegionPx::whole(picture))?;
        prominence::sort(&mut detections, picture, Detection::outline);
        for detection in detections.iter().take(MAX_CANDIDATES) {
            let Some(first) = self.mesh_in(detection.face_region(picture), frame)? else { continue };
            let region = region_of(&first.landmarks, picture);
            let Some(Mesh { presence, landmarks }) = self.mesh_in(region, frame)? else { continue };
            let (next_region, smoother) = (region_of(&landmarks, picture), Smoother::new(&landmarks, picture));
            let face = FollowedFace { presence, landmarks, region, origin: Origin::Detected };
            return Ok(Some((face, Previous { time_ms, picture, region: next_region, smoother })));
        }
        Ok(None)
    }

    /// Runs the landmark network on a region; `None` if it contains no face.
    fn mesh_in(&self, region: RegionOfInterest, frame: &Photo) -> Result<Option<Mesh>, LandmarksError> {
        let picture = PictureSize::of(frame);
        if !is_valid_region(region.px(picture), picture) || contrast(region.px(picture), frame) < MIN_CONTRAST {
            return Ok(None);
        }
        let mesh = self.mesh.look(frame, &region)?;
        Ok(Some(mesh).filter(|mesh| mesh.presence > MIN_PRESENCE))
    }
}

impl Previous {
    /// Whether the next frame can continue this one.
    fn can_continue_to(&self, picture: PictureSize, time_ms: f64) -> bool {
        (0.0..=MAX_GAP_MS).contains(&(time_ms - self.time_ms)) && self.picture == picture
    }
}

/// Whether a region is large enough and centred inside the picture. The landmark network outputs a face for any input.
fn is_valid_region(region: RegionPx, picture: PictureSize) -> bool {
    let [x, y] = region.centre;
    let is_inside = (0.0..=picture.width).contains(&x) && (0.0..=picture.height).contains(&y);
    // The finiteness checks also reject NaN.
    is_inside && region.size[0] >= MIN_WIDTH_PX && region.rotation_rad.is_finite() && region.size[0].is_finite()
}

/// Distance between the centres of two regions, relative to the first one's width.
fn shift(from: RegionPx, to: RegionPx) -> f32 {
    let [x, y] = [0, 1].map(|axis| to.centre[axis] - from.centre[axis]);
    x.hypot(y) / from.size[0]
}

/// Difference between the brightest and the darkest block of a region, 0..255. Averaging over blocks suppresses noise.
fn contrast(region: RegionPx, frame: &Photo) -> f32 {
    let [across, down] = region.picture_from_region(PictureSize::of(frame));
    let brightness = |x: u8, y: u8| {
        let [x, y] = [x, y].map(|at| (f32::from(at) + 0.5) / f32::from(BLOCKS * SAMPLES));
        let [x, y] = [across, down].map(|[per_x, per_y, constant]| f64::from(per_x * x + per_y * y + constant));
        frame.colour_under(x, y).map(f32::from).iter().sum::<f32>() / 3.0
    };
    let block = |x: u8, y: u8| {
        let samples = (0..SAMPLES * SAMPLES).map(|i| brightness(x * SAMPLES + i % SAMPLES, y * SAMPLES + i / SAMPLES));
        samples.sum::<f32>() / f32::from(SAMPLES * SAMPLES)
    };
    let blocks = (0..BLOCKS).flat_map(|y| (0..BLOCKS).map(move |x| block(x, y)));
    let [low, high] = blocks.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], b| [low.min(b), high.max(b)]);
    high - low
}
