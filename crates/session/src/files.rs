use glam::DVec3;
use rosto_export::{BaseColour, Choosable, Content, Format, GlbOptions, Material, Model, Morph, Source, project};

use crate::error::SessionError;
use crate::{OpenFace, Session};

rosto_named::named! {
    /// Which coordinates a mesh is written in.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Units {
        /// MediaPipe's normalised ones.
        Image = "image",
        /// Millimetres of the model.
        Millimetres = "mm",
    }
}

rosto_named::named! {
    /// How edits are in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum EditsAs {
        /// As the shape that they lead to.
        Shape = "shape",
        /// As a morph target each, beside the unedited face.
        MorphTargets = "morph-targets",
    }
}

/// What is chosen about a file; each format takes what it has a place for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileOptions {
    /// What a glTF carries as colour.
    pub base_colour: BaseColour,
    /// Whether light falls on it.
    pub material: Material,
    /// How it carries the edits.
    pub edits: EditsAs,
    /// The unit of JSON's positions.
    pub units: Units,
}

/// What leaves the session.
impl Session {
    /// The face as a file, at the density that is shown; a glTF with what opens it again in the scene's extras. Only morph
    /// targets ask for a solve.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] or [`SessionError::Export`].
    pub fn file(&mut self, format: Format, options: &FileOptions) -> Result<Vec<u8>, SessionError> {
        let layers = match (format.choosable(), options.edits) {
            (Choosable::Material, EditsAs::MorphTargets) => self.displacements()?,
            _ => Vec::new(),
        };
        let face = self.open_face()?;
        let (document, json, in_photo) = (face.document(), face.history_json(), face.in_photo_json());
        let entries = document.history().entries();
        let source = Source {
            face: face.model(),
            triangulation: face.triangulation(),
            density: document.density(),
            history: (!entries.is_empty()).then_some(json.as_str()),
            in_photo: in_photo.as_deref(),
        };
        let named = entries.iter().zip(&layers);
        let morphs: Vec<Morph<'_>> =
            named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
        let (base_colour, material) = (options.base_colour, options.material);
        let gltf = GlbOptions { base_colour, material, source: Some(source), morphs: &morphs, ..GlbOptions::default() };
        let positions = face.positions_in(options.units);
        let uvs = face.uvs();
        let model = Model {
            topology: document.topology(),
            positions_m: document.positions(),
            colours_srgb: &face.colours_srgb(&uvs),
            uvs: &uvs,
            picture: face.model().picture(),
        };
        let positions = (options.units.id(), positions.as_slice());
        Ok(format.write(&Content { model, rest_m: document.rest(), gltf, positions })?)
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
    fn positions_in(&self, units: Units) -> Vec<DVec3> {
        match units {
            Units::Image => self.positions_image(),
            Units::Millimetres => self.positions_mm(),
        }
    }
}
