use glam::{DMat3, DVec2, DVec3};
use rosto_face::{FaceModel, LANDMARK_COUNT, Language, Triangulation, landmark_name};
use rosto_studio::{Command, Document, Entry, Frame, Hold, Rest, Switch, project};

use crate::choices::{AnchorChoice, Choices};
use crate::state::{StudioEntry, StudioState};
use crate::trouble::{Outcome, Trouble};

const M_PER_MM: f64 = 1.0 / 1000.0;
const MM_PER_M: f64 = 1000.0;

/// One open face: its model, its document, and the landmark in hand. Knows neither the page nor the GPU.
pub(crate) struct Session {
    pub face: FaceModel,
    triangulation: Triangulation,
    pub document: Document,
    selected: Option<u32>,
    seed: u64,
    offset_mm: DVec3,
    is_moving: bool,
}

impl Session {
    pub fn new(face: FaceModel) -> Outcome<Self> {
        let document = Document::new(Rest::of_face(&face))?;
        Ok(Self {
            triangulation: face.triangulation(),
            face,
            document,
            selected: None,
            seed: 0,
            offset_mm: DVec3::ZERO,
            is_moving: false,
        })
    }

    /// How the landmarks are joined.
    pub fn triangulation(&self) -> Triangulation {
        self.triangulation
    }

    pub fn selected(&self) -> Option<u32> {
        self.selected
    }

    pub fn is_moving(&self) -> bool {
        self.is_moving
    }

    pub fn offset_m(&self) -> DVec3 {
        if self.is_moving { self.offset_mm * M_PER_MM } else { DVec3::ZERO }
    }

    /// Takes a landmark in hand, or lets go; `seed` chooses random anchors.
    pub fn select(&mut self, vertex: Option<u32>, choices: &mut Choices, seed: u64) -> Outcome<()> {
        if let Some(vertex) = vertex.filter(|&vertex| vertex as usize >= LANDMARK_COUNT) {
            return Err(Trouble::bad_vertex(vertex, LANDMARK_COUNT));
        }
        if let AnchorChoice::Explicit(_) = choices.anchors {
            choices.anchors = AnchorChoice::Random;
        }
        self.selected = vertex;
        self.seed = seed;
        self.hold(choices)
    }

    /// Takes the selected landmark in hand again, after choices have changed. What has no answer lets go of it.
    pub fn hold(&mut self, choices: &Choices) -> Outcome<()> {
        self.cancel();
        let held = match self.selected {
            Some(vertex) => self.document.hold(choices.grip(vertex, self.seed)),
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

    /// One tick: no solve, no allocation.
    pub fn preview(&mut self, offset_mm: DVec3) -> Outcome<()> {
        self.document.preview(&[offset_mm * M_PER_MM])?;
        self.offset_mm = offset_mm;
        self.is_moving = true;
        Ok(())
    }

    pub fn commit(&mut self) {
        if let (true, Some(vertex)) = (self.is_moving && self.offset_mm != DVec3::ZERO, self.selected) {
            self.document.commit(&landmark_name(vertex, Language::English));
        }
        self.cancel();
    }

    pub fn cancel(&mut self) {
        self.document.cancel();
        self.is_moving = false;
        self.offset_mm = DVec3::ZERO;
    }

    pub fn undo(&mut self) {
        self.cancel();
        self.document.undo();
    }

    pub fn redo(&mut self) -> Outcome<()> {
        self.cancel();
        Ok(self.document.redo()?)
    }

    pub fn reset(&mut self) {
        self.cancel();
        self.document.reset();
    }

    pub fn switch(&mut self, index: u32, switch: Switch) -> Outcome<()> {
        self.cancel();
        Ok(self.document.switch(index as usize, switch)?)
    }

    pub fn set_density(&mut self, levels: u32, choices: &Choices) -> Outcome<()> {
        self.cancel();
        self.document.set_density(levels)?;
        self.hold(choices)
    }

    /// Joins the landmarks by other triangles; the edits are carried out again.
    pub fn set_triangulation(&mut self, triangulation: Triangulation, choices: &Choices) -> Outcome<()> {
        let entries = self.document.history().applied().to_vec();
        self.replace_document(self.rest(triangulation), entries)?;
        self.triangulation = triangulation;
        self.hold(choices)
    }

    /// The edits as versioned JSON.
    pub fn edits_json(&self) -> String {
        project::to_json(self.document.history().applied())
    }

    /// Puts the edits of such a text in place of those there are.
    pub fn open_edits(&mut self, json: &str, choices: &Choices) -> Outcome<()> {
        let entries = project::from_json(json)?;
        self.replace_document(self.rest(self.triangulation), entries)?;
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
        StudioState {
            has_face: true,
            vertex_count: topology.vertex_count() as u32,
            edge_count: topology.edges().len() as u32,
            triangle_count: topology.triangles().len() as u32,
            selected: self.selected,
            selected_degree: self.selected.map_or(0, |vertex| self.degree(vertex)),
            offset_x_mm: self.offset_mm.x,
            offset_y_mm: self.offset_mm.y,
            offset_z_mm: self.offset_mm.z,
            reach: self.reach(),
            editing: self.is_moving,
            can_undo: history.can_undo(),
            can_redo: history.can_redo(),
            entries: history.applied().iter().enumerate().filter_map(|(index, entry)| row(index, entry)).collect(),
        }
    }

    fn degree(&self, vertex: u32) -> u32 {
        self.triangulation.topology().degree(vertex) as u32
    }

    fn rest(&self, triangulation: Triangulation) -> Rest {
        Rest::new(triangulation.topology(), self.face.positions_m().to_vec(), Frame::Model)
    }

    fn reach(&self) -> f64 {
        match (self.document.grip().map(|grip| grip.settings.hold), self.selected) {
            (Some(Hold::Exact), _) => 1.0,
            (Some(_), Some(vertex)) => self.document.follow().map_or(0.0, |follow| follow.direct[vertex as usize]),
            _ => 0.0,
        }
    }

    fn replace_document(&mut self, rest: Rest, entries: Vec<Entry>) -> Outcome<()> {
        let density = self.document.density();
        let mut document = Document::replay(rest, entries)?;
        document.set_density(density)?;
        self.document = document;
        self.is_moving = false;
        self.offset_mm = DVec3::ZERO;
        Ok(())
    }
}

/// An entry as the page lists it; only moves are listed.
fn row(index: usize, entry: &Entry) -> Option<StudioEntry> {
    let Command::Move { grip, offsets } = &entry.command else { return None };
    let offset_mm = offsets.first().copied().unwrap_or_default() * MM_PER_M;
    Some(StudioEntry {
        index: index as u32,
        label: entry.label.clone(),
        vertex: grip.handles.first().copied().unwrap_or_default(),
        x_mm: offset_mm.x,
        y_mm: offset_mm.y,
        z_mm: offset_mm.z,
        enabled: entry.switch == Switch::On,
    })
}
