use glam::{DVec3, Vec3};
use rosto_mesh::vertex_normals;
use serde_json::{Map, Value, json};

use super::{Builder, Material, Morph};
use crate::{ExportError, Model, linear_from_srgb};

/// Adds positions and normals.
pub(super) fn geometry(builder: &mut Builder, model: &Model<'_>) -> Map<String, Value> {
    let positions: Vec<Vec3> = model.positions_m.iter().map(|p| p.as_vec3()).collect();
    let normals: Vec<Vec3> = vertex_normals(model.topology, model.positions_m).into_iter().map(unit).collect();
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), builder.bounded_vectors3(&positions).into());
    attributes.insert("NORMAL".into(), builder.vectors3(&normals).into());
    attributes
}

/// RGBA colours of the vertices: linear, opaque, 16 bits per channel.
pub(super) fn linear_colours(model: &Model<'_>) -> Vec<[u16; 4]> {
    let channel = |srgb: u8| (linear_from_srgb(srgb) * f64::from(u16::MAX)).round() as u16;
    model.colours_srgb.iter().map(|&[r, g, b]| [channel(r), channel(g), channel(b), u16::MAX]).collect()
}

/// Adds the morph targets to the mesh, with their names and weights.
pub(super) fn morphs(
    builder: &mut Builder,
    model: &Model<'_>,
    morphs: &[Morph<'_>],
    material: Material,
    mesh: &mut Value,
) -> Result<(), ExportError> {
    if morphs.is_empty() {
        return Ok(());
    }
    let mut targets = Vec::new();
    for morph in morphs {
        let mut target = json!({"POSITION": builder.displacements3(&displacements(model, morph)?)});
        if material == Material::Lit {
            target["NORMAL"] = builder.displacements3(&normal_changes(model, morph)).into();
        }
        targets.push(target);
    }
    mesh["primitives"][0]["targets"] = targets.into();
    mesh["weights"] = morphs.iter().map(|morph| morph.weight).collect();
    mesh["extras"] = json!({"targetNames": morphs.iter().map(|morph| morph.name).collect::<Vec<_>>()});
    Ok(())
}

/// Displacements are rounded to this step. Smaller digits are rounding errors that differ between machines, and the
/// same face should give the same file.
const FINEST_M: f64 = 1e-9;

fn displacements(model: &Model<'_>, morph: &Morph<'_>) -> Result<Vec<Vec3>, ExportError> {
    let (expected, found) = (model.topology.vertex_count(), morph.displacements_m.len());
    if expected != found {
        return Err(ExportError::LengthMismatch { what: "morph displacements", expected, found });
    }
    // Adding zero turns −0 into +0.
    let rounded = |d: &DVec3| ((*d / FINEST_M).round() * FINEST_M + DVec3::ZERO).as_vec3();
    let rounded: Vec<Vec3> = morph.displacements_m.iter().map(rounded).collect();
    match rounded.iter().position(|d| !d.is_finite()) {
        Some(vertex) => Err(ExportError::NotFinite { vertex }),
        None => Ok(rounded),
    }
}

/// Change of each normal at weight 1; invisible changes are set to zero.
fn normal_changes(model: &Model<'_>, morph: &Morph<'_>) -> Vec<Vec3> {
    const LEAST: f32 = 2e-3;
    let moved: Vec<DVec3> = model
        .positions_m
        .iter()
        .zip(morph.displacements_m)
        .map(|(position, displacement)| *position + *displacement)
        .collect();
    let normals = |positions_m| vertex_normals(model.topology, positions_m).into_iter().map(unit);
    let changes = normals(&moved).zip(normals(model.positions_m)).map(|(after, before)| after - before);
    changes.map(|change| if change.abs().max_element() < LEAST { Vec3::ZERO } else { change }).collect()
}

/// Normalises a normal. A vertex of degenerate triangles has none and gets +Z, the direction that the face looks in.
fn unit(normal: DVec3) -> Vec3 {
    normal.as_vec3().try_normalize().unwrap_or(Vec3::Z)
}
