use rosto_export::{
    Content, ExportedFile, GlbOptions, JsonMesh, Model, ModelEyes, Morph, Picture, SavedEdits, Source, Units, about,
    mesh_json, project,
};
use rosto_face::{Gaze, Photo, canonical_uvs};
use rosto_studio::{EditsInRig, Layer, Rig};

use crate::{Error, FaceMesh, FileOptions, Format};

impl FaceMesh {
    /// Encodes the mesh and its sidecar files, which share `name`. A glTF also carries the photos and the edits in its
    /// extras, from which [`reopen`](crate::reopen) restores them.
    ///
    /// # Errors
    /// [`Error::Export`], [`Error::ImageUnits`] for edits in image coordinates in another format than JSON, or
    /// [`Error::Studio`] if expressions are requested of a mesh without them.
    pub fn write(&mut self, format: Format, options: &FileOptions, name: &str) -> Result<ExportedFile, Error> {
        match (self.units, format) {
            (Units::Mm, _) => {}
            (Units::Image, Format::Json) => return Ok(self.image_json().into()),
            (Units::Image, _) => return Err(Error::ImageUnits),
        }
        let max_px = options.texture_size.px();
        let texture = options.has_whole_texture(format).then(|| self.texture(max_px).cloned()).transpose()?;
        match self.rig(format, options)? {
            Some(rig) => self.write_rig(&rig, format, options, name, texture.as_ref()),
            None => self.write_mesh(format, options, name, texture.as_ref()),
        }
    }

    /// Writes the face with its lossless photo as a project file.
    ///
    /// # Errors
    /// [`Error::Export`] if the face was built without its pictures, or [`Error::ImageUnits`].
    pub fn write_project(&self) -> Result<Vec<u8>, Error> {
        if self.units == Units::Image {
            return Err(Error::ImageUnits);
        }
        Ok(project::write(&Source { face: &self.face, edits: &self.saved_edits() })?)
    }

    fn write_mesh(
        &mut self,
        format: Format,
        options: &FileOptions,
        name: &str,
        texture: Option<&Photo>,
    ) -> Result<ExportedFile, Error> {
        let layers = if options.has_edit_targets(format) { self.document.displacements() } else { Vec::new() };
        let named = self.document.history().entries().iter().zip(&layers);
        let morphs: Vec<Morph<'_>> =
            named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
        let positions_image = (options.units == Units::Image).then(|| self.positions_image());
        let positions_image = positions_image.as_deref();
        let edits = self.saved_edits();
        let gltf = gltf(options, &morphs, Source { face: &self.face, edits: &edits });
        let (rest_m, print) = (self.document.rest(), options.print);
        let written = self
            .with_model(texture, |model| format.write(&Content { model, rest_m, gltf, print, name, positions_image }));
        Ok(written?)
    }

    fn write_rig(
        &self,
        rig: &Rig,
        format: Format,
        options: &FileOptions,
        name: &str,
        texture: Option<&Photo>,
    ) -> Result<ExportedFile, Error> {
        let (split_face, base_m) = (rig.split_face(), rig.base_m());
        let uvs = split_face.uvs(&self.uvs());
        let texture_uvs = split_face.uvs(&self.document.from_cage(&canonical_uvs()));
        let model = Model {
            topology: split_face.topology(),
            positions_m: base_m,
            smoothed_m: None,
            eyes: None,
            colours_srgb: &split_face.colours(&self.colours_srgb()),
            photo: self.face.picture().map(|pixels| Picture { pixels, uvs: &uvs }),
            whole: texture.map(|pixels| Picture { pixels, uvs: &texture_uvs }),
        };
        let layers = rig.layers().iter();
        let morphs: Vec<Morph<'_>> = layers
            .map(|Layer { name, displacements_m, weight }| Morph { name, displacements_m, weight: *weight })
            .collect();
        let edits = self.saved_edits();
        let gltf = gltf(options, &morphs, Source { face: &self.face, edits: &edits });
        let print = options.print;
        Ok(format.write(&Content { model, rest_m: base_m, gltf, print, name, positions_image: None })?)
    }

    /// The face in pieces, if the format and options need it.
    fn rig(&mut self, format: Format, options: &FileOptions) -> Result<Option<Rig>, Error> {
        let edits = if options.has_edit_targets(format) { EditsInRig::Layers } else { EditsInRig::AtRest };
        let rig = if options.has_expression_targets(format) {
            Rig::new(&mut self.document, edits)?
        } else if options.has_pieces(format) {
            Rig::still(&mut self.document, edits)
        } else {
            return Ok(None);
        };
        Ok(Some(rig.darkened(self.face.colours_srgb())))
    }

    /// JSON of a face edited in image coordinates.
    fn image_json(&self) -> String {
        mesh_json(&JsonMesh {
            units: Units::Image,
            positions: self.document.positions(),
            colours_srgb: &self.colours_srgb(),
            triangles: self.triangles(),
            about: Some(about(&self.face, &self.landmarks_m())),
        })
    }

    /// The edits from which a file is reopened.
    fn saved_edits(&self) -> SavedEdits {
        let entries = self.document.history().entries();
        SavedEdits {
            triangulation: self.face.triangulation(),
            density: self.document.density(),
            history: (!entries.is_empty()).then(|| rosto_studio::project::to_json(entries)),
            photo_edit: self.photo_edit.clone(),
        }
    }

    /// Calls `then` with the mesh in the form that exporters take.
    pub(crate) fn with_model<T>(&self, texture: Option<&Photo>, then: impl FnOnce(Model<'_>) -> T) -> T {
        let (uvs, texture_uvs) = (self.uvs(), self.document.from_cage(&canonical_uvs()));
        let smoothed_m = self.document.rounded();
        then(Model {
            topology: self.document.topology(),
            positions_m: self.document.positions(),
            smoothed_m: Some(&smoothed_m),
            eyes: Some(ModelEyes { face: self.face.topology().triangles(), gazes: Gaze::of_face(&self.face) }),
            colours_srgb: &self.colours_srgb(),
            photo: self.face.picture().map(|pixels| Picture { pixels, uvs: &uvs }),
            whole: texture.map(|pixels| Picture { pixels, uvs: &texture_uvs }),
        })
    }
}

fn gltf<'a>(options: &FileOptions, morphs: &'a [Morph<'a>], source: Source<'a>) -> GlbOptions<'a> {
    GlbOptions {
        base_colour: options.base_colour,
        material: options.material,
        max_texture_px: options.texture_size.px(),
        morphs,
        source: Some(source),
        ..GlbOptions::default()
    }
}
