use glam::DVec3;
use rosto_face::{FaceModel, LANDMARK_COUNT, Triangulation};
use rosto_studio::{CoordinateFrame, Document, Rest};

use super::OpenFace;
use crate::edit_options::EditOptions;
use crate::error::SessionError;
use crate::{Selection, SelectionMode};

/// Changes of the mesh under the same edits.
impl OpenFace {
    /// Shows the cage subdivided `density` times. A selected point is replaced with the one at its position.
    pub(crate) fn set_density(
        &mut self,
        density: u32,
        mode: SelectionMode,
        edit_options: &EditOptions,
    ) -> Result<(), SessionError> {
        self.commit(edit_options);
        let is_point = mode == SelectionMode::Point || matches!(self.selection, Some(Selection::Point { .. }));
        let selected = self.selected().zip(self.selected_m()).filter(|_| is_point);
        self.document.set_density(density)?;
        if let Some((vertex, position_m)) = selected {
            let is_there = (vertex as usize) < self.document.rest().len();
            let vertex = if is_there { vertex } else { self.nearest(position_m) };
            self.selection = Some(self.at(vertex, SelectionMode::Point));
        }
        self.photo.invalidate();
        self.rows.read(&self.document, 0);
        self.prepare(edit_options);
        Ok(())
    }

    /// Changes the triangulation and reapplies the edits. Pinned points other than landmarks are unpinned.
    pub(crate) fn set_triangulation(
        &mut self,
        triangulation: Triangulation,
        edit_options: &EditOptions,
    ) -> Result<(), SessionError> {
        self.commit(edit_options);
        let position_m = self.selected_m();
        self.document = self.over(triangulation, self.model.positions_m().to_vec())?;
        self.model.set_triangulation(triangulation);
        self.pins.retain(|pin| (*pin as usize) < LANDMARK_COUNT);
        if let (Some(Selection::Point { level, .. }), Some(position_m)) = (self.selection, position_m) {
            self.selection = Some(Selection::Point { level, vertex: self.nearest(position_m) });
        }
        self.photo.invalidate();
        self.rows.read(&self.document, 0);
        self.prepare(edit_options);
        Ok(())
    }

    /// Replaces the model and reapplies the edits.
    pub(super) fn replace_model(&mut self, model: FaceModel, edit_options: &EditOptions) -> Result<(), SessionError> {
        self.commit(edit_options);
        self.document = self.over(model.triangulation(), model.positions_m().to_vec())?;
        self.model = model;
        self.photo.invalidate();
        self.rows.read(&self.document, 0);
        self.prepare(edit_options);
        Ok(())
    }

    fn over(&mut self, triangulation: Triangulation, positions_m: Vec<DVec3>) -> Result<Document, SessionError> {
        let rest = Rest::of_landmarks(triangulation.topology(), positions_m, CoordinateFrame::Model);
        let mut document = self.document.over(rest)?;
        document.set_density(self.document.density())?;
        Ok(document)
    }
}
