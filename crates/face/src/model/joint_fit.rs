//! Fits one shape to several photos of a face.
//!
//! The most frontal photo leads: its landmarks stay on their rays, and the other photos determine their depths along
//! the rays.

mod bias;
mod camera_pose;
mod joint;
mod other_view;
mod rays;
mod weights;

use super::fitting::{Fitted, Observation};
use super::observed::PhotoInput;
use crate::FaceError;
use crate::camera::Camera;
pub use bias::depth_bias_m;
use joint::Joint;
use other_view::OtherView;
use rays::Rays;

/// Reprojection error of a shape in a photo, over the landmarks that face the camera.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reprojection {
    /// Root mean square, in px.
    pub rms_px: f64,
    /// Median, in px.
    pub median_px: f64,
}

/// Leave-one-out result for a photo: how well the other photos predict it, with its best-fitting camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// Index of the photo, in input order.
    pub photo: usize,
    /// Error of the shape from the lead of the other photos alone.
    pub by_one: Reprojection,
    /// Error of the shape from all other photos.
    pub by_others: Reprojection,
}

/// The joint shape and the cameras.
pub(super) struct JointFit {
    /// Index of the lead photo.
    pub(super) lead: usize,
    pub(super) fitted: Fitted,
    /// Index, camera and error of the other photos, in input order.
    pub(super) others: Vec<(usize, Camera, Reprojection)>,
}

/// A shape fitted to some of the photos.
struct Shape {
    lead: usize,
    fitted: Fitted,
    /// The other photos, with their indices.
    others: Vec<(usize, OtherView)>,
}

/// The photos, each with its separate fit.
struct Photos<'a> {
    inputs: &'a [PhotoInput<'a>],
    observations: Vec<Observation>,
    alone: Vec<Fitted>,
}

/// A photo whose face is smaller than this, relative to the largest, cannot lead.
const MIN_RELATIVE_SIZE: f64 = 0.5;
/// Largest median error, in m on the face; beyond it, a photo shows another face.
const MAX_ERROR_M: f64 = 0.006;

/// Fits one shape to 1 to [`MAX_PHOTOS`](crate::MAX_PHOTOS) photos.
pub(super) fn fit(inputs: &[PhotoInput<'_>]) -> Result<JointFit, FaceError> {
    let photos = Photos::new(inputs)?;
    let all: Vec<usize> = (0..inputs.len()).collect();
    let Shape { lead, fitted, others } = photos.fit(&all)?;
    let biased_m = Rays::of(&fitted).biased_m();
    let others = others.into_iter().map(|(photo, view)| {
        let reprojection = view.reprojection(&biased_m);
        let error_m = reprojection.median_px / view.pose.px_per_m;
        if error_m > MAX_ERROR_M {
            let most_px = MAX_ERROR_M * view.pose.px_per_m;
            return Err(FaceError::AnotherFace { photo, reprojection_px: reprojection.median_px, most_px });
        }
        let lens = photos.alone[photo].camera.lens;
        Ok((photo, view.pose.camera(inputs[photo].size_px, lens, fitted.scale.error), reprojection))
    });
    let others = others.collect::<Result<_, _>>()?;
    Ok(JointFit { lead, fitted, others })
}

/// Leaves out each photo in turn; empty for fewer than three photos, since two have to remain.
pub(super) fn left_out(inputs: &[PhotoInput<'_>]) -> Result<Vec<LeftOut>, FaceError> {
    if inputs.len() < 3 {
        return Ok(Vec::new());
    }
    let photos = Photos::new(inputs)?;
    (0..inputs.len()).map(|photo| photos.left_out(photo)).collect()
}

impl<'a> Photos<'a> {
    fn new(inputs: &'a [PhotoInput<'a>]) -> Result<Self, FaceError> {
        let in_photo = |photo| move |reason| FaceError::InPhoto { photo, reason: Box::new(reason) };
        let observation = |(photo, input): (usize, &PhotoInput<'_>)| Observation::new(*input).map_err(in_photo(photo));
        let observations: Vec<Observation> = inputs.iter().enumerate().map(observation).collect::<Result<_, _>>()?;
        let alone = observations.iter().zip(inputs).enumerate();
        let alone = alone.map(|(photo, (observation, input))| observation.fitted(input.lens).map_err(in_photo(photo)));
        Ok(Self { inputs, alone: alone.collect::<Result<_, _>>()?, observations })
    }

    /// Index of the most frontal photo; the first if several are equal.
    fn lead(&self, candidates: &[usize]) -> usize {
        let largest = candidates.iter().map(|&photo| self.observations[photo].frontal().1).fold(0.0, f64::max);
        let frontal = |photo: usize| match self.observations[photo].frontal() {
            (_, size) if size < MIN_RELATIVE_SIZE * largest => f64::NEG_INFINITY,
            (frontal, _) => frontal,
        };
        candidates
            .iter()
            .copied()
            .reduce(|best, photo| if frontal(photo) > frontal(best) { photo } else { best })
            .unwrap_or(0)
    }

    /// Fits a shape to the given photos, with the most frontal one as the lead.
    fn fit(&self, photos: &[usize]) -> Result<Shape, FaceError> {
        const ROUNDS: usize = 3;
        let lead = self.lead(photos);
        let observation = &self.observations[lead];
        let others: Vec<usize> = photos.iter().copied().filter(|&photo| photo != lead).collect();
        let mut alone = self.alone[lead].clone();
        let mut shape = alone.clone();
        if others.is_empty() {
            return Ok(Shape { lead, fitted: shape, others: Vec::new() });
        }
        for _ in 0..ROUNDS {
            let rays = Rays::of(&alone);
            let mut views = self.views(&others, &alone)?;
            let nearer_m = Joint::new(&rays)?.optimise(&mut views)?;
            shape = observation.nearer(&alone, &nearer_m)?;
            let again = observation.resized_to(&shape, &alone)?;
            if again.camera.focal_px == alone.camera.focal_px {
                break;
            }
            alone = again;
        }
        let mut views = self.views(&others, &shape)?;
        let biased_m = Rays::of(&shape).biased_m();
        views.iter_mut().try_for_each(|view| view.optimise(&biased_m))?;
        Ok(Shape { lead, fitted: shape, others: others.into_iter().zip(views).collect() })
    }

    /// Views of the other photos onto a shape; photos from similar directions share their weight.
    fn views(&self, others: &[usize], shape: &Fitted) -> Result<Vec<OtherView>, FaceError> {
        let mut views = others.iter().map(|&photo| self.view(photo, shape)).collect::<Result<Vec<_>, _>>()?;
        other_view::share_directions(&mut views);
        Ok(views)
    }

    fn view(&self, photo: usize, shape: &Fitted) -> Result<OtherView, FaceError> {
        let input = self.inputs[photo];
        OtherView::new(&self.alone[photo], input.landmarks, input.size_px, shape)
    }

    fn left_out(&self, photo: usize) -> Result<LeftOut, FaceError> {
        let others: Vec<usize> = (0..self.inputs.len()).filter(|&other| other != photo).collect();
        let Shape { lead, fitted, .. } = self.fit(&others)?;
        let error = |shape: &Fitted| {
            let mut view = self.view(photo, shape)?;
            let biased_m = Rays::of(shape).biased_m();
            view.optimise(&biased_m)?;
            Ok(view.reprojection(&biased_m))
        };
        Ok(LeftOut { photo, by_one: error(&self.alone[lead])?, by_others: error(&fitted)? })
    }
}
