//! One of several photos beside the one that leads: what it shows, how much each landmark counts, and from where it was taken.

use glam::{DVec2, DVec3};
use nalgebra::SMatrix;

use super::seat::{Known, PARAMETERS, Parameters, Seat};
use super::{Reprojection, trust};
use crate::model::fitting::Fitted;
use crate::procrustes::{Pair, fit};
use crate::{FaceError, LANDMARK_COUNT, PhotoLens};

/// A photo's view of the shape.
#[derive(Debug, Clone)]
pub(super) struct Beside {
    pub(super) seat: Seat,
    /// From the principal point, y up.
    pub(super) seen_px: Vec<DVec2>,
    /// How much each landmark counts.
    pub(super) trust: Vec<f64>,
    /// How far its landmarks are off on the face: errors are counted by their square up to about this, and linearly beyond.
    error_m: f64,
}

/// How far landmarks may be off on the face, as the others tell, at least and at most, and to begin with.
const ERROR_M: std::ops::RangeInclusive<f64> = 0.000_02..=0.003;
const USUAL_ERROR_M: f64 = 0.001;
/// Where nothing is known of its lens, a photo is taken from as far away as the one that leads, give or take this share.
const DISTANCE_DEVIATION: f64 = 0.3;

/// Directions with so much less than 1 between them as the cosine, some 15°, have nothing in common.
const ALIKE: f64 = 0.034;

/// The least squares problem in a seat's parameters and in the depths of the landmarks.
pub(super) struct Slopes {
    /// Of each landmark's depth: the square of its slope, its product with the error, and with the slopes of the seat.
    pub(super) depths: Vec<(f64, f64, Parameters)>,
    pub(super) normal: SMatrix<f64, PARAMETERS, PARAMETERS>,
    pub(super) gradient: Parameters,
}

impl Beside {
    /// A photo that is known alone, put before the shape of the one that leads.
    pub(super) fn new(
        alone: &Fitted,
        landmarks: &[[f32; 3]],
        size_px: [u32; 2],
        lead: &Fitted,
    ) -> Result<Self, FaceError> {
        let [width, height] = size_px.map(f64::from);
        let place_px = |p: &[f32; 3]| DVec2::new((f64::from(p[0]) - 0.5) * width, (0.5 - f64::from(p[1])) * height);
        let seen_px = landmarks[..LANDMARK_COUNT].iter().map(place_px).collect();
        let mut beside =
            Self { seat: seat(alone, lead)?, seen_px, trust: vec![0.0; LANDMARK_COUNT], error_m: USUAL_ERROR_M };
        beside.look(lead.landmarks_m());
        Ok(beside)
    }

    /// Counts the landmarks by how the shape is turned before this camera.
    pub(super) fn look(&mut self, shape_m: &[DVec3]) {
        self.trust = trust::trust(shape_m, |place_m| self.seat.towards(place_m));
    }

    /// Takes the errors for as large as they are about that shape, so that the closer photos agree, the more they count: a step
    /// towards the σ at which the mean of `e² / (e² + σ²)` is a half, whatever the few do that are far off (an M-estimate of
    /// scale, Huber 1981).
    pub(super) fn weigh(&mut self, shape_m: &[DVec3]) {
        let units_per_px = 1.0 / (self.error_m * self.seat.px_per_m);
        let shares = shape_m.iter().zip(&self.seen_px).zip(&self.trust).map(|((&place_m, at_px), trust)| {
            let square = ((self.seat.at_px(place_m) - *at_px) * units_per_px).length_squared();
            trust * square / (1.0 + square)
        });
        let mean = shares.sum::<f64>() / self.trust.iter().sum::<f64>().max(f64::MIN_POSITIVE);
        self.error_m = (self.error_m * (2.0 * mean).sqrt()).clamp(*ERROR_M.start(), *ERROR_M.end());
    }

    /// The problem about the shape as it is, where landmark i comes nearer along `ways[i]`, in m per m of its depth.
    pub(super) fn slopes(&self, shape_m: &[DVec3], ways: &[DVec3]) -> Slopes {
        let (known_error, known_slope) = self.seat.known_distance();
        let mut normal = SMatrix::<f64, PARAMETERS, PARAMETERS>::zeros();
        let mut gradient = Parameters::zeros();
        (normal[(6, 6)], gradient[6]) = (known_slope * known_slope, known_slope * known_error);
        let units_per_px = 1.0 / (self.error_m * self.seat.px_per_m);
        let depths = (0..LANDMARK_COUNT).map(|landmark| {
            let sight = self.seat.sight(shape_m[landmark]);
            let error = (sight.at_px - self.seen_px[landmark]) * units_per_px;
            let weight = self.trust[landmark] / (1.0 + error.length_squared()).sqrt();
            let mut depth = (0.0, 0.0, Parameters::zeros());
            for axis in 0..2 {
                let slope = sight.by_place[axis].dot(ways[landmark]) * units_per_px;
                let by_seat = sight.by_seat[axis] * units_per_px;
                normal.ger(weight, &by_seat, &by_seat, 1.0);
                gradient += by_seat * (weight * error[axis]);
                depth.0 += weight * slope * slope;
                depth.1 += weight * slope * error[axis];
                depth.2 += by_seat * (weight * slope);
            }
            depth
        });
        Slopes { depths: depths.collect(), normal, gradient }
    }

    /// How well the shape agrees with what the photo shows of the landmarks that face its camera.
    pub(super) fn reprojection(&self, shape_m: &[DVec3]) -> Reprojection {
        let seen = trust::visibility(shape_m, |place_m| self.seat.towards(place_m));
        let errors = seen.iter().zip(shape_m).zip(&self.seen_px).filter(|((seen, _), _)| **seen > 0.0);
        let mut errors_px: Vec<f64> =
            errors.map(|((_, &place_m), at_px)| self.seat.at_px(place_m).distance(*at_px)).collect();
        errors_px.sort_by(f64::total_cmp);
        let count = errors_px.len().max(1) as f64;
        Reprojection {
            rms_px: (errors_px.iter().map(|error| error * error).sum::<f64>() / count).sqrt(),
            median_px: errors_px.get(errors_px.len() / 2).copied().unwrap_or(0.0),
        }
    }

    /// Moves the camera alone to where it sees the shape best.
    pub(super) fn settle(&mut self, shape_m: &[DVec3]) -> Result<(), FaceError> {
        const MOST_STEPS: usize = 60;
        const ENOUGH: f64 = 1e-11;
        let still = vec![DVec3::ZERO; LANDMARK_COUNT];
        for _ in 0..MOST_STEPS {
            self.weigh(shape_m);
            let Slopes { normal, gradient, .. } = self.slopes(shape_m, &still);
            let step = -normal.cholesky().ok_or(FaceError::Degenerate)?.solve(&gradient);
            self.seat.take(&step);
            if step.norm() < ENOUGH {
                break;
            }
        }
        Ok(())
    }
}

/// Where the camera stands by what the photo shows alone: the shape is laid on its face.
fn seat(alone: &Fitted, lead: &Fitted) -> Result<Seat, FaceError> {
    let shape_m = lead.landmarks_m();
    let pairs = shape_m.iter().zip(alone.landmarks_m()).zip(trust::steady());
    let pairs: Vec<Pair> = pairs.map(|((&source, &target), weight)| Pair { source, target, weight }).collect();
    let alone_from_shape = fit(&pairs)?;
    let camera = &alone.camera;
    let middle_m = shape_m.iter().sum::<DVec3>() / shape_m.len() as f64;
    let at_m = camera.camera_from_model.transform_point3(alone_from_shape.apply(middle_m));
    // In the shape's metres: a face is as large in every photo of it. A distance that was given is meant in those.
    let per_m = alone_from_shape.scale / camera.distance_m;
    let (known, per_m) = match camera.lens {
        PhotoLens::Parallel => (Known::Distance, 0.0),
        PhotoLens::Distance(_) => (Known::Distance, 1.0 / camera.distance_m),
        PhotoLens::Given(_) | PhotoLens::Exif(_) => (Known::FocalPx(camera.focal_px), per_m),
        PhotoLens::Estimated => as_far_as(lead.camera.distance_m),
    };
    let px_per_m = match known {
        Known::FocalPx(focal_px) => focal_px * per_m,
        Known::Distance | Known::About { .. } => camera.px_per_m * alone_from_shape.scale,
    };
    Ok(Seat {
        rotation: camera.camera_from_model.matrix3 * alone_from_shape.rotation,
        middle_m,
        aside_m: at_m.truncate() / alone_from_shape.scale,
        px_per_m,
        per_m,
        known,
    })
}

/// Where nothing is known: about as far away as the photo that leads was taken from.
fn as_far_as(distance_m: f64) -> (Known, f64) {
    let per_m = 1.0 / distance_m;
    let about = Known::About { per_m, deviation: DISTANCE_DEVIATION };
    (if distance_m.is_finite() { about } else { Known::Distance }, per_m)
}

/// Counts photos that look at the face from alike directions as one: what the network gets wrong there, it does in all of them.
pub(super) fn share_directions(besides: &mut [Beside]) {
    let ways: Vec<DVec3> = besides.iter().map(|beside| beside.seat.towards(beside.seat.middle_m)).collect();
    for (beside, way) in besides.iter_mut().zip(&ways) {
        let alike = |other: &DVec3| (1.0 - (1.0 - way.dot(*other)) / ALIKE).max(0.0);
        let count: f64 = ways.iter().map(alike).sum();
        beside.trust.iter_mut().for_each(|trust| *trust /= count);
    }
}
