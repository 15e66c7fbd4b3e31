use glam::DVec3;
use rosto_studio::{DocumentState, StudioError};

use super::OpenFace;
use crate::rows::Rows;
use crate::selection::Moving;
use crate::slider_influence::SliderInfluence;
use crate::{Selection, SessionError};

/// What a face holds that one step of several may change while a later one can still fail. The model, the document's meshes and
/// the photo are replaced in a last step, after which nothing fails.
pub(crate) struct FaceBefore {
    document: DocumentState,
    selection: Option<Selection>,
    refusal: Option<StudioError>,
    pins: Vec<u32>,
    seed: u64,
    moving: Moving,
    leaves_plane: bool,
    slider_influence: SliderInfluence,
    ways: Vec<DVec3>,
    rows: Rows,
}

impl OpenFace {
    pub(crate) fn before(&self) -> FaceBefore {
        FaceBefore {
            document: self.document.state(),
            selection: self.selection,
            refusal: self.refusal.clone(),
            pins: self.pins.clone(),
            seed: self.seed,
            moving: self.moving,
            leaves_plane: self.leaves_plane,
            slider_influence: self.slider_influence.clone(),
            ways: self.ways.clone(),
            rows: self.rows.clone(),
        }
    }

    pub(crate) fn restore(&mut self, state: FaceBefore) {
        self.document.restore(state.document);
        (self.selection, self.refusal, self.pins, self.seed) = (state.selection, state.refusal, state.pins, state.seed);
        (self.moving, self.leaves_plane) = (state.moving, state.leaves_plane);
        (self.slider_influence, self.ways, self.rows) = (state.slider_influence, state.ways, state.rows);
    }

    /// Takes all of some steps, or none if one of them fails.
    pub(crate) fn whole<T>(
        &mut self,
        steps: impl FnOnce(&mut Self) -> Result<T, SessionError>,
    ) -> Result<T, SessionError> {
        let before = self.before();
        let done = steps(self);
        if done.is_err() {
            self.restore(before);
        }
        done
    }
}
