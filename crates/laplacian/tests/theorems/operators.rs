use nalgebra::DMatrix;
use rosto_laplacian::Operator;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::meshes::{Mesh, canonical_face, plane, small};
use crate::seeded::Seeded;

fn dense(mesh: &Mesh, operator: Operator) -> DMatrix<f64> {
    DMatrix::from(&operator.matrix(&mesh.topology, &mesh.positions).unwrap())
}

fn symmetric() -> impl Iterator<Item = Operator> {
    let scaled = [Operator::Uniform, Operator::CotangentMass];
    Operator::ALL.into_iter().filter(move |operator| !scaled.contains(operator))
}

fn each(check: impl Fn(&Mesh, Operator)) {
    for mesh in small() {
        Operator::ALL.into_iter().for_each(|operator| check(&mesh, operator));
    }
}

#[test]
fn rows_sum_to_zero() {
    each(|mesh, operator| {
        let worst = dense(mesh, operator).column_sum().amax();
        assert!(worst < 1e-12, "{operator:?} on {}: {worst:e}", mesh.name);
    });
}

#[test]
fn operators_without_scaled_rows_are_symmetric() {
    for mesh in small() {
        for operator in symmetric() {
            let matrix = dense(&mesh, operator);
            assert_eq!(matrix, matrix.transpose(), "{operator:?} on {}", mesh.name);
        }
    }
}

#[test]
fn symmetric_operators_are_semi_definite_with_one_zero_per_component() {
    for mesh in small() {
        let mut components = mesh.topology.components();
        components.sort_unstable();
        components.dedup();
        for operator in symmetric() {
            let mut eigenvalues = dense(&mesh, operator).symmetric_eigenvalues().as_slice().to_vec();
            eigenvalues.sort_by(f64::total_cmp);
            let (zeros, rest) = eigenvalues.split_at(components.len());
            assert!(zeros.iter().all(|value| value.abs() < 1e-12), "{operator:?} on {}: {zeros:?}", mesh.name);
            assert!(rest[0] > 1e-3, "{operator:?} on {}: {}", mesh.name, rest[0]);
        }
    }
}

#[test]
fn the_random_walk_operator_is_similar_to_a_symmetric_one() {
    for mesh in small() {
        let degrees: Vec<f64> =
            (0..mesh.vertex_count() as u32).map(|v| mesh.topology.degree(v).max(1) as f64).collect();
        let mut similar = dense(&mesh, Operator::Uniform);
        for ((i, j), value) in
            (0..similar.len()).map(|k| (k % degrees.len(), k / degrees.len())).zip(similar.iter_mut())
        {
            *value *= (degrees[i] / degrees[j]).sqrt();
        }
        assert!((&similar - similar.transpose()).amax() < 1e-15);
        let eigenvalues = similar.symmetric_eigenvalues();
        assert!(eigenvalues.min() > -1e-14 && eigenvalues.max() < 2.0 + 1e-14);
    }
}

#[test]
fn the_mass_weighted_operator_minimises_the_integral_of_the_squared_laplacian() {
    // `Σ mᵢ (Δd)ᵢ²` with `Δd = M⁻¹ L d`, computed per triangle.
    for mesh in small() {
        let random = &mut Seeded::new(7);
        let d = DMatrix::from_fn(mesh.vertex_count(), 1, |_, _| random.signed());
        let mut mass = vec![0.0; mesh.vertex_count()];
        for corners in mesh.topology.triangles() {
            let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize]);
            let third = (b - a).cross(c - a).length() / 6.0;
            corners.iter().for_each(|&corner| mass[corner as usize] += third);
        }
        let mean = mass.iter().sum::<f64>() / mass.len() as f64;
        if mass.iter().any(|mass| *mass < 0.01 * mean) {
            continue;
        }
        let stiffness = dense(&mesh, Operator::Cotangent) * &d;
        let integral: f64 = stiffness.iter().zip(&mass).map(|(value, mass)| value * value * mean / mass).sum();
        let minimised = (dense(&mesh, Operator::CotangentMass) * &d).norm_squared();
        assert!((minimised - integral).abs() < 1e-12 * integral, "{}: {minimised} and {integral}", mesh.name);
    }
}

#[test]
fn the_papers_operators_match_its_equations() {
    let mesh = canonical_face();
    let (symmetric, normalised) = (dense(&mesh, Operator::UniformSymmetric), dense(&mesh, Operator::Uniform));
    for i in 0..468 {
        let degree = mesh.topology.degree(i as u32) as f64;
        for j in 0..468 {
            let joined = mesh.topology.neighbours(i as u32).contains(&(j as u32));
            assert_eq!(symmetric[(i, j)], if i == j { degree } else { -f64::from(u8::from(joined)) });
            assert_eq!(normalised[(i, j)], symmetric[(i, j)] / degree);
        }
    }
}

#[test]
fn the_cotangent_operator_has_linear_precision_on_any_triangulated_plane() {
    for seed in 0..20 {
        let mesh = plane(6, 5, &mut Seeded::new(seed));
        let matrix = dense(&mesh, Operator::Cotangent);
        let rim = mesh.topology.boundary_loops().concat();
        for axis in 0..2 {
            let linear = DMatrix::from_iterator(mesh.vertex_count(), 1, mesh.positions.iter().map(|p| p[axis]));
            let delta = &matrix * linear;
            for vertex in (0..mesh.vertex_count()).filter(|&vertex| !rim.contains(&(vertex as u32))) {
                assert!(delta[vertex].abs() < 1e-12, "seed {seed}, vertex {vertex}: {:e}", delta[vertex]);
            }
        }
    }
}

#[test]
fn operators_are_invariant_to_similarity_transforms() {
    each(|mesh, operator| {
        let random = &mut Seeded::new(mesh.vertex_count() as u64);
        let (turn, shift, scale) = (random.rotation(), 5.0 * random.vector(), 3.7);
        let moved = mesh.positions.iter().map(|&position| turn * position * scale + shift).collect();
        let moved = Mesh { name: mesh.name, topology: mesh.topology.clone(), positions: moved };
        let difference = (dense(mesh, operator) - dense(&moved, operator)).amax();
        assert!(difference < 1e-11, "{operator:?} on {}: {difference:e}", mesh.name);
    });
}

#[test]
fn short_edges_and_high_degrees_weigh_more() {
    let mesh = plane(5, 4, &mut Seeded::new(3));
    let (lengths, degrees) = (dense(&mesh, Operator::InverseLength), dense(&mesh, Operator::Degree));
    let edges = mesh.topology.edges();
    let length = |&[a, b]: &[u32; 2]| mesh.positions[a as usize].distance(mesh.positions[b as usize]);
    let busy = |&[a, b]: &[u32; 2]| mesh.topology.degree(a) + mesh.topology.degree(b);
    for (one, other) in edges.iter().zip(&edges[1..]) {
        let weigh = |matrix: &DMatrix<f64>, edge: &[u32; 2]| -matrix[(edge[0] as usize, edge[1] as usize)];
        assert_eq!(length(one) < length(other), weigh(&lengths, one) > weigh(&lengths, other));
        assert_eq!(busy(one) > busy(other), weigh(&degrees, one) > weigh(&degrees, other));
    }
}
