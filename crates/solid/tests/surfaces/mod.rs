//! Test surfaces.

use glam::DVec3;
use rosto_face::{Triangulation, canonical_positions_m};
use rosto_mesh::Topology;

pub fn face(triangulation: Triangulation) -> (Topology, Vec<DVec3>) {
    (triangulation.topology(), canonical_positions_m())
}

/// A rectangle of 1 cm squares in the plane z = 0, each split along a diagonal, facing +Z.
pub fn plane(columns: u32, rows: u32) -> (Topology, Vec<DVec3>) {
    let name = |column: u32, row: u32| row * (columns + 1) + column;
    let positions =
        (0..=rows).flat_map(|row| (0..=columns).map(move |column| DVec3::new(column.into(), row.into(), 0.0) * 0.01));
    let cut = |(column, row): (u32, u32)| {
        let [a, b, c, d] = [name(column, row), name(column + 1, row), name(column + 1, row + 1), name(column, row + 1)];
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).flat_map(cut).collect();
    let positions: Vec<DVec3> = positions.collect();
    (Topology::new(positions.len(), triangles).unwrap(), positions)
}

/// The canonical face and distorted versions of it.
pub fn faces() -> Vec<(&'static str, Topology, Vec<DVec3>)> {
    let (topology, rest) = face(Triangulation::Canonical);
    let bent = |bend: fn(DVec3) -> DVec3| rest.iter().map(|position| bend(*position)).collect::<Vec<_>>();
    let pulled = |middle: usize, displacement: DVec3, radius_m: f64| {
        let near = |position: &DVec3| (1.0 - position.distance(rest[middle]) / radius_m).max(0.0).powi(2);
        rest.iter().map(|position| *position + displacement * near(position)).collect::<Vec<_>>()
    };
    [
        ("as it is", rest.clone()),
        ("narrow and deep", bent(|p| DVec3::new(p.x * 0.6, p.y, p.z * 1.8))),
        ("flat and wide", bent(|p| DVec3::new(p.x * 1.3, p.y * 0.9, p.z * 0.4))),
        ("sheared", bent(|p| DVec3::new(p.x + 0.3 * p.y, p.y, p.z + 0.2 * p.x))),
        ("lopsided", bent(|p| if p.x > 0.0 { DVec3::new(p.x * 1.6, p.y + p.x * 0.4, p.z) } else { p })),
        ("with a long nose", pulled(4, DVec3::new(0.0, 0.0, 0.04), 0.04)),
        ("with a hooked nose", pulled(4, DVec3::new(0.01, -0.025, 0.03), 0.05)),
        ("with a long chin", pulled(152, DVec3::new(0.0, -0.04, 0.02), 0.06)),
        ("with a swollen cheek", pulled(280, DVec3::new(0.03, 0.0, 0.01), 0.07)),
        ("with pursed lips", pulled(13, DVec3::new(0.0, 0.0, 0.03), 0.035)),
    ]
    .map(|(name, positions)| (name, topology.clone(), positions))
    .into()
}
