mod appearance;
mod editing;
#[cfg(test)]
mod faults;
mod live_preview;
mod opening;
mod photo;
mod pointing;
mod preferences;
mod selecting;
mod texturing;
mod transaction;

use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Scene, Stage};
use rosto_studio::{Document, Switch};

use crate::gesture::{Gesture, Hovered};
use crate::live_preview::LivePreview;
use crate::open_face::OpenFace;
use crate::seeds::Seeds;
use crate::strokes::Strokes;
use crate::{Changed, EditOptions, Intent, SelectionMode, SessionError, View, marks};
pub use photo::BRUSH_PX;

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
    stage: Stage,
    seeds: Seeds,
    brush_px: Option<f64>,
    live_preview: Option<LivePreview>,
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
            stage: Stage::default(),
            seeds: Seeds::new(seed),
            brush_px: None,
            live_preview: None,
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

    /// Applies a user action completely or not at all; returns what changed.
    ///
    /// # Errors
    /// [`SessionError`] if the action is refused; the session is unchanged.
    pub fn apply(&mut self, intent: Intent) -> Result {
        let is_in_hand = intent.ends_idle_rotation();
        let changed = self.apply_atomically(intent)?;
        if is_in_hand {
            self.stage.end_swing();
        }
        if changed >= Changed::Document {
            self.check_pointer();
            self.show_marks();
            self.keep_in_frame();
        }
        if changed >= Changed::Tick {
            marks::show_offset(&mut self.stage, self.face.as_ref());
        }
        Ok(changed)
    }

    fn dispatch(&mut self, intent: Intent) -> Result {
        match intent {
            Intent::Open(incoming) => self.open(*incoming),
            Intent::Close => self.close(),
            Intent::RestorePreferences(text) => self.prefer(&text),
            Intent::Mode(mode) => self.set_mode(mode),
            Intent::Select(selection) => self.select(selection),
            Intent::SelectAt(vertex) => self.select_at(vertex),
            Intent::SelectUnder(position_px) => self.select_under(position_px),
            Intent::Pin(switch) => self.pin_selected(switch),
            Intent::PinUnder(position_px) => self.toggle_pin_at(position_px),
            Intent::Preset(preset) => self.set_preset(preset),
            Intent::Operator(operator) => self.choose(EditOptions { operator, ..self.edit_options }),
            Intent::Constraint(constraint) => self.choose(EditOptions { constraint, ..self.edit_options }),
            Intent::Details(details) => self.choose(EditOptions { details, ..self.edit_options }),
            Intent::Anchors(anchors) => self.choose(EditOptions { anchors, ..self.edit_options }),
            Intent::Mirror(mirror) => self.choose(EditOptions { mirror, ..self.edit_options }),
            Intent::Nearby(switch) => self.choose(EditOptions { is_nearby: switch == Switch::On, ..self.edit_options }),
            Intent::Radius(radius_mm) => self.choose(self.edit_options.with_radius(radius_mm)?),
            Intent::Widen(factor) => self.widen(factor),
            Intent::Preview(offset_mm) => self.preview(offset_mm),
            Intent::Slide(slider, to_mm) => self.slide(slider, to_mm),
            Intent::Express(expression, to) => self.express(expression, to),
            Intent::Commit => self.finish(OpenFace::commit),
            Intent::Cancel => self.cancel(),
            Intent::Hover(position_px) => Ok(self.hover(position_px)),
            Intent::PointAt(landmark) => self.point_at(landmark),
            Intent::Press(position_px, pointer) => Ok(self.press(position_px, pointer)),
            Intent::Drag(position_px, pace) => self.drag(position_px, pace),
            Intent::Along(axis) => self.drag_along(axis),
            Intent::Release => self.release(),
            Intent::Undo if self.brush_px.is_some() => self.change_strokes(Strokes::undo),
            Intent::Redo if self.brush_px.is_some() => self.change_strokes(Strokes::redo),
            Intent::ClearStrokes => self.change_strokes(Strokes::clear),
            Intent::Undo => self.undo(),
            Intent::Redo => self.finish(|face, edit_options| face.change_history(edit_options, Document::redo)),
            Intent::Reset => self.reset(),
            Intent::ResetSelected => self.reset_selected(),
            Intent::ResetExpressions => self.reset_expressions(),
            Intent::Switch(index, switch) => self.switch(index, switch),
            Intent::Symmetrise(share) => self.symmetrise(share),
            Intent::Density(density) => self.set_density(density),
            Intent::PhotoLens(lens) => self.set_photo_lens(lens),
            Intent::AddPhoto(photo) => self.change_photos(|face, edit_options| face.add_photo(&photo, edit_options)),
            Intent::RemovePhoto(photo) => {
                self.change_photos(|face, edit_options| face.remove_photo(photo, edit_options))
            }
            Intent::Triangulation(triangulation) => self.set_triangulation(triangulation),
            Intent::Scene(scene) => Ok(self.set_scene(scene)),
            Intent::FalloffBand(share) => self.set_falloff_band(share),
            Intent::SeenFrom(distance_m) => self.set_seen_from(distance_m),
            Intent::Brush(radius_px) => self.set_brush(radius_px),
            Intent::ShowDepth => self.show_depth(),
            Intent::TextureSource(texture_source) => Ok(self.set_texture_source(texture_source)),
            Intent::TextureSize(size) => Ok(self.set_texture_size(size)),
            seen => self.see(seen),
        }
    }

    /// Frames a face again that has grown out of the view, once the edit has ended.
    fn keep_in_frame(&mut self) {
        let is_free = self.stage.scene() == Scene::Solid;
        if let Some(face) = self.face.as_ref().filter(|face| is_free && !face.is_moving()) {
            self.stage.reframe(face.document().committed());
        }
    }

    fn show_marks(&mut self) {
        let pointed = self.pointed();
        marks::show(&mut self.stage, self.face.as_ref(), self.view.anchors, pointed);
    }
}
