use glam::{DMat3, DVec2, DVec3};
use rosto_face::{FaceModel, LANDMARK_COUNT, Language, Region, Triangulation};
use rosto_studio::{Command, Details, Document, FaceSlider, Frame, Hold, Rest, StudioError, Subject, project};

use crate::choices::{AnchorChoice, Choices};
use crate::follow::{self, SliderFollow};
use crate::hand::{Moving, Selection};
use crate::state::{StudioEntry, StudioState};
use crate::trouble::{Outcome, Trouble};

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

    /// The landmark in hand, or the one in the middle of the region.
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

    /// Takes landmarks in hand, or lets go; `seed` chooses random anchors.
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

    /// The smallest region around a landmark; if it is in hand already, the next larger one.
    pub fn region_at(&self, landmark: u32) -> Option<Region> {
        let around = Region::containing(landmark);
        let is_in_hand = |region: &Region| self.selection == Some(Selection::Region(*region));
        let next = around.iter().position(is_in_hand).map_or(0, |place| (place + 1) % around.len());
        around.get(next).copied()
    }

    /// Takes what is selected in hand again, after choices have changed. What has no answer lets go of it. An edit in
    /// progress is dropped.
    pub fn hold(&mut self, choices: &Choices) -> Outcome<()> {
        self.moving = Moving::Nothing;
        let held = match self.selection {
            Some(selection) => self.document.hold(choices.grip(selection.handles(), self.seed)),
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
            self.document.commit(&subject.name(Language::English));
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

    pub fn set_density(&mut self, levels: u32, choices: &Choices) -> Outcome<()> {
        self.commit(choices)?;
        self.document.set_density(levels)?;
        self.hold(choices)
    }

    /// Joins the landmarks by other triangles; the edits are carried out again.
    pub fn set_triangulation(&mut self, triangulation: Triangulation, choices: &Choices) -> Outcome<()> {
        self.commit(choices)?;
        let history = self.document.history().clone();
        self.replace_document(|rest| Document::resume(rest, history), triangulation)?;
        self.triangulation = triangulation;
        self.hold(choices)
    }

    /// The edits as versioned JSON.
    pub fn edits_json(&self) -> String {
        project::to_json(self.document.history().entries())
    }

    /// Puts the edits of such a text in place of those there are.
    pub fn open_edits(&mut self, json: &str, choices: &Choices) -> Outcome<()> {
        let entries = project::from_json(json)?;
        self.replace_document(|rest| Document::replay(rest, entries), self.triangulation)?;
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
            selected_degree: self.selected().map_or(0, |vertex| self.degree(vertex)),
            offset_x_mm: offset_mm.x,
            offset_y_mm: offset_mm.y,
            offset_z_mm: offset_mm.z,
            kept_x_mm: kept_mm.x,
            kept_y_mm: kept_mm.y,
            kept_z_mm: kept_mm.z,
            sliders_mm: FaceSlider::ALL.iter().map(|&slider| self.slider_mm(slider)).collect(),
            reach: self.reach(),
            editing: self.is_moving(),
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
        self.rows = entries.enumerate().map(|(index, entry)| StudioEntry::new(index, entry)).collect();
    }

    fn degree(&self, vertex: u32) -> u32 {
        self.triangulation.topology().degree(vertex) as u32
    }

    fn rest(&self, triangulation: Triangulation) -> Rest {
        Rest::new(triangulation.topology(), self.face.positions_m().to_vec(), Frame::Model)
    }

    fn reach(&self) -> f64 {
        match (self.document.grip().map(|grip| grip.settings.hold), self.selected()) {
            (Some(Hold::Exact), _) => 1.0,
            (Some(_), Some(vertex)) => self.document.follow().map_or(0.0, |follow| follow.direct[vertex as usize]),
            _ => 0.0,
        }
    }

    fn replace_document(
        &mut self,
        make: impl FnOnce(Rest) -> Result<Document, StudioError>,
        triangulation: Triangulation,
    ) -> Outcome<()> {
        let mut document = make(self.rest(triangulation))?;
        document.set_density(self.document.density())?;
        self.document = document;
        self.moving = Moving::Nothing;
        self.read_history();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_face::{FaceInput, Photo, canonical_positions_m, mirror_of};
    use rosto_studio::{Mirror, Switch};

    fn session() -> Session {
        let landmarks: Vec<[f32; 3]> = canonical_positions_m()
            .iter()
            .map(|p| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|coordinate| coordinate as f32))
            .collect();
        let picture = Photo::from_rgb(1, 1, vec![0; 3]).unwrap();
        let input =
            FaceInput { landmarks: &landmarks, width: 64, height: 64, colours: &[[0; 3]; LANDMARK_COUNT], picture };
        Session::new(FaceModel::new(input, Triangulation::Canonical).unwrap()).unwrap()
    }

    fn sculpting() -> Choices {
        let sculpt = Choices { hold: Hold::Exact, anchors: AnchorChoice::Oval, ..Choices::default() };
        Choices { mirror: Mirror::On, ..sculpt }
    }

    fn drag(session: &mut Session, slider: FaceSlider, to_mm: f64) {
        session.take_slider(slider, &sculpting()).unwrap();
        for tick in 1..=8 {
            session.slide(slider, to_mm * f64::from(tick) / 8.0).unwrap();
        }
        session.commit(&sculpting()).unwrap();
    }

    fn stands_at(session: &Session, slider: FaceSlider) -> f64 {
        let place = FaceSlider::ALL.iter().position(|one| *one == slider).unwrap();
        session.state().sliders_mm[place]
    }

    #[test]
    fn a_slider_stands_where_its_entries_in_force_add_up_to() {
        let (mut session, choices) = (session(), sculpting());
        let slider = FaceSlider::NoseWidth;
        drag(&mut session, slider, 2.0);
        drag(&mut session, FaceSlider::ChinLength, -3.0);
        drag(&mut session, slider, 1.5);
        assert_eq!(session.state().entries.len(), 3);
        assert!((stands_at(&session, slider) - 1.5).abs() < 1e-9);
        session.change_history(&choices, |document| document.switch(0, Switch::Off)).unwrap();
        assert!((stands_at(&session, slider) + 0.5).abs() < 1e-9);
        session.change_history(&choices, Document::undo).unwrap();
        session.change_history(&choices, Document::undo).unwrap();
        assert!((stands_at(&session, slider) - 2.0).abs() < 1e-9);
        session.change_history(&choices, Document::redo).unwrap();
        assert!((stands_at(&session, slider) - 1.5).abs() < 1e-9);
        assert!((stands_at(&session, FaceSlider::ChinLength) + 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_drag_of_a_slider_is_the_command_of_its_amount() {
        let mut session = session();
        drag(&mut session, FaceSlider::JawWidth, 4.0);
        let dragged = session.document.positions().to_vec();
        let entries = session.document.history().entries();
        assert_eq!((entries.len(), entries[0].label.as_str()), (1, "jaw width"));
        let mut applied = Document::new(Rest::of_face(&session.face)).unwrap();
        applied.apply("", FaceSlider::JawWidth.command(0.004)).unwrap();
        assert!(dragged.iter().zip(applied.positions()).all(|(a, b)| a.distance(*b) < 1e-15));
    }

    #[test]
    fn a_slider_put_back_or_let_go_of_leaves_no_entry() {
        let (mut session, choices) = (session(), sculpting());
        let slider = FaceSlider::LipFullness;
        let rest = session.document.positions().to_vec();
        session.take_slider(slider, &choices).unwrap();
        session.slide(slider, 2.0).unwrap();
        assert!(session.state().editing && (stands_at(&session, slider) - 2.0).abs() < 1e-12);
        session.cancel(&choices).unwrap();
        assert_eq!((session.document.positions(), stands_at(&session, slider)), (&rest[..], 0.0));
        session.take_slider(slider, &choices).unwrap();
        session.slide(slider, 2.0).unwrap();
        session.slide(slider, 0.0).unwrap();
        session.commit(&choices).unwrap();
        assert!(session.state().entries.is_empty());
    }

    #[test]
    fn the_selection_is_in_hand_again_after_a_slider() {
        let (mut session, mut choices) = (session(), sculpting());
        session.select(Some(Selection::Landmark(61)), &mut choices, 5).unwrap();
        let (grip, follow) = (session.document.grip().cloned(), session.document.follow().cloned().unwrap());
        session.preview(DVec3::new(0.0, 1.0, 0.0)).unwrap();
        drag(&mut session, FaceSlider::EyeSize, 1.0);
        let subjects: Vec<Subject> = session.state().entries.iter().map(|entry| entry.subject).collect();
        assert_eq!(subjects, [Subject::Landmark(61), Subject::Slider(FaceSlider::EyeSize)]);
        assert_eq!(session.document.grip().cloned(), grip);
        let fields = session.follow_fields()[0].unwrap().iter().zip(follow.direct);
        assert!(fields.into_iter().all(|(now, before)| (now - before).abs() < 1e-12));
        assert_eq!(session.state().kept_y_mm, 1.0);
    }

    #[test]
    fn a_region_moves_as_one_on_both_sides() {
        let (mut session, mut choices) = (session(), sculpting());
        let brow = Selection::Region(Region::LeftBrow);
        session.select(Some(brow), &mut choices, 5).unwrap();
        let before = session.document.positions().to_vec();
        let offset_mm = DVec3::new(1.0, 2.0, 0.5);
        session.preview(offset_mm).unwrap();
        session.commit(&choices).unwrap();
        let way_mm = |vertex: u32| (session.document.positions()[vertex as usize] - before[vertex as usize]) * MM_PER_M;
        for vertex in brow.handles() {
            assert!(way_mm(vertex).distance(offset_mm) < 1e-9);
            let mirrored = DVec3::new(-offset_mm.x, offset_mm.y, offset_mm.z);
            assert!(way_mm(mirror_of(vertex)).distance(mirrored) < 1e-9);
        }
        let state = session.state();
        assert_eq!(state.selected_region.as_deref(), Some("left-brow"));
        assert_eq!((state.entries.len(), state.entries[0].label.as_str()), (1, "left brow"));
        assert!((DVec3::new(state.kept_x_mm, state.kept_y_mm, state.kept_z_mm) - offset_mm).length() < 1e-9);
    }

    #[test]
    fn asking_again_takes_the_next_larger_region() {
        let (mut session, mut choices) = (session(), sculpting());
        let mut seen = Vec::new();
        for _ in 0..4 {
            let region = session.region_at(1).unwrap();
            session.select(Some(Selection::Region(region)), &mut choices, 0).unwrap();
            seen.push(region);
        }
        assert_eq!(seen, [Region::NoseTip, Region::Nose, Region::NoseTip, Region::Nose]);
    }
}
