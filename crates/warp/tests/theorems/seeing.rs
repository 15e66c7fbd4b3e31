use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rosto_warp::{leading, seen};

const ROUND: u32 = 48;
const RINGS: u32 = 24;

/// A sphere about a place: px of the picture, y down, and the way towards the viewer, in px.
fn sphere(middle: DVec3, radius: f64) -> (Vec<[u32; 3]>, Vec<DVec3>) {
    let place = |i: u32| {
        let (around, along) =
            (TAU * f64::from(i % ROUND) / f64::from(ROUND), PI * (f64::from(i / ROUND) + 0.5) / f64::from(RINGS));
        let y_up = DVec3::new(along.sin() * around.cos(), along.cos(), along.sin() * around.sin());
        middle + radius * y_up * DVec3::new(1.0, -1.0, 1.0)
    };
    let at = |ring: u32, i: u32| ring * ROUND + i % ROUND;
    let cells = (0..RINGS - 1).flat_map(|ring| (0..ROUND).map(move |i| (ring, i)));
    let triangles = cells.flat_map(|(ring, i)| {
        // Counter-clockwise from outside: on the front, x grows as the angle shrinks.
        [[at(ring, i), at(ring, i + 1), at(ring + 1, i)], [at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)]]
    });
    (triangles.collect(), (0..ROUND * RINGS).map(place).collect())
}

#[test]
fn of_a_sphere_the_front_is_seen_and_the_back_is_not() {
    let (triangles, places) = sphere(DVec3::new(100.0, 80.0, 5.0), 60.0);
    for (place, is_seen) in places.iter().zip(seen(&triangles, &places, 3.0)) {
        let front = (place.z - 5.0) / 60.0;
        assert!(front < 0.25 || is_seen, "{place} is on the front");
        assert!(front > -0.15 || !is_seen, "{place} is on the back");
    }
    let inside_out: Vec<[u32; 3]> = triangles.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
    let backs =
        places.iter().zip(seen(&inside_out, &places, 3.0)).filter(|(place, is_seen)| *is_seen && place.z > 20.0);
    assert_eq!(backs.count(), 0, "what winds the other way is seen from behind");
}

#[test]
fn what_is_behind_something_is_not_seen() {
    let (mut triangles, mut places) = sphere(DVec3::new(100.0, 80.0, 0.0), 60.0);
    let alone = seen(&triangles, &places, 3.0);
    let count = places.len() as u32;
    let (before, before_places) = sphere(DVec3::new(130.0, 80.0, 100.0), 25.0);
    triangles.extend(before.iter().map(|corners| corners.map(|corner| corner + count)));
    places.extend(before_places);
    let both = seen(&triangles, &places, 3.0);
    for vertex in 0..count as usize {
        let away = places[vertex].truncate().distance(glam::DVec2::new(130.0, 80.0));
        assert!(away > 22.0 || !both[vertex], "{} is hidden", places[vertex]);
        assert!(away < 28.0 || both[vertex] == alone[vertex], "{} is as it was", places[vertex]);
    }
    assert!(both[count as usize..].iter().any(|is_seen| *is_seen));
}

#[test]
fn what_is_nowhere_is_not_seen_and_hides_nothing() {
    assert!(seen(&[], &[], 1.0).is_empty());
    assert_eq!(seen(&[[0, 1, 2]], &[DVec3::ZERO; 3], 1.0), [false; 3]);
    let (triangles, places) = sphere(DVec3::new(100.0, 80.0, 5.0), 60.0);
    let whole = seen(&triangles, &places, 3.0);
    let lost = (0..places.len()).find(|&vertex| whole[vertex]).unwrap();
    for nowhere in [DVec3::NAN, DVec3::INFINITY, DVec3::NEG_INFINITY] {
        let mut places = places.clone();
        places[lost] = nowhere;
        let seen = seen(&triangles, &places, 3.0);
        assert!(!seen[lost]);
        let differ = seen.iter().zip(&whole).filter(|(now, before)| now != before).count();
        assert!(differ <= 7, "itself and its neighbours: {differ}");
    }
}

/// Points near the outline of a sphere lie over each other in the picture.
const INSIDE_PX: f64 = 20.0;

#[test]
fn what_is_of_one_sheet_leads_where_it_is_seen() {
    let (triangles, places) = sphere(DVec3::new(100.0, 80.0, 5.0), 60.0);
    let seen = seen(&triangles, &places, 3.0);
    for apart_px in [0.0, 3.0, 20.0] {
        let leads = leading(&triangles, &places, 3.0, apart_px);
        for vertex in 0..places.len() {
            assert!(leads[vertex] == seen[vertex] || places[vertex].z < INSIDE_PX, "{}", places[vertex]);
        }
    }
}

#[test]
fn beside_what_is_before_it_nothing_leads_and_what_is_before_does() {
    const APART_PX: f64 = 5.0;
    let (mut triangles, mut places) = sphere(DVec3::new(100.0, 80.0, 0.0), 60.0);
    let count = places.len() as u32;
    let (before, before_places) = sphere(DVec3::new(115.0, 80.0, 100.0), 25.0);
    triangles.extend(before.iter().map(|corners| corners.map(|corner| corner + count)));
    places.extend(before_places);
    let (seen, leads) = (seen(&triangles, &places, 3.0), leading(&triangles, &places, 3.0, APART_PX));
    assert_eq!(leads[count as usize..], seen[count as usize..]);
    let outline: Vec<DVec3> = (count as usize..places.len()).filter(|&v| seen[v]).map(|v| places[v]).collect();
    let mut held = 0;
    for vertex in (0..count as usize).filter(|&vertex| seen[vertex] && places[vertex].z > INSIDE_PX) {
        let away_px = |place: &DVec3| place.truncate().distance(places[vertex].truncate());
        let away_px = outline.iter().map(away_px).fold(f64::INFINITY, f64::min);
        assert_eq!(leads[vertex], away_px >= 2.0 * APART_PX, "{away_px} px");
        held += usize::from(!leads[vertex]);
    }
    assert!(held > 10, "{held}");
}

/// A square of 21 × 21 vertices, 4 px apart, cut along its middle row but for its ends; below the cut all is lower by `gap`,
/// which may be less than nothing. With the vertices along the cut, but for the two ends.
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
    let place = |i: u32| {
        let (column, row) = if i < SIDE * SIDE { (i % SIDE, i / SIDE) } else { (i - SIDE * SIDE, MIDDLE) };
        let is_below = row > MIDDLE || i >= SIDE * SIDE;
        let lower = if is_below { lens(column) } else { 0.0 };
        DVec3::new(4.0 * f64::from(column), 4.0 * f64::from(row) + lower, 0.0)
    };
    let along = (1..SIDE - 1).flat_map(|column| [MIDDLE * SIDE + column, below(column)].map(|v| v as usize)).collect();
    (triangles.collect(), (0..SIDE * SIDE + SIDE).map(place).collect(), along)
}

#[test]
fn rims_that_touch_do_not_lead_and_rims_that_are_apart_do() {
    for gap in [-1.0, 0.0, 1.0] {
        let (triangles, places, along) = slit(gap);
        let (seen, leads) = (seen(&triangles, &places, 3.0), leading(&triangles, &places, 3.0, 3.0));
        for vertex in (0..places.len()).filter(|&vertex| seen[vertex]) {
            assert_eq!(leads[vertex], !along.contains(&vertex), "{} with a gap of {gap}", places[vertex]);
        }
    }
    let (triangles, places, _) = slit(30.0);
    let leads = leading(&triangles, &places, 3.0, 3.0);
    assert_eq!(leads, seen(&triangles, &places, 3.0), "opened, it has two rims");
}
