use glam::DVec3;
use rosto_studio::{Command, ConstraintKind, EditTarget, FaceSlider, Mirror};

use super::{MM_PER_M, OpenFace};
use crate::selection::Moving;

/// How far, and how, what is selected has moved and can move.
impl OpenFace {
    /// Where a slider stands, in mm: the sum of its entries that are in force, and the edit in progress.
    pub fn slider_mm(&self, slider: FaceSlider) -> f64 {
        let moving_mm = match self.moving {
            Moving::Slider { slider: moved, by_mm } if moved == slider => by_mm,
            _ => 0.0,
        };
        self.rows.in_force_mm(EditTarget::Slider(slider)) + moving_mm
    }

    /// The sum in mm of the entries in force that moved what is selected.
    pub fn kept_mm(&self) -> DVec3 {
        let Some(selection) = self.selection else { return DVec3::ZERO };
        let entries = self.document.history().entries();
        let offsets = self.rows.in_force(selection.target()).filter_map(|row| match &entries[row.index].command {
            Command::Move { offsets, .. } => offsets.first(),
            Command::Symmetrise { .. } => None,
        });
        offsets.sum::<DVec3>() * MM_PER_M
    }

    /// Whether the history holds edits in force of what is selected.
    pub fn can_reset_selection(&self) -> bool {
        self.selection.is_some_and(|selection| self.rows.in_force(selection.target()).next().is_some())
    }

    /// Whether what is selected is its own mirror image and the mirror is on, so that it cannot move along x.
    pub fn moves_in_plane(&self) -> bool {
        let Some(selection) = self.selection else { return false };
        let handles = selection.handles();
        let is_mirrored = self.document.spec().is_some_and(|spec| spec.settings.mirror == Mirror::On);
        let partner = |handle: u32| self.document.partner(selection.level(), handle);
        let is_own_image = |&handle: &u32| partner(handle).is_some_and(|partner| handles.contains(&partner));
        is_mirrored && handles.iter().all(is_own_image)
    }

    /// Share of its offset that the vertex selected reaches: 1 is all of it. What moves in the mirror's plane is moved by
    /// both its own offset and the mirrored one.
    pub fn share_reached(&self) -> f64 {
        match (self.document.spec().map(|spec| spec.settings.constraint), self.selected(), self.document.influence()) {
            (Some(ConstraintKind::Hard), ..) => 1.0,
            (Some(_), Some(vertex), Some(influence)) => {
                let share = |field: &[f64]| field.get(vertex as usize).copied().unwrap_or(0.0);
                share(&influence.direct) + if self.moves_in_plane() { share(&influence.mirrored) } else { 0.0 }
            }
            _ => 0.0,
        }
    }
}
