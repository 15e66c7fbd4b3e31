//! Triangulation of loops.

use glam::DVec3;

/// Triangulates a loop with minimal area. Returns indices into the loop, with its winding.
///
/// Optimal over all triangulations, by dynamic programming over subchains (Barequet & Sharir 1995), in cubic time.
pub(crate) fn least_area(points: &[DVec3]) -> Vec<[usize; 3]> {
    least(points.len(), |corners| {
        let [a, b, c] = corners.map(|corner| points[corner]);
        (b - a).cross(c - a).length()
    })
    .unwrap_or_default()
}

/// Triangulates a planar loop, counter-clockwise as seen from +Z, with the shortest edges. All triangles are
/// counter-clockwise too.
///
/// Returns `None` if the loop intersects itself. The triangles' areas sum up to that of the loop, so they cannot
/// overlap.
pub(crate) fn flat(points: &[DVec3]) -> Option<Vec<[usize; 3]>> {
    least(points.len(), |corners| {
        let [a, b, c] = corners.map(|corner| points[corner].truncate());
        match (b - a).perp_dot(c - a) > 0.0 {
            true => a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a),
            false => f64::INFINITY,
        }
    })
}

/// Triangulation of a loop of `count` vertices with the least total cost; `None` if it is infinite.
fn least(count: usize, cost: impl Fn([usize; 3]) -> f64) -> Option<Vec<[usize; 3]>> {
    if count < 3 {
        return None;
    }
    // Least cost of closing each subchain, and the vertex that attains it.
    let mut chains = vec![(0.0, 0); count * count];
    for length in 2..count {
        for from in 0..count - length {
            let to = from + length;
            let through = |middle: usize| {
                let parts = chains[from * count + middle].0 + chains[middle * count + to].0;
                (parts + if parts < f64::INFINITY { cost([from, middle, to]) } else { 0.0 }, middle)
            };
            let best = (from + 1..to).map(through).min_by(|one, other| one.0.total_cmp(&other.0));
            chains[from * count + to] = best.expect("invariant: a chain has an inner vertex");
        }
    }
    if chains[count - 1].0 == f64::INFINITY {
        return None;
    }
    let (mut triangles, mut open) = (Vec::with_capacity(count - 2), vec![[0, count - 1]]);
    while let Some([from, to]) = open.pop() {
        if to - from > 1 {
            let middle = chains[from * count + to].1;
            triangles.push([from, middle, to]);
            open.extend([[from, middle], [middle, to]]);
        }
    }
    Some(triangles)
}
