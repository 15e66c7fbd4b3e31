use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rosto_warp::{leading, seen};

const ROUND: u32 = 48;
const RINGS: u32 = 24;

/// A sphere; x and y in px of the picture, y down, z towards the viewer in px.
fn sphere(centre: DVec3, radius: f64) -> (Vec<[u32; 3]>, Vec<DVec3>) {
    let position = |i: u32| {
        let (around, along) =
            (TAU * f64::from(i % ROUND) / f64::from(ROUND), PI * (f64::from(i / ROUND) + 0.5) / f64::from(RINGS));
        let y_up = DVec3::new(along.sin() * around.cos(), along.cos(), along.sin() * around.sin());
        centre + radius * y_up * DVec3::new(1.0, -1.0, 1.0)
    };
    let at = |ring: u32, i: u32| ring * ROUND + i % ROUND;
    let cells = (0..RINGS - 1).flat_map(|ring| (0..ROUND).map(move |i| (ring, i)));
    let triangles = cells.flat_map(|(ring, i)| {
        // Counter-clockwise seen from outside: on the front, x grows as the angle decreases.
        [[at(ring, i), at(ring, i + 1), at(ring + 1, i)], [at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)]]
    });
    (triangles.collect(), (0..ROUND * RINGS).map(position).collect())
}

#[test]
fn the_front_of_a_sphere_is_visible_and_the_back_is_not() {
    let (triangles, positions) = sphere(DVec3::new(100.0, 80.0, 5.0), 60.0);
    for (position, is_seen) in positions.iter().zip(seen(&triangles, &positions, 3.0)) {
        let front = (position.z - 5.0) / 60.0;
        assert!(front < 0.25 || is_seen, "{position} is on the front");
        assert!(front > -0.15 || !is_seen, "{position} is on the back");
    }
    let inside_out: Vec<[u32; 3]> = triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
    let backs = positions
        .iter()
        .zip(seen(&inside_out, &positions, 3.0))
        .filter(|(position, is_seen)| *is_seen && position.z > 20.0);
    assert_eq!(backs.count(), 0, "inverted triangles face away");
}

#[test]
fn occluded_vertices_are_not_visible() {
    let (mut triangles, mut positions) = sphere(DVec3::new(100.0, 80.0, 0.0), 60.0);
    let alone = seen(&triangles, &positions, 3.0);
    let count = positions.len() as u32;
    let (before, before_places) = sphere(DVec3::new(130.0, 80.0, 100.0), 25.0);
    triangles.extend(before.iter().map(|corners| corners.map(|corner| corner + count)));
    positions.extend(before_places);
    let both = seen(&triangles, &positions, 3.0);
    for vertex in 0..count as usize {
        let away = positions[vertex].truncate().distance(glam::DVec2::new(130.0, 80.0));
        assert!(away > 22.0 || !both[vertex], "{} must be hidden", positions[vertex]);
        assert!(away < 28.0 || both[vertex] == alone[vertex], "{} must not change", positions[vertex]);
    }
    assert!(both[count as usize..].iter().any(|is_seen| *is_seen));
}

#[test]
fn non_finite_vertices_are_not_visible_and_hide_nothing() {
    assert!(seen(&[], &[], 1.0).is_empty());
    assert_eq!(seen(&[[0, 1, 2]], &[DVec3::ZERO; 3], 1.0), [false; 3]);
    let (triangles, positions) = sphere(DVec3::new(100.0, 80.0, 5.0), 60.0);
    let whole = seen(&triangles, &positions, 3.0);
    let lost = (0..positions.len()).find(|&vertex| whole[vertex]).unwrap();
    for non_finite in [DVec3::NAN, DVec3::INFINITY, DVec3::NEG_INFINITY] {
        let mut positions = positions.clone();
        positions[lost] = non_finite;
        let seen = seen(&triangles, &positions, 3.0);
        assert!(!seen[lost]);
        let differ = seen.iter().zip(&whole).filter(|(now, before)| now != before).count();
        assert!(differ <= 7, "more than the vertex and its neighbours: {differ}");
    }
}

/// Excludes vertices near the sphere's outline, which overlap in the picture.
const INSIDE_PX: f64 = 20.0;

#[test]
fn visible_vertices_of_a_single_part_lead() {
    let (triangles, positions) = sphere(DVec3::new(100.0, 80.0, 5.0), 60.0);
    let seen = seen(&triangles, &positions, 3.0);
    for apart_px in [0.0, 3.0, 20.0] {
        let leads = leading(&triangles, &positions, 3.0, apart_px);
        for vertex in 0..positions.len() {
            assert!(leads[vertex] == seen[vertex] || positions[vertex].z < INSIDE_PX, "{}", positions[vertex]);
        }
    }
}

#[test]
fn occluding_vertices_lead_and_vertices_close_behind_do_not() {
    const APART_PX: f64 = 5.0;
    let (mut triangles, mut positions) = sphere(DVec3::new(100.0, 80.0, 0.0), 60.0);
    let count = positions.len() as u32;
    let (before, before_places) = sphere(DVec3::new(115.0, 80.0, 100.0), 25.0);
    triangles.extend(before.iter().map(|corners| corners.map(|corner| corner + count)));
    positions.extend(before_places);
    let (seen, leads) = (seen(&triangles, &positions, 3.0), leading(&triangles, &positions, 3.0, APART_PX));
    assert_eq!(leads[count as usize..], seen[count as usize..]);
    let outline: Vec<DVec3> = (count as usize..positions.len()).filter(|&v| seen[v]).map(|v| positions[v]).collect();
    let mut excluded = 0;
    for vertex in (0..count as usize).filter(|&vertex| seen[vertex] && positions[vertex].z > INSIDE_PX) {
        let away_px = |position: &DVec3| position.truncate().distance(positions[vertex].truncate());
        let away_px = outline.iter().map(away_px).fold(f64::INFINITY, f64::min);
        assert_eq!(leads[vertex], away_px >= 2.0 * APART_PX, "{away_px} px");
        excluded += usize::from(!leads[vertex]);
    }
    assert!(excluded > 10, "{excluded}");
}

/// A square of 21 × 21 vertices, 4 px apart, slit along its centre row except at the ends. The part below the slit is
/// shifted down by up to `gap`, which can be negative. Also returns the vertices along the slit, without its ends.
fn slit(gap: f64) -> (Vec<[u32; 3]>, Vec<DVec3>, Vec<usize>) {
    const SIDE: u32 = 21;
    const MIDDLE: u32 = SIDE / 2;
    let below = |column: u32| SIDE * SIDE + column;
    let at = |column: u32, row: u32, of_row: u32| {
        let is_cut = row == MIDDLE && of_row == MIDDLE && (1..SIDE - 1).contains(&column);
        if is_cut { below(column) } else { row * SIDE + column }
    };
    let cells = (0..SIDE - 1).flat_map(|row| (0..SIDE - 1).map(move |column| (column, row)));
    let triangles = cells.flat_map(|(column, row)| {
        let [a, b, c, d] = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| at(column + x, row + y, row));
        [[a, c, b], [b, c, d]]
    });
    let lens = |column: u32| gap * (f64::from(column) / f64::from(SIDE - 1) * PI).sin();
    let position = |i: u32| {
        let (column, row) = if i < SIDE * SIDE { (i % SIDE, i / SIDE) } else { (i - SIDE * SIDE, MIDDLE) };
        let is_below = row > MIDDLE || i >= SIDE * SIDE;
        let lower = if is_below { lens(column) } else { 0.0 };
        DVec3::new(4.0 * f64::from(column), 4.0 * f64::from(row) + lower, 0.0)
    };
    let along = (1..SIDE - 1).flat_map(|column| [MIDDLE * SIDE + column, below(column)].map(|v| v as usize)).collect();
    (triangles.collect(), (0..SIDE * SIDE + SIDE).map(position).collect(), along)
}

#[test]
fn touching_rims_do_not_lead_and_separate_rims_do() {
    for gap in [-1.0, 0.0, 1.0] {
        let (triangles, positions, along) = slit(gap);
        let (seen, leads) = (seen(&triangles, &positions, 3.0), leading(&triangles, &positions, 3.0, 3.0));
        for vertex in (0..positions.len()).filter(|&vertex| seen[vertex]) {
            assert_eq!(leads[vertex], !along.contains(&vertex), "{} with a gap of {gap}", positions[vertex]);
        }
    }
    let (triangles, positions, _) = slit(30.0);
    let leads = leading(&triangles, &positions, 3.0, 3.0);
    assert_eq!(leads, seen(&triangles, &positions, 3.0), "an open slit has two separate rims");
}
