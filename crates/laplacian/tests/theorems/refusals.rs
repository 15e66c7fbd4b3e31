use glam::DVec3;
use rosto_laplacian::{
    ConstraintKind, Constraints, Falloff, Geodesics, LaplacianError, LaplacianSystem, Operator, RigidSystem,
};
use rosto_mesh::Topology;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::meshes::{apart, canonical_face};
use crate::seeded::Seeded;

fn refusal(handles: &[u32], anchors: &[u32], kind: ConstraintKind) -> LaplacianError {
    let mesh = apart(&mut Seeded::new(1));
    let constraints = Constraints { handles, anchors, kind, falloff: None };
    let system = LaplacianSystem::new(&mesh.topology, &mesh.positions, Operator::default()).unwrap();
    let rigid = RigidSystem::new(&mesh.topology, &mesh.positions, Operator::default()).unwrap();
    let error = system.respond(&constraints).unwrap_err();
    assert_eq!(rigid.constrain(&constraints).err(), Some(error.clone()));
    error
}

#[test]
fn invalid_constraints_report_the_vertex() {
    let soft = ConstraintKind::default();
    assert_eq!(refusal(&[], &[1, 2], soft), LaplacianError::NoHandle);
    assert_eq!(refusal(&[3, 4, 3], &[1], soft), LaplacianError::Repeated { vertex: 3 });
    assert_eq!(refusal(&[3], &[1, 5, 1], soft), LaplacianError::Repeated { vertex: 1 });
    assert_eq!(refusal(&[3], &[1, 3], soft), LaplacianError::PinnedHandle { vertex: 3 });
    assert_eq!(refusal(&[3], &[], soft), LaplacianError::Unanchored { handle: 3 });
    assert_eq!(refusal(&[3, 20], &[1], ConstraintKind::Hard), LaplacianError::Unanchored { handle: 20 });
    assert_eq!(refusal(&[31], &[1, 20], soft), LaplacianError::Unanchored { handle: 31 });
    assert_eq!(refusal(&[32], &[1], soft), LaplacianError::NoSuchVertex { vertex: 32, vertex_count: 32 });
    assert_eq!(refusal(&[3], &[1, 99], soft), LaplacianError::NoSuchVertex { vertex: 99, vertex_count: 32 });
}

#[test]
fn weights_must_be_positive_numbers() {
    for weight in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(refusal(&[3], &[1], ConstraintKind::Soft { weight }), LaplacianError::Weight { weight });
    }
    let mesh = apart(&mut Seeded::new(1));
    let system = LaplacianSystem::new(&mesh.topology, &mesh.positions, Operator::default()).unwrap();
    let kind = ConstraintKind::Soft { weight: f64::NAN };
    let error = system.respond(&Constraints { handles: &[3], anchors: &[1], kind, falloff: None }).unwrap_err();
    assert_eq!(error.to_string(), "a constraint's weight must be positive and finite; got NaN");
}

#[test]
fn positions_must_be_finite_and_match_the_vertices() {
    let mesh = canonical_face();
    for operator in Operator::ALL {
        let build = |positions: &[DVec3]| LaplacianSystem::new(&mesh.topology, positions, operator).err();
        let expected = LaplacianError::LengthMismatch { expected: 468, found: 467 };
        assert_eq!(build(&mesh.positions[1..]), Some(expected));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut positions = mesh.positions.clone();
            positions[131].y = bad;
            assert_eq!(build(&positions), Some(LaplacianError::NotFinite { vertex: 131 }));
        }
    }
}

#[test]
fn an_empty_mesh_is_rejected() {
    let nothing = Topology::new(0, Vec::new()).unwrap();
    for operator in Operator::ALL {
        assert_eq!(LaplacianSystem::new(&nothing, &[], operator).err(), Some(LaplacianError::Empty));
    }
    assert_eq!(Geodesics::new(&nothing, &[]).err(), Some(LaplacianError::Empty));
}

#[test]
fn regions_must_match_the_mesh_and_contain_the_handles() {
    let mesh = canonical_face();
    let system = LaplacianSystem::new(&mesh.topology, &mesh.positions, Operator::default()).unwrap();
    let respond = |falloff: &Falloff| {
        let constraints =
            Constraints { handles: &[4, 61], anchors: &[10], falloff: Some(falloff), ..Default::default() };
        system.respond(&constraints).err()
    };
    let short = Falloff::new(vec![1.0; 5]).unwrap();
    assert_eq!(respond(&short), Some(LaplacianError::LengthMismatch { expected: 468, found: 5 }));
    let mut falloff = vec![1.0; 468];
    falloff[61] = 0.0;
    assert_eq!(respond(&Falloff::new(falloff.clone()).unwrap()), Some(LaplacianError::OutsideRegion { handle: 61 }));
    falloff[7] = f64::NAN;
    assert_eq!(Falloff::new(falloff), Err(LaplacianError::NotFinite { vertex: 7 }));
    for radius in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(Falloff::within(radius, &[0.0; 468]), Err(LaplacianError::Radius { radius }));
    }
}

#[test]
fn error_messages_name_the_vertex() {
    let message = refusal(&[3], &[1, 3], ConstraintKind::Hard).to_string();
    assert_eq!(message, "vertex 3 is both a handle and an anchor");
}
