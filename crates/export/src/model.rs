use glam::{DVec2, DVec3};
use rosto_face::{FaceModel, Gaze, Photo};
use rosto_mesh::Topology;

use crate::ExportError;

pub(crate) const MM_PER_M: f64 = 1000.0;

/// Input of the exporters: a borrowed mesh with colours and textures.
#[derive(Debug, Clone, Copy)]
pub struct Model<'a> {
    /// Triangles.
    pub topology: &'a Topology,
    /// Position of each vertex, in metres.
    pub positions_m: &'a [DVec3],
    /// A smoothed version of the positions, if any, used for printing where sharp folds leave no room for a wall.
    pub smoothed_m: Option<&'a [DVec3]>,
    /// The eyes, which a print carves; `None` leaves them as they are.
    pub eyes: Option<ModelEyes<'a>>,
    /// sRGB colour of each vertex.
    pub colours_srgb: &'a [[u8; 3]],
    /// The upright photo, if its pixels are known.
    pub photo: Option<Picture<'a>>,
    /// The whole-face texture, if any, which also covers parts that the photo does not show. Its sides are powers of
    /// two, as some GPUs require.
    pub whole: Option<Picture<'a>>,
}

/// Place of the eyes in a mesh.
#[derive(Debug, Clone, Copy)]
pub struct ModelEyes<'a> {
    /// Triangles of the 468 landmarks, of which the mesh is a subdivision, with its triangles in the order of their
    /// parents.
    pub face: &'a [[u32; 3]],
    /// Gaze of the right and the left eye, if known.
    pub gazes: [Option<Gaze>; 2],
}

/// A picture mapped onto the mesh.
#[derive(Debug, Clone, Copy)]
pub struct Picture<'a> {
    /// Its pixels.
    pub pixels: &'a Photo,
    /// UV of each vertex, 0 to 1 from the top left; edge pixels extend beyond.
    pub uvs: &'a [DVec2],
}

impl<'a> Model<'a> {
    /// The unedited face.
    pub fn of_face(face: &'a FaceModel) -> Self {
        Self {
            topology: face.topology(),
            positions_m: face.positions_m(),
            smoothed_m: None,
            eyes: None,
            colours_srgb: face.colours_srgb(),
            photo: face.picture().map(|pixels| Picture { pixels, uvs: face.uvs() }),
            whole: None,
        }
    }

    /// The same model with other vertex positions, such as after an edit.
    pub fn at(self, positions_m: &'a [DVec3]) -> Self {
        Self { positions_m, smoothed_m: None, ..self }
    }

    pub(crate) fn check(&self) -> Result<(), ExportError> {
        let expected = self.topology.vertex_count();
        let lengths = [
            ("positions", self.positions_m.len()),
            ("smoothed positions", self.smoothed_m.map_or(expected, <[DVec3]>::len)),
            ("colours", self.colours_srgb.len()),
            ("UVs", self.photo.map_or(expected, |photo| photo.uvs.len())),
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
