//! Loops filled with triangles.

use glam::DVec3;

/// Fills a loop with as little area as triangles between its own vertices can have: places of the loop, wound as the loop is.
///
/// The optimum over all triangulations, by dynamic programming over the stretches of the loop (Barequet & Sharir 1995).
/// Cubic in the length of the loop.
pub(crate) fn least_area(places: &[DVec3]) -> Vec<[usize; 3]> {
    least(places.len(), |corners| {
        let [a, b, c] = corners.map(|corner| places[corner]);
        (b - a).cross(c - a).length()
    })
    .unwrap_or_default()
}

/// Fills a loop in the plane, which runs counter-clockwise as seen from +Z and does not meet itself, with triangles that
/// all do: those with the shortest sides. None if it does meet itself.
///
/// What the triangles cover adds up to what the loop encloses, so that none can lie over another.
pub(crate) fn flat(places: &[DVec3]) -> Option<Vec<[usize; 3]>> {
    least(places.len(), |corners| {
        let [a, b, c] = corners.map(|corner| places[corner].truncate());
        match (b - a).perp_dot(c - a) > 0.0 {
            true => a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a),
            false => f64::INFINITY,
        }
    })
}

/// The triangulation of a loop of so many places with the least sum of costs; none if all of them cost infinitely much.
fn least(count: usize, cost: impl Fn([usize; 3]) -> f64) -> Option<Vec<[usize; 3]>> {
    if count < 3 {
        return None;
    }
    // For each stretch from one place to another the least cost of closing it, and the corner that does so.
    let mut stretches = vec![(0.0, 0); count * count];
    for length in 2..count {
        for from in 0..count - length {
            let to = from + length;
            let through = |middle: usize| {
                let parts = stretches[from * count + middle].0 + stretches[middle * count + to].0;
                (parts + if parts < f64::INFINITY { cost([from, middle, to]) } else { 0.0 }, middle)
            };
            let best = (from + 1..to).map(through).min_by(|one, other| one.0.total_cmp(&other.0));
            stretches[from * count + to] = best.expect("invariant: a stretch has a place in the middle");
        }
    }
    if stretches[count - 1].0 == f64::INFINITY {
        return None;
    }
    let (mut triangles, mut open) = (Vec::with_capacity(count - 2), vec![[0, count - 1]]);
    while let Some([from, to]) = open.pop() {
        if to - from > 1 {
            let middle = stretches[from * count + to].1;
            triangles.push([from, middle, to]);
            open.extend([[from, middle], [middle, to]]);
        }
    }
    Some(triangles)
}
