//! A slider tick does not allocate.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, reason = "a failed set-up fails the test")]
#![allow(unsafe_code, reason = "counting allocations needs a global allocator, which is an unsafe trait")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use glam::DVec3;
use rosto_laplacian::{Constraints, LaplacianSystem, Operator};
use rosto_mesh::{LoopSubdivision, Topology};

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: all calls are forwarded unchanged to the system allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: the caller upholds the contract of `GlobalAlloc::alloc`, which is the system allocator's.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above; the pointer came from the system allocator.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations_during(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

#[test]
fn ticks_and_subdivision_do_not_allocate() {
    let octahedron = vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    let cage = Topology::new(6, octahedron).unwrap();
    let corners = [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y, DVec3::Z, -DVec3::Z];
    let dense = LoopSubdivision::new(&cage, 5);
    let rest = dense.apply(&corners);
    let system = LaplacianSystem::new(dense.topology(), &rest, Operator::UniformSymmetric).unwrap();
    let constraints = Constraints { handles: &[0, 1], anchors: &[4, 5], ..Default::default() };
    let response = system.respond(&constraints).unwrap();
    let mut edited = rest.clone();
    let mut lifted = rest.clone();

    assert_eq!(allocations_during(|| response.displace(&rest, &[DVec3::Y, DVec3::Z], &mut edited)), 0);
    assert_eq!(allocations_during(|| dense.apply_to(&corners, &mut lifted)), 0);
    assert!(allocations_during(|| drop(edited.clone())) > 0, "the allocator counts");
    assert_eq!(lifted, rest);
}
