//! Fits the landmarks of a photo to the canonical face and derives the camera.

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::observed::{PhotoInput, fit_canonical_to, in_px, px_from_image};
use super::turned;
use crate::camera::{self, Camera, CanonicalShape, Distance, PARALLEL_M};
use crate::irises::{MIDDLE_OF_LIDS, POINTS_OF_AN_IRIS};
use crate::photo_lens::DISTANCES_M;
use crate::procrustes::Similarity;
use crate::size::{self, Scale};
use crate::{FaceError, LANDMARK_COUNT, PhotoLens, canonical_positions_m, card};

/// Landmarks in the model's frame, with the camera.
#[derive(Clone)]
pub(super) struct Fitted {
    /// 468 positions, or 478 with the irises.
    pub(super) positions_m: Vec<DVec3>,
    pub(super) camera: Camera,
    pub(super) scale: Scale,
    pub(super) image_from_model: DMat3,
    /// Size of the face relative to the canonical face.
    factor: f64,
    /// 90 % interval of the distance's logarithm, without the error of the size.
    log_interval: [f64; 2],
}

/// Lens data of the photo are rejected if they put the face nearer than this, in m: the picture is part of a larger one.
const NEAREST_M: f64 = 0.2;
/// Standard deviation of a focal length rounded to whole mm.
const ROUNDED_MM: f64 = 0.29;

impl Fitted {
    pub(super) fn new(photo: PhotoInput<'_>) -> Result<Self, FaceError> {
        Observation::new(photo)?.fitted(photo.lens)
    }

    /// The landmarks, without the irises.
    pub(super) fn landmarks_m(&self) -> &[DVec3] {
        &self.positions_m[..LANDMARK_COUNT]
    }

    /// Distance at which a face of canonical size would look the same.
    fn canonical_distance_m(&self) -> f64 {
        self.camera.distance_m / self.factor
    }
}

/// Landmarks in px, y up, z towards the camera and 0 at the mean.
pub(super) struct Observation {
    landmarks_px: Vec<DVec3>,
    /// The canonical face fitted under parallel projection, for any lens.
    px_from_model: Similarity,
    size_px: [u32; 2],
    principal_px: DVec2,
    /// Corners of a card relative to the principal point, y up.
    card_px: Option<[DVec2; 4]>,
    shape: CanonicalShape,
}

impl Observation {
    pub(super) fn new(photo: PhotoInput<'_>) -> Result<Self, FaceError> {
        let PhotoInput { landmarks, size_px, card, .. } = photo;
        let landmarks_px = in_px(landmarks, size_px)?;
        let principal_px = DVec2::new(f64::from(size_px[0]), -f64::from(size_px[1])) / 2.0;
        let px_from_model = fit_canonical_to(&landmarks_px)?;
        let shape = CanonicalShape::new()?;
        let corner_px = |[x, y]: [f64; 2]| DVec2::new(x - 0.5, 0.5 - y) * DVec2::from(size_px.map(f64::from));
        let card_px = card.map(|card| card.map(corner_px));
        Ok(Self { landmarks_px, px_from_model, size_px, principal_px, card_px, shape })
    }

    /// Fits the face by this photo alone.
    pub(super) fn fitted(&self, lens: PhotoLens) -> Result<Fitted, FaceError> {
        match lens.checked()? {
            PhotoLens::Parallel => self.parallel(),
            PhotoLens::Estimated => self.estimated(),
            PhotoLens::Distance(distance_m) => self.at_distance(distance_m),
            PhotoLens::Given(focal_length_mm) => self.through(focal_length_mm, lens, 0.0),
            PhotoLens::Exif(focal_length_mm) => {
                let fitted = self.through(focal_length_mm, lens, ROUNDED_MM / focal_length_mm)?;
                if fitted.canonical_distance_m() < NEAREST_M { self.estimated() } else { Ok(fitted) }
            }
        }
    }

    /// Cosine of the angle between face and camera, and size in px per m of the canonical face.
    pub(super) fn frontal(&self) -> (f64, f64) {
        (self.px_from_model.rotation.z_axis.z, self.px_from_model.scale)
    }

    /// Moves each landmark of [`Self::fitted`] nearer to the camera by `by_m`, then scales the face about the camera so
    /// that the mean depth is unchanged.
    pub(super) fn nearer(&self, alone: &Fitted, by_m: &[f64]) -> Result<Fitted, FaceError> {
        let Camera { focal_px, distance_m, px_per_m, lens, camera_from_model, .. } = alone.camera;
        let camera_m = if distance_m.is_finite() { distance_m } else { PARALLEL_M };
        let moved = alone.landmarks_m().iter().zip(by_m).map(|(&position_m, nearer_m)| {
            let seen_m = camera_from_model.transform_point3(position_m);
            let ray = if distance_m.is_finite() { seen_m / seen_m.z } else { DVec3::Z };
            let moved_m = seen_m + ray * *nearer_m;
            self.principal_px.extend(0.0) + (moved_m + DVec3::Z * camera_m) * px_per_m
        });
        let points = self.with_irises(moved.collect(), focal_px);
        self.placed(&points, fit_canonical_to(&points)?, focal_px, lens, alone.log_interval)
    }

    /// Refits the photo with the size known from `shape`. If the lens data give a distance, this changes the focal
    /// length.
    pub(super) fn resized_to(&self, shape: &Fitted, alone: &Fitted) -> Result<Fitted, FaceError> {
        let share = match alone.camera.lens {
            PhotoLens::Distance(distance_m) => distance_m / shape.camera.distance_m,
            PhotoLens::Estimated => alone.canonical_distance_m() / shape.canonical_distance_m(),
            PhotoLens::Parallel | PhotoLens::Given(_) | PhotoLens::Exif(_) => 1.0,
        };
        match alone.camera.lens {
            PhotoLens::Parallel => self.parallel(),
            lens => self.seen_through(shape.camera.focal_px * share, lens, alone.log_interval),
        }
    }

    fn parallel(&self) -> Result<Fitted, FaceError> {
        self.placed(&self.landmarks_px, self.px_from_model, f64::INFINITY, PhotoLens::Parallel, [0.0; 2])
    }

    fn estimated(&self) -> Result<Fitted, FaceError> {
        let Distance { distance_m, log_interval } =
            camera::estimated(&self.landmarks_px[..LANDMARK_COUNT], self.principal_px)?;
        let focal_px = self.focal_px_for(|_, px_from_model, _| Ok(distance_m * px_from_model.scale))?;
        self.seen_through(focal_px, PhotoLens::Estimated, log_interval)
    }

    fn through(&self, focal_length_mm: f64, lens: PhotoLens, deviation: f64) -> Result<Fitted, FaceError> {
        self.seen_through(camera::focal_px(focal_length_mm, self.size_px), lens, camera::log_interval(deviation))
    }

    /// Fits at a distance that holds for the face's true size.
    fn at_distance(&self, distance_m: f64) -> Result<Fitted, FaceError> {
        let focal_px = self.focal_px_for(|points, px_from_model, focal_px| {
            let (factor, _) = self.scale(points, px_from_model, focal_px)?;
            Ok(distance_m / factor * px_from_model.scale)
        })?;
        self.seen_through(focal_px, PhotoLens::Distance(distance_m), [0.0; 2])
    }

    /// Solves for a focal length that depends on the face's size, which depends on the focal length. Starts with the
    /// detected depths, which are accurate enough.
    fn focal_px_for(
        &self,
        focal_px_of: impl Fn(&[DVec3], &Similarity, f64) -> Result<f64, FaceError>,
    ) -> Result<f64, FaceError> {
        const ROUGH_STEPS: usize = 5;
        const STEPS: usize = 2;
        let mut focal_px = focal_px_of(&self.landmarks_px, &self.px_from_model, f64::INFINITY)?;
        for _ in 0..ROUGH_STEPS {
            let points = self.on_rays(&self.depths(), focal_px);
            focal_px = focal_px_of(&points, &fit_canonical_to(&points)?, focal_px)?;
        }
        for _ in 0..STEPS {
            let (points, px_from_model) = self.unprojected(focal_px)?;
            focal_px = focal_px_of(&points, &px_from_model, focal_px)?;
        }
        Ok(focal_px)
    }

    fn seen_through(&self, focal_px: f64, lens: PhotoLens, log_interval: [f64; 2]) -> Result<Fitted, FaceError> {
        // Keeps all parts of the face in front of the camera.
        let focal_px = focal_px.max(DISTANCES_M.start() * self.px_from_model.scale);
        let (points, px_from_model) = self.unprojected(focal_px)?;
        self.placed(&points, px_from_model, focal_px, lens, log_interval)
    }

    /// Detected depths.
    fn depths(&self) -> Vec<f64> {
        self.landmarks_px.iter().map(|point| point.z).collect()
    }

    /// Unprojects the points with regularised depths, corrects the shape of a turned head, and fits the canonical face.
    fn unprojected(&self, focal_px: f64) -> Result<(Vec<DVec3>, Similarity), FaceError> {
        const STEPS: usize = 2;
        let found = self.depths();
        let mut points = self.on_rays(&found, focal_px);
        let mut px_from_model = fit_canonical_to(&points)?;
        for _ in 0..STEPS {
            let mut depths = self.regularised(&px_from_model, focal_px)?;
            let mean = depths.iter().sum::<f64>() / depths.len() as f64;
            depths.iter_mut().for_each(|z| *z -= mean);
            points = self.on_rays(&depths, focal_px);
            px_from_model = fit_canonical_to(&points)?;
        }
        let points = self.with_irises(self.corrected(&points, &px_from_model, focal_px)?, focal_px);
        let px_from_model = fit_canonical_to(&points)?;
        Ok((points, px_from_model))
    }

    /// Depths drawn to those of the canonical face.
    fn regularised(&self, px_from_model: &Similarity, focal_px: f64) -> Result<Vec<f64>, FaceError> {
        let canonical: Vec<DVec3> =
            canonical_positions_m().iter().map(|&position_m| px_from_model.apply(position_m)).collect();
        let depths: Vec<f64> = canonical.iter().map(|point| point.z).collect();
        let seen = self.on_rays(&depths, focal_px);
        let aside: Vec<DVec3> = seen.iter().zip(&canonical).map(|(seen, canonical)| *seen - *canonical).collect();
        self.shape.depths(&self.depths()[..LANDMARK_COUNT], &canonical, &aside)
    }

    /// Landmarks where they are on the head.
    fn corrected(&self, points: &[DVec3], px_from_model: &Similarity, focal_px: f64) -> Result<Vec<DVec3>, FaceError> {
        let model_from_px = px_from_model.inverse();
        let found_m: Vec<DVec3> = points.iter().map(|&point| model_from_px.apply(point)).collect();
        let eye_m = model_from_px.apply(self.principal_px.extend(focal_px));
        let corrected_m = turned::corrected(&found_m, eye_m, &self.shape)?;
        Ok(corrected_m.into_iter().map(|position_m| px_from_model.apply(position_m)).collect())
    }

    /// Shifts the landmarks to a mean depth of 0, scaling them about the camera, and adds the irises, if detected.
    fn with_irises(&self, mut points: Vec<DVec3>, focal_px: f64) -> Vec<DVec3> {
        let mean = points.iter().map(|point| point.z).sum::<f64>() / points.len() as f64;
        let times = if focal_px.is_finite() { 1.0 / (1.0 - mean / focal_px) } else { 1.0 };
        for point in &mut points {
            let aside = (point.truncate() - self.principal_px) * times;
            *point = (self.principal_px + aside).extend((point.z - mean) * times);
        }
        let depths: Vec<f64> = points.iter().map(|point| point.z).collect();
        let irises = self.landmarks_px[LANDMARK_COUNT..].iter().zip(iris_depths(&depths, &self.depths()));
        points.extend(irises.map(|(seen, z)| camera::unprojected(seen.truncate(), z, focal_px, self.principal_px)));
        points
    }

    fn on_rays(&self, depths: &[f64], focal_px: f64) -> Vec<DVec3> {
        let points = self.landmarks_px.iter().zip(depths);
        points.map(|(seen, &z)| camera::unprojected(seen.truncate(), z, focal_px, self.principal_px)).collect()
    }

    /// Size relative to the canonical face.
    fn scale(&self, points: &[DVec3], px_from_model: &Similarity, focal_px: f64) -> Result<(f64, Scale), FaceError> {
        let canonical_m_per_px = 1.0 / px_from_model.scale;
        let Some(card_px) = self.card_px else {
            return Ok(size::scale(points, canonical_m_per_px, camera::turn_rad(px_from_model.rotation)));
        };
        let principal = self.principal_px.extend(0.0);
        let points: Vec<DVec3> = points.iter().map(|&point| point - principal).collect();
        Ok(size::scale_by_card(card::m_per_px(&points, card_px, focal_px)?, canonical_m_per_px))
    }

    fn placed(
        &self,
        points: &[DVec3],
        px_from_model: Similarity,
        focal_px: f64,
        lens: PhotoLens,
        log_interval: [f64; 2],
    ) -> Result<Fitted, FaceError> {
        let (factor, scale) = self.scale(points, &px_from_model, focal_px)?;
        let model_from_px = px_from_model.inverse();
        let m_per_px = factor / px_from_model.scale;
        let distance_m = focal_px * m_per_px;
        let camera_m = if distance_m.is_finite() { distance_m } else { PARALLEL_M };
        let offset = px_from_model.translation - self.principal_px.extend(0.0);
        let camera = Camera {
            lens,
            focal_px,
            principal_px: DVec2::new(self.principal_px.x, -self.principal_px.y),
            px_per_m: m_per_px.recip(),
            distance_m,
            distance_interval_m: match lens {
                PhotoLens::Distance(_) | PhotoLens::Parallel => [distance_m; 2],
                _ => camera::interval_m(distance_m, log_interval, scale.error),
            },
            camera_from_model: DAffine3::from_mat3_translation(
                px_from_model.rotation,
                offset * m_per_px - DVec3::Z * camera_m,
            ),
        };
        let image_from_px = px_from_image(self.size_px).inverse().matrix3;
        Ok(Fitted {
            positions_m: points.iter().map(|&point| model_from_px.apply(point) * factor).collect(),
            camera,
            scale,
            factor,
            log_interval,
            image_from_model: image_from_px * (px_from_model.rotation * px_from_model.scale) * (1.0 / factor),
        })
    }
}

/// Depths of the irises, at the detected offset from the lids.
fn iris_depths(depths: &[f64], found: &[f64]) -> Vec<f64> {
    let lid = |point: usize| MIDDLE_OF_LIDS[(point - LANDMARK_COUNT) / POINTS_OF_AN_IRIS][0];
    (LANDMARK_COUNT..found.len()).map(|point| found[point] + depths[lid(point)] - found[lid(point)]).collect()
}
