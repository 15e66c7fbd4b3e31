//! Pulls the middle of a wavy sheet upwards with its border fixed, and writes the result as OBJ:
//!
//! ```sh
//! cargo run --release --package rosto-laplacian --example pull > sheet.obj
//! ```
//!
//! The same code edits any triangle mesh.

use std::error::Error;

use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Constraints, LaplacianSystem, Operator};
use rosto_mesh::Topology;

/// Vertices along each side.
const SIDE: u32 = 41;

fn main() -> Result<(), Box<dyn Error>> {
    let (topology, rest) = sheet()?;
    let border = topology.boundary_loops().concat();
    let middle = SIDE * SIDE / 2;

    // The system is built once per mesh, the response once per choice of handles and anchors.
    let system = LaplacianSystem::new(&topology, &rest, Operator::Cotangent)?;
    let response = system.respond(&Constraints {
        handles: &[middle],
        anchors: &border,
        kind: ConstraintKind::Hard,
        falloff: None,
    })?;
    let mut edited = rest.clone();
    response.displace(&rest, &[DVec3::new(0.0, 0.0, 8.0)], &mut edited);

    for DVec3 { x, y, z } in &edited {
        println!("v {x} {y} {z}");
    }
    for corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| corner + 1);
        println!("f {a} {b} {c}");
    }
    let height = |positions: &[DVec3]| positions[middle as usize].z;
    eprintln!("{} vertices; the middle rose from {:.2} to {:.2}", rest.len(), height(&rest), height(&edited));
    Ok(())
}

/// A square grid of waves, with two triangles per cell.
fn sheet() -> Result<(Topology, Vec<DVec3>), Box<dyn Error>> {
    let position = |index: u32| {
        let (x, y) = (f64::from(index % SIDE), f64::from(index / SIDE));
        DVec3::new(x, y, 0.4 * (0.9 * x).sin() * (0.7 * y).cos())
    };
    let cells = (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| y * SIDE + x));
    let triangles = cells.flat_map(|a| [[a, a + 1, a + SIDE + 1], [a, a + SIDE + 1, a + SIDE]]).collect();
    Ok((Topology::new((SIDE * SIDE) as usize, triangles)?, (0..SIDE * SIDE).map(position).collect()))
}
