//! Any finite input gives finite output or a typed error, without a panic.

use glam::DVec3;
use rosto_laplacian::{
    ConstraintKind, Constraints, Distortion, Falloff, Geodesics, LaplacianError, LaplacianSystem, Operator,
    RigidOptions, RigidSystem,
};
use rosto_mesh::Topology;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::seeded::Seeded;

/// Arbitrary triangles, including non-manifold edges, duplicates, isolated vertices and several components.
fn any_topology(random: &mut Seeded) -> Topology {
    let count = 3 + random.below(25);
    let triangle = |random: &mut Seeded| <[u32; 3]>::try_from(random.vertices(3, count)).unwrap();
    let triangles = (0..random.below(3 * count)).map(|_| triangle(random)).collect();
    Topology::new(count, triangles).unwrap()
}

/// Points at any scale, many of them coincident, collinear or coplanar.
fn any_positions(count: usize, random: &mut Seeded) -> Vec<DVec3> {
    let scale = 10f64.powi(random.below(13) as i32 - 6);
    let centre = random.vector() * 10f64.powi(random.below(7) as i32);
    let squash = [DVec3::ONE, DVec3::new(1.0, 1.0, 0.0), DVec3::X, DVec3::new(1.0, 1e-9, 1e-12), DVec3::ZERO];
    let squash = squash[random.below(squash.len())];
    let mut positions: Vec<DVec3> = (0..count).map(|_| centre + scale * squash * random.vector()).collect();
    for _ in 0..random.below(count) {
        let (from, to) = (random.below(count), random.below(count));
        positions[to] = positions[from];
    }
    positions
}

fn all_finite(positions: &[DVec3]) -> bool {
    positions.iter().all(|position| position.is_finite())
}

/// Runs each kind of edit on random constraints.
fn edit(topology: &Topology, rest: &[DVec3], random: &mut Seeded) -> Result<(), LaplacianError> {
    let operator = Operator::ALL[random.below(Operator::ALL.len())];
    let count = 2 + random.below(4).min(rest.len() - 2);
    let constrained = random.vertices(count, rest.len());
    let (handles, anchors) = constrained.split_at(1 + random.below(constrained.len() - 1));
    let kind = [
        ConstraintKind::default(),
        ConstraintKind::Soft { weight: 1e6 },
        ConstraintKind::Soft { weight: 1e-6 },
        ConstraintKind::Hard,
    ][random.below(4)];
    let offsets: Vec<DVec3> =
        handles.iter().map(|_| random.vector() * 10f64.powi(random.below(13) as i32 - 6)).collect();
    let geodesics = Geodesics::new(topology, rest)?;
    let along = geodesics.distances(handles)?;
    assert!(along.iter().all(|distance| *distance >= 0.0));
    let falloff = Falloff::within(random.signed().abs() + 1e-3, &along)?;
    let falloff = [None, Some(&falloff)][random.below(2)];

    let system = LaplacianSystem::new(topology, rest, operator)?;
    let constraints = Constraints { handles, anchors, kind, falloff };
    let mut after = rest.to_vec();
    system.respond(&constraints)?.displace(rest, &offsets, &mut after);
    assert!(all_finite(&after), "{operator:?}, {kind:?}");
    let bent = Distortion::measure(topology, &system, rest, &after);
    assert!(bent.delta_change.iter().chain(&bent.edge_stretch).chain(&bent.area_ratio).all(|x| x.is_finite()));

    let rigid = RigidSystem::new(topology, rest, operator)?.constrain(&constraints)?;
    let energies = rigid.settle(&offsets, &RigidOptions::default(), &mut after)?;
    assert!(all_finite(&after) && energies.iter().all(|energy| energy.is_finite()));
    Ok(())
}

#[test]
fn any_mesh_is_edited_or_gives_a_typed_error() {
    let mut edited = 0;
    for seed in 0..500 {
        let random = &mut Seeded::new(seed);
        let topology = any_topology(random);
        let rest = any_positions(topology.vertex_count(), random);
        match edit(&topology, &rest, random) {
            Ok(()) => edited += 1,
            Err(LaplacianError::Unanchored { handle }) => assert!((handle as usize) < rest.len()),
            Err(other) => panic!("seed {seed}: {other}"),
        }
    }
    assert!(edited > 150, "only {edited} of 500 could be edited");
}

#[test]
fn extreme_scales_give_finite_positions() {
    let random = &mut Seeded::new(99);
    let topology = Topology::new(5, vec![[0, 1, 2], [1, 3, 2], [2, 3, 4]]).unwrap();
    for exponent in [-300, -200, 200, 300] {
        let scale = 10f64.powi(exponent);
        let rest: Vec<DVec3> = (0..5).map(|_| scale * random.vector()).collect();
        for operator in Operator::ALL {
            let system = LaplacianSystem::new(&topology, &rest, operator).unwrap();
            let constraints = Constraints { handles: &[0], anchors: &[4], ..Default::default() };
            let mut after = rest.clone();
            system.respond(&constraints).unwrap().displace(&rest, &[scale * DVec3::X], &mut after);
            assert!(all_finite(&after));
        }
    }
}
