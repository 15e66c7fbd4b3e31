mod appearance;
mod card;
mod dispatch;
mod editing;
#[cfg(test)]
mod faults;
mod files;
mod intent;
mod live_preview;
mod opening;
mod panel_state;
mod photo;
mod pointing;
mod preferences;
mod selecting;
mod texturing;
mod tools;
mod transaction;

use glam::DVec2;
use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Axis, Stage, Visibility};

use crate::files::Files;
use crate::gesture::{Gesture, Hovered};
use crate::live_preview::LivePreview;
use crate::open_face::OpenFace;
use crate::panel_state::PanelState;
use crate::seeds::Seeds;
use crate::texture::TextureRequests;
use crate::{Changed, EditOptions, SelectionMode, SessionError, View, marks};
pub use intent::Intent;
pub use photo::{BRUSH_PX, FALLOFF_BAND};

/// A user's session: the open face, settings, selection, edit in progress and view.
///
/// [`Session::apply`] performs the user's actions; a refused intent changes nothing. Camera frames, the worker's
/// texture and the stage's size are set by separate methods.
pub struct Session {
    face: Option<OpenFace>,
    edit_options: EditOptions,
    mode: SelectionMode,
    view: View,
    gesture: Gesture,
    hovered: Hovered,
    /// Position of the pointer over the canvas, in px.
    pointer_px: Option<DVec2>,
    stage: Stage,
    seeds: Seeds,
    brush_px: Option<f64>,
    /// Marked corners of a card in px of the photo, while it is being marked.
    card_px: Option<Vec<DVec2>>,
    live_preview: Option<LivePreview>,
    textures: TextureRequests,
    pub(crate) panel: PanelState,
    pub(crate) files: Files,
}

type Result<T = Changed, E = SessionError> = std::result::Result<T, E>;

impl Session {
    /// Creates a session without a face; `seed` determines all random anchors.
    pub fn new(seed: u64) -> Self {
        let mut session = Self {
            face: None,
            edit_options: EditOptions::default(),
            mode: SelectionMode::default(),
            view: View::default(),
            gesture: Gesture::default(),
            hovered: Hovered::default(),
            pointer_px: None,
            stage: Stage::default(),
            seeds: Seeds::new(seed),
            brush_px: None,
            card_px: None,
            live_preview: None,
            textures: TextureRequests::default(),
            panel: PanelState::default(),
            files: Files::default(),
        };
        session.stage.render_settings_mut().dotted = Some(LANDMARK_COUNT as u32);
        session.show_empty();
        session
    }

    /// The open face.
    pub fn face(&self) -> Option<&OpenFace> {
        self.face.as_ref()
    }

    /// The open face, or an error.
    pub(crate) fn open_face(&self) -> Result<&OpenFace, SessionError> {
        self.face.as_ref().ok_or(SessionError::NoFace)
    }

    /// The settings of edits.
    pub fn edit_options(&self) -> &EditOptions {
        &self.edit_options
    }

    /// Kind of selection made by a click or a drag.
    pub fn mode(&self) -> SelectionMode {
        self.mode
    }

    /// View settings, which take effect when a face is open.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Density of the displayed mesh, or of the next face's without a face.
    pub fn density(&self) -> u32 {
        self.face().map_or(self.view.density, |face| face.document().density())
    }

    /// The stage to draw.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// The stage, for the renderer to advance its animations.
    pub fn stage_mut(&mut self) -> &mut Stage {
        &mut self.stage
    }

    /// The vertex and gizmo axis under the pointer.
    pub fn hovered(&self) -> Hovered {
        self.hovered
    }

    /// Whether the pressed pointer has grabbed something; if not, it orbits the view.
    pub fn has_grabbed(&self) -> bool {
        self.gesture != Gesture::Idle
    }

    /// Whether the selection is being dragged.
    pub fn is_dragging(&self) -> bool {
        matches!(self.gesture, Gesture::Dragging { .. })
    }

    /// Whether the drag exceeds the range of the sliders.
    pub(crate) fn is_at_end(&self) -> bool {
        matches!(self.gesture, Gesture::Dragging { is_at_end: true, .. })
    }

    /// Axis to which the drag is constrained.
    pub(crate) fn dragged_axis(&self) -> Option<Axis> {
        match self.gesture {
            Gesture::Dragging { axis, .. } => axis,
            _ => None,
        }
    }

    /// Applies a user action completely or not at all; returns what changed.
    ///
    /// # Errors
    /// [`SessionError`] if the action is refused; the session is unchanged.
    pub fn apply(&mut self, intent: Intent) -> Result {
        let intent = self.resolved(intent)?;
        let uses_tools = self.uses_tools(&intent);
        let changed = self.apply_atomically(intent)?;
        if uses_tools {
            self.use_tools();
        }
        if changed >= Changed::Document {
            self.check_pointer();
            self.show_marks();
            self.update_tape();
            self.files.outdate();
        }
        if changed >= Changed::Tick {
            marks::show_offset(&mut self.stage, self.face.as_ref());
        }
        Ok(changed)
    }

    fn show_marks(&mut self) {
        let pointed = self.pointed();
        let marked = self.face.as_ref().filter(|_| self.view.print == Visibility::Hidden);
        marks::show(&mut self.stage, marked, self.view.anchors, pointed);
    }
}
