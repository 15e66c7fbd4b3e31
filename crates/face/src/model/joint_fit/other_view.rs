//! A photo other than the lead: its observations, weights and camera.

use glam::{DVec2, DVec3};
use nalgebra::SMatrix;

use super::camera_pose::{CameraPose, DistanceConstraint, PARAMETERS, Parameters};
use super::{Reprojection, weights};
use crate::model::fitting::Fitted;
use crate::procrustes::{Pair, fit};
use crate::{FaceError, LANDMARK_COUNT, PhotoLens};

/// View of the shape in a photo other than the lead.
#[derive(Debug, Clone)]
pub(super) struct OtherView {
    pub(super) pose: CameraPose,
    /// Observed landmarks relative to the principal point, y up.
    pub(super) seen_px: Vec<DVec2>,
    /// Weight of each landmark.
    pub(super) weights: Vec<f64>,
    /// Scale of the landmark errors on the face: the cost is quadratic below it and linear above.
    error_m: f64,
}

/// Range and initial value of the error scale.
const ERROR_M: std::ops::RangeInclusive<f64> = 0.000_02..=0.003;
const INITIAL_ERROR_M: f64 = 0.001;
/// Relative deviation of the prior on the distance of a photo without lens data, centred at the lead photo's distance.
const DISTANCE_DEVIATION: f64 = 0.3;

/// Photos count as independent if the cosine between their directions is below 1 by this or more, about 15°.
const INDEPENDENT: f64 = 0.034;

/// Normal equations in the camera's parameters and the landmarks' depths.
pub(super) struct Slopes {
    /// For each landmark's depth: squared derivative, its product with the residual, and with the camera's derivatives.
    pub(super) depths: Vec<(f64, f64, Parameters)>,
    pub(super) normal: SMatrix<f64, PARAMETERS, PARAMETERS>,
    pub(super) gradient: Parameters,
}

impl OtherView {
    /// Creates the view of a photo, with its initial camera from the fit of that photo alone.
    pub(super) fn new(
        alone: &Fitted,
        landmarks: &[[f32; 3]],
        size_px: [u32; 2],
        lead: &Fitted,
    ) -> Result<Self, FaceError> {
        let [width, height] = size_px.map(f64::from);
        let observed_px = |p: &[f32; 3]| DVec2::new((f64::from(p[0]) - 0.5) * width, (0.5 - f64::from(p[1])) * height);
        let seen_px = landmarks[..LANDMARK_COUNT].iter().map(observed_px).collect();
        let mut view = Self {
            pose: initial_pose(alone, lead)?,
            seen_px,
            weights: vec![0.0; LANDMARK_COUNT],
            error_m: INITIAL_ERROR_M,
        };
        view.update_weights(lead.landmarks_m());
        Ok(view)
    }

    /// Recomputes the weights from the shape's visibility to this camera.
    pub(super) fn update_weights(&mut self, shape_m: &[DVec3]) {
        self.weights = weights::weights(shape_m, |position_m| self.pose.direction_to_camera(position_m));
    }

    /// Updates the error scale, so that photos that agree better weigh more.
    ///
    /// One step towards the σ at which the weighted mean of `e² / (e² + σ²)` is ½, which is robust to outliers (an
    /// M-estimate of scale, Huber 1981).
    pub(super) fn update_error_scale(&mut self, shape_m: &[DVec3]) {
        let units_per_px = 1.0 / (self.error_m * self.pose.px_per_m);
        let shares = shape_m.iter().zip(&self.seen_px).zip(&self.weights).map(|((&position_m, seen_px), weight)| {
            let square = ((self.pose.project(position_m) - *seen_px) * units_per_px).length_squared();
            weight * square / (1.0 + square)
        });
        let mean = shares.sum::<f64>() / self.weights.iter().sum::<f64>().max(f64::MIN_POSITIVE);
        self.error_m = (self.error_m * (2.0 * mean).sqrt()).clamp(*ERROR_M.start(), *ERROR_M.end());
    }

    /// Normal equations at the current shape; landmark i moves along `directions[i]`, in m per m of depth.
    pub(super) fn slopes(&self, shape_m: &[DVec3], directions: &[DVec3]) -> Slopes {
        let (prior_error, prior_slope) = self.pose.distance_residual();
        let mut normal = SMatrix::<f64, PARAMETERS, PARAMETERS>::zeros();
        let mut gradient = Parameters::zeros();
        (normal[(6, 6)], gradient[6]) = (prior_slope * prior_slope, prior_slope * prior_error);
        let units_per_px = 1.0 / (self.error_m * self.pose.px_per_m);
        let depths = (0..LANDMARK_COUNT).map(|landmark| {
            let projection = self.pose.projection(shape_m[landmark]);
            let error = (projection.position_px - self.seen_px[landmark]) * units_per_px;
            let weight = self.weights[landmark] / (1.0 + error.length_squared()).sqrt();
            let mut depth = (0.0, 0.0, Parameters::zeros());
            for axis in 0..2 {
                let slope = projection.by_position[axis].dot(directions[landmark]) * units_per_px;
                let by_pose = projection.by_pose[axis] * units_per_px;
                normal.ger(weight, &by_pose, &by_pose, 1.0);
                gradient += by_pose * (weight * error[axis]);
                depth.0 += weight * slope * slope;
                depth.1 += weight * slope * error[axis];
                depth.2 += by_pose * (weight * slope);
            }
            depth
        });
        Slopes { depths: depths.collect(), normal, gradient }
    }

    /// Reprojection error over the landmarks that face the camera.
    pub(super) fn reprojection(&self, shape_m: &[DVec3]) -> Reprojection {
        let seen = weights::visibility(shape_m, |position_m| self.pose.direction_to_camera(position_m));
        let errors = seen.iter().zip(shape_m).zip(&self.seen_px).filter(|((seen, _), _)| **seen > 0.0);
        let mut errors_px: Vec<f64> =
            errors.map(|((_, &position_m), seen_px)| self.pose.project(position_m).distance(*seen_px)).collect();
        errors_px.sort_by(f64::total_cmp);
        let count = errors_px.len().max(1) as f64;
        Reprojection {
            rms_px: (errors_px.iter().map(|error| error * error).sum::<f64>() / count).sqrt(),
            median_px: errors_px.get(errors_px.len() / 2).copied().unwrap_or(0.0),
        }
    }

    /// Optimises the camera for a fixed shape.
    pub(super) fn optimise(&mut self, shape_m: &[DVec3]) -> Result<(), FaceError> {
        const MAX_STEPS: usize = 60;
        const TOLERANCE: f64 = 1e-11;
        let fixed = vec![DVec3::ZERO; LANDMARK_COUNT];
        for _ in 0..MAX_STEPS {
            self.update_error_scale(shape_m);
            let Slopes { normal, gradient, .. } = self.slopes(shape_m, &fixed);
            let step = -normal.cholesky().ok_or(FaceError::Degenerate)?.solve(&gradient);
            self.pose.apply(&step);
            if step.norm() < TOLERANCE {
                break;
            }
        }
        Ok(())
    }
}

/// Initial camera: the shape aligned with the face of this photo's separate fit.
fn initial_pose(alone: &Fitted, lead: &Fitted) -> Result<CameraPose, FaceError> {
    let shape_m = lead.landmarks_m();
    let pairs = shape_m.iter().zip(alone.landmarks_m()).zip(weights::reliabilities());
    let pairs: Vec<Pair> = pairs.map(|((&source, &target), weight)| Pair { source, target, weight }).collect();
    let alone_from_shape = fit(&pairs)?;
    let camera = &alone.camera;
    let centre_m = shape_m.iter().sum::<DVec3>() / shape_m.len() as f64;
    let at_m = camera.camera_from_model.transform_point3(alone_from_shape.apply(centre_m));
    // In the shape's metres, since the face has the same size in all photos. A given distance is meant in these metres.
    let per_m = alone_from_shape.scale / camera.distance_m;
    let (constraint, per_m) = match camera.lens {
        PhotoLens::Parallel => (DistanceConstraint::Fixed, 0.0),
        PhotoLens::Distance(_) => (DistanceConstraint::Fixed, 1.0 / camera.distance_m),
        PhotoLens::Given(_) | PhotoLens::Exif(_) => (DistanceConstraint::FocalPx(camera.focal_px), per_m),
        PhotoLens::Estimated => prior_at(lead.camera.distance_m),
    };
    let px_per_m = match constraint {
        DistanceConstraint::FocalPx(focal_px) => focal_px * per_m,
        DistanceConstraint::Fixed | DistanceConstraint::Prior { .. } => camera.px_per_m * alone_from_shape.scale,
    };
    Ok(CameraPose {
        rotation: camera.camera_from_model.matrix3 * alone_from_shape.rotation,
        centre_m,
        offset_m: at_m.truncate() / alone_from_shape.scale,
        px_per_m,
        per_m,
        constraint,
    })
}

/// Prior for a photo without lens data: the lead photo's distance.
fn prior_at(distance_m: f64) -> (DistanceConstraint, f64) {
    let per_m = 1.0 / distance_m;
    let prior = DistanceConstraint::Prior { per_m, deviation: DISTANCE_DEVIATION };
    (if distance_m.is_finite() { prior } else { DistanceConstraint::Fixed }, per_m)
}

/// Shares the weight among photos from similar directions, since the network makes the same errors in them.
pub(super) fn share_directions(views: &mut [OtherView]) {
    let directions: Vec<DVec3> = views.iter().map(|view| view.pose.direction_to_camera(view.pose.centre_m)).collect();
    for (view, direction) in views.iter_mut().zip(&directions) {
        let similarity = |other: &DVec3| (1.0 - (1.0 - direction.dot(*other)) / INDEPENDENT).max(0.0);
        let count: f64 = directions.iter().map(similarity).sum();
        view.weights.iter_mut().for_each(|weight| *weight /= count);
    }
}
