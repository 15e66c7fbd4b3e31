use glam::DVec3;
use rosto_studio::{Command, ConstraintKind, EditTarget, Expression, FaceSlider, Mirror};

use super::{MM_PER_M, OpenFace};
use crate::Choices;
use crate::rows::PER_CENT;
use crate::selection::Moving;

/// No hand is followed by less than this share: what is shown of a handle is never rounded off so much.
const LEAST_SHARE: f64 = 0.25;

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

    /// How much of each expression the face shows, 0..=1 as far as sliders go: the sum of its entries that are in force, and the
    /// edit in progress.
    pub fn weights(&self) -> [f64; Expression::ALL.len()] {
        let mut weights = [0.0; Expression::ALL.len()];
        for row in self.rows() {
            if let (EditTarget::Expression(expression), true) = (row.target, row.counts()) {
                weights[expression as usize] += row.amount / PER_CENT;
            }
        }
        if let Moving::Expression { expression, partner } = self.moving {
            let both = [Some(expression), partner].into_iter().flatten();
            both.for_each(|(expression, by)| weights[expression as usize] += by);
        }
        weights
    }

    /// What the history holds of an expression.
    pub(super) fn kept_weight(&self, expression: Expression) -> f64 {
        self.rows.in_force(EditTarget::Expression(expression)).map(|row| row.amount / PER_CENT).sum()
    }

    /// The sum in mm of the entries in force that moved what is selected.
    pub fn kept_mm(&self) -> DVec3 {
        let Some(selection) = self.selection else { return DVec3::ZERO };
        let entries = self.document.history().entries();
        let offsets = self.rows.in_force(selection.target()).filter_map(|row| match &entries[row.index].command {
            Command::Move { offsets, .. } => offsets.first(),
            Command::Symmetrise { .. } | Command::Express { .. } => None,
        });
        offsets.sum::<DVec3>() * MM_PER_M
    }

    /// Whether the history holds edits in force of what is selected.
    pub fn can_reset_selection(&self) -> bool {
        self.selection.is_some_and(|selection| self.rows.in_force(selection.target()).next().is_some())
    }

    /// Whether what is selected is its own mirror image and the mirror is on: up, down and out it moves both sides alike, and
    /// sideways alone.
    pub fn lies_in_plane(&self, choices: &Choices) -> bool {
        choices.mirror == Mirror::On && self.is_own_image()
    }

    fn is_own_image(&self) -> bool {
        let Some(selection) = self.selection else { return false };
        let handles = selection.handles();
        let partner = |handle: u32| self.document.partner(selection.level(), handle);
        handles.iter().all(|&handle| partner(handle).is_some_and(|partner| handles.contains(&partner)))
    }

    /// Whether the edit in progress is one of both halves of what is its own mirror image.
    fn moves_as_own_image(&self) -> bool {
        let is_mirrored = self.document.spec().is_some_and(|spec| spec.settings.mirror == Mirror::On);
        is_mirrored && self.is_own_image()
    }

    /// Share of its offset that the vertex selected reaches: 1 is all of it. What moves in the mirror's plane is moved by
    /// both its own offset and the mirrored one.
    pub fn share_reached(&self) -> f64 {
        let (Some(vertex), Some(influence)) = (self.selected(), self.document.influence()) else { return 0.0 };
        let share = |field: &[f64]| field.get(vertex as usize).copied().unwrap_or(0.0);
        share(&influence.direct) + if self.moves_as_own_image() { share(&influence.mirrored) } else { 0.0 }
    }

    /// The offset that takes the vertex selected, as it is shown, by `way_mm`. Where it is a hard constraint of a coarser mesh,
    /// the one that is shown rounds it off; a soft one is to give way.
    pub(crate) fn offset_for(&self, way_mm: DVec3) -> DVec3 {
        let constraint = self.document.spec().map(|spec| spec.settings.constraint);
        let share = if constraint == Some(ConstraintKind::Hard) { self.share_reached() } else { 1.0 };
        way_mm / share.clamp(LEAST_SHARE, 1.0)
    }
}
