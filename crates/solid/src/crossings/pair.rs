//! Intersection test of two triangles.

use glam::{DVec2, DVec3};

/// Relative size of a determinant below which its sign counts as rounding. Positions come from solves, whose rounding is
/// that of the whole face, and the smallest edges are a thousandth of it.
const ROUNDING: f64 = 1e-9;

/// Whether two triangles with at most two shared corners have a common point outside shared corners and edges.
/// Touching counts.
///
/// Tests each edge of one triangle against the other; coplanar triangles by separating axes.
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

/// Whether the point of an edge that is nearest to a triangle's plane is in the triangle or on its border. This is decided
/// in the plane, because volumes of an edge nearly parallel to it are rounding.
fn passes(from: DVec3, to: DVec3, other: [DVec3; 3]) -> bool {
    let across = across(other);
    let [low, high] = [from, to].map(|point| across.dot(point - other[0]));
    let share = if low == high { 0.0 } else { (low / (low - high)).clamp(0.0, 1.0) };
    let point = without_longest_axis(from.lerp(to, share), across);
    let figure = other.map(|point| without_longest_axis(point, across));
    edges(figure).all(|edge| edge.side_of(point) * edge.inside >= 0)
}

/// Side of a triangle's plane on which a point lies: 1, −1, or 0 if coplanar.
fn side_of([a, b, c]: [DVec3; 3], point: DVec3) -> i8 {
    let (u, v, w) = (a - point, b - point, c - point);
    sign(u.dot(v.cross(w)), u.length() * v.length() * w.length())
}

fn sign(determinant: f64, most: f64) -> i8 {
    match determinant.abs() <= ROUNDING * most {
        true => 0,
        false if determinant > 0.0 => 1,
        false => -1,
    }
}

/// Normal of a triangle, as long as twice its area.
fn across([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// Whether coplanar triangles overlap: no edge of either separates them.
fn overlap(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    let [across_a, across_b] = [a, b].map(across);
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
    edges(figure).any(|edge| other.into_iter().all(|point| edge.side_of(point) * edge.inside <= 0))
}

/// Edge of a triangle in the plane, and the side on which the triangle lies.
struct Edge {
    from: DVec2,
    to: DVec2,
    inside: i8,
}

impl Edge {
    /// Side on which a point lies: 1, −1, or 0 if collinear.
    fn side_of(&self, point: DVec2) -> i8 {
        let (along, away) = (self.to - self.from, point - self.from);
        sign(along.perp_dot(away), along.length() * away.length())
    }
}

fn edges(figure: [DVec2; 3]) -> impl Iterator<Item = Edge> {
    (0..3).map(move |at| {
        let [from, to, inner] = [0, 1, 2].map(|step| figure[(at + step) % 3]);
        let edge = Edge { from, to, inside: 0 };
        Edge { inside: edge.side_of(inner), ..edge }
    })
}
