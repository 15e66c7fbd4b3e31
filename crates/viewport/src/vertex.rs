//! Vertex data for the GPU. A drag needs no upload of it.
//!
//! An edit moves vertex v by `g_v Δ`. The sum of the cross products around the vertex, its unnormalised normal, is then
//! *exactly* `n_v + t_v × Δ`: a triangle's edges become `e + dg Δ`, and `Δ × Δ` vanishes. The field `g` and the
//! derivative `t` are therefore uploaded once per handle, and a tick uploads only the three numbers of Δ. A second,
//! mirrored handle adds the term `c_v Δ_a × Δ_b`.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use rosto_mesh::Topology;

/// Position in metres and unnormalised normal of a vertex.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Default, Pod, Zeroable)]
pub(crate) struct Geometry {
    pub position_m: [f32; 3],
    pub unused: f32,
    pub normal: [f32; 3],
    pub unused_too: f32,
}

/// Distance beyond any influence radius.
const FAR: f64 = 1e3;

/// Weights of a vertex and its normal for two handles, and its distance from them. The default is zero weights, far
/// away.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct InfluenceWeights {
    pub normal_derivative_a: [f32; 3],
    pub field_a: f32,
    pub normal_derivative_b: [f32; 3],
    pub field_b: f32,
    pub cross: f32,
    /// Distance from the handles, as a multiple of the influence radius.
    pub influence_distance: f32,
    pub unused: [f32; 2],
}

impl Default for InfluenceWeights {
    fn default() -> Self {
        Self { influence_distance: FAR as f32, ..Self::zeroed() }
    }
}

/// Colouring of a vertex: texture coordinates, scalar in −1..1, sRGB colour in 0..1.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Default, Pod, Zeroable)]
pub(crate) struct VertexAttributes {
    pub uv: [f32; 2],
    pub scalar: f32,
    pub unused: f32,
    pub colour: [f32; 3],
    pub unused_too: f32,
}

/// Positions and normals of all vertices.
pub(crate) fn geometry(topology: &Topology, positions_m: &[DVec3]) -> Vec<Geometry> {
    let mut normals = vec![DVec3::ZERO; positions_m.len()];
    for corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| positions_m[corner as usize]);
        let normal = (b - a).cross(c - a);
        corners.iter().for_each(|&corner| normals[corner as usize] += normal);
    }
    let shape = |(position, normal): (&DVec3, &DVec3)| Geometry {
        position_m: position.as_vec3().to_array(),
        normal: normal.as_vec3().to_array(),
        ..Geometry::default()
    };
    positions_m.iter().zip(&normals).map(shape).collect()
}

/// Influence weights of all vertices for one or two response fields, with their distances. A missing field is zero;
/// without distances, vertices are far away.
pub(crate) fn influence_weights(
    topology: &Topology,
    positions_m: &[DVec3],
    fields: [Option<&[f64]>; 2],
    influence_distances: Option<&[f64]>,
) -> Vec<InfluenceWeights> {
    let value = |field: Option<&[f64]>, vertex: u32| field.map_or(0.0, |values| values[vertex as usize]);
    let mut turns = vec![([DVec3::ZERO; 2], 0.0); positions_m.len()];
    for corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| positions_m[corner as usize]);
        let steps = fields.map(|field| {
            let [a, b, c] = corners.map(|corner| value(field, corner));
            [b - a, c - a]
        });
        let turn = steps.map(|[to_b, to_c]| (b - a) * to_c - (c - a) * to_b);
        let cross = steps[0][0] * steps[1][1] - steps[1][0] * steps[0][1];
        for &corner in corners {
            let (sum, cross_sum) = &mut turns[corner as usize];
            sum[0] += turn[0];
            sum[1] += turn[1];
            *cross_sum += cross;
        }
    }
    let weights = |(vertex, (turn, cross)): (usize, &([DVec3; 2], f64))| InfluenceWeights {
        normal_derivative_a: turn[0].as_vec3().to_array(),
        field_a: value(fields[0], vertex as u32) as f32,
        normal_derivative_b: turn[1].as_vec3().to_array(),
        field_b: value(fields[1], vertex as u32) as f32,
        cross: *cross as f32,
        influence_distance: influence_distances.map_or(FAR, |distances| distances[vertex]) as f32,
        ..InfluenceWeights::default()
    };
    turns.iter().enumerate().map(weights).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// A bent, asymmetric fan of triangles.
    fn fan() -> (Topology, Vec<DVec3>) {
        let triangles = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [4, 3, 5]];
        let positions = (0..6)
            .map(|i| {
                let turn = f64::from(i) * 1.3;
                DVec3::new(turn.cos() * (1.0 + 0.1 * turn), turn.sin(), 0.3 * turn.sin() - 0.2 * turn)
            })
            .collect();
        (Topology::new(6, triangles).unwrap(), positions)
    }

    #[test]
    fn normals_from_weights_equal_those_of_the_moved_mesh() {
        let (topology, positions) = fan();
        let fields = [[0.9, 0.4, -0.1, 0.3, 0.05, 0.0], [0.0, 0.1, 0.8, 0.25, 0.4, 0.6]];
        let offsets = [DVec3::new(0.4, -0.7, 0.2), DVec3::new(-0.4, -0.5, 0.9)];
        let moved: Vec<DVec3> = (0..positions.len())
            .map(|v| positions[v] + offsets[0] * fields[0][v] + offsets[1] * fields[1][v])
            .collect();
        let before = geometry(&topology, &positions);
        let after = geometry(&topology, &moved);
        let weights = influence_weights(&topology, &positions, [Some(&fields[0]), Some(&fields[1])], None);
        let [a, b] = offsets.map(|offset| offset.as_vec3());
        for v in 0..positions.len() {
            let normal = Vec3::from(before[v].normal)
                + Vec3::from(weights[v].normal_derivative_a).cross(a)
                + Vec3::from(weights[v].normal_derivative_b).cross(b)
                + a.cross(b) * weights[v].cross;
            assert!(normal.distance(after[v].normal.into()) < 2e-6, "vertex {v}: {normal} and {:?}", after[v].normal);
        }
    }

    #[test]
    fn missing_fields_give_zero_weights() {
        let (topology, positions) = fan();
        assert_eq!(influence_weights(&topology, &positions, [None, None], None), vec![InfluenceWeights::default(); 6]);
        let distances = [0.0, 0.5, 1.0, 1.5, 2.0, 3.0];
        let near = influence_weights(&topology, &positions, [None, None], Some(&distances));
        assert!(near.iter().map(|weights| f64::from(weights.influence_distance)).eq(distances));
    }
}
