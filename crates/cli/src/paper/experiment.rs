use std::time::{Duration, Instant};

use glam::DVec3;
use rosto_face::FaceModel;
use rosto_laplacian::{
    Constraints, Distortion, DistortionSummary, Hold, LaplacianError, LaplacianSystem, Operator, random_anchors,
};

/// The paper's small offset, then its large one, in normalised image coordinates.
pub const OFFSETS: [DVec3; 2] = [DVec3::splat(-0.005), DVec3::new(0.1, 0.1, -0.1)];

/// The least degree of the mesh, the commonest, and the greatest.
pub const DEGREES: [usize; 3] = [3, 6, 8];

/// An edit is timed this often, and the median counts.
pub const REPETITIONS: usize = 5;

/// A way of editing: the paper's is `L_s` with soft constraints of weight 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Method {
    pub operator: Operator,
    pub hold: Hold,
}

impl Method {
    /// Every operator, softly and exactly held; the paper's own first.
    pub fn all() -> Vec<Self> {
        let holds = [Hold::default(), Hold::Exact];
        Operator::ALL.into_iter().flat_map(|operator| holds.map(|hold| Self { operator, hold })).collect()
    }
}

/// One run of the experiment.
#[derive(Debug, Clone)]
pub struct Trial {
    /// Six edits: each degree by the small offset, then each by the large one.
    pub edits: Vec<TimedEdit>,
    /// Positions in image coordinates after the small offsets, and after the large ones.
    pub after_rounds: [Vec<DVec3>; 2],
    /// What all six edits together did to the mesh, measured with `L_s` whatever the method.
    pub distortion: DistortionSummary,
}

#[derive(Debug, Clone)]
pub struct TimedEdit {
    pub degree: usize,
    /// Which of [`OFFSETS`].
    pub round: usize,
    pub vertex: u32,
    pub anchors: [u32; 2],
    pub time: Duration,
    /// Whether this edit raised a peak.
    pub peaks: usize,
}

/// Six edits one after the other, each timed from nothing: operator, factor, solve and displacement.
pub fn trial(face: &FaceModel, method: Method, seed: u64) -> Result<Trial, LaplacianError> {
    let topology = face.topology();
    let rest = face.positions_image();
    let yardstick = LaplacianSystem::new(topology, rest, Operator::UniformSymmetric)?;
    let vertices = DEGREES.map(|degree| (degree, vertex_of_degree(face, degree, seed)));
    let mut positions = rest.to_vec();
    let mut edits = Vec::new();
    let mut after_rounds = Vec::new();
    for (round, offset) in OFFSETS.into_iter().enumerate() {
        for (degree, vertex) in vertices {
            let anchors = random_anchors(rest.len(), &[vertex], seed.wrapping_mul(6).wrapping_add(edits.len() as u64));
            let (edited, time) = timed(|| edit(face, method, &positions, vertex, anchors, offset))?;
            let peaks = Distortion::measure(topology, &yardstick, &positions, &edited).peaks.len();
            edits.push(TimedEdit { degree, round, vertex, anchors, time, peaks });
            positions = edited;
        }
        after_rounds.push(positions.clone());
    }
    let after_rounds = after_rounds.try_into().expect("invariant: one shape for each offset");
    Ok(Trial { edits, after_rounds, distortion: Distortion::measure(topology, &yardstick, rest, &positions).summary() })
}

/// The result, and the median time of several repetitions.
fn timed<T>(work: impl Fn() -> Result<T, LaplacianError>) -> Result<(T, Duration), LaplacianError> {
    let mut times = Vec::new();
    loop {
        let started = Instant::now();
        let result = work()?;
        times.push(started.elapsed());
        if times.len() == REPETITIONS {
            times.sort_unstable();
            return Ok((result, times[REPETITIONS / 2]));
        }
    }
}

fn edit(
    face: &FaceModel,
    method: Method,
    positions: &[DVec3],
    vertex: u32,
    anchors: [u32; 2],
    offset: DVec3,
) -> Result<Vec<DVec3>, LaplacianError> {
    let system = LaplacianSystem::new(face.topology(), positions, method.operator)?;
    let constraints = Constraints { handles: &[vertex], anchors: &anchors, hold: method.hold, region: None };
    let mut edited = positions.to_vec();
    system.respond(&constraints)?.displace(positions, &[offset], &mut edited);
    Ok(edited)
}

fn vertex_of_degree(face: &FaceModel, degree: usize, seed: u64) -> u32 {
    let topology = face.topology();
    let all = 0..topology.vertex_count() as u32;
    let others: Vec<u32> = all.filter(|&vertex| topology.degree(vertex) != degree).collect();
    random_anchors(topology.vertex_count(), &others, seed)[0]
}
