use std::time::Duration;

use glam::DVec3;
use rosto_laplacian::{
    ConstraintKind, Constraints, Distortion, DistortionSummary, LaplacianError, LaplacianSystem, Operator,
    random_anchors,
};
use rosto_mesh::Topology;

/// The paper's small offset, then its large one, in normalised image coordinates.
pub const OFFSETS: [DVec3; 2] = [DVec3::splat(-0.005), DVec3::new(0.1, 0.1, -0.1)];

/// The least degree of the mesh, the commonest, and the greatest.
pub const DEGREES: [usize; 3] = [3, 6, 8];

/// A way of editing. The default is the paper's: `L_s` with soft constraints of weight 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Method {
    /// What δ-coordinates are taken with.
    pub operator: Operator,
    /// How firmly handle and anchors are held.
    pub constraint: ConstraintKind,
}

impl Method {
    /// Every operator, softly and exactly held; the paper's own first.
    pub fn all() -> Vec<Self> {
        let constraints = [ConstraintKind::default(), ConstraintKind::Hard];
        Operator::ALL
            .into_iter()
            .flat_map(|operator| constraints.map(|constraint| Self { operator, constraint }))
            .collect()
    }
}

/// The mesh that the experiment is made on.
pub struct Experiment {
    topology: Topology,
    rest: Vec<DVec3>,
    yardstick: LaplacianSystem,
}

impl Experiment {
    /// On a face's landmarks in normalised image coordinates, joined by the paper's triangles: MediaPipe's tessellation.
    ///
    /// # Errors
    /// [`LaplacianError`] for positions that do not fit the mesh or are not finite.
    pub fn new(topology: Topology, positions_image: Vec<DVec3>) -> Result<Self, LaplacianError> {
        let yardstick = LaplacianSystem::new(&topology, &positions_image, Operator::UniformSymmetric)?;
        Ok(Self { topology, rest: positions_image, yardstick })
    }

    /// The first vertex of that degree in an order that the seed shuffles.
    fn vertex_of_degree(&self, degree: usize, seed: u64) -> u32 {
        let all = 0..self.topology.vertex_count() as u32;
        let others: Vec<u32> = all.filter(|&vertex| self.topology.degree(vertex) != degree).collect();
        random_anchors(self.topology.vertex_count(), &others, seed)[0]
    }
}

/// An edit that is to be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    /// The vertex's number of neighbours.
    pub degree: usize,
    /// Which of [`OFFSETS`].
    pub round: usize,
    /// The vertex that is moved.
    pub vertex: u32,
    /// The vertices that hold the rest.
    pub anchors: [u32; 2],
}

/// An edit that was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimedEdit {
    /// What was done.
    pub plan: Plan,
    /// How long it took: operator, factor, solve and displacement.
    pub time: Duration,
    /// How many peaks it raised.
    pub peaks: usize,
}

/// One run of the experiment: six edits, each on the mesh that the last one left.
#[derive(Debug, Clone)]
pub struct Trial {
    method: Method,
    seed: u64,
    positions: Vec<DVec3>,
    edits: Vec<TimedEdit>,
    after_rounds: Vec<Vec<DVec3>>,
}

impl Trial {
    /// Nothing is edited yet. The seed chooses vertices and anchors.
    pub fn new(experiment: &Experiment, method: Method, seed: u64) -> Self {
        Self { method, seed, positions: experiment.rest.clone(), edits: Vec::new(), after_rounds: Vec::new() }
    }

    /// How the edits are made.
    pub fn method(&self) -> Method {
        self.method
    }

    /// The edits so far: each degree by the small offset, then each by the large one.
    pub fn edits(&self) -> &[TimedEdit] {
        &self.edits
    }

    /// Positions in image coordinates after the small offsets, and after the large ones, as far as they are made.
    pub fn after_rounds(&self) -> &[Vec<DVec3>] {
        &self.after_rounds
    }

    /// The next edit; `None` after the last.
    pub fn next_edit(&self, experiment: &Experiment) -> Option<Plan> {
        let number = self.edits.len();
        let round = number / DEGREES.len();
        let degree = *DEGREES.get(number % DEGREES.len()).filter(|_| round < OFFSETS.len())?;
        let vertex = experiment.vertex_of_degree(degree, self.seed);
        let anchor_seed = self.seed.wrapping_mul(6).wrapping_add(number as u64);
        Some(Plan { degree, round, vertex, anchors: random_anchors(self.positions.len(), &[vertex], anchor_seed) })
    }

    /// Where an edit takes the vertices, from nothing: operator, factor, solve and displacement. This is what is timed.
    ///
    /// # Errors
    /// [`LaplacianError`] if the edit has no answer.
    pub fn edit(&self, experiment: &Experiment, plan: &Plan) -> Result<Vec<DVec3>, LaplacianError> {
        let system = LaplacianSystem::new(&experiment.topology, &self.positions, self.method.operator)?;
        let (handles, constraint) = ([plan.vertex], self.method.constraint);
        let constraints = Constraints { handles: &handles, anchors: &plan.anchors, kind: constraint, falloff: None };
        let mut edited = self.positions.clone();
        system.respond(&constraints)?.displace(&self.positions, &[OFFSETS[plan.round]], &mut edited);
        Ok(edited)
    }

    /// Goes on from where an edit took the vertices.
    pub fn go_on(&mut self, experiment: &Experiment, plan: Plan, edited: Vec<DVec3>, time: Duration) {
        let bent = Distortion::measure(&experiment.topology, &experiment.yardstick, &self.positions, &edited);
        self.edits.push(TimedEdit { plan, time, peaks: bent.peaks.len() });
        self.positions = edited;
        if self.edits.len().is_multiple_of(DEGREES.len()) {
            self.after_rounds.push(self.positions.clone());
        }
    }

    /// What all edits together did to the mesh, measured with `L_s` whatever the method.
    pub fn distortion(&self, experiment: &Experiment) -> DistortionSummary {
        let Experiment { topology, rest, yardstick } = experiment;
        Distortion::measure(topology, yardstick, rest, &self.positions).summary()
    }
}
