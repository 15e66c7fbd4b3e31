//! Intersection test of two triangles.

use glam::{DVec2, DVec3};

/// Relative size of a determinant below which rounding decides its sign, so the points count as coplanar.
const COPLANAR: f64 = 1e-13;

/// Whether two triangles with at most two shared corners have a common point outside shared corners and edges.
/// Touching counts.
///
/// Tests each edge of one triangle against the other (by the signs of volumes); coplanar triangles by separating axes.
pub(super) fn intersect(positions: &[DVec3], one: [u32; 3], other: [u32; 3]) -> bool {
    let points = |corners: [u32; 3]| corners.map(|corner| positions[corner as usize]);
    let (a, b) = (points(one), points(other));
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

/// Whether a triangle lies strictly on one side of a plane, given the sides of its corners.
fn is_beyond(sides: [i8; 3]) -> bool {
    sides == [1; 3] || sides == [-1; 3]
}

/// Whether an edge of a triangle without a corner shared with `other` passes through `other`; `sides` are those of the
/// corners.
fn pierces(points: [DVec3; 3], corners: [u32; 3], sides: [i8; 3], other: [DVec3; 3], others: [u32; 3]) -> bool {
    (0..3).any(|at| {
        let next = (at + 1) % 3;
        let is_free = ![at, next].iter().any(|&end| others.contains(&corners[end]));
        is_free && sides[at] * sides[next] <= 0 && sides[at] != sides[next] && passes(points[at], points[next], other)
    })
}

/// Whether the line through two points intersects or touches a triangle.
fn passes(from: DVec3, to: DVec3, [a, b, c]: [DVec3; 3]) -> bool {
    let around = [[a, b], [b, c], [c, a]].map(|[p, q]| side_of([from, to, p], q));
    around.iter().all(|&side| side >= 0) || around.iter().all(|&side| side <= 0)
}

/// Side of a triangle's plane on which a point lies: 1, −1, or 0 if coplanar.
fn side_of([a, b, c]: [DVec3; 3], point: DVec3) -> i8 {
    let (u, v, w) = (a - point, b - point, c - point);
    sign(u.dot(v.cross(w)), u.length() * v.length() * w.length())
}

fn sign(determinant: f64, most: f64) -> i8 {
    match determinant.abs() <= COPLANAR * most {
        true => 0,
        false if determinant > 0.0 => 1,
        false => -1,
    }
}

/// Whether coplanar triangles overlap: no edge of either separates them.
fn overlap(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    let [across_a, across_b] = [a, b].map(|[p, q, r]| (q - p).cross(r - p));
    let across = if across_a.length_squared() > across_b.length_squared() { across_a } else { across_b };
    let [a, b] = [a, b].map(|points| points.map(|point| without_longest_axis(point, across)));
    !separates(a, b) && !separates(b, a)
}

fn without_longest_axis(point: DVec3, across: DVec3) -> DVec2 {
    let size = across.abs();
    match size.max_element() {
        most if most == size.x => DVec2::new(point.y, point.z),
        most if most == size.y => DVec2::new(point.z, point.x),
        _ => DVec2::new(point.x, point.y),
    }
}

fn separates(figure: [DVec2; 3], other: [DVec2; 3]) -> bool {
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
