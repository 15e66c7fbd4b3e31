//! Size of a face by a bank card held against it.

use crate::common::observed;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use rosto_face::*;

const SIZE_PX: [u32; 2] = [900, 1200];

/// The canonical face, larger by `size`, in a camera's frame, without a turn.
fn head(size: f64, distance_m: f64) -> Vec<DVec3> {
    let canonical = canonical_positions_m();
    let mean = canonical.iter().sum::<DVec3>() / LANDMARK_COUNT as f64;
    canonical.iter().map(|&position| (position - mean) * size - DVec3::Z * distance_m).collect()
}

fn seen(position_m: DVec3, focal_px: f64) -> [f64; 2] {
    let [width, height] = SIZE_PX.map(f64::from);
    let at_px = position_m.truncate() * focal_px / -position_m.z;
    [at_px.x / width + 0.5, 0.5 - at_px.y / height]
}

fn photo(head: &[DVec3], distance_m: f64, focal_px: f64, card: Option<CardCorners>) -> Observation {
    let landmark = |&position_m: &DVec3| {
        let [x, y] = seen(position_m, focal_px);
        let depth = (-distance_m - position_m.z) * focal_px / distance_m / f64::from(SIZE_PX[0]);
        [x, y, depth].map(|coordinate| coordinate as f32)
    };
    let landmarks: Vec<[f32; 3]> = head.iter().map(landmark).collect();
    let lens_mm = focal_px * 36_f64.hypot(24.0) / f64::from(SIZE_PX[0]).hypot(f64::from(SIZE_PX[1]));
    Observation { card, ..observed(&landmarks, SIZE_PX, PhotoLens::Given(lens_mm)) }
}

/// A card that touches a landmark with its middle, tilted, with its corners in any order.
fn card(touched_m: DVec3, tilt_deg: [f64; 3], focal_px: f64, first: usize) -> CardCorners {
    let [x, y, z] = tilt_deg.map(f64::to_radians);
    let tilt = DQuat::from_euler(glam::EulerRot::XYZ, x, y, z);
    let corner = |[x, y]: [f64; 2]| seen(touched_m + tilt * DVec3::new(x * 0.0428, y * 0.026_99, 0.0), focal_px);
    let corners = [[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]];
    [0, 1, 2, 3].map(|at: usize| corner(corners[(at + first) % 4]))
}

fn width_m(model: &FaceModel) -> f64 {
    Measure::FaceWidth.of(model.positions_m())
}

proptest! {
    #[test]
    fn a_card_gives_the_size_within_one_per_cent(
        size in 0.7..1.4f64,
        distance_m in 0.3..1.5f64,
        touched in prop::sample::select(vec![10_usize, 151, 199, 152]),
        tilt_deg in prop::array::uniform3(-15.0..15.0f64),
        focal_px in 600.0..3000.0f64,
        first in 0..4usize,
    ) {
        let head = head(size, distance_m);
        let corners = card(head[touched], tilt_deg, focal_px, first);
        let model = FaceModel::new(photo(&head, distance_m, focal_px, Some(corners)), Triangulation::Canonical).unwrap();
        let found = width_m(&model) / Measure::FaceWidth.of(&canonical_positions_m()) / size;
        prop_assert!((found - 1.0).abs() < 0.01, "{found}");
        prop_assert_eq!(model.scale().source, ScaleSource::Card);
        let [nearest_m, farthest_m] = model.camera().distance_interval_m;
        prop_assert!((nearest_m..farthest_m).contains(&distance_m), "{nearest_m} to {farthest_m} m");
    }

    #[test]
    fn a_card_survives_storage(corners in prop::array::uniform4(prop::array::uniform2(0.0..1.0f64))) {
        let stored = photo(&head(1.0, 0.5), 0.5, 1000.0, Some(corners));
        prop_assert_eq!(Observation::from_bytes(&stored.to_bytes()).unwrap().card, Some(corners));
    }
}

#[test]
fn corners_in_px_are_those_of_the_upright_photo() {
    let photo = photo(&head(1.0, 0.5), 0.5, 1000.0, None);
    let marked = photo.with_card_px([[0.0, 0.0], [900.0, 0.0], [900.0, 600.0], [0.0, 1200.0]]);
    assert_eq!(marked.card, Some([[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 1.0]]));
}

#[test]
fn measures_are_withheld_unless_they_say_more_than_the_average() {
    let head = head(1.0, 0.5);
    let corners = card(head[151], [0.0; 3], 1000.0, 0);
    let lengths = |card| {
        let model = FaceModel::new(photo(&head, 0.5, 1000.0, card), Triangulation::Canonical).unwrap();
        Measure::ALL.into_iter().filter_map(|measure| measure.length(model.positions_m(), model.scale())).count()
    };
    assert_eq!((lengths(None), lengths(Some(corners))), (0, Measure::ALL.len()));
}

#[test]
fn other_shapes_than_a_card_are_refused() {
    let head = head(1.0, 0.5);
    for corners in [
        [[0.4, 0.4], [0.6, 0.4], [0.6, 0.55], [0.4, 0.55]],
        [[0.4, 0.4]; 4],
        [[0.3, 0.4], [0.4, 0.4], [0.5, 0.4], [0.6, 0.4]],
        [[0.4, 0.4], [0.6, 0.4], [0.6, f64::NAN], [0.4, 0.5]],
    ] {
        let model = FaceModel::new(photo(&head, 0.5, 1000.0, Some(corners)), Triangulation::Canonical);
        assert_eq!(model.unwrap_err(), FaceError::NotACard, "{corners:?}");
    }
    let far = [[f64::INFINITY, 0.0], [0.6, 0.4], [0.6, 0.5], [0.4, 0.5]];
    assert_eq!(photo(&head, 0.5, 1000.0, Some(far)).checked(), Err(FaceError::NotACard));
}

#[test]
fn the_near_pupillary_distance_is_that_of_converging_eyes() {
    let face = canonical_positions_m();
    let [far_m, near_m] = [Measure::EyeDistance, Measure::NearEyeDistance].map(|measure| measure.of(&face));
    assert!((0.003..0.006).contains(&(far_m - near_m)), "{far_m} {near_m}");
}
