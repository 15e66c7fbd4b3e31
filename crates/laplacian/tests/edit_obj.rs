//! The example that edits OBJ files, on a torus: what is asked for happens there, and nothing else does.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

use std::f64::consts::TAU;
use std::fmt::Write;

use glam::DVec3;

#[allow(dead_code, reason = "its `main` is for the command line")]
#[path = "../examples/edit_obj.rs"]
mod edit_obj;

use edit_obj::edited;

const TORUS: &str = include_str!("../examples/torus.obj");
/// Vertices around the hole, and around the tube.
const AROUND: u32 = 24;
const TUBE: u32 = 12;
/// On the outer equator, where `x` is greatest; from 1, as OBJ counts.
const HANDLE: u32 = 1;
const OFFSET: DVec3 = DVec3::new(0.75, 0.0, 0.25);

/// A ring of radius 2 with a tube of radius 0.75, in quads.
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

/// How many steps two of the ring's cross-sections are apart.
fn steps_around(vertex: usize) -> u32 {
    let section = vertex as u32 / TUBE;
    section.min(AROUND - section)
}

#[test]
fn the_file_is_what_this_test_makes_it() {
    assert!(TORUS == torus(), "examples/torus.obj should hold:\n{}", torus());
}

#[test]
fn the_handle_lands_where_it_was_dragged() {
    let moved = torus_displaced()[HANDLE as usize - 1];
    assert!(moved.distance(OFFSET) < 1e-12, "{moved}");
}

#[test]
fn the_far_half_stays_to_the_byte() {
    let moved = torus_displaced();
    let far: Vec<DVec3> = (0..moved.len()).filter(|&v| steps_around(v) > 8).map(|v| moved[v]).collect();
    assert_eq!(far.len(), 7 * TUBE as usize);
    assert!(far.iter().all(|&moved| moved == DVec3::ZERO), "{far:?}");
    let edit = edited(TORUS, HANDLE, OFFSET).unwrap();
    let kept = TORUS.lines().zip(edit.lines()).filter(|(before, after)| before.starts_with("v ") && before == after);
    assert!((120..200).contains(&kept.count()), "about half of the 288 vertices are anchors");
}

#[test]
fn what_is_between_follows_smoothly() {
    let along = |vertex: usize| torus_displaced()[vertex].dot(OFFSET) / OFFSET.length_squared();
    let shares: Vec<f64> = (0..5).map(|step| along(step * TUBE as usize)).collect();
    assert!(shares.windows(2).all(|pair| pair[1] < pair[0]), "less with every step away: {shares:?}");
    assert!((0.3..1.0).contains(&shares[1]), "the neighbour goes most of the way: {shares:?}");
    let mirrored = |step: usize| along((AROUND as usize - step) * TUBE as usize);
    assert!((1..5).all(|step| (mirrored(step) - shares[step]).abs() < 0.05), "on both sides: {shares:?}");
}

#[test]
fn everything_but_the_vertices_is_kept() {
    let decorated = TORUS.replace("f 1 ", "g part\nusemtl skin\ns 1\nf 1 ");
    let rest = |obj: &str| obj.lines().filter(|line| !line.starts_with("v ")).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rest(&edited(&decorated, HANDLE, OFFSET).unwrap()), rest(&decorated));
    assert_eq!(edited(&decorated, HANDLE, DVec3::ZERO).unwrap(), decorated);
}

#[test]
fn corners_may_name_texture_coordinates_and_normals_beside_their_vertices() {
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

/// Where three triangles meet in an edge there is no surface, but cotangents all the same.
#[test]
fn a_fin_goes_along() {
    let fin = format!("{}f 1 2 289\n", TORUS.replacen("f ", "v 3.5 0 0\nf ", 1));
    let moved = displacements(&fin, &edited(&fin, HANDLE, OFFSET).unwrap());
    assert!(moved[HANDLE as usize - 1].distance(OFFSET) < 1e-12, "{}", moved[HANDLE as usize - 1]);
    // Beyond the handle, on the same slope: it swings out farther, and to no other side.
    let along = moved[288].dot(OFFSET) / OFFSET.length_squared();
    assert!((1.0..2.0).contains(&along) && moved[288].distance(OFFSET * along) < 1e-9, "{}", moved[288]);
}

#[test]
fn what_cannot_be_edited_is_refused_in_words() {
    let refused = |obj: &str, vertex| edited(obj, vertex, OFFSET).unwrap_err().to_string();
    assert_eq!(refused(TORUS, 289), "there is no vertex 289: the file has 1 to 288");
    assert_eq!(refused(TORUS, 0), "there is no vertex 0: the file has 1 to 288");
    let twice = format!("{TORUS}o other\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 289 290 291\n");
    assert_eq!(refused(&twice, 1), "the file holds 2 objects, not one");
    let from_the_end = format!("{TORUS}f -1 -2 -3\n");
    assert_eq!(refused(&from_the_end, 1), "parse error (L579): Expected index in the range [1, 289), but got -1.");
    assert_eq!(refused("o broken\nv 1 2\n", 1), "parse error (L2): cannot parse corrupted data");
}
