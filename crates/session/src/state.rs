use glam::DVec3;
use rosto_face::LANDMARK_COUNT;
use rosto_stage::{Dots, Light};
use rosto_studio::{Expression, FaceSlider, StudioError};

use crate::selection::Moving;
use crate::{EditOptions, OpenFace, Preset, Selection, SelectionMode, Session};

/// The state that panels show.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// The open face.
    pub face: Option<FaceState>,
    /// Kind of selection made by a click or a drag.
    pub mode: SelectionMode,
    /// Number of vertices that can be selected, from 0.
    pub selectable: usize,
    /// Settings of edits.
    pub edit_options: EditOptions,
    /// The preset with these settings, if there is one.
    pub preset: Option<Preset>,
    /// View settings.
    pub view: crate::View,
    /// The light.
    pub light: Light,
    /// Which landmarks show as dots.
    pub dots: Dots,
    /// Radius of the brush in CSS px, if it is in use.
    pub brush_px: Option<f64>,
}

/// The state of an open face that panels show.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceState {
    /// Number of displayed vertices.
    pub vertex_count: usize,
    /// The current selection.
    pub selection: Option<Selection>,
    /// Whether each vertex of the selection is pinned.
    pub is_pinned: bool,
    /// Whether the selection has a mirror image.
    pub can_mirror: bool,
    /// Whether the selection is its own mirror image and the mirror is on; sideways it moves without the mirror.
    pub lies_in_plane: bool,
    /// Whether the edit in progress moves sideways out of the mirror plane.
    pub leaves_plane: bool,
    /// Whether a ready-made slider or an expression is being moved, rather than the selection.
    pub is_sliding: bool,
    /// Why the selection cannot be moved, if it cannot.
    pub refusal: Option<StudioError>,
    /// Vertices that stay in place while the selection moves.
    pub anchors: Vec<u32>,
    /// Sum in mm of the selection's entries in force.
    pub committed_mm: DVec3,
    /// Whether the history contains entries in force that moved the selection.
    pub can_reset_selection: bool,
    /// Whether there is a change to undo.
    pub can_undo: bool,
    /// Whether there is an undone change to redo.
    pub can_redo: bool,
    /// Number of entries, without undone ones.
    pub entry_count: usize,
    /// Whether the committed offset is almost parallel to the view direction and so hardly visible.
    pub is_along_view: bool,
    /// Distance from which the photo is shown, in metres.
    pub seen_from_m: f64,
    /// Whether that is the original distance.
    pub is_as_taken: bool,
    /// Number of strokes that protect the photo.
    pub stroke_count: usize,
    /// Whether there is an undone stroke to redo.
    pub can_redo_stroke: bool,
}

/// The part of the state that changes with a tick of an edit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tick {
    /// Whether an edit is in progress.
    pub is_editing: bool,
    /// Offset in mm, if the edit moves the selection.
    pub offset_mm: DVec3,
    /// Value of each ready-made slider, in mm.
    pub sliders_mm: [f64; FaceSlider::ALL.len()],
    /// Weight of each expression, 0..=1.
    pub weights: [f64; Expression::ALL.len()],
    /// Share of its offset that the selected vertex reaches; 1 is all.
    pub share_reached: f64,
    /// Whether the drag exceeds the range of the sliders.
    pub is_at_end: bool,
    /// Whether the offset is almost parallel to the view direction and so hardly visible.
    pub is_along_view: bool,
}

impl Default for Tick {
    /// No edit in progress.
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
    /// Returns the state for panels.
    pub fn state(&self) -> State {
        let selectable = self.face().map_or(LANDMARK_COUNT, |face| face.selectable_count(self.mode()));
        State {
            face: self.face().map(|face| FaceState {
                is_along_view: self.is_along_view(face.committed_mm()),
                ..face.state(self.edit_options())
            }),
            brush_px: self.brush_px(),
            mode: self.mode(),
            selectable,
            edit_options: *self.edit_options(),
            preset: self.edit_options().preset(),
            view: *self.view(),
            light: self.stage().render_settings().light,
            dots: self.stage().render_settings().dots,
        }
    }

    /// Returns the progress of the edit. Does not allocate.
    pub fn tick(&self) -> Tick {
        let tick = self.face().map(OpenFace::tick).unwrap_or_default();
        Tick { is_at_end: self.is_at_end(), is_along_view: self.is_along_view(tick.offset_mm), ..tick }
    }

    /// Whether an offset of the selection is within 14° of the view direction.
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
    fn state(&self, edit_options: &EditOptions) -> FaceState {
        let history = self.document().history();
        FaceState {
            vertex_count: self.document().topology().vertex_count(),
            selection: self.selection(),
            is_pinned: self.is_pinned(),
            can_mirror: self.can_mirror(),
            lies_in_plane: self.lies_in_plane(edit_options),
            leaves_plane: self.leaves_plane(),
            is_sliding: self.is_sliding(),
            refusal: self.refusal().cloned(),
            anchors: self.document().anchors().to_vec(),
            committed_mm: self.committed_mm(),
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
