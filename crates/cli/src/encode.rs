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

/// Export format for the path's extension, ignoring case.
pub fn format_of(path: &Path) -> Result<Format, CliError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let format = extension.as_deref().and_then(Format::from_id);
    format.ok_or_else(|| CliError::UnknownFormat { path: path.to_owned() })
}

/// File name without its extension, which sidecar files share.
pub fn name_of(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Encodes the edited face and its sidecar files, which share `name`. A glTF also carries the project in its extras
/// and, on request, the edits as morph targets.
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
    let texture_source = TextureData::new(face, document, task, format)?;
    let smoothed_m = document.rounded();
    let model = Model {
        topology: document.topology(),
        positions_m: document.positions(),
        smoothed_m: Some(&smoothed_m),
        colours_srgb: &texture_source.colours_srgb,
        photo: Picture { pixels: face.picture(), uvs: &texture_source.uvs },
        whole: texture_source.texture.as_ref().map(|pixels| Picture { pixels, uvs: &texture_source.texture_uvs }),
    };
    let history = history_json(document);
    let named = document.history().entries().iter().zip(&layers);
    let morphs: Vec<Morph<'_>> =
        named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
    let gltf = GlbOptions { morphs: &morphs, ..gltf(face, task, history.as_deref()) };
    let (rest_m, solid) = (document.rest(), task.solid);
    Ok(format.write(&Content { model, rest_m, gltf, solid, name, positions_image: None })?)
}

/// JSON of a face edited in image coordinates.
fn image_json(face: &FaceModel, document: &Document) -> String {
    let landmarks_m = landmarks_m_from_image(face, document.cage());
    mesh_json(&JsonMesh {
        units: Units::Image,
        positions: document.positions(),
        colours_srgb: &face.colours_under(&document.from_cage(face.uvs())),
        triangles: document.topology().triangles(),
        about: Some(about(face, &landmarks_m)),
    })
}

/// Landmarks in metres after edits in image coordinates: transforms each image displacement into the model's frame.
pub fn landmarks_m_from_image(face: &FaceModel, landmarks: &[DVec3]) -> Vec<DVec3> {
    let model_from_image = face.image_from_model().inverse();
    let displacements_m =
        landmarks.iter().zip(face.positions_image()).map(|(edited, rest)| model_from_image * (*edited - *rest));
    displacements_m.zip(face.positions_m()).map(|(displacement_m, rest_m)| *rest_m + displacement_m).collect()
}

/// Separate pieces for skin, eyes and mouth, if the format and the options ask for them.
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
    let (split_face, base_m) = (rig.split_face(), rig.base_m());
    let texture_source = TextureData::new(face, document, task, format)?;
    let (uvs, texture_uvs) = (split_face.uvs(&texture_source.uvs), split_face.uvs(&texture_source.texture_uvs));
    let model = Model {
        topology: split_face.topology(),
        positions_m: base_m,
        smoothed_m: None,
        colours_srgb: &split_face.colours(&texture_source.colours_srgb),
        photo: Picture { pixels: face.picture(), uvs: &uvs },
        whole: texture_source.texture.as_ref().map(|pixels| Picture { pixels, uvs: &texture_uvs }),
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

/// Colours and texture coordinates of the mesh at its density.
struct TextureData {
    uvs: Vec<DVec2>,
    colours_srgb: Vec<[u8; 3]>,
    texture_uvs: Vec<DVec2>,
    /// Whole-face texture; baked only if the file uses it, because it is expensive.
    texture: Option<Photo>,
}

impl TextureData {
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

/// Whole-face texture from the model's photo and its other views.
fn texture(face: &FaceModel, side_px: u32) -> Result<Photo, StudioError> {
    let others = face.views().iter().skip(1);
    let others: Vec<Shot<'_>> =
        others.map(|view| Shot { picture: &view.picture, uvs: &view.uvs, camera: &view.camera }).collect();
    Ok(whole_texture_of(face, &others, side_px)?.picture)
}

/// History for the glTF's extras; `None` without edits.
fn history_json(document: &Document) -> Option<String> {
    let entries = document.history().entries();
    (!entries.is_empty()).then(|| project::to_json(entries))
}
