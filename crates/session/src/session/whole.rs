use super::{Result, Session};
use crate::gesture::Gesture;
use crate::{Intent, OpenFace};

/// An intent is carried out whole, or not at all.
impl Session {
    /// Whether an intent takes several steps of which a later one may fail. One that goes on with what is in hand is a single
    /// step, and is taken too often to copy anything before it.
    fn takes_steps(&self, intent: &Intent) -> bool {
        let face = self.face.as_ref();
        match intent {
            Intent::Preset(_)
            | Intent::Symmetrise(_)
            | Intent::Density(_)
            | Intent::PhotoLens(_)
            | Intent::AddPhoto(_)
            | Intent::RemovePhoto(_)
            | Intent::Triangulation(_) => true,
            Intent::Preview(_) => face.is_some_and(|face| face.is_sliding()),
            Intent::Slide(slider, _) => face.is_some_and(|face| face.slider() != Some(*slider)),
            Intent::Express(expression, _) => face.is_some_and(|face| face.expression() != Some(*expression)),
            Intent::Drag(..) => matches!(self.gesture, Gesture::Ready { .. }),
            _ => false,
        }
    }

    pub(super) fn carry_out_whole(&mut self, intent: Intent) -> Result {
        if !self.takes_steps(&intent) {
            return self.carry_out(intent);
        }
        let face = self.face.as_ref().map(OpenFace::before);
        let chosen = (self.choices, self.mode, self.view, self.seeds, self.brush_px);
        let shown = (self.gesture.clone(), self.under, self.stage.clone());
        let done = self.carry_out(intent);
        if done.is_err() {
            (self.choices, self.mode, self.view, self.seeds, self.brush_px) = chosen;
            (self.gesture, self.under, self.stage) = shown;
            if let (Some(face), Some(before)) = (&mut self.face, face) {
                face.restore(before);
            }
        }
        done
    }
}
