//! Properties of carved eyes.

use std::collections::HashSet;

use glam::{DVec2, DVec3};
use rosto_face::{
    CarvedEyes, LANDMARK_COUNT, Opening, Triangulation, canonical_positions_m, crowded_landmarks, opening_edges,
};
use rosto_mesh::{LoopSubdivision, Topology};

/// The canonical face, subdivided.
fn face(levels: u32) -> (Topology, Vec<DVec3>) {
    let (mut topology, mut positions) = (Triangulation::Canonical.topology(), canonical_positions_m());
    let mut creases = opening_edges();
    for _ in 0..levels {
        let step = LoopSubdivision::creased(&topology, &creases, 1).rounding(&crowded_landmarks());
        positions = step.interpolate(&positions);
        (topology, creases) = (step.topology().clone(), step.creases().to_vec());
    }
    (topology, positions)
}

fn carved(topology: &Topology, positions: &[DVec3]) -> CarvedEyes {
    CarvedEyes::new(&Triangulation::Canonical.triangles(), topology, positions, [None; 2])
}

/// Positions of the refined mesh, uncarved.
fn refined(eyes: &CarvedEyes, positions: &[DVec3]) -> Vec<DVec3> {
    let mut positions = positions.to_vec();
    eyes.midpoints().iter().for_each(|&[a, b]| positions.push(positions[a as usize].midpoint(positions[b as usize])));
    positions
}

#[test]
fn a_carved_face_is_a_disc_with_the_same_rim_and_skin() {
    for levels in 0..=2 {
        let (topology, positions) = face(levels);
        let eyes = carved(&topology, &positions);
        let depths = eyes.depths(&positions);
        assert_eq!(depths.len(), eyes.topology().vertex_count());
        assert!(
            depths.len() - positions.len() < 16_000,
            "{levels}: {} vertices are added",
            depths.len() - positions.len()
        );
        assert_eq!(eyes.topology().boundary_loops(), topology.boundary_loops());
        let sides: Vec<[u32; 2]> =
            eyes.topology().triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        assert_eq!(sides.iter().collect::<HashSet<_>>().len(), sides.len(), "each directed side has one triangle");
        let [v, e, f] = [depths.len(), eyes.topology().edges().len(), eyes.topology().triangles().len()];
        assert_eq!(v + f, e + 1, "Euler characteristic of a disc");
        assert!(depths[..LANDMARK_COUNT].iter().all(|depth| *depth == 0.0), "landmarks stay");
        let moved = depths[..positions.len()].iter().filter(|depth| **depth > 0.0).count();
        assert!(moved < positions.len() / 10, "{levels}: {moved} vertices of the mesh move");
        let colours: Vec<[u8; 3]> = (0..positions.len()).map(|at| [(at % 256) as u8, 0, 255]).collect();
        let refined = eyes.colours(&colours);
        assert_eq!((refined.len(), &refined[..colours.len()]), (depths.len(), &colours[..]));
    }
}

#[test]
fn the_iris_is_deeper_than_the_white_and_the_pupil_deepest() {
    let (topology, positions) = face(2);
    let eyes = carved(&topology, &positions);
    let (sunk, places) = (eyes.depths(&positions), refined(&eyes, &positions));
    assert!(sunk.iter().all(|depth| *depth >= 0.0), "only backwards");
    for (corners, opening) in [([33, 133], Opening::RightEye), ([263, 362], Opening::LeftEye)] {
        let rim = opening.rim();
        let middle = rim.iter().map(|&at| positions[at as usize].truncate()).sum::<DVec2>() / rim.len() as f64;
        let width = positions[corners[0]].truncate().distance(positions[corners[1]].truncate());
        let deepest = |from: f64, to: f64| {
            let is_there = |place: &DVec3| (from..to).contains(&(place.truncate().distance(middle) / width));
            let depths = places.iter().zip(&sunk).filter(|(place, _)| is_there(place)).map(|(_, depth)| *depth);
            depths.fold(0.0, f64::max) / width
        };
        let [pupil, iris, white] = [deepest(0.0, 0.05), deepest(0.12, 0.16), deepest(0.27, 0.33)];
        assert!(pupil > 1.5 * iris && iris > 1.5 * white && white > 0.03, "{opening:?}: {pupil}, {iris}, {white}");
        assert!(pupil < 0.25, "shallow enough for a wall");
    }
}

#[test]
fn carving_scales_with_the_face() {
    let (topology, positions) = face(1);
    let twice: Vec<DVec3> = positions.iter().map(|position| 2.0 * *position).collect();
    let [one, two] = [&positions, &twice].map(|positions| carved(&topology, positions));
    assert_eq!(one.topology(), two.topology());
    let pairs = one.depths(&positions).into_iter().zip(two.depths(&twice));
    assert!(pairs.into_iter().all(|(one, two)| (2.0 * one - two).abs() < 1e-12));
}

#[test]
fn closed_eyes_and_open_holes_are_not_carved() {
    let (topology, mut positions) = face(0);
    for opening in [Opening::RightEye, Opening::LeftEye] {
        let rim = opening.rim();
        let middle = rim.iter().map(|&at| positions[at as usize].y).sum::<f64>() / rim.len() as f64;
        for at in rim {
            let y = &mut positions[at as usize].y;
            *y = middle + 0.05 * (*y - middle);
        }
    }
    assert!(carved(&topology, &positions).depths(&positions).iter().all(|depth| *depth == 0.0));
    let open = Triangulation::Tessellation;
    let eyes = CarvedEyes::new(&open.triangles(), &open.topology(), &positions, [None; 2]);
    assert_eq!((eyes.topology(), eyes.depths(&positions)), (&open.topology(), vec![0.0; positions.len()]));
}
