use std::collections::BTreeMap;

use rosto_face::{LANDMARK_COUNT, Turn};
use rosto_stage::Visibility;
use rosto_studio::{Expression, FaceSlider};
use serde::Serialize;
use tsify::Tsify;

use super::{LightSettings, Tick};
use crate::open_face::PhotoFacts;
use crate::{Choice, OpenFace, Phrase, Selection, Session, Turntable};

/// The state that the page reads outside the panels.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(hashmap_as_object)]
pub struct State {
    /// Number of displayed vertices; 0 without a face.
    pub vertex_count: usize,
    /// Number of vertices that can be selected, from 0.
    pub selectable: usize,

    /// The selected vertex, or the central landmark of the selected region.
    pub selected: Option<u32>,
    /// Name of the selection.
    pub name: Option<Phrase>,
    /// Whether each vertex of the selection is pinned.
    pub is_pinned: bool,
    /// Whether the edit in progress moves sideways out of the mirror plane.
    pub leaves_plane: bool,
    /// Whether a ready-made slider or an expression is being moved, rather than the selection.
    pub is_sliding: bool,
    /// Whether the selection is being dragged.
    pub is_dragging: bool,
    /// Whether the selection cannot be moved.
    pub is_refused: bool,
    /// Vertices that stay in place while the selection moves.
    pub anchors: Vec<u32>,

    /// Id of each setting's value; none if it is not an available one, such as when no preset matches.
    pub chosen: BTreeMap<&'static str, Option<String>>,
    /// Influence radius, in mm.
    pub radius_mm: f64,

    /// The edit in progress.
    pub tick: Tick,
    /// Offset of the selection in mm: the sum of its entries in force and the edit in progress.
    pub offset_mm: [f64; 3],
    /// Value of each ready-made slider in mm, with the edit in progress.
    pub sliders_mm: BTreeMap<&'static str, f64>,
    /// Weight of each expression, 0..=1, with the edit in progress.
    pub weights: BTreeMap<&'static str, f64>,

    /// Whether there is a change to undo.
    pub can_undo: bool,
    /// Whether there is an undone change to redo.
    pub can_redo: bool,
    /// Number of entries, without undone ones.
    pub entry_count: usize,

    /// Whether edges are shown.
    pub wireframe: bool,
    /// Whether the original face is shown next to the edited one.
    pub is_wiping: bool,
    /// Whether the face rotates automatically.
    pub turntable: bool,
    /// The light.
    pub light: LightSettings,

    /// The photos of the face, in the order in which they were added.
    pub photos: Vec<PhotoState>,
    /// The turns of the head that no photo shows: of "front", "left" and "right".
    pub missing_turns: Vec<&'static str>,
    /// Lens of the lead photo.
    pub photo_lens: Option<String>,
    /// Lens by the lead photo's own data.
    pub found_lens: Option<String>,
    /// Falloff band around the face in its photo, as a share of the face's longer side.
    pub falloff_band: f64,
    /// Radius of the brush in CSS px, if it is in use.
    pub brush_px: Option<f64>,

    /// Settings and view as text, for [`Intent::RestorePreferences`](crate::Intent::RestorePreferences).
    pub preferences: String,
}

/// A photo of the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct PhotoState {
    /// Whether it is the lead photo: its colours, size and lens are the face's, and it is the displayed one.
    pub leads: bool,
    /// Yaw of the head in degrees; positive to the subject's left.
    pub yaw_deg: f64,
    /// "front", "left" or "right"; none for other angles.
    pub turn: Option<&'static str>,
    /// Whether it shows a turn that neither the lead photo nor an earlier one shows.
    pub adds: bool,
}

impl Session {
    /// Returns the state.
    pub fn state(&self) -> State {
        let (view, settings) = (self.view(), self.stage().render_settings());
        State {
            selectable: self.face().map_or(LANDMARK_COUNT, |face| face.selectable_count(self.mode())),
            name: self.selection_name(),
            is_dragging: self.is_dragging(),
            chosen: Choice::ALL.map(|choice| (choice.id(), self.chosen(choice))).into(),
            radius_mm: self.edit_options().radius_mm,
            tick: self.tick(),
            wireframe: view.wireframe == Visibility::Shown,
            is_wiping: settings.wipe.is_some(),
            turntable: view.turntable == Turntable::Turns,
            light: settings.light.into(),
            falloff_band: view.falloff_band,
            brush_px: self.pointer_radius_px(),
            preferences: self.preferences(),
            ..self.face().map_or_else(State::default, OpenFace::state)
        }
    }
}

impl OpenFace {
    /// The part of the state that depends on the face alone.
    fn state(&self) -> State {
        let (document, history) = (self.document(), self.document().history());
        let weights = self.weights();
        State {
            vertex_count: document.topology().vertex_count(),
            selected: self.selection().map(Selection::centre),
            is_pinned: self.is_pinned(),
            leaves_plane: self.leaves_plane(),
            is_sliding: self.is_sliding(),
            is_refused: self.refusal().is_some(),
            anchors: document.anchors().to_vec(),
            offset_mm: self.offset_mm().to_array(),
            sliders_mm: FaceSlider::ALL.map(|slider| (slider.id(), self.slider_mm(slider))).into(),
            weights: Expression::ALL.map(|expression| (expression.id(), weights[expression as usize])).into(),
            can_undo: history.can_undo(),
            can_redo: history.can_redo(),
            entry_count: history.entries().len(),
            photos: self.photos().into_iter().map(PhotoState::from).collect(),
            missing_turns: self.missing_turns().into_iter().map(Turn::id).collect(),
            photo_lens: Some(self.model().lens().to_string()),
            found_lens: Some(self.found_lens().to_string()),
            ..State::default()
        }
    }
}

impl From<PhotoFacts> for PhotoState {
    fn from(facts: PhotoFacts) -> Self {
        let PhotoFacts { leads, yaw_deg, turn, adds } = facts;
        Self { leads, yaw_deg, turn: turn.map(Turn::id), adds }
    }
}
