use std::path::Path;

use glam::{DVec2, DVec3};
use rosto_export::{Choosable, Content, Format, GlbOptions, Model, Morph, Source};
use rosto_face::FaceModel;
use rosto_studio::{Document, Entry, Rest, StudioError, project};

use crate::args::MeshTask;
use crate::error::CliError;
use crate::model_history::model_history;
use crate::terminal;
use crate::units::Units;

/// The format that a file's name asks for by its ending, in capitals or not.
pub fn format_of(path: &Path) -> Result<Format, CliError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let format = extension.as_deref().and_then(Format::from_id);
    format.ok_or_else(|| CliError::UnknownFormat { path: path.to_owned() })
}

/// The bytes of the edited face's file; a glTF with what opens it again in its extras and, if asked for, the edits as morph
/// targets.
pub fn encode(face: &FaceModel, document: &mut Document, task: &MeshTask, format: Format) -> Result<Vec<u8>, CliError> {
    let units = task.edits.units;
    let positions_m = match units {
        Units::Image => model_from_image(face, document)?,
        Units::Mm => document.positions().to_vec(),
    };
    let layers = if task.morph_targets { document.displacements() } else { Vec::new() };
    let document = &*document;
    let uvs: Vec<DVec2> = document.from_cage(face.uvs());
    let colours_srgb = if task.mesh.density == 0 { face.colours_srgb().to_vec() } else { face.colours_under(&uvs) };
    let model = Model {
        topology: document.topology(),
        positions_m: &positions_m,
        colours_srgb: &colours_srgb,
        uvs: &uvs,
        picture: face.picture(),
    };
    let entries = document.history().entries();
    let history = match format.choosable() {
        Choosable::Material => history_json(face, document, units)?,
        Choosable::Nothing | Choosable::Unit => None,
    };
    let triangulation = face.triangulation();
    let source =
        Some(Source { face, triangulation, density: task.mesh.density, history: history.as_deref(), in_photo: None });
    let named = entries.iter().zip(&layers);
    let morphs: Vec<Morph<'_>> =
        named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
    let gltf = GlbOptions { base_colour: task.base_colour, morphs: &morphs, source, ..GlbOptions::default() };
    let in_units: Vec<DVec3> =
        document.positions().iter().map(|&position| position * units.per_document_unit()).collect();
    let positions = (units.id(), in_units.as_slice());
    Ok(format.write(&Content { model, rest_m: document.rest(), gltf, positions })?)
}

/// The history that a glTF opens again with; none where nothing was edited.
fn history_json(face: &FaceModel, document: &Document, units: Units) -> Result<Option<String>, CliError> {
    let entries = match units {
        Units::Mm => document.history().entries().to_vec(),
        Units::Image => carried_over(face, document)?,
    };
    Ok((!entries.is_empty()).then(|| project::to_json(&entries)))
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

/// Positions of a document in image coordinates, in metres of the model: each goes the way there that it went in the picture.
pub fn model_from_image(face: &FaceModel, document: &Document) -> Result<Vec<DVec3>, StudioError> {
    let mut unedited = Document::new(Rest::of_face(face))?;
    unedited.set_density(document.density())?;
    Ok(carried(face, document.rest(), document.positions(), unedited.positions()))
}

/// Ways in the picture, from `found` to `shown`, gone in the model from `rest_m`.
pub fn carried(face: &FaceModel, found: &[DVec3], shown: &[DVec3], rest_m: &[DVec3]) -> Vec<DVec3> {
    let model_from_image = face.image_from_model().inverse();
    let ways = shown.iter().zip(found).map(|(shown, found)| model_from_image * (*shown - *found));
    ways.zip(rest_m).map(|(way, rest)| *rest + way).collect()
}
