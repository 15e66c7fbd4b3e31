//! Where the camera of one of several photos stands, and how what it sees changes with that.

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use nalgebra::SVector;

use crate::PhotoLens;
use crate::camera::{Camera, PARALLEL_M};

/// Turn (3), aside (2), logarithm of the size, one over the distance.
pub(super) const PARAMETERS: usize = 7;
pub(super) type Parameters = SVector<f64, PARAMETERS>;

/// A camera before the shape, by what a photo shows: how the head is turned, how far its middle is aside, how large it is seen,
/// and one over the distance, so that it may be infinite. A point at p from the middle, in the camera's frame, is then seen at
/// `(p.xy + aside) · px_per_m / (1 − p.z · per_m)` from the principal point, y up.
#[derive(Debug, Clone)]
pub(super) struct Seat {
    /// From the model's frame to the camera's.
    pub(super) rotation: DMat3,
    /// A place in the model's frame, amid the landmarks.
    pub(super) middle_m: DVec3,
    pub(super) aside_m: DVec2,
    pub(super) px_per_m: f64,
    /// One over the distance of the middle.
    pub(super) per_m: f64,
    pub(super) known: Known,
}

/// What holds a camera's distance.
#[derive(Debug, Clone, Copy)]
pub(super) enum Known {
    /// It is as it is.
    Distance,
    /// It is as large as the face is seen small: the focal length is known.
    FocalPx(f64),
    /// It is somewhere about this: one over it, and the deviation of that as a share.
    About { per_m: f64, deviation: f64 },
}

/// Where a landmark is seen, and how that changes: along each axis of the photo with its place in the model, in px per metre,
/// and with the [`Parameters`].
pub(super) struct Sight {
    pub(super) at_px: DVec2,
    pub(super) by_place: [DVec3; 2],
    pub(super) by_seat: [Parameters; 2],
}

/// No landmark is nearer to a camera than by this share of the middle's distance, however far off a fit has gone meanwhile.
const NEAREST: f64 = 0.05;

impl Seat {
    /// Where a place in the model is seen, in px from the principal point, y up.
    pub(super) fn at_px(&self, place_m: DVec3) -> DVec2 {
        let turned_m = self.rotation * (place_m - self.middle_m);
        (turned_m.truncate() + self.aside_m) * (self.px_per_m / self.nearness(turned_m))
    }

    fn nearness(&self, turned_m: DVec3) -> f64 {
        (1.0 - turned_m.z * self.per_m).max(NEAREST)
    }

    pub(super) fn sight(&self, place_m: DVec3) -> Sight {
        let turned_m = self.rotation * (place_m - self.middle_m);
        let nearness = self.nearness(turned_m);
        let px_per_m = self.px_per_m / nearness;
        let at_px = (turned_m.truncate() + self.aside_m) * px_per_m;
        let back = self.rotation.transpose();
        let [x, y] = [DVec3::X, DVec3::Y].map(|axis| {
            let along_px = at_px.dot(axis.truncate());
            let by_turned = axis * px_per_m + DVec3::Z * (along_px * self.per_m / nearness);
            let by_turn = turned_m.cross(by_turned);
            let by_nearer = along_px * turned_m.z / nearness;
            let by_size = along_px + if matches!(self.known, Known::FocalPx(_)) { by_nearer * self.per_m } else { 0.0 };
            let by_distance = if matches!(self.known, Known::About { .. }) { by_nearer } else { 0.0 };
            let aside = axis * px_per_m;
            let by_seat = [by_turn.x, by_turn.y, by_turn.z, aside.x, aside.y, by_size, by_distance];
            (back * by_turned, Parameters::from(by_seat))
        });
        Sight { at_px, by_place: [x.0, y.0], by_seat: [x.1, y.1] }
    }

    /// What is known of the distance beside the landmarks, as the error in units of its deviation and the slope of that.
    pub(super) fn known_distance(&self) -> (f64, f64) {
        match self.known {
            Known::About { per_m, deviation } => {
                let per_unit = 1.0 / (per_m * deviation);
                ((self.per_m - per_m) * per_unit, per_unit)
            }
            // The distance is no parameter then, and stays.
            Known::Distance | Known::FocalPx(_) => (0.0, 1.0),
        }
    }

    pub(super) fn take(&mut self, step: &Parameters) {
        let half = DVec3::new(step[0], step[1], step[2]) / 2.0;
        // For small turns the same as by an angle, and by arithmetic that is the same everywhere.
        let turn = DQuat::from_xyzw(half.x, half.y, half.z, 1.0).normalize();
        self.rotation = DMat3::from_quat(turn) * self.rotation;
        self.aside_m += DVec2::new(step[3], step[4]);
        self.px_per_m *= (1.0 + step[5]).clamp(0.5, 2.0);
        self.per_m = match self.known {
            Known::Distance => self.per_m,
            Known::FocalPx(focal_px) => self.px_per_m / focal_px,
            Known::About { per_m, .. } => (self.per_m + step[6]).clamp(per_m / 4.0, per_m * 4.0),
        };
    }

    /// The way from a place in the model to the camera, one long.
    pub(super) fn towards(&self, place_m: DVec3) -> DVec3 {
        let turned_m = self.rotation * (place_m - self.middle_m);
        let way = DVec3::Z - (turned_m + self.aside_m.extend(0.0)) * self.per_m;
        (self.rotation.transpose() * way).normalize()
    }

    /// The camera that sees so, for a photo of that size.
    pub(super) fn camera(&self, size_px: [u32; 2], lens: PhotoLens, size_error: f64) -> Camera {
        let is_parallel = self.per_m == 0.0;
        let distance_m = if is_parallel { f64::INFINITY } else { 1.0 / self.per_m };
        let standing_m = if is_parallel { PARALLEL_M } else { distance_m };
        let at_m = self.aside_m.extend(-standing_m) - self.rotation * self.middle_m;
        let error = match self.known {
            Known::About { deviation, .. } => deviation,
            Known::Distance | Known::FocalPx(_) => 0.0,
        };
        Camera {
            lens,
            focal_px: self.px_per_m * distance_m,
            principal_px: DVec2::from(size_px.map(f64::from)) / 2.0,
            px_per_m: self.px_per_m,
            distance_m,
            distance_error: if matches!(lens, PhotoLens::Distance(_)) { 0.0 } else { error.hypot(size_error) },
            camera_from_model: DAffine3::from_mat3_translation(self.rotation, at_m),
        }
    }
}
