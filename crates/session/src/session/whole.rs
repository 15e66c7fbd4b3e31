use rosto_stage::Stage;

use super::{Result, Session};
use crate::gesture::{Gesture, Under};
use crate::open_face::FaceBefore;
use crate::seeds::Seeds;
use crate::{Choices, Intent, SelectionMode, View};

/// What a session holds that an intent may change before a later step of it fails.
struct SessionBefore {
    face: Option<FaceBefore>,
    choices: Choices,
    mode: SelectionMode,
    view: View,
    gesture: Gesture,
    under: Under,
    stage: Stage,
    seeds: Seeds,
    brush_px: Option<f64>,
}

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
        let before = self.state_before();
        let done = self.carry_out(intent);
        if done.is_err() {
            self.restore(before);
        }
        done
    }

    fn state_before(&self) -> SessionBefore {
        SessionBefore {
            face: self.face.as_ref().map(|face| face.before()),
            choices: self.choices,
            mode: self.mode,
            view: self.view,
            gesture: self.gesture.clone(),
            under: self.under,
            stage: self.stage.clone(),
            seeds: self.seeds,
            brush_px: self.brush_px,
        }
    }

    fn restore(&mut self, before: SessionBefore) {
        if let (Some(face), Some(state)) = (&mut self.face, before.face) {
            face.restore(state);
        }
        (self.choices, self.mode, self.view) = (before.choices, before.mode, before.view);
        (self.gesture, self.under, self.stage) = (before.gesture, before.under, before.stage);
        (self.seeds, self.brush_px) = (before.seeds, before.brush_px);
    }
}
