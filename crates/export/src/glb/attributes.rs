use glam::{DVec3, Vec3};
use rosto_mesh::vertex_normals;
use serde_json::{Map, Value, json};

use super::{Builder, Morph};
use crate::{ExportError, Model, linear_from_srgb};

/// Positions and normals.
pub(super) fn geometry(builder: &mut Builder, model: &Model<'_>) -> Map<String, Value> {
    let positions: Vec<Vec3> = model.positions_m.iter().map(|p| p.as_vec3()).collect();
    let normals: Vec<Vec3> = vertex_normals(model.topology, model.positions_m).into_iter().map(unit).collect();
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), builder.bounded_vectors3(&positions).into());
    attributes.insert("NORMAL".into(), builder.vectors3(&normals).into());
    attributes
}

/// Each vertex's colour in linear light with full alpha.
pub(super) fn linear_colours(model: &Model<'_>) -> Vec<[u16; 4]> {
    let channel = |srgb: u8| (linear_from_srgb(srgb) * f64::from(u16::MAX)).round() as u16;
    model.colours_srgb.iter().map(|&[r, g, b]| [channel(r), channel(g), channel(b), u16::MAX]).collect()
}

/// Adds the morph targets, their names and their weights to the mesh.
pub(super) fn morphs(
    builder: &mut Builder,
    model: &Model<'_>,
    morphs: &[Morph<'_>],
    mesh: &mut Value,
) -> Result<(), ExportError> {
    if morphs.is_empty() {
        return Ok(());
    }
    let mut targets = Vec::new();
    for morph in morphs {
        targets.push(json!({"POSITION": builder.bounded_vectors3(&displacements(model, morph)?)}));
    }
    mesh["primitives"][0]["targets"] = targets.into();
    mesh["weights"] = morphs.iter().map(|morph| morph.weight).collect();
    mesh["extras"] = json!({"targetNames": morphs.iter().map(|morph| morph.name).collect::<Vec<_>>()});
    Ok(())
}

fn displacements(model: &Model<'_>, morph: &Morph<'_>) -> Result<Vec<Vec3>, ExportError> {
    let (expected, found) = (model.topology.vertex_count(), morph.displacements_m.len());
    if expected != found {
        return Err(ExportError::LengthMismatch { what: "morph displacements", expected, found });
    }
    let rounded: Vec<Vec3> = morph.displacements_m.iter().map(|d| d.as_vec3()).collect();
    match rounded.iter().position(|d| !d.is_finite()) {
        Some(vertex) => Err(ExportError::NotFinite { vertex }),
        None => Ok(rounded),
    }
}

/// A vertex between triangles without area has no normal; it then faces the viewer, as the face does.
fn unit(normal: DVec3) -> Vec3 {
    normal.as_vec3().try_normalize().unwrap_or(Vec3::Z)
}
