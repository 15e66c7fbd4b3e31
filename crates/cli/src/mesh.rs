use std::path::Path;

use glam::{DVec2, DVec3};
use rosto_export::{GlbOptions, JsonMesh, Model, glb, gltf, mesh_json, obj, ply, stl};
use rosto_face::FaceModel;
use rosto_studio::{Anchors, Command, Document, Frame, Grip, Rest, project};

use crate::args::{EditArguments, FollowArguments, MeshTask, Paint, Units};
use crate::edits;
use crate::error::CliError;
use crate::{files, follow, networks, portrait};

const MM_PER_M: f64 = 1000.0;

/// The kinds of file that a mesh is written to.
#[derive(Debug, Clone, Copy)]
enum Format {
    Glb,
    Gltf,
    Obj,
    Ply,
    Stl,
    Json,
}

/// A command with the words that a message names it by.
struct Step {
    what: String,
    command: Command,
}

/// `rosto mesh`: photo to edited mesh.
pub fn run(task: &MeshTask, networks: Option<&Path>) -> Result<(), CliError> {
    // What is wrong with the request is said before any work is done.
    let format = format_of(&task.output)?;
    let steps = steps(&task.edits, &task.follow)?;
    let photo = portrait::open(&task.photo)?;
    let face = portrait::face(&photo, &task.photo, &networks::load(networks)?)?;
    let face = portrait::model(&photo, &face, task.topology.into(), &task.photo)?;
    let mut document = edited(&face, steps, task.edits.units)?;
    document.set_density(task.density)?;
    files::write(&task.output, &encoded(&face, &document, task, format)?)
}

fn format_of(path: &Path) -> Result<Format, CliError> {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("glb") => Ok(Format::Glb),
        Some("gltf") => Ok(Format::Gltf),
        Some("obj") => Ok(Format::Obj),
        Some("ply") => Ok(Format::Ply),
        Some("stl") => Ok(Format::Stl),
        Some("json") => Ok(Format::Json),
        _ => Err(CliError::UnknownFormat { path: path.to_owned() }),
    }
}

/// All that was asked for, in the order that `--help` promises.
fn steps(asked: &EditArguments, follow: &FollowArguments) -> Result<Vec<Step>, CliError> {
    let unit = document_unit(asked.units);
    let mut steps = Vec::new();
    let mut edits = asked.file.as_deref().map(edits::read).transpose()?.unwrap_or_default();
    edits.extend(asked.vertices.iter().cloned());
    for edit in edits {
        let mut settings = follow::settings(follow, steps.len(), unit);
        if let Some(anchors) = edit.anchors {
            settings.anchors = Anchors::explicit(anchors);
        }
        let grip = Grip { level: 0, handles: vec![edit.vertex], settings };
        let command = Command::Move { grip, offsets: vec![edit.offset * unit] };
        steps.push(Step { what: format!("vertex {}", edit.vertex), command });
    }
    for edit in &asked.regions {
        let handles = edit.region.vertices();
        let offsets = vec![edit.offset * unit; handles.len()];
        let grip = Grip { level: 0, handles, settings: follow::settings(follow, steps.len(), unit) };
        steps.push(Step { what: edit.region.id().to_owned(), command: Command::Move { grip, offsets } });
    }
    for edit in &asked.sliders {
        let command = edit.slider.command(edit.amount_mm / MM_PER_M);
        steps.push(Step { what: edit.slider.id().to_owned(), command });
    }
    if let Some(share) = asked.symmetrise {
        steps.push(Step { what: "symmetrise".to_owned(), command: Command::Symmetrise { share } });
    }
    Ok(steps)
}

/// The document's unit for one of the command line's: normalised coordinates stay, millimetres become metres.
fn document_unit(units: Units) -> f64 {
    match units {
        Units::Image => 1.0,
        Units::Mm => 1.0 / MM_PER_M,
    }
}

fn edited(face: &FaceModel, steps: Vec<Step>, units: Units) -> Result<Document, CliError> {
    let rest = match units {
        Units::Image => Rest::new(face.topology().clone(), face.positions_image().to_vec(), Frame::Other),
        Units::Mm => Rest::of_face(face),
    };
    let mut document = Document::new(rest)?;
    for (index, Step { what, command }) in steps.into_iter().enumerate() {
        let applied = document.apply(&what, command);
        applied.map_err(|reason| CliError::Edit { number: index + 1, what, reason })?;
    }
    Ok(document)
}

fn encoded(face: &FaceModel, document: &Document, task: &MeshTask, format: Format) -> Result<Vec<u8>, CliError> {
    let positions_m = match task.edits.units {
        Units::Image => model_from_image(face, document.positions()),
        Units::Mm => document.positions().to_vec(),
    };
    let uvs: Vec<DVec2> = document.from_cage(face.uvs());
    let colours = if task.density == 0 { face.colours_srgb().to_vec() } else { face.colours_under(&uvs) };
    let model = Model {
        topology: document.topology(),
        positions_m: &positions_m,
        colours_srgb: &colours,
        uvs: &uvs,
        picture: face.picture(),
    };
    // A history in metres can be carried on with; one in a picture's coordinates would need the picture.
    let keeps_history = task.edits.units == Units::Mm && document.history().can_undo();
    let history = keeps_history.then(|| project::to_json(document.history().applied()));
    let paint = match task.paint {
        Paint::Texture => rosto_export::Paint::Texture,
        Paint::Colors => rosto_export::Paint::VertexColours,
    };
    let options = GlbOptions { paint, extras: history.as_deref(), ..GlbOptions::default() };
    Ok(match format {
        Format::Glb => glb(&model, &options)?,
        Format::Gltf => gltf(&model, &options)?.into_bytes(),
        Format::Obj => obj(&model)?.into_bytes(),
        Format::Ply => ply(&model)?,
        Format::Stl => stl(&model)?,
        Format::Json => json(document, &colours, task.edits.units).into_bytes(),
    })
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
