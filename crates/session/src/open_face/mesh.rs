use glam::DVec3;
use rosto_face::{FaceModel, LANDMARK_COUNT, PhotoLens, Triangulation};
use rosto_studio::{CoordinateFrame, Document, Rest};

use super::OpenFace;
use crate::choices::Choices;
use crate::error::SessionError;
use crate::{Selection, SelectionMode};

/// Another mesh for the same edits.
impl OpenFace {
    /// Shows the cage subdivided so many times. A point that is selected becomes that of the new mesh.
    pub(crate) fn set_density(
        &mut self,
        density: u32,
        mode: SelectionMode,
        choices: &Choices,
    ) -> Result<(), SessionError> {
        self.commit(choices);
        let is_point = mode == SelectionMode::Point || matches!(self.selection, Some(Selection::Point { .. }));
        let selected = self.selected().zip(self.selected_m()).filter(|_| is_point);
        self.document.set_density(density)?;
        if let Some((vertex, place_m)) = selected {
            let is_there = (vertex as usize) < self.document.rest().len();
            let vertex = if is_there { vertex } else { self.nearest(place_m) };
            self.selection = Some(self.at(vertex, SelectionMode::Point));
        }
        self.photo.forget();
        self.rows.read(&self.document, 0);
        self.prepare(choices);
        Ok(())
    }

    /// Joins the landmarks by other triangles; the edits are carried out again. Points that were pinned are free again.
    pub(crate) fn set_triangulation(
        &mut self,
        triangulation: Triangulation,
        choices: &Choices,
    ) -> Result<(), SessionError> {
        self.commit(choices);
        let place_m = self.selected_m();
        self.document = self.over(triangulation, self.model.positions_m().to_vec())?;
        self.triangulation = triangulation;
        self.pins.retain(|pin| (*pin as usize) < LANDMARK_COUNT);
        if let (Some(Selection::Point { level, .. }), Some(place_m)) = (self.selection, place_m) {
            self.selection = Some(Selection::Point { level, vertex: self.nearest(place_m) });
        }
        self.photo.forget();
        self.rows.read(&self.document, 0);
        self.prepare(choices);
        Ok(())
    }

    /// The face as it is if its photo was taken through that lens; the edits are carried out again.
    pub(crate) fn set_photo_lens(&mut self, lens: PhotoLens, choices: &Choices) -> Result<(), SessionError> {
        let model = self.model.with_lens(lens)?;
        self.see_as(model, choices)
    }

    /// The same edits of the face as another model has it.
    pub(super) fn see_as(&mut self, model: FaceModel, choices: &Choices) -> Result<(), SessionError> {
        self.commit(choices);
        self.document = self.over(self.triangulation, model.positions_m().to_vec())?;
        self.model = model;
        // What its camera sees is seen from elsewhere.
        self.texture = None;
        self.photo.forget();
        self.rows.read(&self.document, 0);
        self.prepare(choices);
        Ok(())
    }

    fn over(&mut self, triangulation: Triangulation, positions_m: Vec<DVec3>) -> Result<Document, SessionError> {
        let rest = Rest::new(triangulation.topology(), positions_m, CoordinateFrame::Model);
        let mut document = self.document.over(rest)?;
        document.set_density(self.document.density())?;
        Ok(document)
    }
}
