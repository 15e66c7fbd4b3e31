use glam::DVec3;
use rosto_laplacian::{Fairing, Operator};
use rosto_mesh::vertex_normals;

use crate::areas::Area;
use crate::{FaceError, LANDMARK_COUNT, Triangulation, canonical_positions_m};

/// Weight of the canonical shape relative to the detected depths.
const WEIGHT: f64 = 60.0;

/// Share of a landmark's offset from the canonical face that is a slide along the surface; the rest is the shape of
/// this face. Measured on heads of known shape.
const SLIDE: f64 = 0.5;
/// Smallest cosine between normal and view direction with which a slide is converted to a depth.
const MIN_COSINE: f64 = 0.35;

/// Prior on the shape of a face: the canonical one.
pub(crate) struct CanonicalShape {
    fairing: Fairing,
    /// Share of the offset of each landmark that is a slide.
    slides: Vec<f64>,
}

impl CanonicalShape {
    pub(crate) fn new() -> Result<Self, FaceError> {
        let operator = Operator::Uniform.matrix(&Triangulation::Canonical.topology(), &canonical_positions_m());
        let fairing =
            operator.and_then(|operator| Fairing::new(&operator, WEIGHT)).map_err(|_| FaceError::Degenerate)?;
        let slides: Vec<f64> = (0..LANDMARK_COUNT as u32).map(slide).collect();
        let slides = fairing.faired(&slides).map_err(|_| FaceError::Degenerate)?;
        Ok(Self { fairing, slides })
    }

    /// Smooths a value per landmark along the surface.
    ///
    /// # Errors
    /// [`FaceError::Degenerate`] if a value is not finite.
    pub(crate) fn faired(&self, values: &[f64]) -> Result<Vec<f64>, FaceError> {
        self.fairing.faired(values).map_err(|_| FaceError::Degenerate)
    }

    /// Regularises detected depths. `canonical` is the canonical face fitted to the landmarks, `aside` the offset of
    /// each landmark from it in the picture, at the canonical depth; all in px.
    ///
    /// The differences from the canonical depths c minimise `|x − (found − c + s)|² + w |L x|²`, where L is the
    /// random-walk graph Laplacian: the δ-coordinates are drawn to those of the canonical face. A landmark that slid
    /// along the surface to another place gets the depth of that place, which differs by s.
    ///
    /// # Errors
    /// [`FaceError::Degenerate`] if a depth is not finite.
    pub(crate) fn depths(&self, found: &[f64], canonical: &[DVec3], aside: &[DVec3]) -> Result<Vec<f64>, FaceError> {
        let normals = vertex_normals(&Triangulation::Canonical.topology(), canonical);
        let nearer =
            normals.iter().zip(aside).map(|(n, aside)| -n.truncate().dot(aside.truncate()) / n.z.max(MIN_COSINE));
        let differences = found.iter().zip(canonical).zip(nearer.zip(&self.slides));
        let differences: Vec<f64> =
            differences.map(|((found, point), (nearer, slide))| found - point.z + slide * nearer).collect();
        let faired = self.faired(&differences)?;
        Ok(canonical.iter().zip(faired).map(|(point, difference)| point.z + difference).collect())
    }
}

/// Landmarks of the mouth and the jaw do not slide: they differ between people and move with the expression.
fn slide(landmark: u32) -> f64 {
    match Area::of(landmark) {
        Area::Jaw | Area::LowerLip | Area::UpperLip | Area::MouthCorner | Area::ChinCrease => 0.0,
        _ => SLIDE,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    const NOWHERE: [DVec3; LANDMARK_COUNT] = [DVec3::ZERO; LANDMARK_COUNT];

    fn depths() -> Vec<f64> {
        canonical_positions_m().iter().map(|position| position.z).collect()
    }

    #[test]
    fn a_shifted_canonical_shape_is_unchanged() {
        let found: Vec<f64> = depths().iter().map(|z| z + 0.3).collect();
        let smooth = CanonicalShape::new().unwrap().depths(&found, &canonical_positions_m(), &NOWHERE).unwrap();
        assert!(smooth.iter().zip(&found).all(|(a, b)| (a - b).abs() < 1e-9));
    }

    #[test]
    fn an_outlier_is_reduced() {
        let mut found = depths();
        found[50] += 0.01;
        let smooth = CanonicalShape::new().unwrap().depths(&found, &canonical_positions_m(), &NOWHERE).unwrap();
        let mean = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
        assert!((mean(&smooth) - mean(&found)).abs() < 1e-4, "the mean depth is preserved");
        assert!((0.0..0.005).contains(&(smooth[50] - depths()[50])));
    }

    #[test]
    fn a_cheek_that_slid_outwards_is_drawn_to_the_surface() {
        const CHEEK: usize = 123;
        let canonical = canonical_positions_m();
        let side = canonical[CHEEK].x.signum();
        let outwards =
            |position_m: &DVec3| if position_m.x * side > 0.02 { DVec3::X * side * 0.004 } else { DVec3::ZERO };
        let aside: Vec<DVec3> = canonical.iter().map(outwards).collect();
        let moved = CanonicalShape::new().unwrap().depths(&depths(), &canonical, &aside).unwrap();
        let deeper = canonical[CHEEK].z - moved[CHEEK];
        assert!((0.000_5..0.004).contains(&deeper), "{deeper}");
    }
}
