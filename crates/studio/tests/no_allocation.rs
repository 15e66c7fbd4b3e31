//! Slider ticks do not allocate.

#![cfg(not(target_arch = "wasm32"))]
#![allow(unsafe_code, reason = "a counting allocator implements GlobalAlloc")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use glam::DVec3;
use rosto_face::{FaceModel, LANDMARK_COUNT, Observation, PhotoLens, Triangulation, canonical_positions_m};
use rosto_studio::*;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: each call is forwarded unchanged to the system allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn ticks_after_the_first_allocate_nothing() {
    for (mirror, density) in [(Mirror::Off, 0), (Mirror::On, 0), (Mirror::On, 2)] {
        let topology = Triangulation::Canonical.topology();
        let mut document =
            Document::new(Rest::of_landmarks(topology, canonical_positions_m(), CoordinateFrame::Model)).unwrap();
        document.set_density(density).unwrap();
        let settings = Settings { mirror, ..Settings::default() };
        document.prepare(EditSpec { level: 0, handles: vec![61, 17], settings }).unwrap();
        document.preview(&[DVec3::X, DVec3::Y]).unwrap();
        let before = ALLOCATIONS.with(Cell::get);
        for tick in 0..100 {
            document.preview(&[DVec3::X * f64::from(tick), DVec3::Y]).unwrap();
        }
        assert_eq!(ALLOCATIONS.with(Cell::get), before);
    }
}

#[test]
fn photo_ticks_without_folds_allocate_nothing() {
    let camera = face().camera().to_owned();
    for density in [0, 2] {
        let mut document = Document::new(Rest::of_face(&face())).unwrap();
        document.set_density(density).unwrap();
        document.prepare(FaceSlider::JawWidth.spec()).unwrap();
        let mut photo_warp = PhotoWarp::new(&face(), &document, DEFAULT_FALLOFF_BAND, &[]).unwrap();
        let mut tick = |amount_m: f64| {
            document.preview(&FaceSlider::JawWidth.offsets_m(amount_m)).unwrap();
            let before = ALLOCATIONS.with(Cell::get);
            photo_warp.follow(document.rest(), document.positions(), &camera, &camera);
            assert_eq!(photo_warp.limited_px(), 0.0, "nothing folds");
            ALLOCATIONS.with(Cell::get) - before
        };
        tick(0.001);
        assert!((0..20).all(|step| tick(0.0001 * f64::from(step)) == 0));
    }
}

/// The canonical face in the centre of a photo.
fn face() -> FaceModel {
    let landmark = |position_m: DVec3| {
        [0.5 + 2.0 * position_m.x, 0.5 - 2.0 * position_m.y, -2.0 * position_m.z].map(|at| at as f32)
    };
    let observation = Observation {
        landmarks: canonical_positions_m().into_iter().map(landmark).collect(),
        photo_size_px: [640, 640],
        colours_srgb: vec![[0; 3]; LANDMARK_COUNT],
        found_lens: PhotoLens::Estimated,
        card: None,
        lens: PhotoLens::Distance(0.5),
        picture: None,
    };
    FaceModel::new(observation, Triangulation::Canonical).unwrap()
}
