use glam::{DVec2, DVec3};
use rosto_face::{FaceModel, Photo};
use rosto_mesh::Topology;

use crate::ExportError;

/// What every exporter writes: a coloured, textured mesh, borrowed from whoever holds it.
#[derive(Debug, Clone, Copy)]
pub struct Model<'a> {
    /// The triangles.
    pub topology: &'a Topology,
    /// A position in metres for each vertex.
    pub positions_m: &'a [DVec3],
    /// An sRGB colour for each vertex.
    pub colours_srgb: &'a [[u8; 3]],
    /// A texture coordinate in the upright picture for each vertex, origin at the top left.
    pub uvs: &'a [DVec2],
    /// The upright picture.
    pub picture: &'a Photo,
}

impl<'a> Model<'a> {
    /// The face as the photo gave it.
    pub fn of_face(face: &'a FaceModel) -> Self {
        Self {
            topology: face.topology(),
            positions_m: face.positions_m(),
            colours_srgb: face.colours_srgb(),
            uvs: face.uvs(),
            picture: face.picture(),
        }
    }

    /// The same model with its vertices elsewhere, as after an edit.
    pub fn at(self, positions_m: &'a [DVec3]) -> Self {
        Self { positions_m, ..self }
    }

    pub(crate) fn check(&self) -> Result<(), ExportError> {
        let expected = self.topology.vertex_count();
        let lengths =
            [("positions", self.positions_m.len()), ("colours", self.colours_srgb.len()), ("UVs", self.uvs.len())];
        if let Some(&(what, found)) = lengths.iter().find(|(_, found)| *found != expected) {
            return Err(ExportError::LengthMismatch { what, expected, found });
        }
        if self.topology.triangles().is_empty() {
            return Err(ExportError::Empty);
        }
        match self.positions_m.iter().position(|p| !p.as_vec3().is_finite()) {
            Some(vertex) => Err(ExportError::NotFinite { vertex }),
            None => Ok(()),
        }
    }
}
