use glam::{DMat3, DVec2, DVec3};
use rosto_export::{Print, PrintedBody, SavedEdits, SavedFace, Units};
use rosto_face::{FaceModel, Photo, Triangulation, View};
use rosto_studio::{Document, Rest, SMOOTH_DENSITY, project, texture_side_px, whole_texture};

use crate::{Error, FileOptions, Format};

/// An edited face, ready to be written in any format.
pub struct FaceMesh {
    pub(crate) face: FaceModel,
    pub(crate) document: Document,
    pub(crate) units: Units,
    /// Photo-edit data, for files that Rosto reopens.
    pub(crate) photo_edit: Option<String>,
    /// The whole-face texture that was made last.
    texture: Option<Photo>,
}

impl FaceMesh {
    pub(crate) fn new(face: FaceModel, document: Document, units: Units) -> Self {
        Self { face, document, units, photo_edit: None, texture: None }
    }

    /// Opens a saved face. Edits without a solution are skipped, as when the page reopens it.
    ///
    /// # Errors
    /// [`Error::Face`], [`Error::Project`] or [`Error::Studio`].
    pub fn reopen(saved: SavedFace) -> Result<Self, Error> {
        let edits = saved.edits.unwrap_or_else(|| SavedEdits::none(Triangulation::Canonical, SMOOTH_DENSITY));
        let entries = edits.history.as_deref().map(project::from_json).transpose()?.unwrap_or_default();
        let face = FaceModel::from_photos(saved.photos, edits.triangulation)?;
        let document = Document::open(Rest::of_face(&face), entries, edits.density)?;
        Ok(Self { photo_edit: edits.photo_edit, ..Self::new(face, document, Units::Mm) })
    }

    /// The unedited face.
    pub fn face(&self) -> &FaceModel {
        &self.face
    }

    /// The mesh and its edits.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// Positions in metres, in the model's frame; the first 468 are the landmarks. With edits in image coordinates, in
    /// those.
    pub fn positions(&self) -> &[DVec3] {
        self.document.positions()
    }

    /// Triangles, counter-clockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.document.topology().triangles()
    }

    /// Texture coordinates of each vertex in the lead photo, from its top left corner.
    pub fn uvs(&self) -> Vec<DVec2> {
        self.document.from_cage(self.face.uvs())
    }

    /// sRGB colour of each vertex.
    pub fn colours_srgb(&self) -> Vec<[u8; 3]> {
        rosto_studio::vertex_colours(&self.face, &self.document)
    }

    /// The 468 edited landmarks in metres, in the model's frame.
    pub fn landmarks_m(&self) -> Vec<DVec3> {
        match self.units {
            Units::Mm => self.document.cage().to_vec(),
            Units::Image => landmarks_m_from_image(&self.face, self.document.cage()),
        }
    }

    /// Positions in MediaPipe's normalised coordinates.
    pub fn positions_image(&self) -> Vec<DVec3> {
        if self.units == Units::Image {
            return self.document.positions().to_vec();
        }
        let image_from_model: DMat3 = self.face.image_from_model();
        let moved = self.document.positions().iter().zip(self.document.rest());
        let moved = moved.map(|(now, before)| image_from_model * (*now - *before));
        let rest = self.document.from_cage(self.face.positions_image());
        rest.into_iter().zip(moved).map(|(before, moved)| before + moved).collect()
    }

    /// The whole-face texture of at most this size; made on the first call.
    ///
    /// # Errors
    /// [`Error::Studio`] if the face was built without its pictures.
    pub fn texture(&mut self, at_most_px: u32) -> Result<&Photo, Error> {
        let size_px =
            |view: &View| view.observation.picture.as_ref().map(|picture| [picture.width(), picture.height()]);
        let side_px = texture_side_px(&self.face, size_px, at_most_px);
        let texture = match self.texture.take().filter(|texture| texture.width() == side_px) {
            Some(texture) => texture,
            None => whole_texture(&self.face, side_px)?.picture,
        };
        Ok(self.texture.insert(texture))
    }

    /// The texture that was made last.
    pub fn into_texture(self) -> Option<Photo> {
        self.texture
    }

    /// Sets the texture that was made for the same photos before.
    pub fn with_texture(self, texture: Option<Photo>) -> Self {
        Self { texture, ..self }
    }

    /// Numbers of vertices and triangles of an exported mesh.
    pub fn counts(&self, format: Format, options: &FileOptions) -> [usize; 2] {
        let split = options.has_pieces(format).then(|| self.document.split_face());
        let topology = split.as_ref().map_or(self.document.topology(), |split| split.topology());
        [topology.vertex_count(), topology.triangles().len()]
    }

    /// The body for printing; `None` for the open surface.
    ///
    /// # Errors
    /// [`Error::Export`] if the body cannot be built.
    pub fn printed(&self, print: Print) -> Result<Option<PrintedBody>, Error> {
        Ok(self.with_model(None, |model| print.body(&model))?)
    }
}

/// Landmarks in metres after edits in image coordinates: transforms each image displacement into the model's frame.
pub fn landmarks_m_from_image(face: &FaceModel, landmarks: &[DVec3]) -> Vec<DVec3> {
    let model_from_image = face.image_from_model().inverse();
    let displacements_m =
        landmarks.iter().zip(face.positions_image()).map(|(edited, rest)| model_from_image * (*edited - *rest));
    displacements_m.zip(face.positions_m()).map(|(displacement_m, rest_m)| *rest_m + displacement_m).collect()
}
