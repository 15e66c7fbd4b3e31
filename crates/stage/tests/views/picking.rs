//! Picking with the camera's rays.

use glam::{DVec2, DVec3};
use rosto_mesh::{Surface, Topology, pick};
use rosto_stage::{Glide, Stage};

const CELLS: u32 = 16;

/// A dome from (−1, −1) to (1, 1) that faces the viewer.
fn dome() -> (Topology, Vec<DVec3>) {
    let side = CELLS + 1;
    let triangles = (0..CELLS * CELLS).flat_map(|cell| {
        let at = cell / CELLS * side + cell % CELLS;
        [[at, at + 1, at + side + 1], [at, at + side + 1, at + side]]
    });
    let positions = (0..side * side).map(|vertex| {
        let position = DVec2::new(f64::from(vertex % side), f64::from(vertex / side)) / f64::from(CELLS);
        let position = position * 2.0 - DVec2::ONE;
        position.extend(0.9 * (1.0 - 0.5 * position.length_squared()))
    });
    (Topology::new((side * side) as usize, triangles.collect()).unwrap(), positions.collect())
}

#[test]
fn a_click_on_a_vertex_picks_it() {
    let (topology, positions) = dome();
    let surface = Surface::new(&topology, &positions).unwrap();
    let mut stage = Stage::default();
    stage.camera_mut().resize(240, 240);
    stage.frame(&positions);
    stage.camera_mut().set_glide(Glide::Off);
    stage.camera_mut().orbit(30.0, -20.0);
    stage.advance(0.0);
    let at = |position_px| pick(surface, &stage.camera().ray(position_px)).map(|hit| hit.nearest_corner());
    for vertex in [0_usize, 144, 150, 200] {
        let towards_middle = positions[vertex].lerp(positions[144], 0.02);
        let position_px = stage.camera().project(towards_middle).unwrap();
        assert_eq!(at(position_px), Some(vertex as u32));
    }
    assert_eq!(at(DVec2::ONE), None);
}
