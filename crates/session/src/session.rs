#[cfg(test)]
mod faults;
mod in_photo;
mod live_preview;
mod moving;
mod opening;
mod pointing;
mod seeing;
mod selecting;
mod texturing;
mod whole;

use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Scene, Stage};
use rosto_studio::{Document, Switch};

use crate::gesture::{Gesture, Under};
use crate::live_preview::LivePreview;
use crate::open_face::OpenFace;
use crate::seeds::Seeds;
use crate::strokes::Strokes;
use crate::{Changed, Choices, Intent, SelectionMode, SessionError, View, marks};
pub use in_photo::BRUSH_PX;
pub(crate) use seeing::checked;

/// Everything of a visitor's session: the open face, what is chosen, selected and moved, and what is seen.
///
/// [`Session::apply`] carries out what the user asks for; an intent that is refused changes nothing. Camera frames, the
/// texture that the worker made and the stage's size come in through methods of their own.
pub struct Session {
    face: Option<OpenFace>,
    choices: Choices,
    mode: SelectionMode,
    view: View,
    gesture: Gesture,
    under: Under,
    stage: Stage,
    seeds: Seeds,
    brush_px: Option<f64>,
    live_preview: Option<LivePreview>,
}

type Result<T = Changed, E = SessionError> = std::result::Result<T, E>;

impl Session {
    /// A session in which no face is open; `seed` leads to all random anchors that are ever drawn.
    pub fn new(seed: u64) -> Self {
        let mut session = Self {
            face: None,
            choices: Choices::default(),
            mode: SelectionMode::default(),
            view: View::default(),
            gesture: Gesture::default(),
            under: Under::default(),
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

    /// The same where there must be one.
    pub(crate) fn open_face(&self) -> Result<&OpenFace, SessionError> {
        self.face.as_ref().ok_or(SessionError::NoFace)
    }

    /// How edits are to spread.
    pub fn choices(&self) -> &Choices {
        &self.choices
    }

    /// What a click or a drag selects.
    pub fn mode(&self) -> SelectionMode {
        self.mode
    }

    /// What was asked for that only a face shows.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// What is seen and how, apart from the GPU.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// The same for who draws it: time moves it on.
    pub fn stage_mut(&mut self) -> &mut Stage {
        &mut self.stage
    }

    /// What lies under the pointer.
    pub fn under(&self) -> Under {
        self.under
    }

    /// Whether the pressed pointer has grabbed something; if not, it turns the face.
    pub fn has_grabbed(&self) -> bool {
        self.gesture != Gesture::Idle
    }

    /// Whether something is being dragged.
    pub fn is_dragging(&self) -> bool {
        matches!(self.gesture, Gesture::Dragging { .. })
    }

    /// Whether what is dragged would go further than its sliders do.
    pub(crate) fn is_at_end(&self) -> bool {
        matches!(self.gesture, Gesture::Dragging { is_at_end: true, .. })
    }

    /// Carries out what a visitor wants: all of it, or nothing. Tells what has changed.
    ///
    /// # Errors
    /// [`SessionError`] for what cannot be done; the session is as it was before.
    pub fn apply(&mut self, intent: Intent) -> Result {
        let is_in_hand = intent.takes_in_hand();
        let changed = self.carry_out_whole(intent)?;
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

    fn carry_out(&mut self, intent: Intent) -> Result {
        match intent {
            Intent::Open(incoming) => self.open(*incoming),
            Intent::Close => self.close(),
            Intent::Prefer(text) => self.prefer(&text),
            Intent::Mode(mode) => self.set_mode(mode),
            Intent::Select(selection) => self.select(selection),
            Intent::SelectAt(vertex) => self.select_at(vertex),
            Intent::SelectUnder(place_px) => self.select_under(place_px),
            Intent::Pin(switch) => self.pin_selected(switch),
            Intent::PinUnder(place_px) => self.toggle_pin_at(place_px),
            Intent::Preset(preset) => self.set_preset(preset),
            Intent::Operator(operator) => self.choose(Choices { operator, ..self.choices }),
            Intent::Constraint(constraint) => self.choose(Choices { constraint, ..self.choices }),
            Intent::Details(details) => self.choose(Choices { details, ..self.choices }),
            Intent::Anchors(anchors) => self.choose(Choices { anchors, ..self.choices }),
            Intent::Mirror(mirror) => self.choose(Choices { mirror, ..self.choices }),
            Intent::Nearby(switch) => self.choose(Choices { is_nearby: switch == Switch::On, ..self.choices }),
            Intent::Radius(radius_mm) => self.choose(self.choices.with_radius(radius_mm)?),
            Intent::Widen(factor) => self.widen(factor),
            Intent::Preview(offset_mm) => self.preview(offset_mm),
            Intent::Slide(slider, to_mm) => self.slide(slider, to_mm),
            Intent::Express(expression, to) => self.express(expression, to),
            Intent::Commit => self.finish(OpenFace::commit),
            Intent::Cancel => self.cancel(),
            Intent::Hover(place_px) => Ok(self.hover(place_px)),
            Intent::PointAt(landmark) => self.point_at(landmark),
            Intent::Press(place_px, pointer) => Ok(self.press(place_px, pointer)),
            Intent::Drag(place_px, pace) => self.drag(place_px, pace),
            Intent::Along(axis) => self.drag_along(axis),
            Intent::Release => self.release(),
            Intent::Undo if self.brush_px.is_some() => self.change_strokes(Strokes::undo),
            Intent::Redo if self.brush_px.is_some() => self.change_strokes(Strokes::redo),
            Intent::KeepNothing => self.change_strokes(Strokes::clear),
            Intent::Undo => self.undo(),
            Intent::Redo => self.finish(|face, choices| face.change_history(choices, Document::redo)),
            Intent::Reset => self.reset(),
            Intent::ResetSelected => self.reset_selected(),
            Intent::ComeToRest => self.come_to_rest(),
            Intent::Switch(index, switch) => self.switch(index, switch),
            Intent::Symmetrise(share) => self.symmetrise(share),
            Intent::Density(density) => self.set_density(density),
            Intent::PhotoLens(lens) => self.set_photo_lens(lens),
            Intent::AddPhoto(photo) => self.change_photos(|face, choices| face.add_photo(&photo, choices)),
            Intent::RemovePhoto(photo) => self.change_photos(|face, choices| face.remove_photo(photo, choices)),
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

    /// A face that has grown out of the picture is framed again once it is let go.
    fn keep_in_frame(&mut self) {
        let is_free = self.stage.scene() == Scene::Solid;
        if let Some(face) = self.face.as_ref().filter(|face| is_free && !face.is_moving()) {
            self.stage.frame_again(face.document().committed());
        }
    }

    fn show_marks(&mut self) {
        let pointed = self.pointed();
        marks::show(&mut self.stage, self.face.as_ref(), self.view.anchors, pointed);
    }
}
