use std::time::Duration;

use glam::DVec3;
use rosto_laplacian::{
    ConstraintKind, Constraints, Distortion, DistortionSummary, LaplacianError, LaplacianSystem, Operator,
    random_anchors,
};
use rosto_mesh::Topology;

/// The paper's small and large offset, in normalised image coordinates.
pub const OFFSETS: [DVec3; 2] = [DVec3::splat(-0.005), DVec3::new(0.1, 0.1, -0.1)];

/// The lowest, most common and highest degree of the mesh.
pub const DEGREES: [usize; 3] = [3, 6, 8];

/// An editing method. The default is the paper's: `L_s` with soft constraints of weight 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Method {
    /// Operator of the δ-coordinates.
    pub operator: Operator,
    /// How firmly handle and anchors are held.
    pub constraint: ConstraintKind,
}

impl Method {
    /// Each operator with soft and with hard constraints; the paper's method comes first.
    pub fn all() -> Vec<Self> {
        let constraints = [ConstraintKind::default(), ConstraintKind::Hard];
        Operator::ALL
            .into_iter()
            .flat_map(|operator| constraints.map(|constraint| Self { operator, constraint }))
            .collect()
    }
}

/// The mesh of the experiment.
pub struct Experiment {
    topology: Topology,
    rest: Vec<DVec3>,
    yardstick: LaplacianSystem,
}

impl Experiment {
    /// Creates the experiment from a face's landmarks in normalised image coordinates, with the paper's triangles
    /// (MediaPipe's tessellation).
    ///
    /// # Errors
    /// [`LaplacianError`] if the positions do not fit the mesh or are not finite.
    pub fn new(topology: Topology, positions_image: Vec<DVec3>) -> Result<Self, LaplacianError> {
        let yardstick = LaplacianSystem::new(&topology, &positions_image, Operator::UniformSymmetric)?;
        Ok(Self { topology, rest: positions_image, yardstick })
    }

    /// A vertex of the given degree, chosen by the seed.
    fn vertex_of_degree(&self, degree: usize, seed: u64) -> u32 {
        let all = 0..self.topology.vertex_count() as u32;
        let others: Vec<u32> = all.filter(|&vertex| self.topology.degree(vertex) != degree).collect();
        random_anchors(self.topology.vertex_count(), &others, seed)[0]
    }
}

/// An edit to perform.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    /// Number of neighbours of the vertex.
    pub degree: usize,
    /// Index into [`OFFSETS`].
    pub round: usize,
    /// The moved vertex.
    pub vertex: u32,
    /// The anchors.
    pub anchors: [u32; 2],
}

/// A completed edit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimedEdit {
    /// The edit.
    pub plan: Plan,
    /// Time of operator, factorisation, solve and displacement.
    pub time: Duration,
    /// Number of peaks that it raised.
    pub peaks: usize,
}

/// One run of the experiment: six edits, each on the result of the previous one.
#[derive(Debug, Clone)]
pub struct Trial {
    method: Method,
    seed: u64,
    positions: Vec<DVec3>,
    edits: Vec<TimedEdit>,
    after_rounds: Vec<Vec<DVec3>>,
}

impl Trial {
    /// Creates a trial without edits. The seed selects vertices and anchors.
    pub fn new(experiment: &Experiment, method: Method, seed: u64) -> Self {
        Self { method, seed, positions: experiment.rest.clone(), edits: Vec::new(), after_rounds: Vec::new() }
    }

    /// The editing method.
    pub fn method(&self) -> Method {
        self.method
    }

    /// The edits so far: each degree with the small offset, then each with the large one.
    pub fn edits(&self) -> &[TimedEdit] {
        &self.edits
    }

    /// Positions in image coordinates after each completed round: small offsets, then large ones.
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

    /// Positions after an edit, computed from scratch: operator, factorisation, solve and displacement. This is the
    /// timed part.
    ///
    /// # Errors
    /// [`LaplacianError`] if the edit has no solution.
    pub fn edit(&self, experiment: &Experiment, plan: &Plan) -> Result<Vec<DVec3>, LaplacianError> {
        let system = LaplacianSystem::new(&experiment.topology, &self.positions, self.method.operator)?;
        let (handles, constraint) = ([plan.vertex], self.method.constraint);
        let constraints = Constraints { handles: &handles, anchors: &plan.anchors, kind: constraint, falloff: None };
        let mut edited = self.positions.clone();
        system.respond(&constraints)?.displace(&self.positions, &[OFFSETS[plan.round]], &mut edited);
        Ok(edited)
    }

    /// Records a completed edit; the next one starts from its positions.
    pub fn go_on(&mut self, experiment: &Experiment, plan: Plan, edited: Vec<DVec3>, time: Duration) {
        let bent = Distortion::measure(&experiment.topology, &experiment.yardstick, &self.positions, &edited);
        self.edits.push(TimedEdit { plan, time, peaks: bent.peaks.len() });
        self.positions = edited;
        if self.edits.len().is_multiple_of(DEGREES.len()) {
            self.after_rounds.push(self.positions.clone());
        }
    }

    /// Distortion of the mesh by all edits together, measured with `L_s` for each method.
    pub fn distortion(&self, experiment: &Experiment) -> DistortionSummary {
        let Experiment { topology, rest, yardstick } = experiment;
        Distortion::measure(topology, yardstick, rest, &self.positions).summary()
    }
}
