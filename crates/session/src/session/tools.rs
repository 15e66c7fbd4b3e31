use super::Session;
use crate::{Intent, OpenFace};

/// The marks at the selection.
impl Session {
    /// Whether an intent works at the selection or moves the pointer over the canvas, so that the marks are shown.
    pub(super) fn uses_tools(&self, intent: &Intent) -> bool {
        match intent {
            // The face can also move under a resting pointer.
            Intent::Hover(position_px) => position_px.is_some() && *position_px != self.pointer_px,
            Intent::Press(..)
            | Intent::Drag(..)
            | Intent::Along(_)
            | Intent::Release
            | Intent::PointAt(_)
            | Intent::Mode(_)
            | Intent::Select(_)
            | Intent::SelectAt(_)
            | Intent::SelectUnder(_)
            | Intent::Pin(_)
            | Intent::PinUnder(_)
            | Intent::Radius(_)
            | Intent::Offset(_)
            | Intent::Commit
            | Intent::Cancel => true,
            _ => false,
        }
    }

    /// Shows the marks: during an edit without an end, else for a moment.
    pub(super) fn use_tools(&mut self) {
        let is_held = self.has_grabbed() || self.face().is_some_and(OpenFace::is_moving);
        self.stage.use_tools(is_held);
    }
}
