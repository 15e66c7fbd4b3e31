//! Edge weights for operators of the form `diag(W·1) − W`, one per entry of [`Topology::edges`].

use glam::DVec3;
use rosto_mesh::Topology;

/// Bound on the ratio of the mean length to a length, and on its inverse.
const MAX_LENGTH_RATIO: f64 = 20.0;

/// Lower bound on a vertex's mass, as a share of the mean mass.
const MIN_MASS: f64 = 0.01;

/// Area over squared longest side below which a triangle counts as degenerate.
const MIN_SHAPE: f64 = 0.01;

pub(crate) fn uniform(topology: &Topology) -> Vec<f64> {
    vec![1.0; topology.edges().len()]
}

pub(crate) fn by_degree(topology: &Topology) -> Vec<f64> {
    let ends = |&[a, b]: &[u32; 2]| (topology.degree(a) + topology.degree(b)) as f64;
    let sums: Vec<f64> = topology.edges().iter().map(ends).collect();
    let used = (0..topology.vertex_count() as u32).filter(|&vertex| topology.degree(vertex) > 0).count();
    let mean_degree = 2.0 * sums.len() as f64 / used as f64;
    sums.into_iter().map(|sum| sum / (2.0 * mean_degree)).collect()
}

pub(crate) fn by_inverse_length(topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
    let scale = unit_scale(positions);
    let length = |&[a, b]: &[u32; 2]| (positions[a as usize] * scale).distance(positions[b as usize] * scale);
    let lengths: Vec<f64> = topology.edges().iter().map(length).collect();
    let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
    let weight = |length: f64| (mean / length).clamp(1.0 / MAX_LENGTH_RATIO, MAX_LENGTH_RATIO);
    lengths.into_iter().map(|length| if mean > 0.0 { weight(length) } else { 1.0 }).collect()
}

/// The degree of each vertex; 1 for isolated vertices.
pub(crate) fn degrees(topology: &Topology) -> Vec<f64> {
    (0..topology.vertex_count() as u32).map(|vertex| topology.degree(vertex).max(1) as f64).collect()
}

/// `√mᵢ` for masses `m` divided by their mean, with the mass clamped from below to [`MIN_MASS`].
pub(crate) fn root_masses(topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
    let scale = unit_scale(positions);
    let positions: Vec<DVec3> = positions.iter().map(|&position| position * scale).collect();
    let masses = barycentric_areas(topology, &positions);
    let mean = mean(&masses);
    let root = |mass: f64| (mass / mean).max(MIN_MASS).sqrt();
    masses.into_iter().map(|mass| if mean > 0.0 { root(mass) } else { 1.0 }).collect()
}

/// The mean of [`barycentric_areas`], in the squared unit of the positions.
pub(crate) fn mean_mass(topology: &Topology, positions: &[DVec3]) -> f64 {
    mean(&barycentric_areas(topology, positions))
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// For each vertex, a third of the area of its triangles.
pub(crate) fn barycentric_areas(topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
    let mut areas = vec![0.0; topology.vertex_count()];
    for &corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| positions[corner as usize]);
        let area = 0.5 * (b - a).cross(c - a).length();
        corners.iter().for_each(|&corner| areas[corner as usize] += area / 3.0);
    }
    areas
}

/// Sums over the triangles of an edge `½ cot` of the opposite angle, computed as `e·f / 4A` from the sides `e`, `f` at
/// that corner.
///
/// If a triangle's area `A` is below `A' = MIN_SHAPE · longest²`, its share is
/// `(A/A')·cotangent-with-A' + (1 − A/A')·uniform`: continuous, and positive semi-definite for every shape.
pub(crate) fn cotangent(topology: &Topology, positions: &[DVec3]) -> Vec<f64> {
    summed(topology, &cotangent_shares(topology, positions))
}

/// [`cotangent`], with each triangle's share multiplied by the mean of its corners' factors. Positive semi-definite for
/// non-negative factors.
pub(crate) fn scaled_cotangent(topology: &Topology, positions: &[DVec3], factors: &[f64]) -> Vec<f64> {
    let mut shares = cotangent_shares(topology, positions);
    for (shares, corners) in shares.iter_mut().zip(topology.triangles()) {
        let mean = corners.iter().map(|&corner| factors[corner as usize]).sum::<f64>() / 3.0;
        shares.iter_mut().for_each(|share| *share *= mean);
    }
    summed(topology, &shares)
}

/// The weight of each edge, from the triangles' shares.
fn summed(topology: &Topology, shares: &[[f64; 3]]) -> Vec<f64> {
    let mut weights = vec![0.0; topology.edges().len()];
    for (edges, shares) in triangle_edges(topology).zip(shares) {
        edges.into_iter().zip(shares).for_each(|(edge, share)| weights[edge] += share);
    }
    weights
}

/// For each triangle, its contribution to the weight of the side opposite each corner.
pub(crate) fn cotangent_shares(topology: &Topology, positions: &[DVec3]) -> Vec<[f64; 3]> {
    let scale = unit_scale(positions);
    let shares = |&corners: &[u32; 3]| triangle_shares(corners.map(|corner| positions[corner as usize] * scale));
    topology.triangles().iter().map(shares).collect()
}

/// Splits each edge's weight equally among its triangles, in the layout of [`cotangent_shares`].
pub(crate) fn equal_shares(topology: &Topology, weights: &[f64]) -> Vec<[f64; 3]> {
    let mut uses = vec![0.0; weights.len()];
    triangle_edges(topology).flatten().for_each(|edge| uses[edge] += 1.0);
    triangle_edges(topology).map(|edges| edges.map(|edge| weights[edge] / uses[edge])).collect()
}

/// For each triangle, the edges opposite its corners as indices into [`Topology::edges`].
fn triangle_edges(topology: &Topology) -> impl Iterator<Item = [usize; 3]> {
    topology.triangles().iter().map(|&[a, b, c]| {
        let edge = |from, to| topology.edge(from, to).expect("invariant: a triangle's sides are edges");
        [edge(b, c), edge(c, a), edge(a, b)]
    })
}

fn triangle_shares(corners: [DVec3; 3]) -> [f64; 3] {
    let sides = [0, 1, 2].map(|k| corners[(k + 2) % 3] - corners[(k + 1) % 3]);
    let longest = sides.iter().map(|side| side.length_squared()).fold(0.0, f64::max);
    if longest == 0.0 {
        return [0.5; 3];
    }
    let sides = sides.map(|side| side / longest.sqrt());
    let area = 0.5 * sides[0].cross(sides[1]).length();
    let trust = (area / MIN_SHAPE).min(1.0);
    let cotangent = |k: usize| -sides[(k + 1) % 3].dot(sides[(k + 2) % 3]) / (2.0 * area.max(MIN_SHAPE));
    [0, 1, 2].map(|k| 0.5 * (trust * cotangent(k) + (1.0 - trust)))
}

/// A factor that scales positions to about unit size, to avoid overflow and underflow of squares.
pub(crate) fn unit_scale(positions: &[DVec3]) -> f64 {
    let greatest = positions.iter().map(|position| position.abs().max_element()).fold(0.0, f64::max);
    let scale = greatest.recip();
    if scale.is_finite() { scale } else { 1.0 }
}
