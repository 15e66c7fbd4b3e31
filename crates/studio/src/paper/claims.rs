use super::{DEGREES, Experiment, Method, OFFSETS, Spread, TimedEdit, Trial};

/// The paper's claims as numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Claims {
    /// Ratio of the slowest degree's median time to the fastest's. Near 1 it supports "little dependence on the
    /// degree".
    pub degree_ratio: f64,
    /// Ratio of the slower offset's median time to the faster's.
    pub offset_ratio: f64,
    /// Number of edits that raised no isolated peak.
    pub smooth: usize,
    /// Number of edits.
    pub edits: usize,
}

impl Claims {
    /// Computes the claims from trials of one method.
    pub fn of(trials: &[Trial]) -> Self {
        let edits: Vec<&TimedEdit> = trials.iter().flat_map(Trial::edits).collect();
        let by_degree = DEGREES.map(|degree| spread_ms(&edits, Some(degree), None).median);
        let by_offset =
            std::array::from_fn::<_, { OFFSETS.len() }, _>(|round| spread_ms(&edits, None, Some(round)).median);
        let smooth = edits.iter().filter(|edit| edit.peaks == 0).count();
        Self { degree_ratio: ratio(&by_degree), offset_ratio: ratio(&by_offset), smooth, edits: edits.len() }
    }
}

/// Times and distortions of one method over many trials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodOutcome {
    /// The method.
    pub method: Method,
    /// Time of each edit, in ms.
    pub time_ms: Spread,
    /// `‖δ' − δ‖` over the whole mesh after the last edit, in image units.
    pub bent: Spread,
    /// Greatest ratio of an edge's length to its length at rest.
    pub stretch: Spread,
    /// Number of inverted triangles.
    pub flipped: Spread,
    /// Number of edits that raised no isolated peak.
    pub smooth: usize,
    /// Number of edits.
    pub edits: usize,
}

impl MethodOutcome {
    /// Summarises finished trials of one method.
    pub fn of(experiment: &Experiment, method: Method, trials: &[Trial]) -> Self {
        let edits: Vec<&TimedEdit> = trials.iter().flat_map(Trial::edits).collect();
        let distortions: Vec<_> = trials.iter().map(|trial| trial.distortion(experiment)).collect();
        Self {
            method,
            time_ms: spread_ms(&edits, None, None),
            bent: Spread::of(distortions.iter().map(|distortion| distortion.delta_residual)),
            stretch: Spread::of(distortions.iter().map(|distortion| distortion.greatest_stretch.value)),
            flipped: Spread::of(distortions.iter().map(|distortion| distortion.flipped.0 as f64)),
            smooth: edits.iter().filter(|edit| edit.peaks == 0).count(),
            edits: edits.len(),
        }
    }
}

/// Times in ms of the edits of the given degree and round; `None` selects all.
pub fn spread_ms(edits: &[&TimedEdit], degree: Option<usize>, round: Option<usize>) -> Spread {
    let is_of_kind = |edit: &&&TimedEdit| {
        degree.is_none_or(|degree| edit.plan.degree == degree) && round.is_none_or(|round| edit.plan.round == round)
    };
    Spread::of(edits.iter().filter(is_of_kind).map(|edit| edit.time.as_secs_f64() * 1e3))
}

fn ratio(medians: &[f64]) -> f64 {
    let greatest = medians.iter().copied().fold(f64::MIN, f64::max);
    greatest / medians.iter().copied().fold(f64::MAX, f64::min)
}
