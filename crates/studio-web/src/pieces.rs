use glam::{DVec2, DVec3};
use rosto_face::SplitFace;
use rosto_session::OpenFace;
use rosto_viewport::{MeshInput, PictureOnGpu, Viewport};

use crate::error::Result;

/// A face on the GPU with eyes and mouth in pieces of their own, while it shows an expression: so its lids and lips move before
/// what lies behind them, and nothing is stretched between them.
pub(crate) struct Pieces {
    split_face: SplitFace,
    /// Where the pieces are; they follow edits from commit to commit, and expressions not at all.
    pieces_m: Vec<DVec3>,
}

impl Pieces {
    pub(crate) fn of(face: &OpenFace) -> Self {
        let split_face = face.document().split_face().darkened(face.model().colours_srgb());
        let mut pieces = Self { split_face, pieces_m: Vec::new() };
        pieces.settle(face);
        pieces
    }

    /// Puts the pieces to where the edits have taken them.
    pub(crate) fn settle(&mut self, face: &OpenFace) {
        let base_m = face.document().without_expressions();
        self.pieces_m = self.split_face.positions_m(&base_m).split_off(base_m.len());
    }

    /// Shows the face so.
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
            colours_srgb: &self.split_face.colours(&face.colours_srgb(&face.uvs())),
            uvs: &self.split_face.uvs(uvs),
            picture,
        })?;
        Ok(viewport.set_before(&self.split_face.positions_m(face.document().rest()))?)
    }

    /// Positions of the mesh, and those of the pieces.
    pub(crate) fn positions_m(&self, mesh_m: &[DVec3]) -> Vec<DVec3> {
        mesh_m.iter().chain(&self.pieces_m).copied().collect()
    }

    /// Values of the mesh, and what stands for them on the pieces.
    pub(crate) fn values(&self, of_mesh: &[f64], on_pieces: f64) -> Vec<f64> {
        let mut values = of_mesh.to_vec();
        values.resize(self.split_face.topology().vertex_count(), on_pieces);
        values
    }
}
