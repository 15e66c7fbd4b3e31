use rosto_export::{
    BaseColour, Content, ExportOption, ExportedFile, Eyes, Format, GlbOptions, Material, Model, Morph, Picture, Solid,
    SolidFacts, Source, Units, project,
};
use rosto_mesh::Topology;
use rosto_studio::{EditsInRig, Layer, Rig};

use crate::error::SessionError;
use crate::{OpenFace, Session};

rosto_mesh::named! {
    /// Representation of edits in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum EditsAs {
        /// As part of the shape.
        Shape = "shape",
        /// As one morph target each, on the unedited face.
        MorphTargets = "morph-targets",
    }
}

rosto_mesh::named! {
    /// Representation of expressions in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum ExpressionsAs {
        /// As part of the shape.
        Shape = "shape",
        /// As one morph target for each available expression, at its current weight; eyes and mouth are separate
        /// pieces.
        MorphTargets = "morph-targets",
    }
}

/// The formats for 3D printing, which contain a closed body.
pub fn printed_formats() -> impl Iterator<Item = Format> {
    Format::ALL.into_iter().filter(|format| format.supports(ExportOption::Solid))
}

/// The formats without format-specific options, which panels offer as plain buttons.
pub fn plain_formats() -> impl Iterator<Item = Format> {
    let own = [ExportOption::Material, ExportOption::Units, ExportOption::Solid];
    Format::ALL.into_iter().filter(move |format| !own.iter().any(|&choice| format.supports(choice)))
}

/// Options of an exported file; each format uses those that it supports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FileOptions {
    /// Source of the face's colour.
    pub base_colour: BaseColour,
    /// Whether the face is lit.
    pub material: Material,
    /// Representation of edits.
    pub edits: EditsAs,
    /// Representation of expressions.
    pub expressions: ExpressionsAs,
    /// Filling of eyes and mouth; separate pieces if expressions are morph targets.
    pub eyes: Eyes,
    /// Unit of the positions in JSON.
    pub units: Units,
    /// Body for printing.
    pub solid: Solid,
}

impl Default for FileOptions {
    fn default() -> Self {
        Self {
            base_colour: BaseColour::default(),
            material: Material::default(),
            edits: EditsAs::Shape,
            expressions: ExpressionsAs::Shape,
            eyes: Eyes::default(),
            units: Units::default(),
            solid: Solid::default(),
        }
    }
}

impl FileOptions {
    /// Whether a format's files contain expressions as morph targets.
    fn are_expressions_moved(&self, format: Format) -> bool {
        format.supports(ExportOption::Material) && self.expressions == ExpressionsAs::MorphTargets
    }

    /// Whether a format's files contain eyes and mouth as separate pieces.
    fn are_eyes_pieces(&self, format: Format) -> bool {
        format.supports(ExportOption::Eyes) && self.eyes == Eyes::Pieces
    }
}

/// Base name of companion files, and of the main file in a bundle.
const NAME: &str = "face";

/// File export.
impl Session {
    /// Exports the face at the displayed density, with its companion files. A glTF stores the project in the scene's
    /// extras. Only expressions as morph targets need a solve.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] or [`SessionError::Export`].
    pub fn file(&mut self, format: Format, options: &FileOptions) -> Result<ExportedFile, SessionError> {
        if let Some(rig) = self.rig_for(format, options)? {
            return self.rigged(&rig, format, options);
        }
        let layers = match (format.supports(ExportOption::Material), options.edits) {
            (true, EditsAs::MorphTargets) => self.displacements()?,
            _ => Vec::new(),
        };
        let face = self.open_face()?;
        let (document, json, in_photo) = (face.document(), face.history_json(), face.photo_edit_json());
        let entries = document.history().entries();
        let named = entries.iter().zip(&layers);
        let morphs: Vec<Morph<'_>> =
            named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
        let gltf = GlbOptions { morphs: &morphs, ..self.gltf(options, face.source(&json, in_photo.as_deref())) };
        let positions_image = (options.units == Units::Image).then(|| face.positions_image());
        let (solid, positions_image) = (options.solid, positions_image.as_deref());
        Ok(face.as_model(|model| {
            format.write(&Content { model, rest_m: document.rest(), gltf, solid, name: NAME, positions_image })
        })?)
    }

    /// Exports the face as one file: an archive if there are companion files. [`Format::bundle_extension`] returns the
    /// extension.
    ///
    /// # Errors
    /// See [`Self::file`].
    pub fn bundled_file(&mut self, format: Format, options: &FileOptions) -> Result<Vec<u8>, SessionError> {
        Ok(self.file(format, options)?.bundled(NAME, format))
    }

    /// Numbers of vertices and triangles that an exported mesh will have.
    ///
    /// # Errors
    /// [`SessionError::NoFace`].
    pub fn mesh_counts(&self, format: Format, options: &FileOptions) -> Result<[usize; 2], SessionError> {
        let document = self.open_face()?.document();
        let counts = |topology: &Topology| [topology.vertex_count(), topology.triangles().len()];
        Ok(match options.are_expressions_moved(format) || options.are_eyes_pieces(format) {
            true => counts(document.split_face().topology()),
            false => counts(document.topology()),
        })
    }

    /// Measures of the body for printing; `None` if only the surface is exported.
    ///
    /// # Errors
    /// [`SessionError::NoFace`], or [`SessionError::Export`] if the body cannot be built.
    pub fn solid_facts(&self, solid: Solid) -> Result<Option<SolidFacts>, SessionError> {
        let body = self.open_face()?.as_model(|model| solid.body(&model))?;
        Ok(body.as_ref().map(SolidFacts::of))
    }

    /// The face in pieces, if the format and options need it.
    fn rig_for(&mut self, format: Format, options: &FileOptions) -> Result<Option<Rig>, SessionError> {
        let is_gltf = format.supports(ExportOption::Material);
        let edits = match options.edits {
            EditsAs::MorphTargets if is_gltf => EditsInRig::Layers,
            _ => EditsInRig::AtRest,
        };
        let rig = if options.are_expressions_moved(format) {
            self.rig(edits)?
        } else if options.are_eyes_pieces(format) {
            self.still_rig(edits)?
        } else {
            return Ok(None);
        };
        Ok(Some(rig.darkened(self.open_face()?.model().colours_srgb())))
    }

    fn rigged(&self, rig: &Rig, format: Format, options: &FileOptions) -> Result<ExportedFile, SessionError> {
        let face = self.open_face()?;
        let (json, in_photo) = (face.history_json(), face.photo_edit_json());
        let layers = rig.layers().iter();
        let morphs: Vec<Morph<'_>> = layers
            .map(|Layer { name, displacements_m, weight }| Morph { name, displacements_m, weight: *weight })
            .collect();
        let gltf = GlbOptions { morphs: &morphs, ..self.gltf(options, face.source(&json, in_photo.as_deref())) };
        let (split_face, base_m) = (rig.split_face(), rig.base_m());
        let (uvs, texture_uvs) = (split_face.uvs(&face.uvs()), split_face.uvs(&face.texture_uvs()));
        let model = Model {
            topology: split_face.topology(),
            positions_m: base_m,
            smoothed_m: None,
            colours_srgb: &split_face.colours(&face.colours_srgb(&face.uvs())),
            photo: Picture { pixels: face.model().picture(), uvs: &uvs },
            whole: face.texture().map(|pixels| Picture { pixels, uvs: &texture_uvs }),
        };
        let solid = options.solid;
        Ok(format.write(&Content { model, rest_m: base_m, gltf, solid, name: NAME, positions_image: None })?)
    }

    fn gltf<'a>(&self, options: &FileOptions, source: Source<'a>) -> GlbOptions<'a> {
        GlbOptions {
            base_colour: options.base_colour,
            material: options.material,
            max_texture_px: self.view().texture_size.px(),
            source: Some(source),
            ..GlbOptions::default()
        }
    }

    /// Writes the face and its edits as a project file; `png` is the whole upright picture.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] or [`SessionError::Export`].
    pub fn project(&self, png: &[u8]) -> Result<Vec<u8>, SessionError> {
        let face = self.open_face()?;
        let in_photo = face.photo_edit_json();
        let source = Source {
            face: face.model(),
            triangulation: face.triangulation(),
            density: face.document().density(),
            history: Some(&face.history_json()),
            in_photo: in_photo.as_deref(),
        };
        Ok(project::write(&source, png)?)
    }
}

impl OpenFace {
    /// The data from which a file can be reopened: the history and the photo-edit data, both as JSON.
    fn source<'a>(&'a self, history: &'a str, in_photo: Option<&'a str>) -> Source<'a> {
        let is_edited = !self.document().history().entries().is_empty();
        Source {
            face: self.model(),
            triangulation: self.triangulation(),
            density: self.document().density(),
            history: is_edited.then_some(history),
            in_photo,
        }
    }

    /// Calls `then` with the face in the form that exporters take.
    fn as_model<T>(&self, then: impl FnOnce(Model<'_>) -> T) -> T {
        let (uvs, texture_uvs) = (self.uvs(), self.texture_uvs());
        let smoothed_m = self.document().rounded();
        then(Model {
            topology: self.document().topology(),
            positions_m: self.document().positions(),
            smoothed_m: Some(&smoothed_m),
            colours_srgb: &self.colours_srgb(&uvs),
            photo: Picture { pixels: self.model().picture(), uvs: &uvs },
            whole: self.texture().map(|pixels| Picture { pixels, uvs: &texture_uvs }),
        })
    }
}
