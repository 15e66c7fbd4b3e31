use std::time::Duration;

use glam::DVec3;
use rosto_face::{FaceModel, Observation, PhotoLens, Triangulation};
use rosto_studio::ConstraintKind;
use rosto_studio::paper::{
    Claims, DEGREES, Experiment, Method, MethodOutcome, OFFSETS, Plan, PlotWords, TABLE_1, TableRow, Task, Trial, svg,
};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use crate::error::{Result, of_request, of_studio};
use crate::messages::sent;

/// Width and height of the plot.
const PLOT_PX: [f64; 2] = [272.0, 220.0];

/// The paper's experiment on a face; independent of its edits.
///
/// The caller measures time: it calls `repeat` until a step can be timed, then `goOn` with the time per repetition, until
/// `share` is 1. `free()` it after use.
#[wasm_bindgen]
pub struct PaperRun {
    /// Input of the initial generation. The photo contributes only its colours, which are already sampled.
    face: Observation,
    experiment: Experiment,
    generation_ms: Option<f64>,
    /// Trials of each method; the paper's method comes first.
    trials: Vec<Trial>,
    runs: usize,
    /// The current trial, its next edit, and the resulting positions.
    place: usize,
    pending: Option<(Plan, Vec<DVec3>)>,
}

#[wasm_bindgen]
impl PaperRun {
    /// Completed share of the experiment, 0..1.
    #[wasm_bindgen(getter)]
    pub fn share(&self) -> f64 {
        let done: usize = self.trials.iter().map(|trial| trial.edits().len()).sum();
        done as f64 / (self.trials.len() * DEGREES.len() * OFFSETS.len()) as f64
    }

    /// Repeats the next step `times` times, from scratch each time.
    ///
    /// # Errors
    /// `cannot-solve`.
    pub fn repeat(&mut self, times: u32) -> Result<()> {
        for _ in 0..times {
            self.step()?;
        }
        Ok(())
    }

    /// Records the repeated step with its time and continues with the next one.
    #[wasm_bindgen(js_name = goOn)]
    pub fn go_on(&mut self, #[wasm_bindgen(js_name = eachMs)] each_ms: f64) {
        if self.generation_ms.is_none() {
            self.generation_ms = Some(each_ms);
        } else if let (Some(trial), Some((plan, edited))) = (self.trials.get_mut(self.place), self.pending.take()) {
            trial.go_on(&self.experiment, plan, edited, Duration::from_secs_f64(each_ms.max(0.0) / 1000.0));
            if trial.next_edit(&self.experiment).is_none() {
                self.place += 1;
            }
        }
    }

    /// Returns the results so far.
    pub fn results(&self) -> Result<Ts<PaperResults>> {
        sent(&PaperResults { table: self.table(), methods: self.methods(), claims: self.claims(), plot: self.plot() })
    }
}

impl PaperRun {
    /// Creates the experiment: `runs` random choices of vertices and anchors per method, with seeds from `seed`.
    pub(crate) fn new(face: &FaceModel, runs: u32, seed: u32) -> Result<Self> {
        let positions_image = face.positions_image();
        let experiment = Experiment::new(Triangulation::Tessellation.topology(), positions_image.to_vec())
            .map_err(|reason| of_studio(&reason.into()))?;
        let seeds = (0..u64::from(runs)).map(|run| u64::from(seed) + run);
        let of_method = |method| seeds.clone().map(move |seed| (method, seed));
        let trials = Method::all().into_iter().flat_map(of_method);
        let trials = trials.map(|(method, seed)| Trial::new(&experiment, method, seed)).collect();
        let mut face = face.views()[0].observation.clone().with_lens(PhotoLens::Parallel);
        face.landmarks.truncate(positions_image.len());
        Ok(Self { face, experiment, generation_ms: None, trials, runs: runs as usize, place: 0, pending: None })
    }

    fn step(&mut self) -> Result<()> {
        if self.generation_ms.is_none() {
            FaceModel::new(self.face.clone(), Triangulation::Tessellation).map_err(|error| of_request(error.into()))?;
            return Ok(());
        }
        let Some(trial) = self.trials.get(self.place) else { return Ok(()) };
        let Some(plan) = trial.next_edit(&self.experiment) else { return Ok(()) };
        let edited = trial.edit(&self.experiment, &plan).map_err(|reason| of_studio(&reason.into()))?;
        self.pending = Some((plan, edited));
        Ok(())
    }

    fn table(&self) -> Vec<PaperRow> {
        let mut edits = self.trials[0].edits().iter();
        let row = |row: &TableRow| {
            let [first_ms, second_ms] = row.seconds.map(|seconds| seconds * 1e3);
            let (task, degree, here_ms) = match row.task {
                Task::Extraction => ("extraction", 0, None),
                Task::Generation => ("generation", 0, self.generation_ms),
                Task::Edit { degree, round } => {
                    let task = if round == 0 { "small-edit" } else { "large-edit" };
                    (task, degree, edits.next().map(|edit| edit.time.as_secs_f64() * 1e3))
                }
            };
            PaperRow { task, degree, first_ms, second_ms, here_ms }
        };
        TABLE_1.iter().map(row).collect()
    }

    fn methods(&self) -> Vec<PaperMethod> {
        let of_method = |(method, trials): (Method, &[Trial])| {
            let outcome = MethodOutcome::of(&self.experiment, method, trials);
            PaperMethod {
                operator: method.operator.id(),
                constraint: if method.constraint == ConstraintKind::Hard { "exact" } else { "soft" },
                time_ms: outcome.time_ms.median,
                bent: outcome.bent.median,
                stretch: outcome.stretch.median,
                flipped: outcome.flipped.median,
                smooth: outcome.smooth,
                edits: outcome.edits,
            }
        };
        Method::all().into_iter().zip(self.trials.chunks(self.runs)).map(of_method).collect()
    }

    fn claims(&self) -> PaperClaims {
        let Claims { degree_ratio, offset_ratio, smooth, edits, .. } = Claims::of(self.papers_trials());
        PaperClaims { degree_ratio, offset_ratio, smooth, edits, runs: self.runs }
    }

    /// Plot of time against degree and offset, for the paper's method.
    fn plot(&self) -> String {
        let word = |name: &str| format!("paper.plot.{name}");
        let words =
            PlotWords { title: word("title"), degree: word("degree"), small: word("small"), large: word("large") };
        svg(self.papers_trials(), PLOT_PX, &words)
    }

    fn papers_trials(&self) -> &[Trial] {
        &self.trials[..self.runs]
    }
}

/// Results of the experiment.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct PaperResults {
    /// Table 1 of the paper, with the times of the first run.
    pub table: Vec<PaperRow>,
    /// Results of each method.
    pub methods: Vec<PaperMethod>,
    /// The paper's claims as numbers, for its method.
    pub claims: PaperClaims,
    /// SVG plot of time against degree and offset, for the paper's method. Its texts are ids of the page's words.
    pub plot: String,
}

/// A row of the paper's Table 1, with the time measured here.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct PaperRow {
    /// The timed task: "extraction", "generation", "small-edit" or "large-edit".
    pub task: &'static str,
    /// Number of neighbours of the moved vertex; 0 for other tasks.
    pub degree: usize,
    /// Time in the paper's first test, ms.
    pub first_ms: f64,
    /// Time in the paper's second test, ms.
    pub second_ms: f64,
    /// Time measured here, ms; undefined if not measured.
    pub here_ms: Option<f64>,
}

/// Results of a method: medians over the runs, after all six edits.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct PaperMethod {
    /// Operator of the δ-coordinates.
    pub operator: &'static str,
    /// How firmly handle and anchors were held: "exact" or "soft".
    pub constraint: &'static str,
    /// Time of an edit, ms.
    pub time_ms: f64,
    /// `‖δ' − δ‖` over the mesh, in image units.
    pub bent: f64,
    /// Greatest ratio of an edge's length to its length at rest.
    pub stretch: f64,
    /// Number of inverted triangles.
    pub flipped: f64,
    /// Number of edits that raised no isolated peak.
    pub smooth: usize,
    /// Number of edits.
    pub edits: usize,
}

/// The paper's claims as numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct PaperClaims {
    /// Ratio of the slowest degree's median time to the fastest's.
    pub degree_ratio: f64,
    /// Ratio of the slower offset's median time to the faster's.
    pub offset_ratio: f64,
    /// Number of edits that raised no isolated peak.
    pub smooth: usize,
    /// Number of edits.
    pub edits: usize,
    /// Number of runs of each method.
    pub runs: usize,
}
