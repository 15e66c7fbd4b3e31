use std::path::Path;
use std::time::Duration;

use rosto_studio::{Hold, project::operator_name};

use super::experiment::{DEGREES, Method, REPETITIONS, TimedEdit, Trial};
use super::statistics::Spread;

/// Table 1 of the paper: task, seconds in test 1, seconds in test 2.
const TABLE_1: [(&str, f64, f64); 8] = [
    ("Landmark Extract", 0.218, 0.214),
    ("Initial Generation", 0.003, 0.007),
    ("Degree 3 edit", 0.399, 0.362),
    ("Degree 6 edit", 0.364, 0.389),
    ("Degree 8 edit", 0.366, 0.401),
    ("2nd Degree 3 edit", 0.393, 0.363),
    ("2nd Degree 6 edit", 0.387, 0.374),
    ("2nd Degree 8 edit", 0.384, 0.584),
];

const ROUND_NAMES: [&str; 2] = ["(−0.005, −0.005, −0.005)", "(0.1, 0.1, −0.1)"];

/// Table 1 beside this machine's, the claims as statistics, and every method compared.
pub fn markdown(extraction: Duration, generation: Duration, trials: &[(Method, Vec<Trial>)], folder: &Path) -> String {
    let paper = &trials[0].1;
    let edits: Vec<&TimedEdit> = paper.iter().flat_map(|trial| &trial.edits).collect();
    [
        table_1(extraction, generation, &paper[0]),
        note(paper.len(), folder),
        times(&edits),
        claims(&edits),
        methods(trials),
    ]
    .join("\n\n")
}

fn table_1(extraction: Duration, generation: Duration, trial: &Trial) -> String {
    let times = [extraction, generation].into_iter().chain(trial.edits.iter().map(|edit| edit.time));
    let mut lines = vec![
        "| Task | Paper, test 1 (s) | Paper, test 2 (s) | This machine (s) | Vertex | Anchors |".to_owned(),
        "|---|--:|--:|--:|--:|--:|".to_owned(),
    ];
    for (row, ((task, first, second), time)) in TABLE_1.iter().zip(times).enumerate() {
        let edit = row.checked_sub(2).map(|index| &trial.edits[index]);
        let (vertex, anchors) = edit.map_or_else(Default::default, |edit| {
            (edit.vertex.to_string(), format!("{}, {}", edit.anchors[0], edit.anchors[1]))
        });
        let seconds = time.as_secs_f64();
        lines.push(format!("| {task} | {first:.3} | {second:.3} | {seconds:.6} | {vertex} | {anchors} |"));
    }
    lines.join("\n")
}

fn note(runs: usize, folder: &Path) -> String {
    format!(
        "Each edit is made from nothing (operator, factor, solve, displacement) and timed as the median of \
         {REPETITIONS}. What follows is over {runs} runs with random vertices and anchors, as median [quartiles]. \
         The meshes of Figures 3 to 5 and a plot of the times are in {}.",
        folder.display()
    )
}

/// Time against degree and offset, for the paper's own method.
fn times(edits: &[&TimedEdit]) -> String {
    let mut lines =
        vec![format!("| Time per edit (ms) | {} | {} |", ROUND_NAMES[0], ROUND_NAMES[1]), "|---|--:|--:|".to_owned()];
    for degree in DEGREES {
        let cell = |round| spread(of_kind(edits, Some(degree), Some(round)), 3);
        lines.push(format!("| degree {degree} | {} | {} |", cell(0), cell(1)));
    }
    lines.join("\n")
}

/// The paper's claims, each with the figure that bears on it.
fn claims(edits: &[&TimedEdit]) -> String {
    let by_degree = DEGREES.map(|degree| of_kind(edits, Some(degree), None).median);
    let by_round = [0, 1].map(|round| of_kind(edits, None, Some(round)).median);
    let smooth = edits.iter().filter(|edit| edit.peaks == 0).count();
    [
        format!(
            "- Time depends little on the degree: the slowest degree's median is {:.2} times the fastest's.",
            ratio(&by_degree)
        ),
        format!(
            "- Time depends little on the offset: the slower offset's median is {:.2} times the faster's.",
            ratio(&by_round)
        ),
        format!("- No peaks without a gradual rise: {smooth} of {} edits raised none.", edits.len()),
    ]
    .join("\n")
}

/// Every operator and hold: time, and what the six edits did to the mesh.
fn methods(trials: &[(Method, Vec<Trial>)]) -> String {
    let mut lines = vec![
        "| Operator | Hold | Time per edit (ms) | Bent: ‖δ′ − δ‖ | Longest edge (×) | Triangles turned over | Edits without peaks |"
            .to_owned(),
        "|---|---|--:|--:|--:|--:|--:|".to_owned(),
    ];
    for (method, trials) in trials {
        let edits: Vec<&TimedEdit> = trials.iter().flat_map(|trial| &trial.edits).collect();
        let of = |value: fn(&Trial) -> f64| Spread::of(trials.iter().map(value));
        let hold = match method.hold {
            Hold::Soft { .. } => "soft",
            Hold::Exact => "exact",
        };
        lines.push(format!(
            "| {} | {hold} | {} | {} | {} | {} | {} of {} |",
            operator_name(method.operator),
            spread(of_kind(&edits, None, None), 3),
            spread(of(|trial| trial.distortion.delta_residual), 4),
            spread(of(|trial| trial.distortion.greatest_stretch.value), 2),
            spread(of(|trial| trial.distortion.flipped.0 as f64), 0),
            edits.iter().filter(|edit| edit.peaks == 0).count(),
            edits.len(),
        ));
    }
    lines.join("\n")
}

/// Times in ms of the edits of one degree or round, or of all.
pub fn of_kind(edits: &[&TimedEdit], degree: Option<usize>, round: Option<usize>) -> Spread {
    let is_kind = |edit: &&&TimedEdit| {
        degree.is_none_or(|degree| edit.degree == degree) && round.is_none_or(|round| edit.round == round)
    };
    Spread::of(edits.iter().filter(is_kind).map(|edit| edit.time.as_secs_f64() * 1e3))
}

fn spread(spread: Spread, digits: usize) -> String {
    format!("{:.digits$} [{:.digits$}, {:.digits$}]", spread.median, spread.lower, spread.upper)
}

fn ratio(medians: &[f64]) -> f64 {
    let greatest = medians.iter().copied().fold(f64::MIN, f64::max);
    greatest / medians.iter().copied().fold(f64::MAX, f64::min)
}
