use std::path::Path;

use glam::{DVec2, DVec3};
use rosto_export::{GlbOptions, JsonMesh, Model, Morph, Source, glb, gltf, mesh_json, obj, ply, stl};
use rosto_face::FaceModel;
use rosto_studio::{Document, Entry, project};

use crate::args::{BaseColour, MeshTask, Units};
use crate::error::CliError;
use crate::model_history::model_history;
use crate::terminal;

pub const MM_PER_M: f64 = 1000.0;

/// The kinds of file that a mesh is written to.
#[derive(Debug, Clone, Copy)]
pub enum Format {
    Glb,
    Gltf,
    Obj,
    Ply,
    Stl,
    Json,
}

impl Format {
    /// By the ending of the file's name, in capitals or not.
    pub fn of(path: &Path) -> Result<Self, CliError> {
        let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
        match extension.as_deref() {
            Some("glb") => Ok(Self::Glb),
            Some("gltf") => Ok(Self::Gltf),
            Some("obj") => Ok(Self::Obj),
            Some("ply") => Ok(Self::Ply),
            Some("stl") => Ok(Self::Stl),
            Some("json") => Ok(Self::Json),
            _ => Err(CliError::UnknownFormat { path: path.to_owned() }),
        }
    }
}

/// The bytes of the edited face's file.
pub fn encode(face: &FaceModel, document: &mut Document, task: &MeshTask, format: Format) -> Result<Vec<u8>, CliError> {
    let positions_m = match task.edits.units {
        Units::Image => model_from_image(face, document.positions()),
        Units::Mm => document.positions().to_vec(),
    };
    let layers = if task.morph_targets { document.displacements() } else { Vec::new() };
    let document = &*document;
    let uvs: Vec<DVec2> = document.from_cage(face.uvs());
    let colours_srgb = if task.density == 0 { face.colours_srgb().to_vec() } else { face.colours_under(&uvs) };
    let model = Model {
        topology: document.topology(),
        positions_m: &positions_m,
        colours_srgb: &colours_srgb,
        uvs: &uvs,
        picture: face.picture(),
    };
    Ok(match format {
        Format::Glb => gltf_as(face, &model, document, &layers, task, glb)?,
        Format::Gltf => gltf_as(face, &model, document, &layers, task, gltf)?.into_bytes(),
        Format::Obj => obj(&model)?.into_bytes(),
        Format::Ply => ply(&model)?,
        Format::Stl => stl(&model)?,
        Format::Json => json(document, &colours_srgb, task.edits.units).into_bytes(),
    })
}

/// Writes glTF, binary or text, with what opens it again in its extras and, if asked for, the edits as morph targets.
fn gltf_as<T>(
    face: &FaceModel,
    model: &Model<'_>,
    document: &Document,
    layers: &[Vec<DVec3>],
    task: &MeshTask,
    write: impl Fn(&Model<'_>, &GlbOptions<'_>) -> Result<T, rosto_export::ExportError>,
) -> Result<T, CliError> {
    let entries = document.history().entries();
    let in_metres = task.edits.units == Units::Mm;
    let in_model = if in_metres { entries.to_vec() } else { carried_over(face, document)? };
    let history = (!in_model.is_empty()).then(|| project::to_json(&in_model));
    let triangulation = face.triangulation();
    let source = Some(Source { face, triangulation, density: task.density, history: history.as_deref() });
    let named = entries.iter().zip(layers);
    let morphs: Vec<Morph<'_>> =
        named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
    let base_colour = match task.paint {
        BaseColour::Texture => rosto_export::BaseColour::Texture,
        BaseColour::Colors => rosto_export::BaseColour::VertexColours,
    };
    let options = GlbOptions { base_colour, morphs: &morphs, source, ..GlbOptions::default() };
    let model = if morphs.is_empty() { *model } else { model.at(document.rest()) };
    Ok(write(&model, &options)?)
}

/// The history for the file, with a word on what it lacks.
fn carried_over(face: &FaceModel, document: &Document) -> Result<Vec<Entry>, CliError> {
    let history = model_history(face, document)?;
    for label in &history.left_out {
        terminal::note(&format!(
            "the file shows {label:?}, but opens again without it: an edit of a denser mesh with such settings needs --units mm"
        ));
    }
    Ok(history.entries)
}

fn json(document: &Document, colours_srgb: &[[u8; 3]], units: Units) -> String {
    let (units, scale) = match units {
        Units::Image => ("image", 1.0),
        Units::Mm => ("mm", MM_PER_M),
    };
    let positions: Vec<DVec3> = document.positions().iter().map(|&position| position * scale).collect();
    mesh_json(&JsonMesh { units, positions: &positions, colours_srgb, triangles: document.topology().triangles() })
}

/// Positions in image coordinates, in metres of the model.
pub fn model_from_image(face: &FaceModel, positions: &[DVec3]) -> Vec<DVec3> {
    let model_from_image = face.image_from_model().inverse();
    positions.iter().map(|&position| model_from_image.transform_point3(position)).collect()
}
