//! A face from frame to frame, as MediaPipe's Face Mesh does it in its video mode: where to look comes from the landmarks of
//! the frame before, so that the detector runs only while no face is followed.

mod one_euro;
mod smoothing;

use rosto_photo::Photo;

use crate::detection::Detection;
use crate::finder::{FaceFinder, MIN_PRESENCE};
use crate::mesh::{Mesh, region_of};
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::{LandmarksError, RegionOfInterest, prominence};
use smoothing::Smoother;

/// What is remembered of the frames before; neither pictures nor networks. A new one follows nobody.
#[derive(Debug, Clone, Default)]
pub struct Follower {
    last: Option<Last>,
}

/// The face of the frame before.
#[derive(Debug, Clone)]
struct Last {
    time_ms: f64,
    picture: PictureSize,
    /// Where its landmarks, not smoothed, say that the next frame has it.
    region: RegionOfInterest,
    smoother: Smoother,
}

/// A face in one frame of a video.
#[derive(Debug, Clone, PartialEq)]
pub struct FollowedFace {
    /// The landmark network's, 0.5..1.
    pub presence: f32,
    /// As [`Face::landmarks`](crate::Face::landmarks), smoothed over time.
    pub landmarks: Vec<[f32; 3]>,
    /// Where the landmark network looked.
    pub region: RegionOfInterest,
    /// How it was known where to look.
    pub origin: Origin,
}

/// How it was known where a face is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// From the frame before.
    Followed,
    /// The detector looked at this frame, since no face was followed or the one that was is no longer there.
    Detected,
}

/// After a longer pause than this a face is looked for anew: nobody stays where they were.
const LONGEST_GAP_MS: f64 = 1000.0;
/// So many of the detector's faces are tried in one frame, so that no frame takes long.
const MOST_TRIED: usize = 2;
/// A face whose region is narrower than this is too small for the landmarks to mean anything.
const NARROWEST_PX: f32 = 8.0;

/// What has gone further than this since the frame before, in shares of its region, is looked at once more: the landmark network
/// draws a face that lies askew in its region some px towards the middle.
const FAR: f32 = 0.1;
/// What differs by less than this, of 255, is a covered camera: of pure black the landmark network is sure that it is a face.
const LEAST_CONTRAST: f32 = 6.0;
/// Blocks of a region each way, and pixels that are looked at in each of them.
const BLOCKS: u8 = 8;
const SAMPLES: u8 = 4;

/// A face in this frame, and what the next one needs.
type Found = (FollowedFace, Last);

impl FaceFinder {
    /// The face that is followed, in the next frame of a video; none is an answer, not an error.
    ///
    /// The landmark network looks once at the region that the landmarks of the frame before suggest (their box × 1.5, square,
    /// the outer eye corners level), once more if the face has gone far, and the face is followed for as long as it finds one
    /// there. Else the detector looks once at the frame, the landmark network twice, and the most prominent face is followed
    /// from then on. Nobody is seen by a covered camera. Landmarks are smoothed by the one-euro filter with MediaPipe's
    /// settings; where to look next comes from those that are not.
    ///
    /// `time_ms` says when the frame was taken, from any beginning. A frame of the same moment as the one before moves nothing
    /// on. After a pause of more than a second, when time runs backwards or is no number, and when frames change their size,
    /// a face is looked for anew.
    ///
    /// # Errors
    /// As [`Self::find`]; nobody is followed then.
    pub fn follow(
        &self,
        follower: &mut Follower,
        frame: &Photo,
        time_ms: f64,
    ) -> Result<Option<FollowedFace>, LandmarksError> {
        let picture = PictureSize::of(frame);
        let last = follower.last.take().filter(|last| last.leads_to(picture, time_ms));
        let followed = last.map(|last| self.still_there(last, frame, time_ms)).transpose()?.flatten();
        let found = match followed {
            Some(found) => Some(found),
            None => self.find_first(frame, time_ms)?,
        };
        Ok(found.map(|(face, last)| {
            follower.last = Some(last);
            face
        }))
    }

    /// Where the face of the frame before is by now.
    fn still_there(&self, last: Last, frame: &Photo, time_ms: f64) -> Result<Option<Found>, LandmarksError> {
        let picture = PictureSize::of(frame);
        let Some(mut mesh) = self.seen_in(last.region, frame)? else { return Ok(None) };
        let (mut region, mut next_region) = (last.region, region_of(&mesh.landmarks, picture));
        if shift(region.px(picture), next_region.px(picture)) > FAR {
            let Some(nearer) = self.seen_in(next_region, frame)? else { return Ok(None) };
            (mesh, region) = (nearer, next_region);
            next_region = region_of(&mesh.landmarks, picture);
        }
        let mut smoother = last.smoother;
        let landmarks = smoother.next(&mesh.landmarks, picture, (time_ms - last.time_ms) / 1000.0);
        let face = FollowedFace { presence: mesh.presence, landmarks, region, origin: Origin::Followed };
        Ok(Some((face, Last { time_ms, picture, region: next_region, smoother })))
    }

    /// Finds a face without an earlier frame. The landmark network looks twice, as it will in the next frame: what it sees in the
    /// detector's region is a px off, which would be smoothed away only slowly.
    fn find_first(&self, frame: &Photo, time_ms: f64) -> Result<Option<Found>, LandmarksError> {
        let picture = PictureSize::of(frame);
        let mut detections = self.detector.detect(frame, &RegionPx::whole(picture))?;
        prominence::sort(&mut detections, picture, Detection::outline);
        for detection in detections.iter().take(MOST_TRIED) {
            let Some(first) = self.seen_in(detection.face_region(picture), frame)? else { continue };
            let region = region_of(&first.landmarks, picture);
            let Some(Mesh { presence, landmarks }) = self.seen_in(region, frame)? else { continue };
            let (next_region, smoother) = (region_of(&landmarks, picture), Smoother::new(&landmarks, picture));
            let face = FollowedFace { presence, landmarks, region, origin: Origin::Detected };
            return Ok(Some((face, Last { time_ms, picture, region: next_region, smoother })));
        }
        Ok(None)
    }

    /// What the landmark network sees there, if that is a face.
    fn seen_in(&self, region: RegionOfInterest, frame: &Photo) -> Result<Option<Mesh>, LandmarksError> {
        let picture = PictureSize::of(frame);
        if !is_worth_a_look(region.px(picture), picture) || contrast(region.px(picture), frame) < LEAST_CONTRAST {
            return Ok(None);
        }
        let mesh = self.mesh.look(frame, &region)?;
        Ok(Some(mesh).filter(|mesh| mesh.presence > MIN_PRESENCE))
    }
}

impl Last {
    /// Whether a frame may show the same face, not far from here.
    fn leads_to(&self, picture: PictureSize, time_ms: f64) -> bool {
        (0.0..=LONGEST_GAP_MS).contains(&(time_ms - self.time_ms)) && self.picture == picture
    }
}

/// The landmark network draws a face into whatever it is shown: not into a speck, nor into what lies beyond the border.
fn is_worth_a_look(region: RegionPx, picture: PictureSize) -> bool {
    let [x, y] = region.centre;
    let is_inside = (0.0..=picture.width).contains(&x) && (0.0..=picture.height).contains(&y);
    // Not so either where a number is none.
    is_inside && region.size[0] >= NARROWEST_PX && region.rotation_rad.is_finite() && region.size[0].is_finite()
}

/// How far one region lies from another, in shares of its width.
fn shift(from: RegionPx, to: RegionPx) -> f32 {
    let [x, y] = [0, 1].map(|axis| to.centre[axis] - from.centre[axis]);
    x.hypot(y) / from.size[0]
}

/// How much the brightest and the darkest part of a region differ, noise averaged out; 0 to 255.
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
