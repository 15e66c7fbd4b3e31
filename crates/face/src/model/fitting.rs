//! Where the landmarks of a photo lie in the canonical face's frame, and where the camera stood.

use glam::{DAffine3, DMat3, DVec2, DVec3};

use super::seen::{fit_canonical_to, in_px, px_from_image};
use crate::camera::{self, Camera, CanonicalShape, Evidence, PARALLEL_M};
use crate::irises::{MIDDLE_OF_LIDS, POINTS_OF_AN_IRIS};
use crate::photo_lens::DISTANCES_M;
use crate::procrustes::Similarity;
use crate::size::{self, Scale};
use crate::{FaceError, LANDMARK_COUNT, PhotoLens, canonical_positions_m};

/// Landmarks in the model's frame.
#[derive(Clone)]
pub(super) struct Fitted {
    /// 468, or 478 with the irises.
    pub(super) positions_m: Vec<DVec3>,
    pub(super) camera: Camera,
    pub(super) scale: Scale,
    pub(super) image_from_model: DMat3,
    /// How many times the canonical face's size this one has.
    factor: f64,
    /// Of the distance, before that of the size is added.
    error: f64,
}

/// Lens data of the photo are set aside if they make what is seen less likely than e to the power of minus this.
const MOST_CONTRADICTION: f64 = 20.0;

impl Fitted {
    pub(super) fn new(landmarks: &[[f32; 3]], size_px: [u32; 2], lens: PhotoLens) -> Result<Self, FaceError> {
        Sight::new(landmarks, size_px)?.fitted(lens)
    }

    /// Those of [`Self::positions_m`] that are landmarks.
    pub(super) fn landmarks_m(&self) -> &[DVec3] {
        &self.positions_m[..LANDMARK_COUNT]
    }

    /// How large the face is taken to be beside the canonical one, and so how far away it is.
    fn canonical_distance_m(&self) -> f64 {
        self.camera.distance_m / self.factor
    }
}

/// Landmarks as they are seen: px, y up, z towards the camera and 0 in the mean.
pub(super) struct Sight {
    seen: Vec<DVec3>,
    /// The canonical face as if it were seen from infinitely far away, whatever the lens is.
    px_from_model: Similarity,
    size_px: [u32; 2],
    principal_px: DVec2,
    /// What depths are drawn to, as much as the turn of the head asks for.
    shape: CanonicalShape,
}

impl Sight {
    pub(super) fn new(landmarks: &[[f32; 3]], size_px: [u32; 2]) -> Result<Self, FaceError> {
        let seen = in_px(landmarks, size_px)?;
        let principal_px = DVec2::new(f64::from(size_px[0]), -f64::from(size_px[1])) / 2.0;
        let px_from_model = fit_canonical_to(&seen)?;
        let shape = CanonicalShape::new(camera::turn_rad(px_from_model.rotation))?;
        Ok(Self { seen, px_from_model, size_px, principal_px, shape })
    }

    /// The face by this photo alone.
    pub(super) fn fitted(&self, lens: PhotoLens) -> Result<Fitted, FaceError> {
        match lens.checked()? {
            PhotoLens::Parallel => self.parallel(),
            PhotoLens::Estimated => self.estimated(&self.evidence()?),
            PhotoLens::Distance(distance_m) => self.from(distance_m),
            PhotoLens::Given(focal_length_mm) => self.through(focal_length_mm, lens),
            PhotoLens::Exif(focal_length_mm) => {
                let fitted = self.through(focal_length_mm, lens)?;
                let evidence = self.evidence()?;
                let log_likelihood = evidence.log_likelihood(fitted.canonical_distance_m());
                if log_likelihood < -MOST_CONTRADICTION { self.estimated(&evidence) } else { Ok(fitted) }
            }
        }
    }

    /// How much the face looks at the camera, as the cosine, and how large it is, in px per m of the canonical face.
    pub(super) fn frontal(&self) -> (f64, f64) {
        (self.px_from_model.rotation.z_axis.z, self.px_from_model.scale)
    }

    /// The face of [`Self::fitted`] with each landmark nearer to the camera by so many metres. All of it is then made larger or
    /// smaller about the camera, so that the middle stays where it is.
    pub(super) fn nearer(&self, alone: &Fitted, by_m: &[f64]) -> Result<Fitted, FaceError> {
        let Camera { focal_px, distance_m, px_per_m, lens, .. } = alone.camera;
        let standing_m = if distance_m.is_finite() { distance_m } else { PARALLEL_M };
        let depths =
            alone.positions_m.iter().zip(by_m).map(|(&place_m, nearer_m)| {
                (alone.camera.towards_camera_m(place_m) + standing_m + nearer_m) * px_per_m
            });
        let mut depths = about_the_middle(depths.collect(), focal_px);
        depths.extend(with_their_eyes(&depths, &self.depths()));
        let points = self.on_rays(&depths, focal_px);
        Ok(self.placed(&points, fit_canonical_to(&points)?, focal_px, lens, alone.error))
    }

    /// The face of [`Self::fitted`] again, where what was found to be `shape` tells better how large it is: a lens of which
    /// the distance is known has another focal length then.
    pub(super) fn as_large_as(&self, shape: &Fitted, alone: &Fitted) -> Result<Fitted, FaceError> {
        let share = match alone.camera.lens {
            PhotoLens::Distance(distance_m) => distance_m / shape.camera.distance_m,
            PhotoLens::Estimated => alone.canonical_distance_m() / shape.canonical_distance_m(),
            PhotoLens::Parallel | PhotoLens::Given(_) | PhotoLens::Exif(_) => 1.0,
        };
        match alone.camera.lens {
            PhotoLens::Parallel => self.parallel(),
            lens => self.seen_through(shape.camera.focal_px * share, lens, alone.error),
        }
    }

    fn evidence(&self) -> Result<Evidence, FaceError> {
        camera::evidence(&self.seen[..LANDMARK_COUNT], self.principal_px)
    }

    fn parallel(&self) -> Result<Fitted, FaceError> {
        Ok(self.placed(&self.seen, self.px_from_model, f64::INFINITY, PhotoLens::Parallel, 0.0))
    }

    fn estimated(&self, evidence: &Evidence) -> Result<Fitted, FaceError> {
        let focal_px = self.focal_px_for(|_, px_from_model| evidence.distance_m * px_from_model.scale)?;
        self.seen_through(focal_px, PhotoLens::Estimated, evidence.error)
    }

    fn through(&self, focal_length_mm: f64, lens: PhotoLens) -> Result<Fitted, FaceError> {
        self.seen_through(camera::focal_px(focal_length_mm, self.size_px), lens, 0.0)
    }

    /// From a distance that is meant for the face in its true size.
    fn from(&self, distance_m: f64) -> Result<Fitted, FaceError> {
        let focal_px = self.focal_px_for(|points, px_from_model| {
            let (factor, _) = size::scale(points, 1.0 / px_from_model.scale);
            distance_m / factor * px_from_model.scale
        })?;
        self.seen_through(focal_px, PhotoLens::Distance(distance_m), 0.0)
    }

    /// The focal length that depends on how large the face is, which depends on the focal length: with the depths that were
    /// found first, which are near enough to begin with.
    fn focal_px_for(&self, of: impl Fn(&[DVec3], &Similarity) -> f64) -> Result<f64, FaceError> {
        const ROUGH_STEPS: usize = 5;
        const STEPS: usize = 2;
        let mut focal_px = of(&self.seen, &self.px_from_model);
        for _ in 0..ROUGH_STEPS {
            let points = self.on_rays(&self.depths(), focal_px);
            focal_px = of(&points, &fit_canonical_to(&points)?);
        }
        for _ in 0..STEPS {
            let (points, px_from_model) = self.unprojected(focal_px)?;
            focal_px = of(&points, &px_from_model);
        }
        Ok(focal_px)
    }

    fn seen_through(&self, focal_px: f64, lens: PhotoLens, error: f64) -> Result<Fitted, FaceError> {
        // No part of a face is behind its camera.
        let focal_px = focal_px.max(DISTANCES_M.start() * self.px_from_model.scale);
        let (points, px_from_model) = self.unprojected(focal_px)?;
        Ok(self.placed(&points, px_from_model, focal_px, lens, error))
    }

    /// As they were found.
    fn depths(&self) -> Vec<f64> {
        self.seen.iter().map(|point| point.z).collect()
    }

    /// The points on their rays, their depths drawn to the canonical shape, and the canonical face fitted to them.
    fn unprojected(&self, focal_px: f64) -> Result<(Vec<DVec3>, Similarity), FaceError> {
        const STEPS: usize = 2;
        let canonical = canonical_positions_m();
        let found = self.depths();
        let mut points = self.on_rays(&found, focal_px);
        let mut px_from_model = fit_canonical_to(&points)?;
        for _ in 0..STEPS {
            let depths: Vec<f64> = canonical.iter().map(|&position| px_from_model.apply(position).z).collect();
            let mut drawn = self.shape.drawn(&found[..LANDMARK_COUNT], &depths)?;
            let mean = drawn.iter().sum::<f64>() / drawn.len() as f64;
            drawn.iter_mut().for_each(|z| *z -= mean);
            drawn.extend(with_their_eyes(&drawn, &found));
            points = self.on_rays(&drawn, focal_px);
            px_from_model = fit_canonical_to(&points)?;
        }
        Ok((points, px_from_model))
    }

    fn on_rays(&self, depths: &[f64], focal_px: f64) -> Vec<DVec3> {
        let points = self.seen.iter().zip(depths);
        points.map(|(seen, &z)| camera::unprojected(seen.truncate(), z, focal_px, self.principal_px)).collect()
    }

    fn placed(
        &self,
        points: &[DVec3],
        px_from_model: Similarity,
        focal_px: f64,
        lens: PhotoLens,
        error: f64,
    ) -> Fitted {
        let (factor, scale) = size::scale(points, 1.0 / px_from_model.scale);
        let model_from_px = px_from_model.inverse();
        let m_per_px = factor / px_from_model.scale;
        let distance_m = focal_px * m_per_px;
        let standing_m = if distance_m.is_finite() { distance_m } else { PARALLEL_M };
        let aside = px_from_model.translation - self.principal_px.extend(0.0);
        let camera = Camera {
            lens,
            focal_px,
            principal_px: DVec2::new(self.principal_px.x, -self.principal_px.y),
            px_per_m: m_per_px.recip(),
            distance_m,
            distance_error: match lens {
                PhotoLens::Distance(_) => 0.0,
                _ => error.hypot(scale.error),
            },
            camera_from_model: DAffine3::from_mat3_translation(
                px_from_model.rotation,
                aside * m_per_px - DVec3::Z * standing_m,
            ),
        };
        let image_from_px = px_from_image(self.size_px).inverse().matrix3;
        Fitted {
            positions_m: points.iter().map(|&point| model_from_px.apply(point) * factor).collect(),
            camera,
            scale,
            factor,
            error,
            image_from_model: image_from_px * (px_from_model.rotation * px_from_model.scale) * (1.0 / factor),
        }
    }
}

/// Depths that are 0 in the mean, of points that are made larger or smaller about the camera together.
fn about_the_middle(mut depths: Vec<f64>, focal_px: f64) -> Vec<f64> {
    let mean = depths.iter().sum::<f64>() / depths.len() as f64;
    let times = if focal_px.is_finite() { 1.0 / (1.0 - mean / focal_px) } else { 1.0 };
    depths.iter_mut().for_each(|z| *z = (*z - mean) * times);
    depths
}

/// The irises' depths: as far before or behind the lids as they were found.
fn with_their_eyes(drawn: &[f64], found: &[f64]) -> Vec<f64> {
    let lid = |point: usize| MIDDLE_OF_LIDS[(point - LANDMARK_COUNT) / POINTS_OF_AN_IRIS][0];
    (LANDMARK_COUNT..found.len()).map(|point| found[point] + drawn[lid(point)] - found[lid(point)]).collect()
}
