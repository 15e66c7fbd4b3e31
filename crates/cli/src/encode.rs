use std::path::Path;

use glam::{DVec2, DVec3};
use rosto_export::{
    BaseColour, Choosable, Content, Eyes, Format, GlbOptions, Model, Morph, Picture, Source, Units, Written,
};
use rosto_face::{FaceModel, Photo, canonical_uvs};
use rosto_studio::{
    Document, EditsInRig, Entry, Rest, Rig, Shot, StudioError, project, texture_side_px, whole_texture_of,
};

use crate::args::MeshTask;
use crate::error::CliError;
use crate::model_history::model_history;
use crate::terminal;

/// The format that a file's name asks for by its ending, in capitals or not.
pub fn format_of(path: &Path) -> Result<Format, CliError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let format = extension.as_deref().and_then(Format::from_id);
    format.ok_or_else(|| CliError::UnknownFormat { path: path.to_owned() })
}

/// What a file is called without its ending; those beside it are called so, too.
pub fn name_of(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// The edited face's file, with those beside it, which are called `name`; a glTF with what opens it again in its extras and, if asked for, the edits as morph
/// targets.
pub fn encode(
    face: &FaceModel,
    document: &mut Document,
    task: &MeshTask,
    format: Format,
    name: &str,
) -> Result<Written, CliError> {
    if let Some(rig) = rig(face, document, task, format)? {
        return rigged(face, document, &rig, task, format, name);
    }
    let units = task.edits.units;
    let layers = if task.morph_targets { document.displacements() } else { Vec::new() };
    let document = &*document;
    let shape = Shape::of(face, document, units)?;
    let skin = Skin::new(face, document, task, format)?;
    let model = Model {
        topology: document.topology(),
        positions_m: &shape.positions_m,
        softer_m: Some(&shape.softer_m),
        colours_srgb: &skin.colours_srgb,
        photo: Picture { pixels: face.picture(), uvs: &skin.uvs },
        whole: skin.texture.as_ref().map(|pixels| Picture { pixels, uvs: &skin.texture_uvs }),
    };
    let history = history_json(face, document, units, format)?;
    let named = document.history().entries().iter().zip(&layers);
    let morphs: Vec<Morph<'_>> =
        named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
    let gltf = GlbOptions { morphs: &morphs, ..gltf(face, task, history.as_deref()) };
    let in_units: Vec<DVec3> =
        document.positions().iter().map(|&position| position * units.per_document_unit()).collect();
    let positions = (units.id(), in_units.as_slice());
    let (solid, colours) = (task.solid, task.colours);
    Ok(format.write(&Content { model, rest_m: document.rest(), gltf, solid, colours, name, positions })?)
}

/// The face in its pieces, for a file that has them.
fn rig(face: &FaceModel, document: &mut Document, task: &MeshTask, format: Format) -> Result<Option<Rig>, CliError> {
    let edits = if task.morph_targets { EditsInRig::Layers } else { EditsInRig::AtRest };
    let rig = if task.expression_targets && format.lets_choose(Choosable::Material) {
        Rig::new(document, edits)?
    } else if task.eyes == Eyes::Pieces && format.lets_choose(Choosable::Eyes) {
        let shown_m = Shape::of(face, document, task.edits.units)?.positions_m;
        Rig::still(document, &shown_m, edits)
    } else {
        return Ok(None);
    };
    Ok(Some(rig.darkened(face.colours_srgb())))
}

fn rigged(
    face: &FaceModel,
    document: &Document,
    rig: &Rig,
    task: &MeshTask,
    format: Format,
    name: &str,
) -> Result<Written, CliError> {
    let (parted, base_m) = (rig.parted(), rig.base_m());
    let skin = Skin::new(face, document, task, format)?;
    let (uvs, texture_uvs) = (parted.uvs(&skin.uvs), parted.uvs(&skin.texture_uvs));
    let model = Model {
        topology: parted.topology(),
        positions_m: base_m,
        softer_m: None,
        colours_srgb: &parted.colours(&skin.colours_srgb),
        photo: Picture { pixels: face.picture(), uvs: &uvs },
        whole: skin.texture.as_ref().map(|pixels| Picture { pixels, uvs: &texture_uvs }),
    };
    let history = history_json(face, document, task.edits.units, format)?;
    let layers = rig.layers_m().iter().map(|(name, ways)| Morph { name, displacements_m: ways, weight: 1.0 });
    let expressions = rig.expressions().iter();
    let expressions =
        expressions.map(|(name, ways, weight)| Morph { name: name.id(), displacements_m: ways, weight: *weight });
    let morphs: Vec<Morph<'_>> = layers.chain(expressions).collect();
    let gltf = GlbOptions { morphs: &morphs, ..gltf(face, task, history.as_deref()) };
    let (solid, colours) = (task.solid, task.colours);
    let positions = (task.edits.units.id(), base_m);
    Ok(format.write(&Content { model, rest_m: base_m, gltf, solid, colours, name, positions })?)
}

fn gltf<'a>(face: &'a FaceModel, task: &MeshTask, history: Option<&'a str>) -> GlbOptions<'a> {
    let (triangulation, density) = (face.triangulation(), task.mesh.density);
    let source = Some(Source { face, triangulation, density, history, in_photo: None });
    let (base_colour, material, max_texture_px) = (task.base_colour, task.material, task.texture_size.px());
    GlbOptions { base_colour, material, max_texture_px, source, ..GlbOptions::default() }
}

/// Where a document's mesh is in the model's frame, in metres.
pub struct Shape {
    pub positions_m: Vec<DVec3>,
    softer_m: Vec<DVec3>,
}

impl Shape {
    pub fn of(face: &FaceModel, document: &Document, units: Units) -> Result<Self, StudioError> {
        let softer = document.rounded();
        Ok(match units {
            Units::Mm => Self { positions_m: document.positions().to_vec(), softer_m: softer },
            Units::Image => {
                let positions_m = model_from_image(face, document)?;
                Self { softer_m: carried(face, document.positions(), &softer, &positions_m), positions_m }
            }
        })
    }
}

/// What the mesh that is shown is painted with.
struct Skin {
    uvs: Vec<DVec2>,
    colours_srgb: Vec<[u8; 3]>,
    texture_uvs: Vec<DVec2>,
    /// Only where the file is painted with it: it takes a while.
    texture: Option<Photo>,
}

impl Skin {
    fn new(face: &FaceModel, document: &Document, task: &MeshTask, format: Format) -> Result<Self, CliError> {
        let uvs: Vec<DVec2> = document.from_cage(face.uvs());
        let colours_srgb = face.colours_under(&uvs);
        let texture = match task.base_colour == BaseColour::Whole && format.lets_choose(Choosable::BaseColour) {
            true => Some(texture(face, texture_side_px(face, task.texture_size.px()))?),
            false => None,
        };
        Ok(Self { uvs, colours_srgb, texture_uvs: document.from_cage(&canonical_uvs()), texture })
    }
}

/// The texture of the whole face, of all its photos; the first is the face's own.
fn texture(face: &FaceModel, side_px: u32) -> Result<Photo, StudioError> {
    let views = face.views();
    let others = views.iter().skip(1);
    let others: Vec<Shot<'_>> =
        others.map(|view| Shot { picture: view.picture, uvs: view.uvs, camera: view.camera }).collect();
    Ok(whole_texture_of(face, &others, side_px)?.picture)
}

/// The history that a glTF opens again with; none where nothing was edited, and for other formats.
fn history_json(
    face: &FaceModel,
    document: &Document,
    units: Units,
    format: Format,
) -> Result<Option<String>, CliError> {
    if !format.lets_choose(Choosable::Material) {
        return Ok(None);
    }
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
fn model_from_image(face: &FaceModel, document: &Document) -> Result<Vec<DVec3>, StudioError> {
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
