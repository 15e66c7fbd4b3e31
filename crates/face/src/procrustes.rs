use glam::{DMat3, DVec3};
use nalgebra::{Matrix3, Vector3};

use crate::FaceError;

/// A similarity transform: `target = scale · rotation · source + translation`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Similarity {
    pub scale: f64,
    pub rotation: DMat3,
    pub translation: DVec3,
}

impl Similarity {
    pub(crate) fn inverse(&self) -> Self {
        let scale = 1.0 / self.scale;
        let rotation = self.rotation.transpose();
        Self { scale, rotation, translation: rotation * self.translation * -scale }
    }

    pub(crate) fn apply(&self, point: DVec3) -> DVec3 {
        self.rotation * point * self.scale + self.translation
    }
}

/// A weighted correspondence.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair {
    pub source: DVec3,
    pub target: DVec3,
    pub weight: f64,
}

/// Similarity transform with the least weighted squared error (Umeyama 1991, with weights).
///
/// # Errors
/// [`FaceError::Degenerate`] if the source or target points are collinear.
pub(crate) fn fit(pairs: &[Pair]) -> Result<Similarity, FaceError> {
    let total: f64 = pairs.iter().map(|pair| pair.weight).sum();
    let source_mean = pairs.iter().map(|pair| pair.source * pair.weight).sum::<DVec3>() / total;
    let target_mean = pairs.iter().map(|pair| pair.target * pair.weight).sum::<DVec3>() / total;
    let mut covariance = Matrix3::<f64>::zeros();
    let mut source_variance = 0.0;
    for pair in pairs {
        let (source, target) = (pair.source - source_mean, pair.target - target_mean);
        covariance += vector(target) * vector(source).transpose() * (pair.weight / total);
        source_variance += pair.weight / total * source.length_squared();
    }
    let (rotation, trace) = rotation_and_trace(&covariance)?;
    let scale = trace / source_variance;
    Ok(Similarity { scale, rotation, translation: target_mean - rotation * source_mean * scale })
}

/// The proper rotation closest to the covariance, and the trace of `D·S`, which gives the scale.
fn rotation_and_trace(covariance: &Matrix3<f64>) -> Result<(DMat3, f64), FaceError> {
    // A covariance of rank two, as of a flat face, still determines a proper rotation; rank one does not.
    const RANK_TOLERANCE: f64 = 1e-9;
    let svd = covariance.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return Err(FaceError::Degenerate) };
    let d = svd.singular_values;
    let proper = d[1].is_finite() && d[1] > RANK_TOLERANCE * d[0];
    if !proper {
        return Err(FaceError::Degenerate);
    }
    let handedness = (u.determinant() * v_t.determinant()).signum();
    let flip = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, handedness));
    let rotation = u * flip * v_t;
    Ok((DMat3::from_cols_slice(rotation.as_slice()), d[0] + d[1] + d[2] * handedness))
}

fn vector(v: DVec3) -> Vector3<f64> {
    Vector3::new(v.x, v.y, v.z)
}
