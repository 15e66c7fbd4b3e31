//! Pulls one vertex of a mesh in an OBJ file; the nearer half of the surface follows.
//!
//! ```sh
//! cargo run --release --package rosto-laplacian --example edit_obj -- IN.obj OUT.obj VERTEX DX DY DZ
//! ```
//!
//! `VERTEX` counts from 1, as in OBJ. `DX DY DZ` is the displacement in the file's unit. Vertices farther along the
//! surface than half the greatest distance stay. Only the lines of moved vertices change.

use std::{error::Error, fs};

use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Constraints, Geodesics, LaplacianSystem, Operator};
use rosto_mesh::Topology;
use wavefront_obj::obj::{Primitive, Shape, parse};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [from, to, vertex, x, y, z] = &arguments[..] else {
        return Err("usage: edit_obj IN.obj OUT.obj VERTEX DX DY DZ".into());
    };
    let offset = DVec3::new(x.parse()?, y.parse()?, z.parse()?);
    Ok(fs::write(to, edited(&fs::read_to_string(from)?, vertex.parse()?, offset)?)?)
}

/// Returns the text of the edited OBJ file.
pub fn edited(obj: &str, vertex: u32, offset: DVec3) -> Result<String, Box<dyn Error>> {
    let (topology, rest) = read(obj)?;
    let handle = vertex.checked_sub(1).filter(|&index| (index as usize) < rest.len());
    let handle =
        handle.ok_or_else(|| format!("vertex {vertex} does not exist: the file has vertices 1 to {}", rest.len()))?;

    let distances = Geodesics::new(&topology, &rest)?.distances(&[handle])?;
    let radius = distances.iter().copied().filter(|distance| distance.is_finite()).fold(0.0, f64::max) / 2.0;
    let stays = |&vertex: &u32| distances[vertex as usize] > radius;
    let anchors: Vec<u32> = (0..rest.len() as u32).filter(stays).collect();

    let system = LaplacianSystem::new(&topology, &rest, Operator::Cotangent)?;
    let constraints = Constraints { handles: &[handle], anchors: &anchors, kind: ConstraintKind::Hard, falloff: None };
    let mut moved = rest.clone();
    system.respond(&constraints)?.displace(&rest, &[offset], &mut moved);
    Ok(with_positions(obj, &rest, &moved))
}

/// Reads triangles and positions; faces with more than three corners are split into triangles.
fn read(obj: &str) -> Result<(Topology, Vec<DVec3>), Box<dyn Error>> {
    let file = parse(obj)?;
    let [object] = &file.objects[..] else {
        return Err(format!("the file must contain one object; it contains {}", file.objects.len()).into());
    };
    let corners = |shape: &Shape| match shape.primitive {
        Primitive::Triangle(a, b, c) => Some([a.0, b.0, c.0].map(|index| index as u32)),
        _ => None,
    };
    let triangles = object.geometry.iter().flat_map(|part| &part.shapes).filter_map(corners).collect();
    let positions: Vec<DVec3> = object.vertices.iter().map(|vertex| DVec3::new(vertex.x, vertex.y, vertex.z)).collect();
    Ok((Topology::new(positions.len(), triangles)?, positions))
}

fn with_positions(obj: &str, rest: &[DVec3], moved: &[DVec3]) -> String {
    let mut positions = rest.iter().zip(moved);
    let line = |line: &str| match line.trim_start().starts_with("v ").then(|| positions.next()).flatten() {
        Some((before, after)) if before != after => format!("v {} {} {}\n", after.x, after.y, after.z),
        _ => format!("{line}\n"),
    };
    obj.lines().map(line).collect()
}
