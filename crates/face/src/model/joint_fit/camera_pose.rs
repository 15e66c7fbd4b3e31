//! Camera parameters of a photo other than the lead, and derivatives of its projection.

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use nalgebra::SVector;

use crate::PhotoLens;
use crate::camera::{Camera, PARALLEL_M, interval_m, log_interval};

/// Rotation (3), offset (2), logarithm of the scale, inverse distance.
pub(super) const PARAMETERS: usize = 7;
pub(super) type Parameters = SVector<f64, PARAMETERS>;

/// A camera relative to the shape, parameterised by rotation, offset, scale and inverse distance, which allows an
/// infinite distance.
///
/// A point at p from the centre, in the camera's frame, is seen at `(p.xy + offset) · px_per_m / (1 − p.z · per_m)`
/// from the principal point, y up.
#[derive(Debug, Clone)]
pub(super) struct CameraPose {
    /// Rotation from the model's frame to the camera's.
    pub(super) rotation: DMat3,
    /// Reference point in the model's frame, among the landmarks.
    pub(super) centre_m: DVec3,
    pub(super) offset_m: DVec2,
    pub(super) px_per_m: f64,
    /// Inverse distance of the centre.
    pub(super) per_m: f64,
    pub(super) constraint: DistanceConstraint,
}

/// Constraint on a camera's distance.
#[derive(Debug, Clone, Copy)]
pub(super) enum DistanceConstraint {
    /// The distance is fixed.
    Fixed,
    /// The focal length is fixed, so the distance follows from the scale.
    FocalPx(f64),
    /// Gaussian prior on the inverse distance, with a relative deviation.
    Prior { per_m: f64, deviation: f64 },
}

/// Projection of a landmark with its derivatives: by the position in the model, in px per metre along each photo axis,
/// and by the [`Parameters`].
pub(super) struct Projection {
    pub(super) position_px: DVec2,
    pub(super) by_position: [DVec3; 2],
    pub(super) by_pose: [Parameters; 2],
}

/// Lower limit of a landmark's depth, relative to the centre's distance, for intermediate steps of the fit.
const NEAREST: f64 = 0.05;

impl CameraPose {
    /// Projects a point of the model, in px from the principal point, y up.
    pub(super) fn project(&self, position_m: DVec3) -> DVec2 {
        let rotated_m = self.rotation * (position_m - self.centre_m);
        (rotated_m.truncate() + self.offset_m) * (self.px_per_m / self.nearness(rotated_m))
    }

    fn nearness(&self, rotated_m: DVec3) -> f64 {
        (1.0 - rotated_m.z * self.per_m).max(NEAREST)
    }

    pub(super) fn projection(&self, position_m: DVec3) -> Projection {
        let rotated_m = self.rotation * (position_m - self.centre_m);
        let nearness = self.nearness(rotated_m);
        let px_per_m = self.px_per_m / nearness;
        let position_px = (rotated_m.truncate() + self.offset_m) * px_per_m;
        let model_from_camera = self.rotation.transpose();
        let [x, y] = [DVec3::X, DVec3::Y].map(|axis| {
            let along_px = position_px.dot(axis.truncate());
            let by_rotated = axis * px_per_m + DVec3::Z * (along_px * self.per_m / nearness);
            let by_rotation = rotated_m.cross(by_rotated);
            let by_nearer = along_px * rotated_m.z / nearness;
            let by_scale = along_px
                + if matches!(self.constraint, DistanceConstraint::FocalPx(_)) { by_nearer * self.per_m } else { 0.0 };
            let by_distance = if matches!(self.constraint, DistanceConstraint::Prior { .. }) { by_nearer } else { 0.0 };
            let by_offset = axis * px_per_m;
            let by_pose =
                [by_rotation.x, by_rotation.y, by_rotation.z, by_offset.x, by_offset.y, by_scale, by_distance];
            (model_from_camera * by_rotated, Parameters::from(by_pose))
        });
        Projection { position_px, by_position: [x.0, y.0], by_pose: [x.1, y.1] }
    }

    /// Residual of the distance prior in units of its deviation, and its derivative.
    pub(super) fn distance_residual(&self) -> (f64, f64) {
        match self.constraint {
            DistanceConstraint::Prior { per_m, deviation } => {
                let per_unit = 1.0 / (per_m * deviation);
                ((self.per_m - per_m) * per_unit, per_unit)
            }
            // Not a free parameter: the unit derivative keeps the step at zero.
            DistanceConstraint::Fixed | DistanceConstraint::FocalPx(_) => (0.0, 1.0),
        }
    }

    pub(super) fn apply(&mut self, step: &Parameters) {
        let half = DVec3::new(step[0], step[1], step[2]) / 2.0;
        // Equal to the rotation by an angle for small steps, without platform-dependent trigonometry.
        let turn = DQuat::from_xyzw(half.x, half.y, half.z, 1.0).normalize();
        self.rotation = DMat3::from_quat(turn) * self.rotation;
        self.offset_m += DVec2::new(step[3], step[4]);
        self.px_per_m *= (1.0 + step[5]).clamp(0.5, 2.0);
        self.per_m = match self.constraint {
            DistanceConstraint::Fixed => self.per_m,
            DistanceConstraint::FocalPx(focal_px) => self.px_per_m / focal_px,
            DistanceConstraint::Prior { per_m, .. } => (self.per_m + step[6]).clamp(per_m / 4.0, per_m * 4.0),
        };
    }

    /// Unit vector from a point of the model towards the camera.
    pub(super) fn direction_to_camera(&self, position_m: DVec3) -> DVec3 {
        let rotated_m = self.rotation * (position_m - self.centre_m);
        let direction = DVec3::Z - (rotated_m + self.offset_m.extend(0.0)) * self.per_m;
        (self.rotation.transpose() * direction).normalize()
    }

    /// Converts to a [`Camera`] for a photo of `size_px`.
    pub(super) fn camera(&self, size_px: [u32; 2], lens: PhotoLens, size_error: f64) -> Camera {
        let is_parallel = self.per_m == 0.0;
        let distance_m = if is_parallel { f64::INFINITY } else { 1.0 / self.per_m };
        let camera_m = if is_parallel { PARALLEL_M } else { distance_m };
        let at_m = self.offset_m.extend(-camera_m) - self.rotation * self.centre_m;
        let error = match self.constraint {
            DistanceConstraint::Prior { deviation, .. } => deviation,
            DistanceConstraint::Fixed | DistanceConstraint::FocalPx(_) => 0.0,
        };
        Camera {
            lens,
            focal_px: self.px_per_m * distance_m,
            principal_px: DVec2::from(size_px.map(f64::from)) / 2.0,
            px_per_m: self.px_per_m,
            distance_m,
            distance_interval_m: match lens {
                PhotoLens::Distance(_) => [distance_m; 2],
                _ => interval_m(distance_m, log_interval(error), size_error),
            },
            camera_from_model: DAffine3::from_mat3_translation(self.rotation, at_m),
        }
    }
}
