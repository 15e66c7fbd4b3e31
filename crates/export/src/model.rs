use glam::{DVec2, DVec3};
use rosto_face::{FaceModel, Photo};
use rosto_mesh::Topology;

use crate::ExportError;

pub(crate) const MM_PER_M: f64 = 1000.0;

/// What every exporter writes: a coloured, textured mesh, borrowed from whoever holds it.
#[derive(Debug, Clone, Copy)]
pub struct Model<'a> {
    /// The triangles.
    pub topology: &'a Topology,
    /// A position in metres for each vertex.
    pub positions_m: &'a [DVec3],
    /// The same surface softer, where there is such a one: what is printed where sharp folds leave no room for a wall.
    pub softer_m: Option<&'a [DVec3]>,
    /// An sRGB colour for each vertex.
    pub colours_srgb: &'a [[u8; 3]],
    /// The upright photo.
    pub photo: Picture<'a>,
    /// A picture of the whole face laid flat, if there is one: what the photo does not show is in it, too.
    /// Its sides are powers of two, as graphics cards want them.
    pub whole: Option<Picture<'a>>,
}

/// A picture that paints the mesh.
#[derive(Debug, Clone, Copy)]
pub struct Picture<'a> {
    /// Its pixels.
    pub pixels: &'a Photo,
    /// A place in it for each vertex, 0 to 1 from the top left; outside of that its edge goes on.
    pub uvs: &'a [DVec2],
}

impl<'a> Model<'a> {
    /// The face as the photo gave it.
    pub fn of_face(face: &'a FaceModel) -> Self {
        Self {
            topology: face.topology(),
            positions_m: face.positions_m(),
            softer_m: None,
            colours_srgb: face.colours_srgb(),
            photo: Picture { pixels: face.picture(), uvs: face.uvs() },
            whole: None,
        }
    }

    /// The same model with its vertices elsewhere, as after an edit.
    pub fn at(self, positions_m: &'a [DVec3]) -> Self {
        Self { positions_m, softer_m: None, ..self }
    }

    pub(crate) fn check(&self) -> Result<(), ExportError> {
        let expected = self.topology.vertex_count();
        let lengths = [
            ("positions", self.positions_m.len()),
            ("softer positions", self.softer_m.map_or(expected, <[DVec3]>::len)),
            ("colours", self.colours_srgb.len()),
            ("UVs", self.photo.uvs.len()),
            ("UVs of the whole texture", self.whole.map_or(expected, |whole| whole.uvs.len())),
        ];
        if let Some((what, found)) = lengths.into_iter().find(|(_, found)| *found != expected) {
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
