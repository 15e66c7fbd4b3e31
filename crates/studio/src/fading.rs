use glam::DVec3;
use rosto_mesh::Topology;

/// Added to both lengths before edges are compared, in metres: edges between closed lips are almost zero.
const EASE_M: f64 = 0.004;
/// Share of its stretch that a vertex passes to its neighbours in each round.
const PASSED_ON: f64 = 0.85;
const ROUNDS: usize = 6;
/// Logarithm of the length ratio: an edit has its full effect at the first value and below, and none at the second and
/// above.
const FADES: [f64; 2] = [0.6, 1.5];

/// Share of an edit that remains at each vertex, 0..=1, when the edited mesh takes another shape. It is lower where
/// edges become much longer or shorter, such as at lips that part and lids that close, and around there.
///
/// # Panics
/// If the number of positions, in metres, differs from the number of vertices.
pub fn fading(topology: &Topology, edited_m: &[DVec3], seen_m: &[DVec3]) -> Vec<f64> {
    let mut stretch = stretch(topology, edited_m, seen_m);
    for _ in 0..ROUNDS {
        let before = stretch.clone();
        for (vertex, value) in (0..).zip(&mut stretch) {
            let around = topology.neighbours(vertex).iter().map(|&other| PASSED_ON * before[other as usize]);
            *value = around.fold(*value, f64::max);
        }
    }
    stretch.into_iter().map(remaining).collect()
}

/// Largest stretch of the edges at each vertex: absolute logarithm of the length ratio.
fn stretch(topology: &Topology, edited_m: &[DVec3], seen_m: &[DVec3]) -> Vec<f64> {
    let count = topology.vertex_count();
    assert_eq!([edited_m.len(), seen_m.len()], [count; 2], "one position for each vertex");
    let mut stretch = vec![0.0_f64; count];
    for &[a, b] in topology.edges() {
        let length = |positions: &[DVec3]| positions[a as usize].distance(positions[b as usize]) + EASE_M;
        let of_edge = (length(seen_m) / length(edited_m)).ln().abs();
        for end in [a, b] {
            let value = &mut stretch[end as usize];
            *value = value.max(of_edge);
        }
    }
    stretch
}

fn remaining(stretch: f64) -> f64 {
    1.0 - smooth_step((stretch - FADES[0]) / (FADES[1] - FADES[0]))
}

/// Smooth step from 0 to 1 with zero slope at both ends.
pub(crate) fn smooth_step(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
