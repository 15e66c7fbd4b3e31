use super::{PER_CENT, Phrase, moved, shown, slid};
use crate::selection::Moving;
use crate::{Intent, OpenFace, Session};

/// Speech of screen readers about an intent.
impl Session {
    /// Announcement of an intent that is about to be applied.
    pub(crate) fn said_before(&self, intent: &Intent) -> Option<Phrase> {
        let face = self.face()?;
        let history = face.document().history();
        match intent {
            Intent::Commit => self.committed(face),
            Intent::Undo if history.can_undo() => Some(Phrase::word("undone")),
            Intent::Redo if history.can_redo() => Some(Phrase::word("redone")),
            Intent::Reset => Some(Phrase::word("was-reset")),
            Intent::ResetSelected => {
                let name = self.name_of(face.selection()?.target());
                Some(Phrase::word("was-reset.one").with("name", name))
            }
            Intent::ResetExpressions => Some(Phrase::word("expressions.rested")),
            Intent::Symmetrise(share) => Some(Phrase::word("symmetrised").number("n", PER_CENT * share, 0)),
            _ => None,
        }
    }

    fn committed(&self, face: &OpenFace) -> Option<Phrase> {
        match face.moving() {
            Moving::Nothing => None,
            Moving::Selection { .. } => moved(self, face),
            Moving::Slider { slider, .. } => Some(slid(slider, face.slider_mm(slider))),
            Moving::Expression { expression: (one, _), .. } => Some(shown(self, one, face.weight(one))),
        }
    }
}
