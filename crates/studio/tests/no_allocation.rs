//! A slider tick allocates nothing.

#![cfg(not(target_arch = "wasm32"))]
#![allow(unsafe_code, reason = "an allocator that counts has to be an allocator")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use glam::DVec3;
use rosto_face::{Triangulation, canonical_positions_m};
use rosto_studio::*;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is handed on to the system's allocator as it came.
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
        let mut document = Document::new(Rest::new(topology, canonical_positions_m(), CoordinateFrame::Model)).unwrap();
        document.set_density(density).unwrap();
        let settings = Settings { mirror, ..Settings::default() };
        document.hold(EditSpec { level: 0, handles: vec![61, 17], settings }).unwrap();
        document.preview(&[DVec3::X, DVec3::Y]).unwrap();
        let before = ALLOCATIONS.with(Cell::get);
        for tick in 0..100 {
            document.preview(&[DVec3::X * f64::from(tick), DVec3::Y]).unwrap();
        }
        assert_eq!(ALLOCATIONS.with(Cell::get), before);
    }
}
