use glam::DVec3;
use rosto_studio::Expression;
use serde::Serialize;
use tsify::Tsify;

use crate::Session;
use crate::open_face::OpenFace;
use crate::selection::Moving;

/// The edit in progress: the values that it moves, including earlier entries.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Tick {
    /// Whether an edit is in progress.
    pub is_editing: bool,
    /// Offset of the selection in mm, if it moves.
    pub offset_mm: Option<[f64; 3]>,
    /// Id and value in mm of the ready-made slider that moves.
    pub slider: Option<(&'static str, f64)>,
    /// Id and weight, 0..=1, of each expression that moves.
    pub expressions: Vec<(&'static str, f64)>,
    /// Share of its offset that the selected vertex reaches; 1 is all.
    pub share_reached: f64,
    /// Whether the drag exceeds the range of the sliders.
    pub is_at_end: bool,
    /// Axis to which the drag is constrained: "x", "y" or "z".
    pub along: Option<&'static str>,
    /// Whether the offset, or without an edit the committed one, is almost parallel to the view direction and so hardly
    /// visible.
    pub is_along_view: bool,
}

impl Session {
    /// Returns the progress of the edit.
    pub fn tick(&self) -> Tick {
        let tick = self.face().map(OpenFace::tick).unwrap_or_default();
        let along = self.dragged_axis().map(rosto_stage::Axis::id);
        Tick { is_at_end: self.is_at_end(), along, is_along_view: self.is_along_view(), ..tick }
    }

    /// Whether the offset of the edit in progress, or without one the committed offset, is within 14° of the view
    /// direction.
    pub(crate) fn is_along_view(&self) -> bool {
        const LEAST_MM: f64 = 0.5;
        let Some(face) = self.face() else { return false };
        let offset_mm = match face.moving() {
            Moving::Nothing => face.committed_mm(),
            Moving::Selection { offset_mm } => offset_mm,
            Moving::Slider { .. } | Moving::Expression { .. } => DVec3::ZERO,
        };
        let place_m = face.selected().and_then(|vertex| face.document().positions().get(vertex as usize).copied());
        let Some(place_m) = place_m.filter(|_| offset_mm.length() > LEAST_MM) else { return false };
        let along_mm = offset_mm.dot(self.stage().camera().to_eye(place_m));
        along_mm.abs() > 0.97 * offset_mm.length()
    }
}

impl OpenFace {
    fn tick(&self) -> Tick {
        let tick = Tick { is_editing: self.is_moving(), share_reached: self.share_reached(), ..Tick::default() };
        match self.moving() {
            Moving::Nothing => tick,
            Moving::Selection { .. } => Tick { offset_mm: Some(self.offset_mm().to_array()), ..tick },
            Moving::Slider { slider, .. } => Tick { slider: Some((slider.id(), self.slider_mm(slider))), ..tick },
            Moving::Expression { expression, partner } => {
                let weight = |expression: Expression| (expression.id(), self.weight(expression));
                let moved = [Some(expression), partner].into_iter().flatten();
                Tick { expressions: moved.map(|(expression, _)| weight(expression)).collect(), ..tick }
            }
        }
    }
}
