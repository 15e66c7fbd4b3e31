use rosto_export::{
    BaseColour, Content, ExportOption, ExportedFile, Eyes, Format, GlbOptions, Material, Model, Morph, Picture, Solid,
    SolidFacts, Source, Units, project,
};
use rosto_mesh::Topology;
use rosto_studio::{EditsInRig, Layer, Rig};

use crate::error::SessionError;
use crate::{OpenFace, Session};

rosto_mesh::named! {
    /// How edits are in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum EditsAs {
        /// As the shape that they lead to.
        Shape = "shape",
        /// As a morph target each, beside the unedited face.
        MorphTargets = "morph-targets",
    }
}

rosto_mesh::named! {
    /// How expressions are in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum ExpressionsAs {
        /// As the shape that they lead to.
        Shape = "shape",
        /// As a morph target each, all that there are, at the weights that they stand at; eyes and mouth are pieces of their own.
        MorphTargets = "morph-targets",
    }
}

/// The formats that are for printing: a body is made of the face for them.
pub fn printed_formats() -> impl Iterator<Item = Format> {
    Format::ALL.into_iter().filter(|format| format.supports(ExportOption::Solid))
}

/// The formats that a panel offers by a button each: those with choices that are no other's have a place of their own.
pub fn plain_formats() -> impl Iterator<Item = Format> {
    let own = [ExportOption::Material, ExportOption::Units, ExportOption::Solid];
    Format::ALL.into_iter().filter(move |format| !own.iter().any(|&choice| format.supports(choice)))
}

/// What is chosen about a file; each format takes what it has a place for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FileOptions {
    /// What paints the face.
    pub base_colour: BaseColour,
    /// Whether light falls on it.
    pub material: Material,
    /// How it carries the edits.
    pub edits: EditsAs,
    /// How it carries expressions.
    pub expressions: ExpressionsAs,
    /// What fills eyes and mouth; where expressions are morph targets, they are pieces.
    pub eyes: Eyes,
    /// The unit of JSON's positions.
    pub units: Units,
    /// The body that is printed.
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
    /// Whether a format's files have each expression as a morph target.
    fn are_expressions_moved(&self, format: Format) -> bool {
        format.supports(ExportOption::Material) && self.expressions == ExpressionsAs::MorphTargets
    }

    /// Whether a format's files have eyes and mouth in pieces of their own, though they move none.
    fn are_eyes_pieces(&self, format: Format) -> bool {
        format.supports(ExportOption::Eyes) && self.eyes == Eyes::Pieces
    }
}

/// What files are called that lie beside another one, and that one in a bundle with them.
const NAME: &str = "face";

/// What leaves the session.
impl Session {
    /// The face as a file, at the density that is shown, with what lies beside it; a glTF with what opens it again in the
    /// scene's extras. Only morph targets ask for a solve.
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
        let (document, json, in_photo) = (face.document(), face.history_json(), face.in_photo_json());
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

    /// The same as one file: where others lie beside it, an archive of them all, whose name ends as
    /// [`Format::bundle_extension`] tells.
    ///
    /// # Errors
    /// As [`Self::file`].
    pub fn bundled_file(&mut self, format: Format, options: &FileOptions) -> Result<Vec<u8>, SessionError> {
        Ok(self.file(format, options)?.bundled(NAME, format))
    }

    /// How many vertices and triangles the mesh in a file has, before it is written.
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

    /// What the body measures that a printer would be given; none of the surface alone.
    ///
    /// # Errors
    /// [`SessionError::NoFace`], or [`SessionError::Export`] if there can be no such body.
    pub fn solid_facts(&self, solid: Solid) -> Result<Option<SolidFacts>, SessionError> {
        let body = self.open_face()?.as_model(|model| solid.body(&model))?;
        Ok(body.as_ref().map(SolidFacts::of))
    }

    /// The face in its pieces, for a file that has them.
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
        let (json, in_photo) = (face.history_json(), face.in_photo_json());
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

    /// The face and its work as a project file; `png` is its whole upright picture.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] or [`SessionError::Export`].
    pub fn project(&self, png: &[u8]) -> Result<Vec<u8>, SessionError> {
        let face = self.open_face()?;
        let in_photo = face.in_photo_json();
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
    /// What the file opens again with: the history as JSON, and what was done to the photo alone.
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

    /// Does something with the face as exporters take it.
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
