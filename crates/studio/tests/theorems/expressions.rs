//! Expressions move the part that they name and nothing else, are mirror images of each other, do not fold, and add up.

use glam::DVec3;
use rosto_face::{Region, Triangulation, canonical_positions_m, mirror_of, without_fillings};
use rosto_studio::project::{ProjectError, from_json, to_json};
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

const UPPER_LIDS: [u32; 7] = [246, 161, 160, 159, 158, 157, 173];
const LOWER_LIDS: [u32; 7] = [7, 163, 144, 145, 153, 154, 155];

fn faces() -> [Vec<DVec3>; 2] {
    let portrait = Document::new(portrait(Triangulation::Canonical)).unwrap().rest().to_vec();
    [canonical_positions_m(), portrait]
}

fn skin() -> Vec<[u32; 3]> {
    let triangles = Triangulation::Canonical.triangles();
    without_fillings(&triangles, &triangles)
}

/// Expressions of the right and of both sides; those of the left are mirror images.
fn right_and_symmetric() -> impl Iterator<Item = Expression> {
    Expression::ALL.into_iter().filter(|expression| !expression.id().ends_with("Left"))
}

#[test]
fn expressions_of_a_symmetric_face_are_mirror_images() {
    let mut expressions = Expressions::new(&canonical_positions_m()).unwrap();
    for expression in right_and_symmetric() {
        let image = expressions.displacement(expression.mirrored()).unwrap().to_vec();
        let displacements = expressions.displacement(expression).unwrap();
        for vertex in 0..468 {
            let (displacement, partner) = (displacements[vertex as usize], image[mirror_of(vertex) as usize]);
            assert!(
                displacement.distance(partner * MIRROR) < 1e-12,
                "{expression:?} at {vertex}: {displacement} and {partner}"
            );
        }
        assert_eq!(expression.mirrored().mirrored(), expression);
    }
}

#[test]
fn expressions_are_visible_and_do_not_fold_skin() {
    for rest in faces() {
        let mut expressions = Expressions::new(&rest).unwrap();
        for expression in Expression::ALL {
            let displacements = expressions.displacement(expression).unwrap();
            let furthest_mm =
                1000.0 * displacements.iter().map(|displacement| displacement.length()).fold(0.0, f64::max);
            assert!((1.5..40.0).contains(&furthest_mm), "{expression:?} moves {furthest_mm} mm");
            let moved: Vec<DVec3> =
                rest.iter().zip(displacements).map(|(at, displacement)| *at + *displacement).collect();
            let is_turned = |corners: &[u32; 3]| normal(&moved, corners).dot(normal(&rest, corners)) <= 0.0;
            let folded: Vec<_> = skin().into_iter().filter(is_turned).collect();
            assert!(folded.iter().all(|corners| degenerates(expression, corners)), "{expression:?} folds {folded:?}");
        }
    }
}

/// Triangles between lid edges and corners degenerate in a blink.
fn degenerates(expression: Expression, corners: &[u32; 3]) -> bool {
    let is_blink = matches!(expression, Expression::EyeBlinkLeft | Expression::EyeBlinkRight);
    let is_edge = |corner: &u32| UPPER_LIDS.contains(corner) || LOWER_LIDS.contains(corner);
    is_blink && corners.iter().any(|corner| is_edge(corner) || is_edge(&mirror_of(*corner)))
}

fn normal(positions: &[DVec3], corners: &[u32; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|corner| positions[corner as usize]);
    (b - a).cross(c - a)
}

#[test]
fn a_blink_closes_the_eye_at_each_density() {
    const MAX_MM: f64 = 0.3;
    for triangulation in Triangulation::ALL {
        for rest in [canonical(triangulation), portrait(triangulation)] {
            let mut document = Document::new(rest).unwrap();
            for density in [0, 2] {
                document.set_density(density).unwrap();
                document.preview_expressions(&[(Expression::EyeBlinkRight, 1.0)]).unwrap();
                let at = document.positions();
                let pairs = UPPER_LIDS.into_iter().zip(LOWER_LIDS);
                let gaps = pairs.map(|(upper, lower)| 1000.0 * at[upper as usize].distance(at[lower as usize]));
                let widest_mm = gaps.fold(0.0, f64::max);
                assert!(widest_mm < MAX_MM, "{triangulation:?}, {density}: lids are {widest_mm} mm apart");
            }
        }
    }
}

#[test]
fn expressions_leave_other_regions_in_place() {
    let parts: [(Expression, &[Region]); 5] = [
        (Expression::JawOpen, &[Region::UpperLip, Region::Nose, Region::RightEye, Region::LeftEye, Region::Forehead]),
        (
            Expression::EyeBlinkRight,
            &[Region::RightBrow, Region::LeftEye, Region::Nose, Region::RightCheek, Region::Lips],
        ),
        (Expression::MouthSmileLeft, &[Region::RightCheek, Region::Nose, Region::RightEye, Region::Forehead]),
        (Expression::BrowInnerUp, &[Region::RightEye, Region::Nose, Region::Jaw]),
        (Expression::CheekPuff, &[Region::RightEye, Region::Nose, Region::Forehead]),
    ];
    for rest in faces() {
        let mut expressions = Expressions::new(&rest).unwrap();
        for (expression, parts) in parts {
            let displacements = expressions.displacement(expression).unwrap();
            for vertex in parts.iter().flat_map(|part| part.vertices()) {
                assert_eq!(displacements[vertex as usize], DVec3::ZERO, "{expression:?} moves {vertex}");
            }
        }
    }
}

#[test]
fn expressions_move_in_the_named_direction() {
    for rest in faces() {
        let mut expressions = Expressions::new(&rest).unwrap();
        let mut displacement =
            |expression, vertex: usize| expressions.displacement(expression).unwrap()[vertex] * 1000.0;
        let chin = displacement(Expression::JawOpen, 152);
        assert!(chin.y < -12.0 && chin.z < -3.0, "the chin does not move in an arc: {chin}");
        assert!(
            displacement(Expression::MouthSmileRight, 61).y > 4.0
                && displacement(Expression::MouthSmileRight, 205).y > 2.0
        );
        assert!(displacement(Expression::MouthFrownRight, 61).y < -4.0);
        assert!(displacement(Expression::MouthPucker, 0).z > 4.0 && displacement(Expression::MouthPucker, 61).x > 4.0);
        assert!(displacement(Expression::JawLeft, 152).x > 4.0 && displacement(Expression::JawRight, 152).x < -4.0);
        assert!(
            displacement(Expression::BrowInnerUp, 107).y > 4.0
                && displacement(Expression::BrowDownLeft, mirror_of(107) as usize).y < -3.0
        );
        assert!(displacement(Expression::CheekPuff, 207).z > 4.0 && displacement(Expression::CheekPuff, 207).x < -4.0);
        assert!(displacement(Expression::MouthLeft, 13).x > 4.0);
    }
}

#[test]
fn mouth_close_closes_the_lips_of_an_open_jaw() {
    for rest in faces() {
        let mut expressions = Expressions::new(&rest).unwrap();
        let mut displacements = |expression| expressions.displacement(expression).unwrap().to_vec();
        let (open, close) = (displacements(Expression::JawOpen), displacements(Expression::MouthClose));
        let parted_mm = 1000.0 * ((open[13] + close[13]) - (open[14] + close[14])).length();
        assert!(parted_mm < 0.3, "{parted_mm} mm");
    }
}

#[test]
fn weights_add_up_and_a_commit_matches_its_preview() {
    for (triangulation, density) in [(Triangulation::Tessellation, 0), (Triangulation::Canonical, 2)] {
        let fresh = || {
            let mut document = Document::new(portrait(triangulation)).unwrap();
            document.set_density(density).unwrap();
            document.apply("nose", single_move(4, DVec3::Z * 0.01)).unwrap();
            document
        };
        let (mut once, mut twice) = (fresh(), fresh());
        once.preview_expressions(&[(Expression::JawOpen, 0.75)]).unwrap();
        let previewed = once.positions().to_vec();
        once.commit("");
        assert_eq!(bits(once.committed()), bits(&previewed));
        for weight in [0.5, 0.25] {
            twice.apply("jawOpen", Command::Express { expression: Expression::JawOpen, weight }).unwrap();
        }
        let apart = once.committed().iter().zip(twice.committed()).map(|(one, two)| one.distance(*two));
        assert!(apart.fold(0.0, f64::max) < 1e-12);
        assert!(once.committed()[14].distance(fresh().committed()[14]) > 0.005);
    }
}

#[test]
fn a_rig_keeps_skin_and_eyes_in_place_under_expressions() {
    for density in [0, 2] {
        let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
        document.set_density(density).unwrap();
        let open = Rig::still(&mut document, EditsInRig::AtRest);
        assert_eq!(open.base_m(), Rig::new(&mut document, EditsInRig::AtRest).unwrap().base_m());
        document.apply("chin", single_move(152, DVec3::new(0.0, -0.004, 0.001))).unwrap();
        let edited = Rig::still(&mut document, EditsInRig::AtRest);
        let blink = Command::Express { expression: Expression::EyeBlinkLeft, weight: 1.0 };
        document.apply("blink", blink).unwrap();
        let blinking = Rig::still(&mut document, EditsInRig::AtRest);
        let skin = document.positions().len();
        assert_eq!(blinking.base_m()[..skin], *document.positions());
        let pieces = edited.base_m()[skin..].iter().zip(&blinking.base_m()[skin..]);
        assert!(pieces.clone().count() > 0 && pieces.into_iter().all(|(a, b)| a.distance(*b) < 1e-12));
        let layered = Rig::still(&mut document, EditsInRig::Layers);
        assert_eq!(layered.layers().len(), 2);
        let sum = |vertex: usize| layered.layers().iter().map(|layer| layer.displacements_m[vertex]).sum::<DVec3>();
        let shown = (0..skin).map(|vertex| layered.base_m()[vertex] + sum(vertex));
        assert!(shown.zip(document.positions()).all(|(a, b)| a.distance(*b) < 1e-12));
    }
}

#[test]
fn both_sides_are_one_change_and_so_is_a_reset() {
    let mut document = Document::new(portrait(Triangulation::Tessellation)).unwrap();
    let both = [(Expression::MouthSmileLeft, 0.5), (Expression::MouthSmileRight, 0.5)];
    document.preview_expressions(&both).unwrap();
    document.commit("");
    document.apply("nose", single_move(4, DVec3::Z * 0.01)).unwrap();
    let smiling = bits(document.committed());
    assert_eq!(document.history().entries().len(), 3);
    assert_eq!(document.reset_expressions(), Some(0));
    let mut alone = Document::new(portrait(Triangulation::Tessellation)).unwrap();
    alone.apply("nose", single_move(4, DVec3::Z * 0.01)).unwrap();
    assert_eq!(bits(document.committed()), bits(alone.committed()));
    document.undo();
    assert_eq!(bits(document.committed()), smiling);
    document.undo();
    document.undo();
    assert!(document.history().entries().is_empty());
    assert_eq!(document.committed(), document.rest());
    document.redo();
    assert_eq!(document.history().entries().len(), 2);
}

#[test]
fn expressions_survive_files_triangulations_and_densities() {
    let mut document = Document::new(portrait(Triangulation::Canonical)).unwrap();
    document.preview_expressions(&[(Expression::EyeBlinkLeft, 1.0), (Expression::JawOpen, 0.3)]).unwrap();
    document.commit("");
    let text = to_json(document.history().entries());
    let entries = from_json(&text).unwrap();
    assert_eq!(entries, document.history().entries());
    assert_eq!(entries[0].command.target().to_string(), "eyeBlinkLeft");
    assert_eq!(entries[1].command.amount(), Amount::Weight(0.3));
    let again = Document::replay(portrait(Triangulation::Canonical), entries).unwrap();
    assert_eq!(bits(again.committed()), bits(document.committed()));
    let joined = document.over(portrait(Triangulation::Tessellation)).unwrap();
    assert_eq!(bits(joined.committed()), bits(document.committed()));
    document.set_density(1).unwrap();
    assert_eq!(bits(document.cage()), bits(again.committed()));
}

#[test]
fn meshes_without_a_face_and_invalid_weights_are_refused() {
    let express = |weight| Command::Express { expression: Expression::JawOpen, weight };
    let image = Rest::of_landmarks(Triangulation::Canonical.topology(), portrait_image(), CoordinateFrame::Other);
    let mut document = Document::new(image).unwrap();
    let none = Err(StudioError::NoExpressions { vertex_count: 468 });
    assert_eq!(document.apply("", express(0.5)), none);
    assert_eq!(document.preview_expressions(&[(Expression::JawOpen, 0.5)]), none);
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    assert_eq!(document.apply("", express(1.5)), Err(StudioError::Weight { weight: 1.5 }));
    assert!(document.apply("", express(f64::NAN)).is_err());
    assert!(document.history().entries().is_empty() && document.positions() == document.rest());
    assert_eq!(Expressions::new(&[DVec3::ZERO]).err(), Some(StudioError::NoExpressions { vertex_count: 1 }));
    assert!(Expressions::new(&[DVec3::NAN; 468]).is_err());
    let text = to_json(&[Entry { label: String::new(), command: express(0.5), switch: Switch::On }]);
    let unknown = from_json(&text.replace("jawOpen", "tongueOut"));
    assert_eq!(unknown, Err(ProjectError::Field { entry: 0, field: "expression" }));
}
