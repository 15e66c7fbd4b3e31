//! Tests of the example `edit_obj` on a torus.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, reason = "a failed set-up fails the test")]

use std::f64::consts::TAU;
use std::fmt::Write;

use glam::DVec3;

#[allow(dead_code, reason = "its `main` is for the command line")]
#[path = "../examples/edit_obj.rs"]
mod edit_obj;

use edit_obj::edited;

const TORUS: &str = include_str!("../examples/torus.obj");
/// Number of vertices around the hole and around the tube.
const AROUND: u32 = 24;
const TUBE: u32 = 12;
/// On the outer equator, at the greatest `x`; counts from 1, as in OBJ.
const HANDLE: u32 = 1;
const OFFSET: DVec3 = DVec3::new(0.75, 0.0, 0.25);

/// A torus of quads with radius 2 and tube radius 0.75.
fn torus() -> String {
    let rounded = |value: f64| (value * 1e4).round() / 1e4 + 0.0;
    let mut obj = "# Made by the test that reads it.\no torus\n".to_owned();
    for (i, j) in (0..AROUND).flat_map(|i| (0..TUBE).map(move |j| (i, j))) {
        let (u, v) = (TAU * f64::from(i) / f64::from(AROUND), TAU * f64::from(j) / f64::from(TUBE));
        let radius = 2.0 + 0.75 * v.cos();
        let [x, y, z] = [radius * u.cos(), radius * u.sin(), 0.75 * v.sin()].map(rounded);
        writeln!(obj, "v {x:.4} {y:.4} {z:.4}").unwrap();
    }
    let vertex = |i: u32, j: u32| (i % AROUND) * TUBE + j % TUBE + 1;
    for (i, j) in (0..AROUND).flat_map(|i| (0..TUBE).map(move |j| (i, j))) {
        let corners = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        writeln!(obj, "f {} {} {} {}", corners[0], corners[1], corners[2], corners[3]).unwrap();
    }
    obj
}

fn positions(obj: &str) -> Vec<DVec3> {
    let numbers = |line: &str| line.split(' ').map(|number| number.parse().unwrap()).collect::<Vec<f64>>();
    obj.lines().filter_map(|line| line.strip_prefix("v ")).map(|line| DVec3::from_slice(&numbers(line))).collect()
}

fn displacements(before: &str, after: &str) -> Vec<DVec3> {
    positions(after).iter().zip(positions(before)).map(|(after, before)| after - before).collect()
}

fn torus_displaced() -> Vec<DVec3> {
    displacements(TORUS, &edited(TORUS, HANDLE, OFFSET).unwrap())
}

/// Distance of the vertex's cross-section from the handle's, in cross-sections.
fn steps_around(vertex: usize) -> u32 {
    let section = vertex as u32 / TUBE;
    section.min(AROUND - section)
}

#[test]
fn the_example_file_is_up_to_date() {
    assert!(TORUS == torus(), "examples/torus.obj should hold:\n{}", torus());
}

#[test]
fn the_handle_moves_by_the_offset() {
    let moved = torus_displaced()[HANDLE as usize - 1];
    assert!(moved.distance(OFFSET) < 1e-12, "{moved}");
}

#[test]
fn vertices_of_the_far_half_stay_exactly() {
    let moved = torus_displaced();
    let far: Vec<DVec3> = (0..moved.len()).filter(|&v| steps_around(v) > 8).map(|v| moved[v]).collect();
    assert_eq!(far.len(), 7 * TUBE as usize);
    assert!(far.iter().all(|&moved| moved == DVec3::ZERO), "{far:?}");
    let edit = edited(TORUS, HANDLE, OFFSET).unwrap();
    let unchanged =
        TORUS.lines().zip(edit.lines()).filter(|(before, after)| before.starts_with("v ") && before == after);
    assert!((120..200).contains(&unchanged.count()), "about half of the 288 vertices are anchors");
}

#[test]
fn displacements_decrease_with_distance() {
    let along = |vertex: usize| torus_displaced()[vertex].dot(OFFSET) / OFFSET.length_squared();
    let shares: Vec<f64> = (0..5).map(|step| along(step * TUBE as usize)).collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "decreasing: {shares:?}");
    assert!((0.3..1.0).contains(&shares[1]), "the first neighbour: {shares:?}");
    let mirrored = |step: usize| along((AROUND as usize - step) * TUBE as usize);
    assert!((1..5).all(|step| (mirrored(step) - shares[step]).abs() < 0.05), "symmetric: {shares:?}");
}

#[test]
fn other_lines_are_preserved() {
    let decorated = TORUS.replace("f 1 ", "g part\nusemtl skin\ns 1\nf 1 ");
    let rest = |obj: &str| obj.lines().filter(|line| !line.starts_with("v ")).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rest(&edited(&decorated, HANDLE, OFFSET).unwrap()), rest(&decorated));
    assert_eq!(edited(&decorated, HANDLE, DVec3::ZERO).unwrap(), decorated);
}

#[test]
fn corners_may_have_texture_coordinates_and_normals() {
    let corners = |line: &str, write: &dyn Fn(i32) -> String| {
        let vertices = line.strip_prefix("f ").map(|face| face.split(' ').map(|vertex| vertex.parse().unwrap()));
        vertices.map_or(line.to_owned(), |vertices| format!("f {}", vertices.map(write).collect::<Vec<_>>().join(" ")))
    };
    let rewritten = |before: &str, write: &dyn Fn(i32) -> String| {
        let lines: Vec<String> = TORUS.lines().map(|line| corners(line, write)).collect();
        format!("{}\n", lines.join("\n")).replacen("f ", &format!("{before}f "), 1)
    };
    let plain = torus_displaced();
    let (vt, vn) = ("vt 0 0\n", "vn 0 0 1\n");
    for obj in [
        rewritten(vt, &|vertex| format!("{vertex}/1")),
        rewritten(vn, &|vertex| format!("{vertex}//1")),
        rewritten(&format!("{vt}{vn}"), &|vertex| format!("{vertex}/1/1")),
    ] {
        assert_eq!(displacements(&obj, &edited(&obj, HANDLE, OFFSET).unwrap()), plain);
    }
}

/// An edge with three triangles is not manifold, but its cotangent weights are defined.
#[test]
fn a_non_manifold_fin_follows() {
    let fin = format!("{}f 1 2 289\n", TORUS.replacen("f ", "v 3.5 0 0\nf ", 1));
    let moved = displacements(&fin, &edited(&fin, HANDLE, OFFSET).unwrap());
    assert!(moved[HANDLE as usize - 1].distance(OFFSET) < 1e-12, "{}", moved[HANDLE as usize - 1]);
    // The fin extends the slope beyond the handle, so it moves farther in the same direction.
    let along = moved[288].dot(OFFSET) / OFFSET.length_squared();
    assert!((1.0..2.0).contains(&along) && moved[288].distance(OFFSET * along) < 1e-9, "{}", moved[288]);
}

#[test]
fn invalid_input_gives_clear_errors() {
    let refused = |obj: &str, vertex| edited(obj, vertex, OFFSET).unwrap_err().to_string();
    assert_eq!(refused(TORUS, 289), "vertex 289 does not exist: the file has vertices 1 to 288");
    assert_eq!(refused(TORUS, 0), "vertex 0 does not exist: the file has vertices 1 to 288");
    let twice = format!("{TORUS}o other\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 289 290 291\n");
    assert_eq!(refused(&twice, 1), "the file must contain one object; it contains 2");
    let from_the_end = format!("{TORUS}f -1 -2 -3\n");
    assert_eq!(refused(&from_the_end, 1), "parse error (L579): Expected index in the range [1, 289), but got -1.");
    assert_eq!(refused("o broken\nv 1 2\n", 1), "parse error (L2): cannot parse corrupted data");
}
