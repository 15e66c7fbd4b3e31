mod mesh;
mod movement;
mod outputs;
mod photo_edit;
mod photos;
mod selecting;
mod state;

use glam::DVec3;
use rosto_face::{FaceModel, Triangulation};
use rosto_studio::{Command, Details, Document, EditTarget, Expression, FaceSlider, Mirror, StudioError, Switch};

use crate::Selection;
use crate::edit_options::EditOptions;
use crate::error::SessionError;
use crate::rows::{Row, Rows};
use crate::selection::Moving;
use crate::slider_influence::{self, SliderInfluence};
use crate::strokes::Strokes;
pub use photo_edit::PhotoEdit;
pub use photos::PhotoFacts;

pub(crate) const M_PER_MM: f64 = 1.0 / 1000.0;
pub(crate) const MM_PER_M: f64 = 1000.0;

/// Maximum offset of a handle: more than twice the height of a face.
pub const MAX_OFFSET_M: f64 = 0.5;

/// Offsets below this are zero: slider values and the history's sum differ by rounding.
pub(crate) const MIN_MM: f64 = 1e-6;
const MIN_M: f64 = MIN_MM * M_PER_MM;
const MIN_WEIGHT: f64 = 1e-9;

/// An open face: its model, document and selection, and the edit in progress. Independent of page and camera.
pub struct OpenFace {
    model: FaceModel,
    document: Document,
    selection: Option<Selection>,
    /// Why the selection cannot be moved, if it cannot.
    refusal: Option<StudioError>,
    /// Vertices pinned by the user.
    pins: Vec<u32>,
    seed: u64,
    moving: Moving,
    /// Whether the edit in progress has left the mirror plane. Sideways, a selection in the plane moves without the
    /// mirror.
    leaves_plane: bool,
    /// Influence of the ready-made slider that moved last.
    slider_influence: SliderInfluence,
    /// Offset of each handle at amount 1, while a ready-made slider moves.
    unit_offsets_m: Vec<DVec3>,
    /// Scratch buffer: one offset for each handle.
    offsets_m: Vec<DVec3>,
    rows: Rows,
    photo: PhotoEdit,
    /// View distance and strokes of photos that led before, by their landmarks.
    inactive_photos: Vec<(Vec<[f32; 3]>, Option<f64>, Strokes)>,
}

impl OpenFace {
    pub(crate) fn new(model: FaceModel, document: Document) -> Self {
        let rows = Rows::of(&document);
        Self {
            model,
            document,
            selection: None,
            refusal: None,
            pins: Vec::new(),
            seed: 0,
            moving: Moving::Nothing,
            leaves_plane: false,
            slider_influence: SliderInfluence::default(),
            unit_offsets_m: Vec::new(),
            offsets_m: Vec::new(),
            rows,
            photo: PhotoEdit::default(),
            inactive_photos: Vec::new(),
        }
    }

    /// The face as detected.
    pub fn model(&self) -> &FaceModel {
        &self.model
    }

    /// Mesh and history.
    pub fn document(&self) -> &Document {
        &self.document
    }

    pub(crate) fn document_mut(&mut self) -> &mut Document {
        &mut self.document
    }

    /// Triangulation of the landmarks.
    pub fn triangulation(&self) -> Triangulation {
        self.model.triangulation()
    }

    /// The current selection.
    pub fn selection(&self) -> Option<Selection> {
        self.selection
    }

    /// The selected vertex, or the central landmark of the selected region.
    pub fn selected(&self) -> Option<u32> {
        self.selection.map(Selection::centre)
    }

    /// Why the selection cannot be moved, if it cannot.
    pub fn refusal(&self) -> Option<&StudioError> {
        self.refusal.as_ref()
    }

    /// Vertices pinned by the user.
    pub fn pins(&self) -> &[u32] {
        &self.pins
    }

    /// Entries of the history for display, oldest first.
    pub fn rows(&self) -> &[Row] {
        self.rows.all()
    }

    pub(crate) fn moving(&self) -> Moving {
        self.moving
    }

    /// Whether an edit is in progress.
    pub fn is_moving(&self) -> bool {
        self.moving != Moving::Nothing
    }

    /// The ready-made slider being moved.
    pub fn slider(&self) -> Option<FaceSlider> {
        match self.moving {
            Moving::Slider { slider, .. } => Some(slider),
            _ => None,
        }
    }

    /// The expression being moved.
    pub fn expression(&self) -> Option<Expression> {
        match self.moving {
            Moving::Expression { expression: (expression, _), .. } => Some(expression),
            _ => None,
        }
    }

    /// Whether a ready-made slider or an expression is being moved, rather than the selection.
    pub fn is_sliding(&self) -> bool {
        self.slider().is_some() || self.expression().is_some()
    }

    /// Whether the edit in progress moves sideways out of the mirror plane, and so without the mirror.
    pub fn leaves_plane(&self) -> bool {
        self.leaves_plane
    }

    /// Whether details rotate in the prepared edit, so that it is not linear.
    pub fn turns_details(&self) -> bool {
        self.document.spec().is_some_and(|spec| spec.settings.details == Details::AsRigidAsPossible)
    }

    /// Influence fields of the edit in progress over the displayed vertices, for [`Self::influence_offsets_m`].
    pub fn influence_fields(&self) -> [Option<&[f64]>; 2] {
        if self.expression().is_some() {
            return [None, None];
        }
        let fields = match (self.slider(), self.document.influence()) {
            (Some(_), _) => [&self.slider_influence.a, &self.slider_influence.b],
            (None, Some(influence)) => [&influence.direct, &influence.mirrored],
            (None, None) => return [None, None],
        };
        fields.map(|field| (!field.is_empty()).then_some(field.as_slice()))
    }

    /// Offset of each of [`Self::influence_fields`], in metres.
    pub fn influence_offsets_m(&self) -> [DVec3; 2] {
        match self.moving {
            Moving::Nothing | Moving::Expression { .. } => [DVec3::ZERO; 2],
            Moving::Selection { offset_mm } => slider_influence::offsets(offset_mm * M_PER_MM),
            Moving::Slider { slider, by_mm } => slider_influence::slider_offsets(slider, by_mm * M_PER_MM),
        }
    }

    /// Sets the selection; `seed` selects random anchors.
    pub(crate) fn select(&mut self, selection: Option<Selection>, edit_options: &EditOptions, seed: u64) {
        self.selection = selection;
        self.seed = seed;
        self.prepare(edit_options);
    }

    /// Pins or unpins vertices. An edit in progress continues.
    pub(crate) fn pin(&mut self, vertices: &[u32], switch: Switch, edit_options: &EditOptions) {
        self.pins.retain(|pin| !vertices.contains(pin));
        if switch == Switch::On {
            self.pins.extend(vertices);
        }
        self.keep_prepared(edit_options);
    }

    /// Prepares the selection's edit with the given settings. If it has no solution, the selection stays and cannot be
    /// moved. An edit in progress is discarded.
    pub(crate) fn prepare(&mut self, edit_options: &EditOptions) {
        self.leaves_plane = false;
        self.prepare_selection(edit_options);
    }

    fn prepare_selection(&mut self, edit_options: &EditOptions) {
        self.moving = Moving::Nothing;
        self.refusal = None;
        let Some(selection) = self.selection else { return self.document.release() };
        let mirror = if self.leaves_plane { Mirror::Off } else { edit_options.mirror };
        let spec = EditOptions { mirror, ..*edit_options }.spec(selection, &self.pins, self.seed, &self.document);
        if let Err(reason) = self.document.prepare(spec) {
            self.document.release();
            self.refusal = Some(reason);
        }
    }

    /// Prepares the selection's edit again; an edit in progress continues.
    pub(crate) fn keep_prepared(&mut self, edit_options: &EditOptions) {
        match self.moving {
            Moving::Nothing => self.prepare(edit_options),
            Moving::Slider { .. } | Moving::Expression { .. } => self.commit(edit_options),
            Moving::Selection { offset_mm } => {
                self.prepare(edit_options);
                // If rotating details do not converge, the previous preview remains.
                let _ = self.preview(offset_mm, edit_options);
            }
        }
    }

    /// Tick of the selection's offset: no solve, no allocation. On an error the previous offset remains; without a
    /// prepared edit it is a no-op, because a tick can arrive after its selection is gone. Returns whether the edit was
    /// prepared again, which happens when it leaves the mirror plane or returns to it.
    pub(crate) fn preview(&mut self, offset_mm: DVec3, edit_options: &EditOptions) -> Result<bool, SessionError> {
        let leaves_plane = offset_mm.x != 0.0 && self.lies_in_plane(edit_options);
        if leaves_plane == self.leaves_plane {
            self.move_selection(offset_mm)?;
            return Ok(false);
        }
        self.transaction(|face| {
            face.leaves_plane = leaves_plane;
            face.prepare_selection(edit_options);
            face.move_selection(offset_mm)
        })?;
        Ok(true)
    }

    fn move_selection(&mut self, offset_mm: DVec3) -> Result<(), SessionError> {
        let Some(spec) = self.document.spec() else { return Ok(()) };
        self.offsets_m.clear();
        self.offsets_m.resize(spec.handles.len(), offset_mm * M_PER_MM);
        self.move_to(Moving::Selection { offset_mm })
    }

    /// Starts moving a ready-made slider: one solve. Commits another edit in progress first.
    pub(crate) fn start_slider(&mut self, slider: FaceSlider, edit_options: &EditOptions) -> Result<(), SessionError> {
        self.commit(edit_options);
        let prepared = self.document.prepare(slider.spec());
        self.slider_influence = prepared.and_then(|()| SliderInfluence::of(&mut self.document, slider))?;
        self.unit_offsets_m = slider.offsets_m(1.0);
        self.refusal = None;
        self.moving = Moving::Slider { slider, by_mm: 0.0 };
        Ok(())
    }

    /// Tick of the current slider: no solve, no allocation. `to_mm` is its value, including earlier entries.
    pub(crate) fn slide(&mut self, slider: FaceSlider, to_mm: f64) -> Result<(), SessionError> {
        let by_mm = to_mm - self.rows.slider_mm(slider);
        self.offsets_m.clear();
        self.offsets_m.extend(self.unit_offsets_m.iter().map(|offset| *offset * (by_mm * M_PER_MM)));
        self.move_to(Moving::Slider { slider, by_mm })
    }

    /// Tick of an expression; solves on its first use. `to` is its weight, including earlier entries; with the mirror,
    /// its partner gets the same weight.
    pub(crate) fn express(
        &mut self,
        expression: Expression,
        to: f64,
        edit_options: &EditOptions,
    ) -> Result<(), SessionError> {
        let change = |expression: Expression| (expression, (to - self.committed_weight(expression)).clamp(-1.0, 1.0));
        let partner =
            Some(expression.mirrored()).filter(|&other| other != expression && edit_options.mirror == Mirror::On);
        let (expression, partner) = (change(expression), partner.map(change));
        let changes = [Some(expression), partner].into_iter().flatten().filter(|(_, by)| by.abs() > MIN_WEIGHT);
        self.document.preview_expressions(&changes.collect::<Vec<_>>())?;
        self.moving = Moving::Expression { expression, partner };
        Ok(())
    }

    /// Sets the weights of all expressions, as one change of the history; no change if they have them.
    pub(crate) fn set_weights(
        &mut self,
        weights: &[f64; Expression::ALL.len()],
        edit_options: &EditOptions,
    ) -> Result<(), SessionError> {
        self.commit(edit_options);
        let now = self.weights();
        let change = |one: Expression| (one, (weights[one as usize] - now[one as usize]).clamp(-1.0, 1.0));
        let changes: Vec<_> = Expression::ALL.map(change).into_iter().filter(|(_, by)| by.abs() > MIN_WEIGHT).collect();
        if changes.is_empty() {
            return Ok(());
        }
        let first = self.document.history().entries().len();
        self.document.preview_expressions(&changes)?;
        // Each entry gets the id of its expression as label.
        self.document.commit("");
        self.rows.read(&self.document, first);
        Ok(())
    }

    fn move_to(&mut self, moving: Moving) -> Result<(), SessionError> {
        self.document.preview(&self.offsets_m)?;
        self.moving = moving;
        Ok(())
    }

    /// Commits the edit in progress as one entry, unless nothing moved. After a slider, the selection is prepared
    /// again.
    pub(crate) fn commit(&mut self, edit_options: &EditOptions) {
        let target = match (self.moving, self.selection) {
            (Moving::Selection { offset_mm }, Some(selection)) if offset_mm != DVec3::ZERO => Some(selection.target()),
            (Moving::Slider { slider, by_mm }, _) if by_mm.abs() > MIN_MM => Some(EditTarget::Slider(slider)),
            (Moving::Expression { expression: (expression, _), .. }, _) => Some(EditTarget::Expression(expression)),
            _ => None,
        };
        if let Some(target) = target.filter(|_| self.has_moved()) {
            let first = self.document.history().entries().len();
            self.document.commit(&target.to_string());
            self.rows.read(&self.document, first);
        }
        self.cancel(edit_options);
    }

    /// Discards the edit in progress.
    pub(crate) fn cancel(&mut self, edit_options: &EditOptions) {
        self.document.cancel();
        let was_slider = matches!(std::mem::take(&mut self.moving), Moving::Slider { .. });
        if was_slider || self.leaves_plane {
            self.prepare(edit_options);
        }
    }

    fn has_moved(&self) -> bool {
        let mut pairs = self.document.positions().iter().zip(self.document.committed());
        pairs.any(|(now, before)| now.distance(*before) > MIN_M)
    }

    /// Applies a change of the history that returns the index of the first changed entry.
    pub(crate) fn change_history(
        &mut self,
        edit_options: &EditOptions,
        change: impl FnOnce(&mut Document) -> Option<usize>,
    ) {
        self.cancel(edit_options);
        if let Some(first) = change(&mut self.document) {
            self.rows.read(&self.document, first);
        }
    }

    /// Moves both sides towards symmetry, as an entry of the history; no entry if nothing moves.
    pub(crate) fn symmetrise(&mut self, share: f64, edit_options: &EditOptions) -> Result<(), SessionError> {
        self.commit(edit_options);
        let (label, first) = (EditTarget::Symmetry.to_string(), self.document.history().entries().len());
        let command = Command::Symmetrise { share };
        if self.document.displacement(&command)?.iter().all(|displacement| displacement.length() <= MIN_M) {
            return Ok(());
        }
        self.document.apply(&label, command)?;
        self.rows.read(&self.document, first);
        Ok(())
    }
}
