//! Mirrored edits mirror the change and preserve the face's asymmetry.

use glam::DVec3;
use rosto_face::{MIDLINE, Region, Triangulation, mirror_of};
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;
use crate::seeded::Seeded;

const TOLERANCE_M: f64 = 1e-12;

/// Greatest difference between a displacement and its mirror image.
fn asymmetry_m(from: &[DVec3], to: &[DVec3]) -> f64 {
    let moved = |vertex: usize| to[vertex] - from[vertex];
    (0..from.len()).map(|v| (moved(v) - moved(mirror_of(v as u32) as usize) * MIRROR).length()).fold(0.0, f64::max)
}

/// Difference between each vertex and its partner's mirror image.
fn asymmetry(positions: &[DVec3]) -> Vec<DVec3> {
    (0..positions.len()).map(|v| positions[v] - positions[mirror_of(v as u32) as usize] * MIRROR).collect()
}

#[test]
fn mirrored_edits_are_symmetric_and_preserve_asymmetry() {
    let mut random = Seeded::new(4);
    for _ in 0..16 {
        let settings = Settings {
            operator: Operator::ALL[random.below(Operator::ALL.len())],
            constraint: [ConstraintKind::Hard, ConstraintKind::default()][random.below(2)],
            anchors: [Anchors::default(), Anchors::random(random.bits())][random.below(2)].clone(),
            mirror: Mirror::On,
            ..Settings::default()
        };
        let spec = EditSpec { level: 0, handles: vec![random.below(468) as u32], settings };
        let offset = random.vector() * 0.02;
        for rest in [canonical(Triangulation::Canonical), portrait(Triangulation::Tessellation)] {
            let mut document = Document::new(rest).unwrap();
            document.apply("mirrored", Command::Move { spec: spec.clone(), offsets: vec![offset] }).unwrap();
            assert!(asymmetry_m(document.rest(), document.positions()) < TOLERANCE_M, "{spec:?}");
            let (before, after) = (asymmetry(document.rest()), asymmetry(document.positions()));
            assert!(before.iter().zip(after).all(|(b, a)| (*b - a).length() < TOLERANCE_M), "{spec:?}");
        }
    }
}

#[test]
fn an_exact_handle_and_its_partner_both_reach_their_targets() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    let offset = DVec3::new(0.004, -0.002, 0.003);
    document.prepare(mirrored_spec(61)).unwrap();
    document.preview(&[offset]).unwrap();
    assert_eq!(document.handles(), [61, 291]);
    assert!((document.positions()[61] - document.rest()[61] - offset).length() < TOLERANCE_M);
    assert!((document.positions()[291] - document.rest()[291] - offset * MIRROR).length() < TOLERANCE_M);
}

#[test]
fn mirrored_handles_keep_separate_offsets() {
    let settings = Settings { mirror: Mirror::On, constraint: ConstraintKind::Hard, ..Settings::default() };
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    let moves =
        [(205, DVec3::new(0.004, 0.0, 0.001)), (61, DVec3::new(0.0, 0.003, 0.0)), (4, DVec3::new(0.0, 0.0, 0.005))];
    let (handles, offsets) = moves.iter().copied().unzip();
    document.apply("three", Command::Move { spec: EditSpec { level: 0, handles, settings }, offsets }).unwrap();
    for (vertex, offset) in moves {
        let displacement = |vertex: u32| document.positions()[vertex as usize] - document.rest()[vertex as usize];
        assert!((displacement(vertex) - offset).length() < TOLERANCE_M, "{vertex}: {}", displacement(vertex));
        assert!((displacement(mirror_of(vertex)) - offset * MIRROR).length() < TOLERANCE_M, "partner of {vertex}");
    }
}

#[test]
fn the_midline_stays_in_its_plane() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.prepare(mirrored_spec(4)).unwrap();
    document.preview(&[DVec3::new(0.01, 0.002, 0.003)]).unwrap();
    assert!(MIDLINE.into_iter().all(|vertex| document.positions()[vertex as usize].x.abs() < TOLERANCE_M));
    let moved = document.positions()[4] - document.rest()[4];
    assert!((moved - DVec3::new(0.0, 0.002, 0.003)).length() < TOLERANCE_M);
}

#[test]
fn a_region_across_the_midline_loses_its_sideways_component() {
    let settings = Settings { mirror: Mirror::On, constraint: ConstraintKind::Hard, ..Settings::default() };
    let handles = Region::Lips.vertices();
    let offsets = vec![DVec3::new(0.005, 0.0, 0.004); handles.len()];
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document
        .apply("lips", Command::Move { spec: EditSpec { level: 0, handles: handles.clone(), settings }, offsets })
        .unwrap();
    for vertex in handles {
        let moved = document.positions()[vertex as usize] - document.rest()[vertex as usize];
        assert!((moved - DVec3::Z * 0.004).length() < TOLERANCE_M);
    }
}

#[test]
fn symmetrising_removes_the_given_share_of_asymmetry() {
    for share in [0.0, 0.3, 1.0] {
        let mut document = Document::new(portrait(Triangulation::Tessellation)).unwrap();
        document.apply("symmetrise", Command::Symmetrise { share }).unwrap();
        let left = asymmetry(document.positions());
        for (before, after) in asymmetry(document.rest()).into_iter().zip(left) {
            assert!((before * (1.0 - share) - after).length() < TOLERANCE_M);
        }
    }
}

#[test]
fn image_coordinates_have_no_mirror() {
    let topology = Triangulation::Canonical.topology();
    let positions = rosto_face::canonical_positions_m();
    let mut document = Document::new(Rest::of_landmarks(topology, positions, CoordinateFrame::Other)).unwrap();
    assert_eq!(document.prepare(mirrored_spec(4)), Err(StudioError::NoMirror));
    assert_eq!(document.apply("half", Command::Symmetrise { share: 0.5 }), Err(StudioError::NoMirror));
}
