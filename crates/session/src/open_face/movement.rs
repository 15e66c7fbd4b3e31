use glam::DVec3;
use rosto_studio::{Command, ConstraintKind, EditTarget, Expression, FaceSlider, Mirror};

use super::{MM_PER_M, OpenFace};
use crate::EditOptions;
use crate::rows::PER_CENT;
use crate::selection::Moving;

/// Lower bound of the share of its offset that a handle reaches. Interpolation reduces a displayed handle less than
/// that.
const MIN_SHARE: f64 = 0.25;

/// Amounts and limits of edits.
impl OpenFace {
    /// Value of a slider in mm: the sum of its entries in force, and the amount of it in edits by hand, with the edit in
    /// progress. A drag of the chin moves the slider of its length, too.
    pub fn slider_mm(&self, slider: FaceSlider) -> f64 {
        let moving_mm = match self.moving {
            Moving::Slider { slider: moved, by_mm } if moved == slider => by_mm,
            Moving::Selection { .. } => self.document.preview_amounts_m()[slider as usize] * MM_PER_M,
            _ => 0.0,
        };
        self.rows.slider_mm(slider) + moving_mm
    }

    /// Weight of each expression, 0..=1 within the sliders' range: the sum of its entries in force and the edit in
    /// progress.
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

    /// Weight of an expression, as in [`Self::weights`].
    pub fn weight(&self, expression: Expression) -> f64 {
        let moving = match self.moving {
            Moving::Expression { expression, partner } => [Some(expression), partner],
            _ => [None; 2],
        };
        let moving = moving.into_iter().flatten().filter(|(moved, _)| *moved == expression).map(|(_, by)| by);
        self.committed_weight(expression) + moving.sum::<f64>()
    }

    /// Sum of an expression's entries in force.
    pub(super) fn committed_weight(&self, expression: Expression) -> f64 {
        self.rows.in_force(EditTarget::Expression(expression)).map(|row| row.amount / PER_CENT).sum()
    }

    /// Sum in mm of the entries in force that moved the selection.
    pub fn committed_mm(&self) -> DVec3 {
        let Some(selection) = self.selection else { return DVec3::ZERO };
        let entries = self.document.history().entries();
        let offsets = self.rows.in_force(selection.target()).filter_map(|row| match &entries[row.index].command {
            Command::Move { offsets, .. } => offsets.first(),
            Command::Symmetrise { .. } | Command::Express { .. } => None,
        });
        offsets.sum::<DVec3>() * MM_PER_M
    }

    /// Offset of the selection in mm: the sum of its entries in force and the edit in progress.
    pub fn offset_mm(&self) -> DVec3 {
        match self.moving {
            Moving::Selection { offset_mm } => self.committed_mm() + offset_mm,
            _ => self.committed_mm(),
        }
    }

    /// Whether the history contains entries in force that moved the selection.
    pub fn can_reset_selection(&self) -> bool {
        self.selection.is_some_and(|selection| self.rows.in_force(selection.target()).next().is_some())
    }

    /// Whether the selection is its own mirror image and the mirror is on. Both sides then move alike, except sideways,
    /// where the selection moves without the mirror.
    pub fn lies_in_plane(&self, edit_options: &EditOptions) -> bool {
        edit_options.mirror == Mirror::On && self.is_own_image()
    }

    fn is_own_image(&self) -> bool {
        let Some(selection) = self.selection else { return false };
        let handles = selection.handles();
        let partner = |handle: u32| self.document.partner(selection.level(), handle);
        handles.iter().all(|&handle| partner(handle).is_some_and(|partner| handles.contains(&partner)))
    }

    /// Whether the edit in progress is mirrored and the selection is its own mirror image.
    fn moves_as_own_image(&self) -> bool {
        let is_mirrored = self.document.spec().is_some_and(|spec| spec.settings.mirror == Mirror::On);
        is_mirrored && self.is_own_image()
    }

    /// Share of its offset that the selected vertex reaches, where 1 is all. In the mirror plane, both the offset and
    /// its mirror image contribute.
    pub fn share_reached(&self) -> f64 {
        let (Some(vertex), Some(influence)) = (self.selected(), self.document.influence()) else { return 0.0 };
        let share = |field: &[f64]| field.get(vertex as usize).copied().unwrap_or(0.0);
        share(&influence.direct) + if self.moves_as_own_image() { share(&influence.mirrored) } else { 0.0 }
    }

    /// Offset that moves the displayed position of the selected vertex by `displacement_mm`. Subdivision reduces the
    /// displacement of a hard constraint on a coarser mesh, which this compensates; soft constraints are meant to
    /// yield.
    pub(crate) fn offset_for(&self, displacement_mm: DVec3) -> DVec3 {
        let constraint = self.document.spec().map(|spec| spec.settings.constraint);
        let share = if constraint == Some(ConstraintKind::Hard) { self.share_reached() } else { 1.0 };
        displacement_mm / share.clamp(MIN_SHARE, 1.0)
    }
}
