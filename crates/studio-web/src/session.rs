use glam::{DMat3, DVec2, DVec3};
use rosto_face::{FaceModel, LANDMARK_COUNT, Language, Triangulation};
use rosto_studio::{Command, Details, Document, FaceSlider, Frame, Hold, Mirror, Rest, Subject, project};

use crate::choices::{AnchorChoice, Choices};
use crate::follow::{self, SliderFollow};
use crate::hand::{Hand, Moving, Selection};
use crate::state::{StudioEntry, StudioState};
use crate::trouble::{Outcome, Trouble};

mod taking;
#[cfg(test)]
mod tests;

const M_PER_MM: f64 = 1.0 / 1000.0;
const MM_PER_M: f64 = 1000.0;

/// An edit of less is none: what sliders show and what the history adds up to differ by rounding.
const LEAST_MM: f64 = 1e-6;

/// One open face: its model, its document, and what is in hand. Knows neither the page nor the GPU.
pub(crate) struct Session {
    pub face: FaceModel,
    triangulation: Triangulation,
    pub document: Document,
    /// Of the slider that was in hand last.
    slider_follow: SliderFollow,
    selection: Option<Selection>,
    seed: u64,
    moving: Moving,
    /// What each handle does for an amount of 1, while a slider moves.
    ways: Vec<DVec3>,
    /// Room for one offset for each handle.
    offsets_m: Vec<DVec3>,
    /// The history as the page lists it; read anew after each change.
    rows: Vec<StudioEntry>,
}

impl Session {
    pub fn new(face: FaceModel) -> Outcome<Self> {
        let document = Document::new(Rest::of_face(&face))?;
        Ok(Self {
            triangulation: face.triangulation(),
            face,
            document,
            slider_follow: SliderFollow::default(),
            selection: None,
            seed: 0,
            moving: Moving::Nothing,
            ways: Vec::new(),
            offsets_m: Vec::new(),
            rows: Vec::new(),
        })
    }

    /// How the landmarks are joined.
    pub fn triangulation(&self) -> Triangulation {
        self.triangulation
    }

    pub fn selection(&self) -> Option<Selection> {
        self.selection
    }

    /// The vertex in hand, or the landmark in the middle of the region.
    pub fn selected(&self) -> Option<u32> {
        self.selection.map(Selection::middle)
    }

    pub fn is_moving(&self) -> bool {
        self.moving != Moving::Nothing
    }

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
            Moving::Selection { offset_mm } => follow::offsets(offset_mm * M_PER_MM),
            Moving::Slider { slider, by_mm } => follow::slider_offsets(slider, by_mm * M_PER_MM),
        }
    }

    /// Takes something in hand, or lets go; `seed` chooses random anchors.
    pub fn select(&mut self, selection: Option<Selection>, choices: &mut Choices, seed: u64) -> Outcome<()> {
        if let Some(Selection::Landmark(vertex)) = selection
            && vertex as usize >= LANDMARK_COUNT
        {
            return Err(Trouble::bad_vertex(vertex, LANDMARK_COUNT));
        }
        if let AnchorChoice::Explicit(_) = choices.anchors {
            choices.anchors = AnchorChoice::Random;
        }
        self.selection = selection;
        self.seed = seed;
        self.hold(choices)
    }

    /// Takes what is selected in hand again, after choices have changed. What has no answer lets go of it. An edit in
    /// progress is dropped.
    pub fn hold(&mut self, choices: &Choices) -> Outcome<()> {
        self.moving = Moving::Nothing;
        let held = match self.selection {
            Some(selection) => self.document.hold(choices.grip(selection, self.seed, &self.document)),
            None => {
                self.document.release();
                Ok(())
            }
        };
        if held.is_err() {
            self.document.release();
        }
        Ok(held?)
    }

    /// The same, but an edit in progress goes on.
    pub fn hold_on(&mut self, choices: &Choices) -> Outcome<()> {
        match self.moving {
            Moving::Nothing => self.hold(choices),
            Moving::Slider { .. } => self.commit(choices),
            Moving::Selection { offset_mm } => {
                self.hold(choices)?;
                self.preview(offset_mm)
            }
        }
    }

    /// One tick: no solve, no allocation.
    pub fn preview(&mut self, offset_mm: DVec3) -> Outcome<()> {
        let handles = self.document.grip().map_or(0, |grip| grip.handles.len());
        self.offsets_m.clear();
        self.offsets_m.resize(handles, offset_mm * M_PER_MM);
        self.document.preview(&self.offsets_m)?;
        self.moving = Moving::Selection { offset_mm };
        Ok(())
    }

    /// Takes a ready-made slider in hand, unless it is: one solve. An edit of something else is kept first.
    pub fn take_slider(&mut self, slider: FaceSlider, choices: &Choices) -> Outcome<()> {
        self.commit(choices)?;
        self.document.hold(slider.grip())?;
        self.slider_follow = SliderFollow::of(&mut self.document, slider)?;
        self.ways = slider.offsets_m(1.0);
        self.moving = Moving::Slider { slider, by_mm: 0.0 };
        Ok(())
    }

    /// One tick of the slider in hand: no solve, no allocation. `to_mm` is where it is to stand, all its entries counted.
    pub fn slide(&mut self, slider: FaceSlider, to_mm: f64) -> Outcome<()> {
        let by_mm = to_mm - self.kept_slider_mm(slider);
        self.offsets_m.clear();
        self.offsets_m.extend(self.ways.iter().map(|way| *way * (by_mm * M_PER_MM)));
        self.document.preview(&self.offsets_m)?;
        self.moving = Moving::Slider { slider, by_mm };
        Ok(())
    }

    /// Keeps the edit in progress as one entry; nothing moved is no entry. After a slider, the selection is in hand again.
    pub fn commit(&mut self, choices: &Choices) -> Outcome<()> {
        let subject = match (self.moving, self.selection) {
            (Moving::Selection { offset_mm }, Some(selection)) if offset_mm != DVec3::ZERO => Some(selection.subject()),
            (Moving::Slider { slider, by_mm }, _) if by_mm.abs() > LEAST_MM => Some(Subject::Slider(slider)),
            _ => None,
        };
        if let Some(subject) = subject {
            self.document.commit(&self.document.name_of(subject, Language::English));
            self.read_history();
        }
        self.cancel(choices)
    }

    /// Drops the edit in progress.
    pub fn cancel(&mut self, choices: &Choices) -> Outcome<()> {
        self.document.cancel();
        match std::mem::take(&mut self.moving) {
            Moving::Slider { .. } => self.hold(choices),
            _ => Ok(()),
        }
    }

    /// Changes the history by something that the document does; an edit in progress is dropped.
    pub fn change_history<E: Into<Trouble>>(
        &mut self,
        choices: &Choices,
        change: impl FnOnce(&mut Document) -> Result<(), E>,
    ) -> Outcome<()> {
        self.cancel(choices)?;
        let outcome = change(&mut self.document);
        self.read_history();
        outcome.map_err(Into::into)
    }

    /// Brings the two sides of the face closer, as an entry of the history.
    pub fn symmetrise(&mut self, share: f64, choices: &Choices) -> Outcome<()> {
        self.commit(choices)?;
        let label = Subject::Symmetry.name(Language::English);
        self.change_history(choices, |document| document.apply(&label, Command::Symmetrise { share }))
    }

    /// What an entry of the history works on.
    pub fn subject_of(&self, index: usize) -> Outcome<Subject> {
        self.rows.get(index).map(|row| row.subject).ok_or_else(Trouble::no_entry)
    }

    /// Shows the cage subdivided so many times. A point in hand becomes that of the new mesh.
    pub fn set_density(&mut self, levels: u32, hand: Hand, choices: &Choices) -> Outcome<()> {
        self.commit(choices)?;
        let in_hand = self.selected().zip(self.selected_m());
        self.document.set_density(levels)?;
        if let (Hand::Point, Some((vertex, place_m))) = (hand, in_hand) {
            let is_there = (vertex as usize) < self.document.rest().len();
            let vertex = if is_there { vertex } else { self.nearest(place_m) };
            self.selection = Some(self.at(vertex, hand));
        }
        self.read_history();
        self.hold(choices)
    }

    /// Joins the landmarks by other triangles; the edits are carried out again.
    pub fn set_triangulation(&mut self, triangulation: Triangulation, choices: &Choices) -> Outcome<()> {
        self.commit(choices)?;
        let place_m = self.selected_m();
        let document = self.document.over(self.rest(triangulation))?;
        self.replace_document(document)?;
        self.triangulation = triangulation;
        if let (Some(Selection::Point { level, .. }), Some(place_m)) = (self.selection, place_m) {
            self.selection = Some(Selection::Point { level, vertex: self.nearest(place_m) });
        }
        self.hold(choices)
    }

    /// The edits as versioned JSON.
    pub fn edits_json(&self) -> String {
        project::to_json(self.document.history().entries())
    }

    /// Puts the edits of such a text in place of those there are.
    pub fn open_edits(&mut self, json: &str, choices: &Choices) -> Outcome<()> {
        let entries = project::from_json(json)?;
        self.replace_document(Document::replay(self.rest(self.triangulation), entries)?)?;
        self.hold(choices)
    }

    /// Positions in MediaPipe's normalised picture coordinates.
    pub fn positions_image(&self) -> Vec<DVec3> {
        let image_from_model: DMat3 = self.face.image_from_model().matrix3;
        let moved = self.document.positions().iter().zip(self.document.rest());
        let moved = moved.map(|(now, before)| image_from_model * (*now - *before));
        let rest = self.document.from_cage(self.face.positions_image());
        rest.into_iter().zip(moved).map(|(before, moved)| before + moved).collect()
    }

    /// Positions in millimetres.
    pub fn positions_mm(&self) -> Vec<DVec3> {
        self.document.positions().iter().map(|&position| position * MM_PER_M).collect()
    }

    /// Places in the picture for every vertex shown.
    pub fn uvs(&self) -> Vec<DVec2> {
        self.document.from_cage(self.face.uvs())
    }

    /// Colours for every vertex shown: the landmarks' own, and the photo's for those that were added between them.
    pub fn colours_srgb(&self, uvs: &[DVec2]) -> Vec<[u8; 3]> {
        let own = self.face.colours_srgb();
        match self.document.density() {
            0 => own.to_vec(),
            _ => uvs.iter().map(|uv| self.face.picture().colour_under(uv.x, uv.y)).collect(),
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

    pub fn state(&self) -> StudioState {
        let topology = self.document.topology();
        let history = self.document.history();
        let offset_mm = match self.moving {
            Moving::Selection { offset_mm } => offset_mm,
            _ => DVec3::ZERO,
        };
        let kept_mm = self.kept_offset_m() * MM_PER_M;
        StudioState {
            has_face: true,
            vertex_count: topology.vertex_count() as u32,
            edge_count: topology.edges().len() as u32,
            triangle_count: topology.triangles().len() as u32,
            selected: self.selected(),
            selected_region: match self.selection {
                Some(Selection::Region(region)) => Some(region.id().to_owned()),
                _ => None,
            },
            can_mirror: self.can_mirror(),
            selected_degree: self.selected().map_or(0, |vertex| self.degree(vertex)),
            selected_in_plane: self.moves_in_plane(),
            offset_x_mm: offset_mm.x,
            offset_y_mm: offset_mm.y,
            offset_z_mm: offset_mm.z,
            kept_x_mm: kept_mm.x,
            kept_y_mm: kept_mm.y,
            kept_z_mm: kept_mm.z,
            sliders_mm: FaceSlider::ALL.iter().map(|&slider| self.slider_mm(slider)).collect(),
            reach: self.reach(),
            editing: self.is_moving(),
            can_reset_selection: self.selection.is_some_and(|one| self.in_force(one.subject()).next().is_some()),
            can_undo: history.can_undo(),
            can_redo: history.can_redo(),
            entries: self.rows.clone(),
        }
    }

    /// Where a slider stands.
    fn slider_mm(&self, slider: FaceSlider) -> f64 {
        let moving_mm = match self.moving {
            Moving::Slider { slider: in_hand, by_mm } if in_hand == slider => by_mm,
            _ => 0.0,
        };
        self.kept_slider_mm(slider) + moving_mm
    }

    /// The sum of the slider's entries that are in force.
    fn kept_slider_mm(&self, slider: FaceSlider) -> f64 {
        self.in_force(Subject::Slider(slider)).map(|row| row.amount).sum()
    }

    /// The sum of the entries in force that moved what is selected.
    fn kept_offset_m(&self) -> DVec3 {
        let Some(selection) = self.selection else { return DVec3::ZERO };
        let entries = self.document.history().entries();
        let offsets = self.in_force(selection.subject()).filter_map(|row| match &entries[row.index as usize].command {
            Command::Move { offsets, .. } => offsets.first(),
            Command::Symmetrise { .. } => None,
        });
        offsets.sum()
    }

    fn in_force(&self, subject: Subject) -> impl Iterator<Item = &StudioEntry> {
        self.rows.iter().filter(move |row| row.enabled && row.subject == subject)
    }

    fn read_history(&mut self) {
        let entries = self.document.history().entries().iter();
        let density = self.document.density();
        self.rows = entries.enumerate().map(|(index, entry)| StudioEntry::new(index, entry, density)).collect();
    }

    fn degree(&self, vertex: u32) -> u32 {
        match self.selection {
            Some(Selection::Point { .. }) => self.document.topology().degree(vertex) as u32,
            _ => self.triangulation.topology().degree(vertex) as u32,
        }
    }

    fn rest(&self, triangulation: Triangulation) -> Rest {
        Rest::new(triangulation.topology(), self.face.positions_m().to_vec(), Frame::Model)
    }

    fn moves_in_plane(&self) -> bool {
        let Some(selection) = self.selection else { return false };
        let handles = selection.handles();
        let is_mirrored = self.document.grip().is_some_and(|grip| grip.settings.mirror == Mirror::On);
        let partner = |handle: u32| self.document.partner(selection.level(), handle);
        let is_own_image = |&handle: &u32| partner(handle).is_some_and(|partner| handles.contains(&partner));
        is_mirrored && handles.iter().all(is_own_image)
    }

    fn reach(&self) -> f64 {
        match (self.document.grip().map(|grip| grip.settings.hold), self.selected()) {
            (Some(Hold::Exact), _) => 1.0,
            (Some(_), Some(vertex)) => self.document.follow().map_or(0.0, |follow| follow.direct[vertex as usize]),
            _ => 0.0,
        }
    }

    fn replace_document(&mut self, mut document: Document) -> Outcome<()> {
        document.set_density(self.document.density())?;
        self.document = document;
        self.moving = Moving::Nothing;
        self.read_history();
        Ok(())
    }
}
