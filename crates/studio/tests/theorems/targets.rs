//! Targets are derived from commands.

use std::collections::BTreeSet;

use glam::DVec3;
use rosto_face::{Region, Triangulation};
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

fn of_region(region: Region, offset: DVec3) -> Command {
    let handles = region.vertices();
    let offsets = vec![offset; handles.len()];
    Command::Move { spec: EditSpec { level: 0, handles, settings: Settings::default() }, offsets }
}

#[test]
fn sliders_and_amounts_are_recognised_from_commands() {
    for slider in FaceSlider::ALL {
        for amount_m in [-0.004, 0.0011] {
            let command = slider.command(amount_m);
            assert_eq!(command.target(), EditTarget::Slider(slider));
            let Amount::Distance(found_m) = command.amount() else { panic!("{slider:?} is a distance") };
            assert!((found_m - amount_m).abs() < 1e-15, "{slider:?}: {found_m}");
            let others = FaceSlider::ALL.into_iter().filter(|other| *other != slider);
            assert!(others.into_iter().all(|other| other.amount_m(&command).is_none()));
        }
    }
}

#[test]
fn a_deviating_handle_makes_a_command_not_a_slider() {
    let Command::Move { spec, mut offsets } = FaceSlider::JawWidth.command(0.004) else { panic!("it moves") };
    offsets[2].y += 1e-6;
    let command = Command::Move { spec: spec.clone(), offsets };
    assert_eq!(command.target(), EditTarget::Vertices(spec.handles.len()));
    assert_eq!(FaceSlider::JawWidth.amount_m(&command), None);
}

#[test]
fn regions_and_landmarks_are_recognised_from_handles() {
    let offset = DVec3::new(0.0, 0.003, 0.004);
    for region in Region::ALL {
        let command = of_region(region, offset);
        assert_eq!(command.target(), EditTarget::Region(region));
        assert_eq!(command.amount(), Amount::Distance(0.005));
    }
    assert_eq!(single_move(4, offset).target(), EditTarget::Landmark(4));
    let spec = EditSpec { level: 2, handles: vec![4], ..EditSpec::default() };
    let dense = Command::Move { spec, offsets: vec![offset] };
    assert_eq!(dense.target(), EditTarget::Point { level: 2, vertex: 4 });
    assert_eq!(Command::Symmetrise { share: 0.3 }.target(), EditTarget::Symmetry);
    assert_eq!(Command::Symmetrise { share: 0.3 }.amount(), Amount::Share(0.3));
}

#[test]
fn target_ids_are_distinct_within_their_kind() {
    let regions = Region::ALL.map(EditTarget::Region);
    let sliders = FaceSlider::ALL.map(EditTarget::Slider);
    let landmarks: Vec<EditTarget> = (0..468).map(EditTarget::Landmark).collect();
    let point = EditTarget::Point { level: 3, vertex: 12_045 };
    let others = [EditTarget::Symmetry, EditTarget::Vertices(3), point];
    let targets = [&regions[..], &sliders, &landmarks, &others].concat();
    let ids: BTreeSet<(&str, String)> = targets.iter().map(|target| (target.kind(), target.to_string())).collect();
    assert_eq!(ids.len(), targets.len());
    assert_eq!(point.to_string(), "point-12045@3");
    assert_eq!(EditTarget::Landmark(1).to_string(), "nose-tip");
}

#[test]
fn points_of_denser_meshes_have_a_part_of_the_face() {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    let part =
        |document: &Document, vertex| document.part_of(EditTarget::Point { level: 1, vertex }).unwrap_or_default();
    assert_eq!(part(&document, 1_045), "", "that mesh has not been built");
    document.set_density(1).unwrap();
    assert_eq!([1, 152, 425].map(|vertex| part(&document, vertex)), ["nose-tip", "chin", "left-cheek"]);
    assert_ne!(part(&document, 1_045), "");
    let (of_coarse, of_dense) = (document.nearest_on(0, 425), document.nearest_on(1, 1_045));
    assert_eq!((of_coarse, of_dense), (Some(425), Some(1_045)));
    assert_eq!(document.part_of(EditTarget::Landmark(1)), None);
}

#[test]
fn slider_amounts_add_up() {
    let slider = FaceSlider::LipFullness;
    let mut steps = Document::new(portrait(Triangulation::Canonical)).unwrap();
    for amount_m in [0.002, -0.0005, 0.001] {
        steps.apply("slid", slider.command(amount_m)).unwrap();
        steps.apply("between", FaceSlider::NoseLength.command(amount_m)).unwrap();
    }
    let mut once = Document::new(portrait(Triangulation::Canonical)).unwrap();
    once.apply("between", FaceSlider::NoseLength.command(0.0025)).unwrap();
    once.apply("slid", slider.command(0.0025)).unwrap();
    let furthest = steps.positions().iter().zip(once.positions()).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(furthest < 1e-15, "{furthest}");
}
