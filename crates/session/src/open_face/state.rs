use glam::DVec3;
use rosto_studio::{DocumentState, StudioError};

use super::OpenFace;
use crate::rows::Rows;
use crate::selection::Moving;
use crate::slider_influence::SliderInfluence;
use crate::{Selection, SessionError};

/// Snapshot of the parts of a face that change before the last fallible step. The model, the meshes and the photo are
/// replaced last, after which nothing fails.
pub(crate) struct FaceSnapshot {
    document: DocumentState,
    selection: Option<Selection>,
    refusal: Option<StudioError>,
    pins: Vec<u32>,
    seed: u64,
    moving: Moving,
    leaves_plane: bool,
    slider_influence: SliderInfluence,
    unit_offsets_m: Vec<DVec3>,
    rows: Rows,
}

impl OpenFace {
    pub(crate) fn snapshot(&self) -> FaceSnapshot {
        FaceSnapshot {
            document: self.document.state(),
            selection: self.selection,
            refusal: self.refusal.clone(),
            pins: self.pins.clone(),
            seed: self.seed,
            moving: self.moving,
            leaves_plane: self.leaves_plane,
            slider_influence: self.slider_influence.clone(),
            unit_offsets_m: self.unit_offsets_m.clone(),
            rows: self.rows.clone(),
        }
    }

    pub(crate) fn restore(&mut self, state: FaceSnapshot) {
        self.document.restore(state.document);
        (self.selection, self.refusal, self.pins, self.seed) = (state.selection, state.refusal, state.pins, state.seed);
        (self.moving, self.leaves_plane) = (state.moving, state.leaves_plane);
        (self.slider_influence, self.unit_offsets_m, self.rows) =
            (state.slider_influence, state.unit_offsets_m, state.rows);
    }

    /// Runs fallible steps; restores the face if one fails.
    pub(crate) fn transaction<T>(
        &mut self,
        steps: impl FnOnce(&mut Self) -> Result<T, SessionError>,
    ) -> Result<T, SessionError> {
        let snapshot = self.snapshot();
        let result = steps(self);
        if result.is_err() {
            self.restore(snapshot);
        }
        result
    }
}
