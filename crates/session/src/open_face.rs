mod mesh;
mod movement;
mod outputs;
mod photo;
mod photos;
mod selecting;
mod state;

use glam::DVec3;
use rosto_face::{FaceModel, Photo, Triangulation};
use rosto_studio::{Command, Details, Document, EditTarget, Expression, FaceSlider, Mirror, StudioError, Switch};

use crate::Selection;
use crate::choices::Choices;
use crate::error::SessionError;
use crate::rows::{Row, Rows};
use crate::selection::Moving;
use crate::slider_influence::{self, SliderInfluence};
use crate::strokes::Strokes;
pub use photo::PhotoEdit;
pub use photos::PhotoFacts;

pub(crate) const M_PER_MM: f64 = 1.0 / 1000.0;
pub(crate) const MM_PER_M: f64 = 1000.0;

/// No hand moves anything further than this: more than twice the height of a face.
pub const MAX_OFFSET_M: f64 = 0.5;

/// An edit of less is none: what sliders show and what the history adds up to differ by rounding.
const LEAST_MM: f64 = 1e-6;
const LEAST_M: f64 = LEAST_MM * M_PER_MM;
const LEAST_WEIGHT: f64 = 1e-9;

/// One open face: its model, its document, and what is selected and moved. Knows neither the page nor the camera.
pub struct OpenFace {
    model: FaceModel,
    document: Document,
    triangulation: Triangulation,
    selection: Option<Selection>,
    /// Why what is selected cannot be moved, if it cannot.
    refusal: Option<StudioError>,
    /// Vertices of the mesh, pinned by hand.
    pins: Vec<u32>,
    seed: u64,
    moving: Moving,
    /// Whether the edit in progress has left the mirror's plane, in which what is selected lies: sideways it moves alone.
    leaves_plane: bool,
    /// Of the slider that was moved last.
    slider_influence: SliderInfluence,
    /// What each handle does for an amount of 1, while a slider moves.
    ways: Vec<DVec3>,
    /// Scratch: one offset for each handle.
    offsets_m: Vec<DVec3>,
    rows: Rows,
    photo: PhotoEdit,
    /// How photos that led before were seen, and what was kept of them, by the landmarks found in them.
    set_aside: Vec<(Vec<[f32; 3]>, Option<f64>, Strokes)>,
    /// Of the whole face, in the canonical one's coordinates.
    pub(crate) texture: Option<Photo>,
}

impl OpenFace {
    pub(crate) fn new(model: FaceModel, document: Document) -> Self {
        let rows = Rows::of(&document);
        Self {
            triangulation: model.triangulation(),
            model,
            document,
            selection: None,
            refusal: None,
            pins: Vec::new(),
            seed: 0,
            moving: Moving::Nothing,
            leaves_plane: false,
            slider_influence: SliderInfluence::default(),
            ways: Vec::new(),
            offsets_m: Vec::new(),
            rows,
            photo: PhotoEdit::default(),
            set_aside: Vec::new(),
            texture: None,
        }
    }

    /// The face as it was found.
    pub fn model(&self) -> &FaceModel {
        &self.model
    }

    /// Its mesh, and what was done to it.
    pub fn document(&self) -> &Document {
        &self.document
    }

    pub(crate) fn document_mut(&mut self) -> &mut Document {
        &mut self.document
    }

    /// How the landmarks are joined.
    pub fn triangulation(&self) -> Triangulation {
        self.triangulation
    }

    /// What is selected.
    pub fn selection(&self) -> Option<Selection> {
        self.selection
    }

    /// The vertex selected, or the landmark in the middle of the region.
    pub fn selected(&self) -> Option<u32> {
        self.selection.map(Selection::middle)
    }

    /// Why what is selected cannot be moved, if it cannot.
    pub fn refusal(&self) -> Option<&StudioError> {
        self.refusal.as_ref()
    }

    /// Vertices pinned by hand.
    pub fn pins(&self) -> &[u32] {
        &self.pins
    }

    /// The history as people read it, oldest first.
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

    /// Whether a ready-made slider or an expression is in hand, and not what is selected.
    pub fn is_sliding(&self) -> bool {
        self.slider().is_some() || self.expression().is_some()
    }

    /// Whether the edit in progress goes sideways out of the mirror's plane, and so without the mirror.
    pub fn leaves_plane(&self) -> bool {
        self.leaves_plane
    }

    /// Whether what is held does not follow in a straight line.
    pub fn turns_details(&self) -> bool {
        self.document.spec().is_some_and(|spec| spec.settings.details == Details::AsRigidAsPossible)
    }

    /// How every vertex shown follows the edit in progress, for [`Self::influence_offsets_m`].
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

    /// The offsets that [`Self::influence_fields`] are for, in metres.
    pub fn influence_offsets_m(&self) -> [DVec3; 2] {
        match self.moving {
            Moving::Nothing | Moving::Expression { .. } => [DVec3::ZERO; 2],
            Moving::Selection { offset_mm } => slider_influence::offsets(offset_mm * M_PER_MM),
            Moving::Slider { slider, by_mm } => slider_influence::slider_offsets(slider, by_mm * M_PER_MM),
        }
    }

    /// Selects something, or nothing; `seed` chooses random anchors.
    pub(crate) fn select(&mut self, selection: Option<Selection>, choices: &Choices, seed: u64) {
        self.selection = selection;
        self.seed = seed;
        self.prepare(choices);
    }

    /// Pins vertices, or frees them. An edit in progress goes on.
    pub(crate) fn pin(&mut self, vertices: &[u32], switch: Switch, choices: &Choices) {
        self.pins.retain(|pin| !vertices.contains(pin));
        if switch == Switch::On {
            self.pins.extend(vertices);
        }
        self.keep_prepared(choices);
    }

    /// Takes hold of what is selected again, after choices have changed. What has no answer stays selected, and cannot be
    /// moved until it has one. An edit in progress is dropped.
    pub(crate) fn prepare(&mut self, choices: &Choices) {
        self.leaves_plane = false;
        self.prepare_as_it_moves(choices);
    }

    fn prepare_as_it_moves(&mut self, choices: &Choices) {
        self.moving = Moving::Nothing;
        self.refusal = None;
        let Some(selection) = self.selection else { return self.document.release() };
        let mirror = if self.leaves_plane { Mirror::Off } else { choices.mirror };
        let spec = Choices { mirror, ..*choices }.spec(selection, &self.pins, self.seed, &self.document);
        if let Err(reason) = self.document.prepare(spec) {
            self.document.release();
            self.refusal = Some(reason);
        }
    }

    /// The same, but an edit in progress goes on.
    pub(crate) fn keep_prepared(&mut self, choices: &Choices) {
        match self.moving {
            Moving::Nothing => self.prepare(choices),
            Moving::Slider { .. } | Moving::Expression { .. } => self.commit(choices),
            Moving::Selection { offset_mm } => {
                self.prepare(choices);
                // Details that find no rest are where they were.
                let _ = self.preview(offset_mm, choices);
            }
        }
    }

    /// One tick: no solve, no allocation. What has no answer stays where it is, as the refusal says; and where nothing is
    /// selected, nothing happens: what moved it may speak after what it was for has gone. Returns whether it had to be held
    /// anew, which it is when it leaves the mirror's plane or comes back.
    pub(crate) fn preview(&mut self, offset_mm: DVec3, choices: &Choices) -> Result<bool, SessionError> {
        let leaves_plane = offset_mm.x != 0.0 && self.lies_in_plane(choices);
        if leaves_plane == self.leaves_plane {
            self.move_selection(offset_mm)?;
            return Ok(false);
        }
        self.whole(|face| {
            face.leaves_plane = leaves_plane;
            face.prepare_as_it_moves(choices);
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

    /// Takes a ready-made slider in hand, unless it is: one solve. An edit of something else is kept first.
    pub(crate) fn take_slider(&mut self, slider: FaceSlider, choices: &Choices) -> Result<(), SessionError> {
        self.commit(choices);
        let taken = self.document.prepare(slider.spec());
        self.slider_influence = taken.and_then(|()| SliderInfluence::of(&mut self.document, slider))?;
        self.ways = slider.offsets_m(1.0);
        self.refusal = None;
        self.moving = Moving::Slider { slider, by_mm: 0.0 };
        Ok(())
    }

    /// One tick of the slider in hand: no solve, no allocation. `to_mm` is where it is to stand, all its entries counted.
    pub(crate) fn slide(&mut self, slider: FaceSlider, to_mm: f64) -> Result<(), SessionError> {
        let by_mm = to_mm - self.rows.in_force_mm(EditTarget::Slider(slider));
        self.offsets_m.clear();
        self.offsets_m.extend(self.ways.iter().map(|way| *way * (by_mm * M_PER_MM)));
        self.move_to(Moving::Slider { slider, by_mm })
    }

    /// One tick of an expression: no solve but for its first. `to` is how much of it the face is to show, all its entries
    /// counted; with the mirror, its partner shows as much.
    pub(crate) fn express(&mut self, expression: Expression, to: f64, choices: &Choices) -> Result<(), SessionError> {
        let way = |expression: Expression| (expression, (to - self.kept_weight(expression)).clamp(-1.0, 1.0));
        let partner = Some(expression.mirrored()).filter(|&other| other != expression && choices.mirror == Mirror::On);
        let (expression, partner) = (way(expression), partner.map(way));
        let both = [Some(expression), partner].into_iter().flatten().filter(|(_, by)| by.abs() > LEAST_WEIGHT);
        self.document.preview_expressions(&both.collect::<Vec<_>>())?;
        self.moving = Moving::Expression { expression, partner };
        Ok(())
    }

    fn move_to(&mut self, moving: Moving) -> Result<(), SessionError> {
        self.document.preview(&self.offsets_m)?;
        self.moving = moving;
        Ok(())
    }

    /// Keeps the edit in progress as one entry; one that moves nothing is none. After a slider, the selection is held again.
    pub(crate) fn commit(&mut self, choices: &Choices) {
        let target = match (self.moving, self.selection) {
            (Moving::Selection { offset_mm }, Some(selection)) if offset_mm != DVec3::ZERO => Some(selection.target()),
            (Moving::Slider { slider, by_mm }, _) if by_mm.abs() > LEAST_MM => Some(EditTarget::Slider(slider)),
            (Moving::Expression { expression: (expression, _), .. }, _) => Some(EditTarget::Expression(expression)),
            _ => None,
        };
        if let Some(target) = target.filter(|_| self.has_moved()) {
            let first = self.document.history().entries().len();
            self.document.commit(&target.to_string());
            self.rows.read(&self.document, first);
        }
        self.cancel(choices);
    }

    /// Drops the edit in progress.
    pub(crate) fn cancel(&mut self, choices: &Choices) {
        self.document.cancel();
        let was_slider = matches!(std::mem::take(&mut self.moving), Moving::Slider { .. });
        if was_slider || self.leaves_plane {
            self.prepare(choices);
        }
    }

    fn has_moved(&self) -> bool {
        let mut ways = self.document.positions().iter().zip(self.document.committed());
        ways.any(|(now, before)| now.distance(*before) > LEAST_M)
    }

    /// Changes the history by something that the document does, which says the first entry that has changed.
    pub(crate) fn change_history(&mut self, choices: &Choices, change: impl FnOnce(&mut Document) -> Option<usize>) {
        self.cancel(choices);
        if let Some(first) = change(&mut self.document) {
            self.rows.read(&self.document, first);
        }
    }

    /// Brings the two sides of the face closer, as an entry of the history; none if they are as close already.
    pub(crate) fn symmetrise(&mut self, share: f64, choices: &Choices) -> Result<(), SessionError> {
        self.commit(choices);
        let (label, first) = (EditTarget::Symmetry.to_string(), self.document.history().entries().len());
        let command = Command::Symmetrise { share };
        if self.document.displacement(&command)?.iter().all(|way| way.length() <= LEAST_M) {
            return Ok(());
        }
        self.document.apply(&label, command)?;
        self.rows.read(&self.document, first);
        Ok(())
    }
}
