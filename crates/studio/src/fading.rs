use glam::DVec3;
use rosto_mesh::Topology;

/// Edges are compared as if both were longer by this, in metres: between closed lips they have next to no length.
const EASE_M: f64 = 0.004;
/// A vertex hands so much of its stretch on to its neighbours, so many times.
const HANDED_ON: f64 = 0.85;
const ROUNDS: usize = 6;
/// Stretched by this and less (logarithm of the ratio of lengths) an edit has its full effect, by this and more none.
const FADES: [f64; 2] = [0.6, 1.5];

/// How much of an edit is left at each vertex, 0..=1, when the mesh that it was made on is seen in another shape: less where edges
/// are much longer or shorter, as lips that part and lids that close, and around there.
///
/// # Panics
/// If there are not as many positions, in metres, as the topology has vertices.
pub fn fading(topology: &Topology, edited_m: &[DVec3], seen_m: &[DVec3]) -> Vec<f64> {
    let mut stretch = stretch(topology, edited_m, seen_m);
    for _ in 0..ROUNDS {
        let before = stretch.clone();
        for (vertex, own) in (0..).zip(&mut stretch) {
            let around = topology.neighbours(vertex).iter().map(|&other| HANDED_ON * before[other as usize]);
            *own = around.fold(*own, f64::max);
        }
    }
    stretch.into_iter().map(left_of).collect()
}

/// The largest of the edges around each vertex, as the logarithm's absolute value.
fn stretch(topology: &Topology, edited_m: &[DVec3], seen_m: &[DVec3]) -> Vec<f64> {
    let count = topology.vertex_count();
    assert_eq!([edited_m.len(), seen_m.len()], [count; 2], "one position for each vertex");
    let mut stretch = vec![0.0_f64; count];
    for &[a, b] in topology.edges() {
        let length = |positions: &[DVec3]| positions[a as usize].distance(positions[b as usize]) + EASE_M;
        let of_edge = (length(seen_m) / length(edited_m)).ln().abs();
        for end in [a, b] {
            let own = &mut stretch[end as usize];
            *own = own.max(of_edge);
        }
    }
    stretch
}

fn left_of(stretch: f64) -> f64 {
    1.0 - smooth_step((stretch - FADES[0]) / (FADES[1] - FADES[0]))
}

/// From 0 to 1 without a kink at either end.
pub(crate) fn smooth_step(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
