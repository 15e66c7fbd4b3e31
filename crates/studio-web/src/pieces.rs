use glam::{DVec2, DVec3};
use rosto_face::SplitFace;
use rosto_session::OpenFace;
use rosto_viewport::{MeshInput, PictureOnGpu, Viewport};

use crate::error::Result;

/// A face with an expression on the GPU, with eyes and mouth as separate pieces. Lids and lips move in front of them,
/// and no triangles stretch between them.
pub(crate) struct Pieces {
    split_face: SplitFace,
    /// Positions of the pieces; they follow committed edits but not expressions.
    pieces_m: Vec<DVec3>,
}

impl Pieces {
    pub(crate) fn of(face: &OpenFace) -> Self {
        let split_face = face.document().split_face().darkened(face.model().colours_srgb());
        let mut pieces = Self { split_face, pieces_m: Vec::new() };
        pieces.update(face);
        pieces
    }

    /// Moves the pieces to the committed edits.
    pub(crate) fn update(&mut self, face: &OpenFace) {
        let base_m = face.document().without_expressions();
        self.pieces_m = self.split_face.positions_m(&base_m).split_off(base_m.len());
    }

    /// Shows the face with its pieces.
    pub(crate) fn show(
        &self,
        viewport: &mut Viewport,
        face: &OpenFace,
        uvs: &[DVec2],
        picture: Option<&PictureOnGpu>,
    ) -> Result<()> {
        viewport.show(&MeshInput {
            topology: self.split_face.topology(),
            positions_m: &self.positions_m(face.document().committed()),
            colours_srgb: &self.split_face.colours(&face.colours_srgb()),
            uvs: &self.split_face.uvs(uvs),
            picture,
        })?;
        Ok(viewport.set_before(&self.split_face.positions_m(face.document().rest()))?)
    }

    /// Positions of the mesh and of the pieces.
    pub(crate) fn positions_m(&self, mesh_m: &[DVec3]) -> Vec<DVec3> {
        mesh_m.iter().chain(&self.pieces_m).copied().collect()
    }

    /// Per-vertex values of the mesh, extended by one value for the pieces.
    pub(crate) fn values(&self, of_mesh: &[f64], on_pieces: f64) -> Vec<f64> {
        let mut values = of_mesh.to_vec();
        values.resize(self.split_face.topology().vertex_count(), on_pieces);
        values
    }
}
