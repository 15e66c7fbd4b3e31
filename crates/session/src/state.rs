use glam::DVec3;
use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Dots, Light};
use rosto_studio::{Expression, FaceSlider, StudioError};

use crate::selection::Moving;
use crate::{Choices, OpenFace, Preset, Selection, SelectionMode, Session};

/// Everything that panels show, as it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// The open face.
    pub face: Option<FaceState>,
    /// What a click or a drag selects.
    pub mode: SelectionMode,
    /// How many vertices it can select, from 0.
    pub selectable: usize,
    /// How edits are to spread.
    pub choices: Choices,
    /// The preset that these are, if they are one.
    pub preset: Option<Preset>,
    /// How a face is seen.
    pub view: crate::View,
    /// The light.
    pub light: Light,
    /// Which landmarks show as dots.
    pub dots: Dots,
    /// The brush in hand: its radius in CSS px.
    pub brush_px: Option<f64>,
}

/// What panels show of an open face.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceState {
    /// Vertices shown.
    pub vertex_count: usize,
    /// What is selected.
    pub selection: Option<Selection>,
    /// Whether all that is selected is pinned.
    pub is_pinned: bool,
    /// Whether the other side of the face can follow what is selected.
    pub can_mirror: bool,
    /// Whether what is selected is its own mirror image and the mirror is on: sideways it moves alone.
    pub lies_in_plane: bool,
    /// Whether it does so now.
    pub leaves_plane: bool,
    /// Whether a ready-made slider or an expression is in hand, and not what is selected.
    pub is_sliding: bool,
    /// Why what is selected cannot be moved, if it cannot.
    pub refusal: Option<StudioError>,
    /// Vertices that stay while what is selected moves.
    pub anchors: Vec<u32>,
    /// Sum in mm of the offsets that the history holds for what is selected, as far as they are in force.
    pub kept_mm: DVec3,
    /// Whether there are any.
    pub can_reset_selection: bool,
    /// Whether there is something to undo.
    pub can_undo: bool,
    /// Whether there is something to redo.
    pub can_redo: bool,
    /// How many entries the history has, without what was undone.
    pub entry_count: usize,
    /// Whether the offsets kept go so nearly along the view that they hardly show from here.
    pub is_along_view: bool,
    /// From how far away the face is shown in its photo, in metres.
    pub seen_from_m: f64,
    /// Whether that is as it was taken.
    pub is_as_taken: bool,
    /// How many strokes of the brush keep something of the photo.
    pub stroke_count: usize,
    /// Whether one can be brought back.
    pub can_redo_stroke: bool,
}

/// What one tick of an edit changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tick {
    /// Whether an edit is in progress that a commit would keep.
    pub is_editing: bool,
    /// Its offset in mm, if it is one of what is selected.
    pub offset_mm: DVec3,
    /// Where each ready-made slider stands, in mm.
    pub sliders_mm: [f64; FaceSlider::ALL.len()],
    /// How much of each expression the face shows, 0..=1.
    pub weights: [f64; Expression::ALL.len()],
    /// Share of its offset that the vertex selected reaches: 1 is all of it.
    pub share_reached: f64,
    /// Whether the pointer drags it further than its sliders go.
    pub is_at_end: bool,
    /// Whether it goes so nearly along the view that it hardly shows from here.
    pub is_along_view: bool,
}

impl Default for Tick {
    /// Nothing is moved.
    fn default() -> Self {
        Self {
            is_editing: false,
            offset_mm: DVec3::ZERO,
            sliders_mm: [0.0; FaceSlider::ALL.len()],
            weights: [0.0; Expression::ALL.len()],
            share_reached: 0.0,
            is_at_end: false,
            is_along_view: false,
        }
    }
}

impl Session {
    /// How things stand.
    pub fn state(&self) -> State {
        let selectable = self.face().map_or(LANDMARK_COUNT, |face| face.within_reach(self.mode()));
        State {
            face: self.face().map(|face| FaceState {
                is_along_view: self.is_along_view(face.kept_mm()),
                ..face.state(self.choices())
            }),
            brush_px: self.brush_px(),
            mode: self.mode(),
            selectable,
            choices: *self.choices(),
            preset: self.choices().preset(),
            view: *self.view(),
            light: self.stage().render_settings().light,
            dots: self.stage().render_settings().dots,
        }
    }

    /// How far the edit in progress has gone. No allocation.
    pub fn tick(&self) -> Tick {
        let tick = self.face().map(OpenFace::tick).unwrap_or_default();
        Tick { is_at_end: self.is_at_end(), is_along_view: self.is_along_view(tick.offset_mm), ..tick }
    }

    /// Whether what is selected, moved by so much, goes along the view but for 14°.
    fn is_along_view(&self, offset_mm: DVec3) -> bool {
        const LEAST_MM: f64 = 0.5;
        let selected = self.face().and_then(|face| Some((face, face.selected()?)));
        let place_m = selected.and_then(|(face, vertex)| face.document().positions().get(vertex as usize).copied());
        let Some(place_m) = place_m.filter(|_| offset_mm.length() > LEAST_MM) else { return false };
        let along_mm = offset_mm.dot(self.stage().camera().to_eye(place_m));
        along_mm.abs() > 0.97 * offset_mm.length()
    }
}

impl OpenFace {
    fn state(&self, choices: &Choices) -> FaceState {
        let history = self.document().history();
        FaceState {
            vertex_count: self.document().topology().vertex_count(),
            selection: self.selection(),
            is_pinned: self.is_pinned(),
            can_mirror: self.can_mirror(),
            lies_in_plane: self.lies_in_plane(choices),
            leaves_plane: self.leaves_plane(),
            is_sliding: self.is_sliding(),
            refusal: self.refusal().cloned(),
            anchors: self.document().anchors().to_vec(),
            kept_mm: self.kept_mm(),
            can_reset_selection: self.can_reset_selection(),
            can_undo: history.can_undo(),
            can_redo: history.can_redo(),
            entry_count: history.entries().len(),
            is_along_view: false,
            seen_from_m: self.seen_by().distance_m,
            is_as_taken: self.photo().seen_from_m().is_none(),
            stroke_count: self.photo().strokes().count(),
            can_redo_stroke: self.photo().strokes().can_redo(),
        }
    }

    fn tick(&self) -> Tick {
        let offset_mm = match self.moving() {
            Moving::Selection { offset_mm } => offset_mm,
            _ => DVec3::ZERO,
        };
        Tick {
            is_editing: self.is_moving(),
            offset_mm,
            sliders_mm: FaceSlider::ALL.map(|slider| self.slider_mm(slider)),
            weights: self.weights(),
            share_reached: self.share_reached(),
            is_at_end: false,
            is_along_view: false,
        }
    }
}
