use super::{Result, Session};
use crate::gesture::Gesture;
use crate::{Intent, OpenFace};

/// Atomic application of intents.
impl Session {
    /// Whether an intent has several steps of which a later one can fail. Ticks of the current edit have one step and
    /// are too frequent for a snapshot.
    fn has_several_steps(&self, intent: &Intent) -> bool {
        let face = self.face.as_ref();
        match intent {
            Intent::Preset(_)
            | Intent::Look(_)
            | Intent::Symmetrise(_)
            | Intent::Density(_)
            | Intent::PhotoLens(_)
            | Intent::ForgetCard
            | Intent::AddPhoto(_)
            | Intent::RemovePhoto(_)
            | Intent::Triangulation(_) => true,
            Intent::Offset(_) => face.is_some_and(|face| face.is_sliding()),
            Intent::Slide(slider, _) => face.is_some_and(|face| face.slider() != Some(*slider)),
            Intent::Express(expression, _) => face.is_some_and(|face| face.expression() != Some(*expression)),
            Intent::Press(..) => self.card_px.is_some(),
            Intent::Drag(..) => matches!(self.gesture, Gesture::Pressed { .. }),
            _ => false,
        }
    }

    pub(super) fn apply_atomically(&mut self, intent: Intent) -> Result {
        if !self.has_several_steps(&intent) {
            return self.dispatch(intent);
        }
        let face = self.face.as_ref().map(OpenFace::snapshot);
        let chosen = (self.edit_options, self.mode, self.view, self.seeds, self.brush_px);
        let shown = (self.gesture.clone(), self.hovered, self.stage.clone());
        let done = self.dispatch(intent);
        if done.is_err() {
            (self.edit_options, self.mode, self.view, self.seeds, self.brush_px) = chosen;
            (self.gesture, self.hovered, self.stage) = shown;
            if let (Some(face), Some(before)) = (&mut self.face, face) {
                face.restore(before);
            }
        }
        done
    }
}
