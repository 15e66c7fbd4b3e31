//! Influence radii and rotating details.

use glam::DVec3;
use rosto_face::Triangulation;
use rosto_laplacian::Geodesics;
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

const RADIUS_M: f64 = 0.03;

fn moved(settings: Settings, offset: DVec3) -> Document {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.prepare(EditSpec { level: 0, handles: vec![205], settings }).unwrap();
    document.preview(&[offset]).unwrap();
    document
}

#[test]
fn nothing_moves_outside_the_radius() {
    let settings = Settings {
        influence: RegionOfInfluence::Within { radius: RADIUS_M },
        constraint: ConstraintKind::Hard,
        ..Settings::default()
    };
    let document = moved(settings, DVec3::Z * 0.01);
    let distances = Geodesics::new(document.topology(), document.rest()).unwrap().distances(&[205]).unwrap();
    let mut inside = 0;
    for (vertex, distance) in distances.into_iter().enumerate() {
        let displacement = document.positions()[vertex] - document.rest()[vertex];
        assert!(
            distance < RADIUS_M || displacement == DVec3::ZERO,
            "vertex {vertex}, {distance} m away, moved by {displacement}"
        );
        inside += usize::from(displacement.length() > 1e-6);
    }
    assert!(inside > 5, "{inside} vertices follow");
}

#[test]
fn anchors_outside_a_radius_stay_in_place() {
    let anchors = Anchors { kind: AnchorKind::Outside { radius: RADIUS_M }, pins: vec![50] };
    let document =
        moved(Settings { anchors, constraint: ConstraintKind::Hard, ..Settings::default() }, DVec3::Z * 0.01);
    assert!(document.anchors().len() > 100 && document.anchors().contains(&50));
    for &anchor in document.anchors() {
        let displacement = document.positions()[anchor as usize] - document.rest()[anchor as usize];
        assert!(displacement.length() < 1e-12);
    }
}

#[test]
fn rotating_details_stretch_less_and_reach_the_target() {
    let settings = |details| Settings { details, constraint: ConstraintKind::Hard, ..Settings::default() };
    let stretch = |document: &Document| -> f64 {
        let length = |at: &[DVec3], [a, b]: [u32; 2]| at[a as usize].distance(at[b as usize]);
        let edges = document.topology().edges().iter();
        edges.map(|&edge| (length(document.positions(), edge) / length(document.rest(), edge) - 1.0).powi(2)).sum()
    };
    let offset = DVec3::new(0.0, 0.02, 0.03);
    let (kept, turned) = (moved(settings(Details::Kept), offset), moved(settings(Details::AsRigidAsPossible), offset));
    assert!((turned.positions()[205] - turned.rest()[205] - offset).length() < 1e-12);
    assert!(stretch(&turned) < stretch(&kept), "{} against {}", stretch(&turned), stretch(&kept));
}

#[test]
fn consecutive_drags_with_rotating_details_replay_identically() {
    let settings =
        Settings { details: Details::AsRigidAsPossible, constraint: ConstraintKind::Hard, ..Settings::default() };
    let mut document = moved(settings, DVec3::Z * 0.01);
    document.commit("first");
    document.preview(&[DVec3::X * 0.01]).unwrap();
    document.commit("second");
    let reached = document.positions()[205] - document.rest()[205];
    assert!((reached - DVec3::new(0.01, 0.0, 0.01)).length() < 1e-12);
    let rest = canonical(Triangulation::Canonical);
    let replayed = Document::replay(rest, document.history().entries().to_vec()).unwrap();
    assert_eq!(bits(replayed.positions()), bits(document.positions()));
}
