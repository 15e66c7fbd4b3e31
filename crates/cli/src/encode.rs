use std::path::Path;

use glam::{DVec2, DVec3};
use rosto_export::{
    BaseColour, Content, ExportOption, ExportedFile, Eyes, Format, GlbOptions, JsonMesh, Model, Morph, Picture, Source,
    Units, about, mesh_json,
};
use rosto_face::{FaceModel, Photo, canonical_uvs};
use rosto_studio::{Document, EditsInRig, Layer, Rig, Shot, StudioError, project, texture_side_px, whole_texture_of};

use crate::args::MeshTask;
use crate::error::CliError;

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
) -> Result<ExportedFile, CliError> {
    if task.units == Units::Image {
        return Ok(image_json(face, document).into());
    }
    if let Some(rig) = rig(face, document, task, format)? {
        return rigged(face, document, &rig, task, format, name);
    }
    let layers = if task.morph_targets { document.displacements() } else { Vec::new() };
    let document = &*document;
    let skin = Skin::new(face, document, task, format)?;
    let smoothed_m = document.rounded();
    let model = Model {
        topology: document.topology(),
        positions_m: document.positions(),
        smoothed_m: Some(&smoothed_m),
        colours_srgb: &skin.colours_srgb,
        photo: Picture { pixels: face.picture(), uvs: &skin.uvs },
        whole: skin.texture.as_ref().map(|pixels| Picture { pixels, uvs: &skin.texture_uvs }),
    };
    let history = history_json(document);
    let named = document.history().entries().iter().zip(&layers);
    let morphs: Vec<Morph<'_>> =
        named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
    let gltf = GlbOptions { morphs: &morphs, ..gltf(face, task, history.as_deref()) };
    let (rest_m, solid) = (document.rest(), task.solid);
    Ok(format.write(&Content { model, rest_m, gltf, solid, name, positions_image: None })?)
}

/// JSON of a face that was edited in image coordinates.
fn image_json(face: &FaceModel, document: &Document) -> String {
    let landmarks_m = carried(face, document.cage());
    mesh_json(&JsonMesh {
        units: Units::Image,
        positions: document.positions(),
        colours_srgb: &face.colours_under(&document.from_cage(face.uvs())),
        triangles: document.topology().triangles(),
        about: Some(about(face, &landmarks_m)),
    })
}

/// Landmarks that were moved in image coordinates, in metres: each goes the way in the model that it went in the picture.
pub fn carried(face: &FaceModel, landmarks: &[DVec3]) -> Vec<DVec3> {
    let model_from_image = face.image_from_model().inverse();
    let ways = landmarks.iter().zip(face.positions_image()).map(|(shown, found)| model_from_image * (*shown - *found));
    ways.zip(face.positions_m()).map(|(way, rest)| *rest + way).collect()
}

/// The face in its pieces, for a file that has them.
fn rig(face: &FaceModel, document: &mut Document, task: &MeshTask, format: Format) -> Result<Option<Rig>, CliError> {
    let edits = if task.morph_targets { EditsInRig::Layers } else { EditsInRig::AtRest };
    let rig = if task.expression_targets && format.supports(ExportOption::Material) {
        Rig::new(document, edits)?
    } else if task.eyes == Eyes::Pieces && format.supports(ExportOption::Eyes) {
        Rig::still(document, edits)
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
) -> Result<ExportedFile, CliError> {
    let (parted, base_m) = (rig.parted(), rig.base_m());
    let skin = Skin::new(face, document, task, format)?;
    let (uvs, texture_uvs) = (parted.uvs(&skin.uvs), parted.uvs(&skin.texture_uvs));
    let model = Model {
        topology: parted.topology(),
        positions_m: base_m,
        smoothed_m: None,
        colours_srgb: &parted.colours(&skin.colours_srgb),
        photo: Picture { pixels: face.picture(), uvs: &uvs },
        whole: skin.texture.as_ref().map(|pixels| Picture { pixels, uvs: &texture_uvs }),
    };
    let history = history_json(document);
    let layers = rig.layers().iter();
    let morphs: Vec<Morph<'_>> = layers
        .map(|Layer { name, displacements_m, weight }| Morph { name, displacements_m, weight: *weight })
        .collect();
    let gltf = GlbOptions { morphs: &morphs, ..gltf(face, task, history.as_deref()) };
    let solid = task.solid;
    Ok(format.write(&Content { model, rest_m: base_m, gltf, solid, name, positions_image: None })?)
}

fn gltf<'a>(face: &'a FaceModel, task: &MeshTask, history: Option<&'a str>) -> GlbOptions<'a> {
    let (triangulation, density) = (face.triangulation(), task.mesh.density);
    let source = Some(Source { face, triangulation, density, history, in_photo: None });
    let (base_colour, material, max_texture_px) = (task.base_colour, task.material, task.texture_size.px());
    GlbOptions { base_colour, material, max_texture_px, source, ..GlbOptions::default() }
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
        let texture = match task.base_colour == BaseColour::Whole && format.supports(ExportOption::BaseColour) {
            true => Some(texture(face, texture_side_px(face, task.texture_size.px()))?),
            false => None,
        };
        Ok(Self { uvs, colours_srgb, texture_uvs: document.from_cage(&canonical_uvs()), texture })
    }
}

/// The texture of the whole face, of all its photos; the first is the face's own.
fn texture(face: &FaceModel, side_px: u32) -> Result<Photo, StudioError> {
    let others = face.views().iter().skip(1);
    let others: Vec<Shot<'_>> =
        others.map(|view| Shot { picture: &view.picture, uvs: &view.uvs, camera: &view.camera }).collect();
    Ok(whole_texture_of(face, &others, side_px)?.picture)
}

/// The history that a glTF opens again with; none where nothing was edited.
fn history_json(document: &Document) -> Option<String> {
    let entries = document.history().entries();
    (!entries.is_empty()).then(|| project::to_json(entries))
}
