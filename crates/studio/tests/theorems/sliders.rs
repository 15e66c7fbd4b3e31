//! Sliders change the proportion that they name, symmetrically and without peaks or inverted triangles.

use std::collections::BTreeSet;

use glam::DVec3;
use rosto_face::{Triangulation, mirror_of};
use rosto_laplacian::peaks;
use rosto_studio::*;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

fn moved(slider: FaceSlider, amount_m: f64) -> Document {
    let mut document = Document::new(canonical(Triangulation::Canonical)).unwrap();
    document.apply(slider.id(), slider.command(amount_m)).unwrap();
    document
}

/// The end points and axis of a slider's proportion, and its growth as a multiple of the amount.
fn measure(slider: FaceSlider) -> (u32, u32, DVec3, f64) {
    match slider {
        FaceSlider::NoseWidth => (64, 294, DVec3::X, 2.0),
        FaceSlider::NoseLength => (4, 168, DVec3::Y, 1.0),
        FaceSlider::EyeSize => (145, 159, DVec3::Y, 2.0),
        FaceSlider::EyeDistance => (133, 362, DVec3::X, 2.0),
        FaceSlider::LipFullness => (17, 0, DVec3::Y, 2.0),
        FaceSlider::JawWidth => (172, 397, DVec3::X, 2.0),
        FaceSlider::ChinLength => (152, 17, DVec3::Y, 1.0),
        FaceSlider::BrowHeight => (159, 105, DVec3::Y, 1.0),
        FaceSlider::Cheekbones => (117, 346, DVec3::X, 1.4),
        FaceSlider::FaceLength => (152, 10, DVec3::Y, 2.0),
        other => panic!("no measure for {other:?}"),
    }
}

#[test]
fn sliders_change_their_proportion_by_their_amount() {
    for slider in FaceSlider::ALL {
        let (from, to, axis, times) = measure(slider);
        let length = |at: &[DVec3]| (at[to as usize] - at[from as usize]).dot(axis);
        for amount_m in [-slider.range_m(), slider.range_m()] {
            let document = moved(slider, amount_m);
            let grown = length(document.positions()) - length(document.rest());
            assert!((grown - times * amount_m).abs() < 1e-9, "{slider:?} grew by {grown}, not {times} × {amount_m}");
        }
    }
}

#[test]
fn sliders_are_symmetric_and_zero_is_the_identity() {
    for slider in FaceSlider::ALL {
        let document = moved(slider, slider.range_m());
        for vertex in 0..468 {
            let partner = mirror_of(vertex) as usize;
            let displacement = |vertex: usize| document.positions()[vertex] - document.rest()[vertex];
            assert!((displacement(vertex as usize) - displacement(partner) * MIRROR).length() < 1e-12, "{slider:?}");
        }
        assert_eq!(moved(slider, 0.0).positions(), document.rest());
    }
}

#[test]
fn sliders_raise_no_peaks_and_invert_no_triangles() {
    let mut found = Vec::new();
    for slider in FaceSlider::ALL {
        for amount_m in [-slider.range_m(), slider.range_m()] {
            let document = moved(slider, amount_m);
            let displacement: Vec<DVec3> =
                document.positions().iter().zip(document.rest()).map(|(to, at)| *to - *at).collect();
            found.extend(
                peaks(document.topology(), &displacement).iter().map(|peak| format!("{slider:?} {amount_m}: {peak:?}")),
            );
            let turned = |corners: &&[u32; 3]| {
                normal(document.positions(), corners).dot(normal(document.rest(), corners)) <= 0.0
            };
            let turned = document.topology().triangles().iter().filter(turned);
            found.extend(turned.map(|corners| format!("{slider:?} {amount_m}: {corners:?} inverted")));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

fn normal(positions: &[DVec3], corners: &[u32; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|corner| positions[corner as usize]);
    (b - a).cross(c - a)
}

#[test]
fn ids_are_distinct_and_read_back() {
    let ids: BTreeSet<&str> = FaceSlider::ALL.iter().map(|slider| slider.id()).collect();
    assert_eq!(ids.len(), FaceSlider::ALL.len());
    assert!(FaceSlider::ALL.iter().all(|&slider| FaceSlider::from_id(slider.id()) == Some(slider)));
}
