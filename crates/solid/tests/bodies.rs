//! Properties of closed bodies.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod exact;
mod surfaces;

use std::collections::HashMap;

use exact::meets_itself;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use rosto_face::{CarvedEyes, Triangulation, canonical_positions_m, crowded_landmarks, opening_edges};
use rosto_mesh::{LoopSubdivision, Surface, Topology};
use rosto_solid::{Body, Carving, Closing, PLA_G_PER_CM3, SolidError};
use surfaces::{face, faces, plane};

const CLOSINGS: [Closing; 3] = [
    Closing::Thickness { thickness_m: 0.0015 },
    Closing::Thickness { thickness_m: 0.004 },
    Closing::FlatBack { thickness_m: 0.003 },
];

fn closed(topology: &Topology, positions: &[DVec3], closing: Closing) -> Result<Body, SolidError> {
    Body::closed(Surface::new(topology, positions).unwrap(), closing)
}

/// Each directed edge and its opposite occur exactly once.
fn assert_watertight(body: &Body) {
    let mut sides: HashMap<[u32; 2], usize> = HashMap::new();
    for &[a, b, c] in body.topology().triangles() {
        [[a, b], [b, c], [c, a]].into_iter().for_each(|side| *sides.entry(side).or_default() += 1);
    }
    assert!(sides.iter().all(|(&[from, to], &uses)| uses == 1 && sides.get(&[to, from]) == Some(&1)));
    let (v, e, f) = (body.topology().vertex_count(), body.topology().edges().len(), body.topology().triangles().len());
    assert_eq!(v + f, e + 2, "Euler characteristic of a sphere");
    assert!((0..v as u32).all(|vertex| body.topology().degree(vertex) >= 3), "every vertex is used");
}

#[test]
fn faces_become_watertight_bodies_without_self_intersections() {
    for (name, topology, positions) in faces() {
        for closing in CLOSINGS {
            let body =
                closed(&topology, &positions, closing).unwrap_or_else(|error| panic!("{name}, {closing:?}: {error}"));
            assert_watertight(&body);
            assert!(body.volume_m3() > 0.0, "{name}, {closing:?}");
            assert_eq!(meets_itself(body.topology().triangles(), body.positions_m()), None, "{name}, {closing:?}");
            assert_eq!(body.topology().triangles()[..topology.triangles().len()], *topology.triangles());
        }
    }
}

#[test]
#[ignore = "slow; runs at night"]
fn subdivided_faces_become_bodies_too() {
    let (topology, positions) = face(Triangulation::Canonical);
    for density in 1..=3 {
        let finer = LoopSubdivision::new(&topology, density);
        for closing in CLOSINGS {
            let body = closed(finer.topology(), &finer.apply(&positions), closing).unwrap();
            assert_watertight(&body);
            assert_eq!(body.moved_m(), 0.0);
            if density < 3 {
                assert_eq!(meets_itself(body.topology().triangles(), body.positions_m()), None);
            }
        }
    }
}

#[test]
fn a_wall_has_at_least_three_quarters_of_the_requested_thickness() {
    let (topology, positions) = face(Triangulation::Canonical);
    for thickness_m in [0.001, 0.002, 0.003] {
        let body = closed(&topology, &positions, Closing::Thickness { thickness_m }).unwrap();
        assert!(body.thinnest_m() >= 0.75 * thickness_m && body.thinnest_m() <= thickness_m * (1.0 + 1e-12));
        assert_eq!(body.positions_m()[..468], positions, "the face is unchanged");
    }
}

/// A face interpolated through its landmarks, with little room for a wall between the lips, and its approximating
/// version.
fn smooth(levels: u32) -> (Topology, Vec<DVec3>, Vec<DVec3>) {
    let (mut topology, firm) = face(Triangulation::Canonical);
    let (mut creases, mut firm, mut soft) = (opening_edges(), firm.clone(), firm);
    for _ in 0..levels {
        let step = LoopSubdivision::creased(&topology, &creases, 1).rounding(&crowded_landmarks());
        (firm, soft) = (step.interpolate(&firm), step.apply(&soft));
        (topology, creases) = (step.topology().clone(), step.creases().to_vec());
    }
    (topology, firm, soft)
}

#[test]
fn a_surface_is_smoothed_only_around_tight_folds() {
    let thickness_m = 0.002;
    for levels in [2, 3] {
        let (topology, firm, soft) = smooth(levels);
        let surface = Surface::new(&topology, &firm).unwrap();
        let body = Body::closed_or_smoothed(surface, &soft, Closing::Thickness { thickness_m }).unwrap();
        assert_watertight(&body);
        assert!(body.thinnest_m() >= 0.6 * thickness_m, "{levels}: {} m", body.thinnest_m());
        assert!(body.moved_m() < 0.002, "{levels}: {} m", body.moved_m());
        let moved = |vertex: usize| body.positions_m()[vertex].distance(firm[vertex]);
        let most_m = (0..firm.len()).map(moved).fold(0.0, f64::max);
        assert!((most_m - body.moved_m()).abs() < 1e-12);
        let unchanged =
            topology.triangles().iter().filter(|corners| corners.iter().all(|&corner| moved(corner as usize) == 0.0));
        assert!(unchanged.count() * 10 > topology.triangles().len() * 9, "{levels}: only the folds are smoothed");
        let flat = Closing::FlatBack { thickness_m };
        assert_eq!(
            Body::closed_or_smoothed(surface, &soft, flat),
            Body::closed(surface, flat),
            "a flat back needs no smoothing"
        );
    }
    let (topology, positions) = face(Triangulation::Canonical);
    let surface = Surface::new(&topology, &positions).unwrap();
    let scaled: Vec<DVec3> = positions.iter().map(|position| *position * 1.1).collect();
    let wall = Closing::Thickness { thickness_m };
    assert_eq!(Body::closed_or_smoothed(surface, &scaled, wall), Body::closed(surface, wall), "there is room");
}

#[test]
#[ignore = "slow; runs at night"]
fn a_thickness_suggested_for_a_small_face_fits() {
    let (topology, firm, soft) = smooth(2);
    let [firm, soft] = [firm, soft].map(|positions| positions.iter().map(|at| *at * 0.45).collect::<Vec<_>>());
    let surface = Surface::new(&topology, &firm).unwrap();
    let closed = |thickness_m| Body::closed_or_smoothed(surface, &soft, Closing::Thickness { thickness_m });
    let Err(SolidError::TooThick { most_m, .. }) = closed(0.02) else { panic!("a wall of 20 mm fits") };
    assert!(most_m >= 0.002, "{most_m} m");
    assert_watertight(&closed(most_m).unwrap());
}

#[test]
#[ignore = "slow; runs at night"]
fn a_body_with_carved_eyes_is_watertight_and_as_thick() {
    for (levels, size) in [(0, 1.0), (1, 0.55), (2, 1.0), (2, 0.55), (2, 0.28)] {
        let (topology, firm, soft) = smooth(levels);
        let [firm, soft] = [firm, soft].map(|positions| positions.iter().map(|at| *at * size).collect::<Vec<_>>());
        let surface = Surface::new(&topology, &firm).unwrap();
        for closing in [Closing::Thickness { thickness_m: 0.002 }, Closing::FlatBack { thickness_m: 0.002 }] {
            let whole = Body::closed_or_smoothed(surface, &soft, closing).unwrap();
            let front = &whole.positions_m()[..whole.front_vertices()];
            let eyes = CarvedEyes::new(&Triangulation::Canonical.triangles(), &topology, front, [None; 2]);
            let depths_m = eyes.depths(front);
            let carving = Carving { topology: eyes.topology(), midpoints: eyes.midpoints(), depths_m: &depths_m };
            let body = whole.carved(&topology, &carving);
            let name = format!("{levels}, {size}, {closing:?}");
            assert_watertight(&body);
            if levels < 2 {
                assert_eq!(meets_itself(body.topology().triangles(), body.positions_m()), None, "{name}");
            }
            let count = eyes.topology().vertex_count();
            assert_eq!((body.front_vertices(), body.thickness_m().len()), (count, count), "{name}: not carved");
            assert_eq!(body.front_triangles(), eyes.topology().triangles().len());
            if let Closing::Thickness { .. } = closing {
                let least = if levels == 0 { 0.5 } else { 0.7 };
                assert!(body.thinnest_m() > least * whole.thinnest_m(), "{name}: {} m", body.thinnest_m());
            }
            assert!(body.volume_m3() > 0.0 && body.size_m().distance(whole.size_m()) < 0.003, "{name}");
        }
    }
}

#[test]
fn the_error_for_a_thick_wall_gives_a_thickness_that_works() {
    let (topology, positions) = face(Triangulation::Canonical);
    let thickness_m = 0.5;
    let refused = closed(&topology, &positions, Closing::Thickness { thickness_m });
    let Err(SolidError::TooThick { thickness_m: asked, most_m }) = refused else { panic!("{refused:?}") };
    assert!(asked == thickness_m && most_m > 0.005 && most_m < thickness_m, "{most_m}");
    assert!(closed(&topology, &positions, Closing::Thickness { thickness_m: most_m }).is_ok());
}

#[test]
fn openings_are_filled() {
    let (open, positions) = face(Triangulation::Tessellation);
    let rims = open.boundary_loops();
    assert_eq!(rims.len(), 4);
    for closing in CLOSINGS {
        let body = closed(&open, &positions, closing).unwrap();
        assert_watertight(&body);
        let fillings: usize = rims[1..].iter().map(|rim| rim.len() - 2).sum();
        assert_eq!(body.front_triangles(), open.triangles().len() + fillings);
    }
    let filled = closed(&face(Triangulation::Canonical).0, &positions, CLOSINGS[2]).unwrap();
    let volume = closed(&open, &positions, CLOSINGS[2]).unwrap().volume_m3();
    assert!((volume / filled.volume_m3() - 1.0).abs() < 0.005, "like the canonical triangulation");
}

#[test]
fn a_plate_has_the_expected_volume() {
    for turn in [DQuat::IDENTITY, DQuat::from_euler(glam::EulerRot::XYZ, 0.3, -0.8, 0.5)] {
        let (topology, flat) = plane(7, 5);
        let positions: Vec<DVec3> = flat.iter().map(|position| turn * *position).collect();
        for thickness_m in [0.001, 0.01, 0.1] {
            let plate = closed(&topology, &positions, Closing::Thickness { thickness_m }).unwrap();
            let expected = 0.07 * 0.05 * thickness_m;
            assert!((plate.volume_m3() / expected - 1.0).abs() < 1e-12);
            assert!((plate.thinnest_m() / thickness_m - 1.0).abs() < 1e-12);
        }
    }
    let (topology, positions) = plane(7, 5);
    let block = closed(&topology, &positions, Closing::FlatBack { thickness_m: 0.02 }).unwrap();
    assert!((block.volume_m3() / (0.07 * 0.05 * 0.02) - 1.0).abs() < 1e-12);
    assert!(block.size_m().distance(DVec3::new(0.07, 0.05, 0.02)) < 1e-15);
    let shell_cm3 = 0.12 * (2.0 * (7.0 * 5.0 + 7.0 * 2.0 + 5.0 * 2.0));
    assert!((block.area_m2() * 1e4 - 118.0).abs() < 1e-9);
    let mass_g = 1.24 * (shell_cm3 + 0.15 * (70.0 - shell_cm3));
    assert!((block.printed_mass_g(PLA_G_PER_CM3) - mass_g).abs() < 1e-9, "a shell and sparse infill");
    let thin = closed(&topology, &positions, Closing::Thickness { thickness_m: 0.001 }).unwrap();
    assert!((thin.printed_mass_g(PLA_G_PER_CM3) - 3.5 * 1.24).abs() < 1e-9, "a shell thicker than the wall fills it");
}

#[test]
fn the_thickness_is_that_between_front_and_back() {
    let (topology, positions) = face(Triangulation::Canonical);
    let wall = closed(&topology, &positions, CLOSINGS[1]).unwrap();
    let count = wall.front_vertices();
    for (vertex, thickness_m) in wall.thickness_m().iter().enumerate() {
        let along_m = wall.positions_m()[vertex].distance(wall.positions_m()[count + vertex]);
        assert!(
            *thickness_m > 0.0 && *thickness_m <= along_m * (1.0 + 1e-12),
            "{vertex}: {thickness_m} of {along_m} m"
        );
    }
    assert_eq!(wall.thinner_share(wall.thinnest_m()), 0.0);
    assert_eq!(wall.thinner_share(1.0), 1.0);
    let shares = [0.0038, 0.0039, 0.004, 0.0041].map(|least_m| wall.thinner_share(least_m));
    assert!(shares.is_sorted() && shares[3] > shares[0], "{shares:?}");
    let relief = closed(&topology, &positions, CLOSINGS[2]).unwrap();
    let deepest_m = positions.iter().map(|position| position.z).fold(f64::INFINITY, f64::min);
    for (position, thickness_m) in positions.iter().zip(relief.thickness_m()) {
        assert!((thickness_m - (position.z - deepest_m + 0.003)).abs() < 1e-12);
    }
}

#[test]
fn only_faces_that_look_down_and_are_not_on_the_bed_hang_over() {
    let (topology, positions) = plane(7, 5);
    let block = closed(&topology, &positions, Closing::FlatBack { thickness_m: 0.02 }).unwrap();
    for up in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z] {
        assert_eq!(block.overhang_m2(up), 0.0, "a block on its side");
    }
    // On an edge, both sides at 45° to the bed.
    let tilted = |degrees: f64| DQuat::from_rotation_y(degrees.to_radians()) * DVec3::Z;
    let bottom_m2 = 0.07 * 0.05;
    assert!((block.overhang_m2(tilted(30.0)) - bottom_m2).abs() < 1e-12, "the bottom is 30° off the bed");
    assert!((block.overhang_m2(tilted(60.0)) - 0.02 * 0.05).abs() < 1e-12, "the side is 30° off the bed");
    // The hollow of a mask that lies on its rim hangs over; the same face as a relief does not.
    let (topology, positions) = face(Triangulation::Canonical);
    let [wall, relief] = [CLOSINGS[0], CLOSINGS[2]].map(|closing| closed(&topology, &positions, closing).unwrap());
    assert!(wall.overhang_m2(DVec3::Z) > 0.3 * wall.area_m2() / 2.0, "{}", wall.overhang_m2(DVec3::Z));
    assert!(relief.overhang_m2(DVec3::Z) < 1e-5, "{}", relief.overhang_m2(DVec3::Z));
}

#[test]
fn volume_scales_with_the_cube_of_the_size_and_is_invariant_to_position() {
    let (topology, positions) = face(Triangulation::Canonical);
    let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.2, 0.4, -0.3);
    for closing in CLOSINGS {
        let volume = closed(&topology, &positions, closing).unwrap().volume_m3();
        let twice: Vec<DVec3> = positions.iter().map(|position| 2.0 * *position).collect();
        let larger = match closing {
            Closing::Thickness { thickness_m } => Closing::Thickness { thickness_m: 2.0 * thickness_m },
            Closing::FlatBack { thickness_m } => Closing::FlatBack { thickness_m: 2.0 * thickness_m },
        };
        let grown = closed(&topology, &twice, larger).unwrap().volume_m3();
        assert!((grown / volume / 8.0 - 1.0).abs() < 1e-12);
        let shifted: Vec<DVec3> = positions.iter().map(|position| *position + DVec3::new(0.3, -2.0, 1.0)).collect();
        let there = closed(&topology, &shifted, closing).unwrap().volume_m3();
        assert!((there / volume - 1.0).abs() < 1e-9);
        if let Closing::Thickness { .. } = closing {
            let turned: Vec<DVec3> = positions.iter().map(|position| turn * *position).collect();
            let there = closed(&topology, &turned, closing).unwrap().volume_m3();
            assert!((there / volume - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn invalid_surfaces_are_refused() {
    let positions = canonical_positions_m();
    let one = Closing::Thickness { thickness_m: 0.001 };
    let refused = |count: usize, triangles: Vec<[u32; 3]>| {
        closed(&Topology::new(count, triangles).unwrap(), &positions[..count], one).unwrap_err()
    };
    assert_eq!(refused(4, vec![[0, 1, 2], [0, 1, 3]]), SolidError::NotASurface { from: 0, to: 1 });
    assert_eq!(refused(5, vec![[0, 1, 2], [0, 3, 4]]), SolidError::Pinched { vertex: 0 });
    assert_eq!(refused(6, vec![[0, 1, 2], [3, 4, 5]]), SolidError::NotADisc { pieces: 2, rims: 2, euler: 2 });
    assert_eq!(refused(4, vec![[0, 1, 2]]), SolidError::NotADisc { pieces: 2, rims: 1, euler: 2 });
    let ball = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [3, 2, 1]];
    assert_eq!(refused(4, ball), SolidError::NotADisc { pieces: 1, rims: 0, euler: 2 });
    assert_eq!(refused(0, vec![]), SolidError::NotADisc { pieces: 0, rims: 0, euler: 0 });
    let (topology, mut broken) = plane(2, 2);
    for thickness_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = closed(&topology, &broken, Closing::FlatBack { thickness_m });
        assert!(matches!(refused, Err(SolidError::Thickness { .. })));
    }
    broken[3].y = f64::NAN;
    assert_eq!(closed(&topology, &broken, one), Err(SolidError::NotFinite { vertex: 3 }));
    let (topology, away) = plane(2, 2);
    let away: Vec<DVec3> = away.iter().map(|position| DVec3::new(-position.x, position.y, position.z)).collect();
    assert_eq!(closed(&topology, &away, Closing::FlatBack { thickness_m: 0.1 }), Err(SolidError::NoFlatBack));
}

#[test]
fn self_intersections_of_a_face_are_removed() {
    let (topology, mut positions) = face(Triangulation::Canonical);
    // Swapping two landmarks of the cheek makes the surface intersect itself.
    positions.swap(205, 50);
    assert!(meets_itself(topology.triangles(), &positions).is_some(), "the input does not intersect itself");
    for closing in CLOSINGS {
        let body = closed(&topology, &positions, closing).unwrap();
        assert_watertight(&body);
        assert_eq!(meets_itself(body.topology().triangles(), body.positions_m()), None);
        assert!(body.moved_m() > 0.0 && body.moved_m() < 0.03, "{} m", body.moved_m());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Bumps and dents of up to 25 mm, anywhere on the face, wider than high.
    #[test]
    fn faces_with_bumps_become_bodies(
        bumps in prop::collection::vec((0..468usize, prop::array::uniform3(-1.0..1.0f64), 0.0..0.025f64), 1..4),
        thickness_m in 0.0008..0.005f64,
    ) {
        let (topology, rest) = face(Triangulation::Canonical);
        let mut positions = rest.clone();
        for (middle, displacement, height_m) in bumps {
            let displacement = DVec3::from(displacement).normalize_or(DVec3::Z) * height_m;
            for (position, at) in positions.iter_mut().zip(&rest) {
                let near = (1.0 - at.distance(rest[middle]) / 0.06).max(0.0);
                *position += displacement * near * near * (3.0 - 2.0 * near);
            }
        }
        for closing in [Closing::Thickness { thickness_m }, Closing::FlatBack { thickness_m }] {
            let body = match closed(&topology, &positions, closing) {
                // Behind a sharp bump, the requested thickness may not fit, but the suggested one has to.
                Err(SolidError::TooThick { most_m, .. }) => {
                    prop_assert!(most_m > 0.0008, "{most_m} m");
                    closed(&topology, &positions, Closing::Thickness { thickness_m: most_m }).unwrap()
                }
                made => made.unwrap(),
            };
            assert_watertight(&body);
            prop_assert!(body.volume_m3() > 0.0);
            prop_assert_eq!(meets_itself(body.topology().triangles(), body.positions_m()), None);
        }
    }
}
