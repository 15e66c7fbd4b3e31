//! Whether two triangles meet where they should not.

use glam::{DVec2, DVec3};

/// A determinant below this share of what its factors could make is one of points in a plane: rounding decides its sign.
const IN_A_PLANE: f64 = 1e-13;

/// Whether two triangles with other corners in common than all three have a point in common beside those and the side
/// between them. What touches meets.
///
/// Each side of one is tried against the other (segment against triangle by the signs of volumes); triangles in one plane
/// by the axes that part convex figures.
pub(super) fn meet(positions: &[DVec3], one: [u32; 3], other: [u32; 3]) -> bool {
    let place = |corners: [u32; 3]| corners.map(|corner| positions[corner as usize]);
    let (a, b) = (place(one), place(other));
    let of_a = a.map(|point| side_of(b, point));
    if is_beyond(of_a) {
        return false;
    }
    let of_b = b.map(|point| side_of(a, point));
    if of_a == [0; 3] && of_b == [0; 3] {
        return overlap(a, b);
    }
    !is_beyond(of_b) && (pierces(a, one, of_a, b, other) || pierces(b, other, of_b, a, one))
}

/// Whether a triangle whose corners lie on these sides of a plane has no point in it.
fn is_beyond(sides: [i8; 3]) -> bool {
    sides == [1; 3] || sides == [-1; 3]
}

/// Whether a side of a triangle that has no corner of the other's goes through the other, on whose sides its corners lie.
fn pierces(places: [DVec3; 3], corners: [u32; 3], of: [i8; 3], other: [DVec3; 3], others: [u32; 3]) -> bool {
    (0..3).any(|at| {
        let next = (at + 1) % 3;
        let is_free = ![at, next].iter().any(|&end| others.contains(&corners[end]));
        is_free && of[at] * of[next] <= 0 && of[at] != of[next] && passes(places[at], places[next], other)
    })
}

/// Whether the line through two points goes through a triangle, or touches it.
fn passes(from: DVec3, to: DVec3, [a, b, c]: [DVec3; 3]) -> bool {
    let around = [[a, b], [b, c], [c, a]].map(|[p, q]| side_of([from, to, p], q));
    around.iter().all(|&side| side >= 0) || around.iter().all(|&side| side <= 0)
}

/// On which side of a triangle's plane a point lies: 1, −1, or 0 in it.
fn side_of([a, b, c]: [DVec3; 3], point: DVec3) -> i8 {
    let (u, v, w) = (a - point, b - point, c - point);
    sign(u.dot(v.cross(w)), u.length() * v.length() * w.length())
}

fn sign(determinant: f64, most: f64) -> i8 {
    match determinant.abs() <= IN_A_PLANE * most {
        true => 0,
        false if determinant > 0.0 => 1,
        false => -1,
    }
}

/// Whether triangles in one plane have inner points in common: no side of either has all of the other beyond it.
fn overlap(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    let [across_a, across_b] = [a, b].map(|[p, q, r]| (q - p).cross(r - p));
    let across = if across_a.length_squared() > across_b.length_squared() { across_a } else { across_b };
    let [a, b] = [a, b].map(|places| places.map(|place| without_longest_axis(place, across)));
    !parts(a, b) && !parts(b, a)
}

fn without_longest_axis(place: DVec3, across: DVec3) -> DVec2 {
    let size = across.abs();
    match size.max_element() {
        most if most == size.x => DVec2::new(place.y, place.z),
        most if most == size.y => DVec2::new(place.z, place.x),
        _ => DVec2::new(place.x, place.y),
    }
}

fn parts(figure: [DVec2; 3], other: [DVec2; 3]) -> bool {
    (0..3).any(|at| {
        let [from, to, inner] = [0, 1, 2].map(|step| figure[(at + step) % 3]);
        let side = |point: DVec2| {
            let (along, away) = (to - from, point - from);
            sign(along.perp_dot(away), along.length() * away.length())
        };
        let inside = side(inner);
        other.into_iter().all(|point| side(point) * inside <= 0)
    })
}
