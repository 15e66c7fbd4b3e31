//! Comparison with NumPy and libigl on the canonical face and two other meshes (`tests/golden/engine.json`, written by
//! `tests/reference/engine.py`).

use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Constraints, Geodesics, LaplacianSystem, Operator, RigidOptions, RigidSystem};
use rosto_mesh::Topology;
use serde_json::Value;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::golden::{golden, indices, points};

struct Reference {
    answers: Value,
    topology: Topology,
    rest: Vec<DVec3>,
    handle: u32,
    anchors: Vec<u32>,
    offset: DVec3,
}

impl Reference {
    fn all() -> Vec<Self> {
        let file = golden(include_str!("../../../../tests/golden/engine.json"));
        let meshes: Vec<Self> = file["meshes"].as_array().unwrap().iter().cloned().map(Self::new).collect();
        assert_eq!(meshes.len(), 3);
        meshes
    }

    fn new(answers: Value) -> Self {
        let rest = points(&answers["vertices"]);
        let triangles = answers["triangles"].as_array().unwrap().iter().map(indices).collect();
        let [handle] = indices(&Value::from(vec![answers["handle"].clone()]));
        let anchors = answers["anchors"].as_array().unwrap().iter().map(|v| v.as_u64().unwrap() as u32).collect();
        let offset = points(&Value::from(vec![answers["offset"].clone()]))[0];
        Self { topology: Topology::new(rest.len(), triangles).unwrap(), rest, handle, anchors, offset, answers }
    }

    fn name(&self) -> &Value {
        &self.answers["name"]
    }

    fn numbers(&self, answer: &str) -> Vec<f64> {
        self.answers[answer].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
    }

    /// Greatest distance from `found` to the points of an answer, relative to the offset.
    fn worst(&self, answer: &str, found: &[DVec3]) -> f64 {
        let distances = points(&self.answers[answer]).into_iter().zip(found).map(|(a, b)| a.distance(*b));
        distances.fold(0.0, f64::max) / self.offset.length()
    }
}

#[test]
fn the_papers_edit_equals_numpys_pseudo_inverse() {
    for reference in Reference::all() {
        let system = LaplacianSystem::new(&reference.topology, &reference.rest, Operator::UniformSymmetric).unwrap();
        let handles = [reference.handle];
        let constraints = Constraints { handles: &handles, anchors: &reference.anchors[..2], ..Default::default() };
        let mut edited = reference.rest.clone();
        system.respond(&constraints).unwrap().displace(&reference.rest, &[reference.offset], &mut edited);
        let worst = reference.worst("paper", &edited);
        assert!(worst < 1e-9, "{}: {worst:e}", reference.name());
    }
}

#[test]
fn the_cotangent_operator_is_the_negative_of_libigls() {
    for reference in Reference::all() {
        let matrix = Operator::Cotangent.matrix(&reference.topology, &reference.rest).unwrap();
        let entries = reference.answers["cotangent"].as_array().unwrap();
        assert_eq!(entries.len(), reference.topology.vertex_count() + reference.topology.edges().len());
        for entry in entries {
            let [row, column] = indices(entry).map(|index| index as usize);
            let (own, theirs) = (matrix.get_entry(row, column).unwrap().into_value(), entry[2].as_f64().unwrap());
            assert!((own + theirs).abs() < 1e-10, "{}: {own} at {row}, {column} for {theirs}", reference.name());
        }
    }
}

#[test]
fn hard_cotangent_edits_equal_libigls_biharmonic_fields() {
    for reference in Reference::all() {
        let system = LaplacianSystem::new(&reference.topology, &reference.rest, Operator::Cotangent).unwrap();
        let handles = [reference.handle];
        let constraints =
            Constraints { handles: &handles, anchors: &reference.anchors, kind: ConstraintKind::Hard, falloff: None };
        let response = system.respond(&constraints).unwrap();
        let difference = response.field(0).iter().zip(reference.numbers("biharmonic")).map(|(a, b)| (a - b).abs());
        let worst = difference.fold(0.0, f64::max);
        assert!(worst < 1e-9, "{}: {worst:e}", reference.name());
    }
}

#[test]
fn libigls_harmonic_fields_have_zero_delta_at_free_vertices() {
    for reference in Reference::all() {
        let system = LaplacianSystem::new(&reference.topology, &reference.rest, Operator::Cotangent).unwrap();
        let field: Vec<DVec3> = reference.numbers("harmonic").into_iter().map(DVec3::splat).collect();
        for (vertex, delta) in system.deltas(&field).into_iter().enumerate() {
            let constrained = reference.anchors.contains(&(vertex as u32)) || vertex as u32 == reference.handle;
            assert!(constrained || delta.length() < 1e-10, "{}: {delta} at {vertex}", reference.name());
        }
    }
}

/// libigl fits its rotations in single precision and stops slightly above the minimum of the energy.
#[test]
fn rigid_edits_converge_to_libigls_at_no_higher_energy() {
    let settled = RigidOptions { max_iterations: 500, tolerance: 0.0 };
    let untouched = RigidOptions { max_iterations: 0, tolerance: 0.0 };
    for reference in Reference::all() {
        let rigid = RigidSystem::new(&reference.topology, &reference.rest, Operator::Cotangent).unwrap();
        let handles = [reference.handle];
        let constraints =
            Constraints { handles: &handles, anchors: &reference.anchors, kind: ConstraintKind::Hard, falloff: None };
        let edit = rigid.constrain(&constraints).unwrap();
        let mut theirs = points(&reference.answers["arap"]);
        let their_energy = edit.settle(&[reference.offset], &untouched, &mut theirs).unwrap()[0];
        let mut own = reference.rest.clone();
        let energies = edit.settle(&[reference.offset], &settled, &mut own).unwrap();
        assert!(*energies.last().unwrap() <= their_energy, "{}", reference.name());
        let worst = reference.worst("arap", &own);
        assert!(worst < 1e-3, "{}: {worst:e}", reference.name());
    }
}

#[test]
fn distances_approximate_libigls_exact_geodesics() {
    for reference in Reference::all() {
        let geodesics = Geodesics::new(&reference.topology, &reference.rest).unwrap();
        let found = geodesics.distances(&[reference.handle]).unwrap();
        let exact = reference.numbers("geodesic");
        let furthest = exact.iter().copied().fold(0.0, f64::max);
        let differences = found.iter().zip(&exact).map(|(a, b)| (a - b).abs() / furthest);
        let (count, sum, worst) =
            differences.fold((0.0, 0.0, 0.0f64), |(count, sum, worst), d| (count + 1.0, sum + d, worst.max(d)));
        assert!(sum / count < 0.03 && worst < 0.1, "{}: mean {}, worst {worst}", reference.name(), sum / count);
    }
}
