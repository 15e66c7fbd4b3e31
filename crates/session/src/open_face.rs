use glam::{DMat3, DVec2, DVec3};
use rosto_face::{FaceModel, LANDMARK_COUNT, Language, Triangulation};
use rosto_studio::{Command, Details, Document, FaceSlider, Frame, Hold, Rest, StudioError, Subject, Switch, project};

use crate::choices::Choices;
use crate::error::SessionError;
use crate::rows::{Row, Rows};
use crate::selection::Moving;
use crate::slider_follow::{self, SliderFollow};
use crate::{Selection, SelectionMode};

pub(crate) const M_PER_MM: f64 = 1.0 / 1000.0;
pub(crate) const MM_PER_M: f64 = 1000.0;

/// No hand moves anything further than this: more than twice the height of a face.
pub const MAX_OFFSET_M: f64 = 0.5;

/// An edit of less is none: what sliders show and what the history adds up to differ by rounding.
const LEAST_MM: f64 = 1e-6;

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
    /// Of the slider that was moved last.
    slider_follow: SliderFollow,
    /// What each handle does for an amount of 1, while a slider moves.
    ways: Vec<DVec3>,
    /// Room for one offset for each handle.
    offsets_m: Vec<DVec3>,
    rows: Rows,
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
            slider_follow: SliderFollow::default(),
            ways: Vec::new(),
            offsets_m: Vec::new(),
            rows,
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

    /// Whether what is held does not follow in a straight line.
    pub fn turns_details(&self) -> bool {
        self.document.grip().is_some_and(|grip| grip.settings.details == Details::Turned)
    }

    /// How every vertex shown follows the edit in progress, for [`Self::follow_offsets_m`].
    pub fn follow_fields(&self) -> [Option<&[f64]>; 2] {
        let fields = match (self.slider(), self.document.follow()) {
            (Some(_), _) => [&self.slider_follow.a, &self.slider_follow.b],
            (None, Some(follow)) => [&follow.direct, &follow.mirrored],
            (None, None) => return [None, None],
        };
        fields.map(|field| (!field.is_empty()).then_some(field.as_slice()))
    }

    /// The offsets that [`Self::follow_fields`] are for, in metres.
    pub fn follow_offsets_m(&self) -> [DVec3; 2] {
        match self.moving {
            Moving::Nothing => [DVec3::ZERO; 2],
            Moving::Selection { offset_mm } => slider_follow::offsets(offset_mm * M_PER_MM),
            Moving::Slider { slider, by_mm } => slider_follow::slider_offsets(slider, by_mm * M_PER_MM),
        }
    }

    /// Selects something, or nothing; `seed` chooses random anchors.
    pub(crate) fn select(&mut self, selection: Option<Selection>, choices: &Choices, seed: u64) {
        self.selection = selection;
        self.seed = seed;
        self.hold(choices);
    }

    /// Pins vertices, or frees them. An edit in progress goes on.
    pub(crate) fn pin(&mut self, vertices: &[u32], switch: Switch, choices: &Choices) {
        self.pins.retain(|pin| !vertices.contains(pin));
        if switch == Switch::On {
            self.pins.extend(vertices);
        }
        self.hold_on(choices);
    }

    /// Takes hold of what is selected again, after choices have changed. What has no answer stays selected, and cannot be
    /// moved until it has one. An edit in progress is dropped.
    pub(crate) fn hold(&mut self, choices: &Choices) {
        self.moving = Moving::Nothing;
        self.refusal = None;
        let Some(selection) = self.selection else { return self.document.release() };
        let grip = choices.grip(selection, &self.pins, self.seed, &self.document);
        if let Err(reason) = self.document.hold(grip) {
            self.document.release();
            self.refusal = Some(reason);
        }
    }

    /// The same, but an edit in progress goes on.
    pub(crate) fn hold_on(&mut self, choices: &Choices) {
        match self.moving {
            Moving::Nothing => self.hold(choices),
            Moving::Slider { .. } => self.commit(choices),
            Moving::Selection { offset_mm } => {
                self.hold(choices);
                // Details that find no rest are where they were.
                let _ = self.preview(offset_mm);
            }
        }
    }

    /// One tick: no solve, no allocation. What has no answer stays where it is, as the refusal says; and where nothing is
    /// selected, nothing happens: what moved it may speak after what it was for has gone.
    pub(crate) fn preview(&mut self, offset_mm: DVec3) -> Result<(), SessionError> {
        let Some(grip) = self.document.grip() else { return Ok(()) };
        self.offsets_m.clear();
        self.offsets_m.resize(grip.handles.len(), offset_mm * M_PER_MM);
        self.move_to(Moving::Selection { offset_mm })
    }

    /// Takes a ready-made slider in hand, unless it is: one solve. An edit of something else is kept first.
    pub(crate) fn take_slider(&mut self, slider: FaceSlider, choices: &Choices) -> Result<(), SessionError> {
        self.commit(choices);
        let taken = self.document.hold(slider.grip());
        let follow = taken.and_then(|()| SliderFollow::of(&mut self.document, slider));
        self.slider_follow = follow.inspect_err(|_| self.hold(choices))?;
        self.ways = slider.offsets_m(1.0);
        self.refusal = None;
        self.moving = Moving::Slider { slider, by_mm: 0.0 };
        Ok(())
    }

    /// One tick of the slider in hand: no solve, no allocation. `to_mm` is where it is to stand, all its entries counted.
    pub(crate) fn slide(&mut self, slider: FaceSlider, to_mm: f64) -> Result<(), SessionError> {
        let by_mm = to_mm - self.rows.in_force_mm(Subject::Slider(slider));
        self.offsets_m.clear();
        self.offsets_m.extend(self.ways.iter().map(|way| *way * (by_mm * M_PER_MM)));
        self.move_to(Moving::Slider { slider, by_mm })
    }

    fn move_to(&mut self, moving: Moving) -> Result<(), SessionError> {
        match self.document.preview(&self.offsets_m) {
            Ok(()) => self.moving = moving,
            Err(reason) => {
                self.document.cancel();
                self.moving = Moving::Nothing;
                return Err(reason.into());
            }
        }
        Ok(())
    }

    /// Keeps the edit in progress as one entry; nothing moved is no entry. After a slider, the selection is held again.
    pub(crate) fn commit(&mut self, choices: &Choices) {
        let subject = match (self.moving, self.selection) {
            (Moving::Selection { offset_mm }, Some(selection)) if offset_mm != DVec3::ZERO => Some(selection.subject()),
            (Moving::Slider { slider, by_mm }, _) if by_mm.abs() > LEAST_MM => Some(Subject::Slider(slider)),
            _ => None,
        };
        if let Some(subject) = subject {
            let first = self.document.history().entries().len();
            self.document.commit(&self.document.name_of(subject, Language::English));
            self.rows.read(&self.document, first);
        }
        self.cancel(choices);
    }

    /// Drops the edit in progress.
    pub(crate) fn cancel(&mut self, choices: &Choices) {
        self.document.cancel();
        if let Moving::Slider { .. } = std::mem::take(&mut self.moving) {
            self.hold(choices);
        }
    }

    /// Changes the history by something that the document does, which says the first entry that has changed.
    pub(crate) fn change_history(&mut self, choices: &Choices, change: impl FnOnce(&mut Document) -> Option<usize>) {
        self.cancel(choices);
        if let Some(first) = change(&mut self.document) {
            self.rows.read(&self.document, first);
        }
    }

    /// Brings the two sides of the face closer, as an entry of the history.
    pub(crate) fn symmetrise(&mut self, share: f64, choices: &Choices) -> Result<(), SessionError> {
        self.commit(choices);
        let (label, first) = (Subject::Symmetry.name(Language::English), self.document.history().entries().len());
        self.document.apply(&label, Command::Symmetrise { share })?;
        self.rows.read(&self.document, first);
        Ok(())
    }

    /// Shows the cage subdivided so many times. A point that is selected becomes that of the new mesh.
    pub(crate) fn set_density(
        &mut self,
        density: u32,
        mode: SelectionMode,
        choices: &Choices,
    ) -> Result<(), SessionError> {
        self.commit(choices);
        let is_point = mode == SelectionMode::Point || matches!(self.selection, Some(Selection::Point { .. }));
        let selected = self.selected().zip(self.selected_m()).filter(|_| is_point);
        self.document.set_density(density)?;
        if let Some((vertex, place_m)) = selected {
            let is_there = (vertex as usize) < self.document.rest().len();
            let vertex = if is_there { vertex } else { self.nearest(place_m) };
            self.selection = Some(self.at(vertex, SelectionMode::Point));
        }
        self.rows.read(&self.document, 0);
        self.hold(choices);
        Ok(())
    }

    /// Joins the landmarks by other triangles; the edits are carried out again. Points that were pinned are free again.
    pub(crate) fn set_triangulation(
        &mut self,
        triangulation: Triangulation,
        choices: &Choices,
    ) -> Result<(), SessionError> {
        let density = self.document.density();
        self.commit(choices);
        let place_m = self.selected_m();
        let rest = Rest::new(triangulation.topology(), self.model.positions_m().to_vec(), Frame::Model);
        let mut document = self.document.over(rest)?;
        document.set_density(density)?;
        (self.document, self.triangulation) = (document, triangulation);
        self.pins.retain(|pin| (*pin as usize) < LANDMARK_COUNT);
        if let (Some(Selection::Point { level, .. }), Some(place_m)) = (self.selection, place_m) {
            self.selection = Some(Selection::Point { level, vertex: self.nearest(place_m) });
        }
        self.rows.read(&self.document, 0);
        self.hold(choices);
        Ok(())
    }

    /// The edits as versioned JSON.
    pub fn history_json(&self) -> String {
        project::to_json(self.document.history().entries())
    }

    /// Positions in MediaPipe's normalised picture coordinates.
    pub fn positions_image(&self) -> Vec<DVec3> {
        let image_from_model: DMat3 = self.model.image_from_model().matrix3;
        let moved = self.document.positions().iter().zip(self.document.rest());
        let moved = moved.map(|(now, before)| image_from_model * (*now - *before));
        let rest = self.document.from_cage(self.model.positions_image());
        rest.into_iter().zip(moved).map(|(before, moved)| before + moved).collect()
    }

    /// Positions in millimetres.
    pub fn positions_mm(&self) -> Vec<DVec3> {
        self.document.positions().iter().map(|&position| position * MM_PER_M).collect()
    }

    /// Places in the picture for every vertex shown.
    pub fn uvs(&self) -> Vec<DVec2> {
        self.document.from_cage(self.model.uvs())
    }

    /// Colours for every vertex shown: the landmarks' own, and the photo's for those that were added between them.
    pub fn colours_srgb(&self, uvs: &[DVec2]) -> Vec<[u8; 3]> {
        let own = self.model.colours_srgb();
        match self.document.density() {
            0 => own.to_vec(),
            _ => uvs.iter().map(|uv| self.model.picture().colour_under(uv.x, uv.y)).collect(),
        }
    }

    /// For each vertex shown, how much longer its edges are than in the face as it was found: −1 for 20 % or more
    /// shorter, 1 for 20 % or more longer.
    pub fn stretch(&self) -> Vec<f64> {
        let (topology, rest, now) = (self.document.topology(), self.document.rest(), self.document.positions());
        let mut sums = vec![(0.0, 0.0); topology.vertex_count()];
        for edge in topology.edges() {
            let [a, b] = edge.map(|end| end as usize);
            let (before, after) = (rest[a].distance(rest[b]), now[a].distance(now[b]));
            for end in [a, b] {
                sums[end].0 += before;
                sums[end].1 += after;
            }
        }
        let ratio = |(before, after): (f64, f64)| if before > 0.0 { after / before - 1.0 } else { 0.0 };
        sums.into_iter().map(|sum| (ratio(sum) / 0.2).clamp(-1.0, 1.0)).collect()
    }

    /// Where a slider stands, in mm: the sum of its entries that are in force, and the edit in progress.
    pub fn slider_mm(&self, slider: FaceSlider) -> f64 {
        let moving_mm = match self.moving {
            Moving::Slider { slider: moved, by_mm } if moved == slider => by_mm,
            _ => 0.0,
        };
        self.rows.in_force_mm(Subject::Slider(slider)) + moving_mm
    }

    /// The sum in mm of the entries in force that moved what is selected.
    pub fn kept_mm(&self) -> DVec3 {
        let Some(selection) = self.selection else { return DVec3::ZERO };
        let entries = self.document.history().entries();
        let offsets = self.rows.in_force(selection.subject()).filter_map(|row| match &entries[row.index].command {
            Command::Move { offsets, .. } => offsets.first(),
            Command::Symmetrise { .. } => None,
        });
        offsets.sum::<DVec3>() * MM_PER_M
    }

    /// Whether the history holds edits in force of what is selected.
    pub fn can_reset_selection(&self) -> bool {
        self.selection.is_some_and(|selection| self.rows.in_force(selection.subject()).next().is_some())
    }

    /// Whether what is selected is its own mirror image and the mirror is on, so that it cannot move along x.
    pub fn moves_in_plane(&self) -> bool {
        let Some(selection) = self.selection else { return false };
        let handles = selection.handles();
        let is_mirrored = self.document.grip().is_some_and(|grip| grip.settings.mirror == rosto_studio::Mirror::On);
        let partner = |handle: u32| self.document.partner(selection.level(), handle);
        let is_own_image = |&handle: &u32| partner(handle).is_some_and(|partner| handles.contains(&partner));
        is_mirrored && handles.iter().all(is_own_image)
    }

    /// Share of its offset that the vertex selected reaches: 1 is all of it. What moves in the mirror's plane is moved by both its
    /// own offset and the mirrored one.
    pub fn reach(&self) -> f64 {
        match (self.document.grip().map(|grip| grip.settings.hold), self.selected(), self.document.follow()) {
            (Some(Hold::Exact), ..) => 1.0,
            (Some(_), Some(vertex), Some(follow)) => {
                let share = |field: &[f64]| field.get(vertex as usize).copied().unwrap_or(0.0);
                share(&follow.direct) + if self.moves_in_plane() { share(&follow.mirrored) } else { 0.0 }
            }
            _ => 0.0,
        }
    }

    /// Number of neighbours of the vertex selected: of a landmark, in the cage.
    pub fn degree(&self) -> u32 {
        match self.selection {
            Some(Selection::Point { vertex, .. }) => self.document.topology().degree(vertex) as u32,
            Some(other) => self.triangulation.topology().degree(other.middle()) as u32,
            None => 0,
        }
    }
}
