use nalgebra::{DMatrix, DVector};
use nalgebra_sparse::CsrMatrix;
use rosto_laplacian::{Fairing, LaplacianError, Operator};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::meshes::small;
use crate::seeded::Seeded;

fn faired(operator: &CsrMatrix<f64>, values: &[f64], weight: f64) -> Result<Vec<f64>, LaplacianError> {
    Fairing::new(operator, weight)?.faired(values)
}

const WEIGHTS: [f64; 3] = [0.1, 30.0, 1e4];

#[test]
fn faired_values_solve_the_dense_normal_equations() {
    for mesh in small() {
        let mut seeded = Seeded::new(5);
        let values: Vec<f64> = mesh.positions.iter().map(|_| seeded.signed()).collect();
        for operator in Operator::ALL {
            let matrix = operator.matrix(&mesh.topology, &mesh.positions).unwrap();
            let dense = DMatrix::from(&matrix);
            for weight in WEIGHTS {
                let found = DVector::from(faired(&matrix, &values, weight).unwrap());
                let normal = DMatrix::identity(values.len(), values.len()) + dense.tr_mul(&dense) * weight;
                let off = (normal * &found - DVector::from(values.clone())).amax();
                let scale = 1.0 + weight * dense.norm_squared();
                assert!(off < 1e-13 * scale, "{operator:?} on {} by {weight}: {off:e}", mesh.name);
            }
        }
    }
}

#[test]
fn fairing_keeps_constants_and_the_mean_under_a_symmetric_operator() {
    for mesh in small() {
        let mut seeded = Seeded::new(6);
        let values: Vec<f64> = mesh.positions.iter().map(|_| seeded.signed()).collect();
        let matrix = Operator::UniformSymmetric.matrix(&mesh.topology, &mesh.positions).unwrap();
        for weight in WEIGHTS {
            let constant = faired(&matrix, &vec![2.5; values.len()], weight).unwrap();
            assert!(constant.iter().all(|value| (value - 2.5).abs() < 1e-8), "{} by {weight}", mesh.name);
            let sum = |values: &[f64]| values.iter().sum::<f64>();
            let moved = sum(&faired(&matrix, &values, weight).unwrap()) - sum(&values);
            assert!(moved.abs() < 1e-7, "{} by {weight}: {moved:e}", mesh.name);
        }
    }
}

#[test]
fn invalid_weights_and_values_are_rejected() {
    let mesh = &small()[0];
    let matrix = Operator::Uniform.matrix(&mesh.topology, &mesh.positions).unwrap();
    let values = vec![0.0; mesh.positions.len()];
    for weight in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(faired(&matrix, &values, weight), Err(LaplacianError::Weight { .. })));
    }
    assert!(matches!(faired(&matrix, &values[1..], 1.0), Err(LaplacianError::LengthMismatch { .. })));
    let hole: Vec<f64> = (0..values.len()).map(|i| if i == 2 { f64::NAN } else { 0.0 }).collect();
    assert_eq!(faired(&matrix, &hole, 1.0), Err(LaplacianError::NotFinite { vertex: 2 }));
}
