use glam::{DMat3, DQuat};
use nalgebra::Matrix4;

/// The rotation `R` that maximises `Σ w ⟨b, R a⟩` for pairs of vectors with covariance `Σ w b aᵀ`.
///
/// Horn's closed form (1987): the unit quaternion of the greatest eigenvalue of a symmetric 4 × 4 matrix. Works for any
/// rank; if several rotations are optimal, returns one of them.
pub(crate) fn best_rotation(covariance: &DMat3) -> DMat3 {
    let greatest = covariance.to_cols_array().into_iter().map(f64::abs).fold(0.0, f64::max);
    if greatest == 0.0 || !greatest.is_finite() {
        return DMat3::IDENTITY;
    }
    let [x, y, z] = (*covariance * greatest.recip()).to_cols_array_2d();
    // x[1] is the y of b times the x of a.
    let [a, b, c] = [y[2] - z[1], z[0] - x[2], x[1] - y[0]];
    let [d, e, f] = [x[1] + y[0], z[0] + x[2], y[2] + z[1]];
    #[rustfmt::skip]
    let form = Matrix4::new(
        x[0] + y[1] + z[2], a, b, c,
        a, x[0] - y[1] - z[2], d, e,
        b, d, y[1] - x[0] - z[2], f,
        c, e, f, z[2] - x[0] - y[1],
    );
    let eigen = form.symmetric_eigen();
    let best = eigen.eigenvectors.column(eigen.eigenvalues.imax());
    DMat3::from_quat(DQuat::from_xyzw(best[1], best[2], best[3], best[0]).normalize())
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use glam::DVec3;
    use proptest::prelude::*;

    use super::*;

    fn covariance(pairs: &[(DVec3, DVec3)]) -> DMat3 {
        pairs.iter().fold(DMat3::ZERO, |sum, (a, b)| sum + DMat3::from_cols(*b * a.x, *b * a.y, *b * a.z))
    }

    fn vector() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from)
    }

    fn quaternion() -> impl Strategy<Value = DQuat> {
        let long = |q: &[f64; 4]| q.iter().map(|x| x * x).sum::<f64>() > 0.1;
        prop::array::uniform4(-1.0..1.0f64)
            .prop_filter("long enough", long)
            .prop_map(|q| DQuat::from_array(q).normalize())
    }

    proptest! {
        #[test]
        fn rotated_vectors_give_back_their_rotation(turn in quaternion(), vectors in prop::array::uniform4(vector())) {
            prop_assume!(vectors[0].cross(vectors[1]).length() > 0.05);
            let pairs = vectors.map(|vector| (vector, turn * vector));
            let found = best_rotation(&covariance(&pairs));
            for (before, after) in pairs {
                prop_assert!((found * before - after).length() < 1e-9);
            }
        }

        #[test]
        fn no_other_rotation_is_better(pairs in prop::array::uniform4((vector(), vector())), other in quaternion()) {
            let fit = |rotation: DMat3| pairs.iter().map(|(a, b)| b.dot(rotation * *a)).sum::<f64>();
            prop_assert!(fit(best_rotation(&covariance(&pairs))) >= fit(DMat3::from_quat(other)) - 1e-12);
        }

        #[test]
        fn result_is_a_rotation_for_any_rank(vector in vector(), image in vector(), exponent in -250..250i32) {
            let scale = 10f64.powi(exponent);
            let found = best_rotation(&(covariance(&[(vector, image)]) * scale));
            prop_assert!((found * found.transpose() - DMat3::IDENTITY).to_cols_array().iter().all(|x| x.abs() < 1e-12));
            prop_assert!((found.determinant() - 1.0).abs() < 1e-12);
        }
    }
}
