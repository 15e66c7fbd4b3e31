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
pub(super) struct Fitted {
    /// 468, or 478 with the irises.
    pub(super) positions_m: Vec<DVec3>,
    pub(super) camera: Camera,
    pub(super) scale: Scale,
    pub(super) image_from_model: DMat3,
    /// How many times the canonical face's size this one has.
    factor: f64,
}

/// Lens data of the photo are set aside if they make what is seen less likely than e to the power of minus this.
const MOST_CONTRADICTION: f64 = 20.0;

impl Fitted {
    pub(super) fn new(landmarks: &[[f32; 3]], size_px: [u32; 2], lens: PhotoLens) -> Result<Self, FaceError> {
        let seen = in_px(landmarks, size_px)?;
        let principal_px = DVec2::new(f64::from(size_px[0]), -f64::from(size_px[1])) / 2.0;
        let shape = CanonicalShape::new(camera::turn_rad(fit_canonical_to(&seen)?.rotation))?;
        let sight = Sight { seen, size_px, principal_px, shape };
        match lens.checked()? {
            PhotoLens::Parallel => sight.parallel(),
            PhotoLens::Estimated => sight.estimated(&sight.evidence()?),
            PhotoLens::Distance(distance_m) => sight.from(distance_m),
            PhotoLens::Given(focal_length_mm) => sight.through(focal_length_mm, lens),
            PhotoLens::Exif(focal_length_mm) => {
                let fitted = sight.through(focal_length_mm, lens)?;
                let evidence = sight.evidence()?;
                let log_likelihood = evidence.log_likelihood(fitted.camera.distance_m / fitted.factor);
                if log_likelihood < -MOST_CONTRADICTION { sight.estimated(&evidence) } else { Ok(fitted) }
            }
        }
    }
}

/// Landmarks as they are seen: px, y up, z towards the camera and 0 in the mean.
struct Sight {
    seen: Vec<DVec3>,
    size_px: [u32; 2],
    principal_px: DVec2,
    /// What depths are drawn to, as much as the turn of the head asks for.
    shape: CanonicalShape,
}

impl Sight {
    fn evidence(&self) -> Result<Evidence, FaceError> {
        camera::evidence(&self.seen[..LANDMARK_COUNT], self.principal_px)
    }

    fn parallel(&self) -> Result<Fitted, FaceError> {
        let px_from_model = fit_canonical_to(&self.seen)?;
        Ok(self.placed(&self.seen, px_from_model, f64::INFINITY, PhotoLens::Parallel, 0.0))
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
        let mut focal_px = of(&self.seen, &fit_canonical_to(&self.seen)?);
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
        let focal_px = focal_px.max(DISTANCES_M.start() * fit_canonical_to(&self.seen)?.scale);
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
            image_from_model: image_from_px * px_from_model.to_affine().matrix3 * (1.0 / factor),
        }
    }
}

/// The irises' depths: as far before or behind the lids as they were found.
fn with_their_eyes(drawn: &[f64], found: &[f64]) -> Vec<f64> {
    let lid = |point: usize| MIDDLE_OF_LIDS[(point - LANDMARK_COUNT) / POINTS_OF_AN_IRIS][0];
    (LANDMARK_COUNT..found.len()).map(|point| found[point] + drawn[lid(point)] - found[lid(point)]).collect()
}
