use std::path::Path;
use std::time::Duration;

use rosto_studio::ConstraintKind;
use rosto_studio::paper::{Claims, DEGREES, MethodOutcome, Spread, TABLE_1, Task, TimedEdit, Trial, spread_ms};

use super::REPETITIONS;
use crate::terminal;

const ROUND_NAMES: [&str; 2] = ["(−0.005, −0.005, −0.005)", "(0.1, 0.1, −0.1)"];

/// Markdown report: Table 1 with this machine's times, the paper's claims as statistics, and a comparison of methods,
/// the paper's first.
pub fn markdown(
    extraction: Duration,
    generation: Duration,
    paper: &[Trial],
    methods: &[MethodOutcome],
    folder: &Path,
) -> String {
    [
        table_1(extraction, generation, &paper[0]),
        note(paper.len(), folder),
        times(&paper.iter().flat_map(Trial::edits).collect::<Vec<_>>()),
        claims(&Claims::of(paper)),
        self::methods(methods),
    ]
    .join("\n\n")
}

fn table_1(extraction: Duration, generation: Duration, trial: &Trial) -> String {
    let mut lines = vec![
        "| Task | Paper, test 1 (s) | Paper, test 2 (s) | This machine (s) | Vertex | Anchors |".to_owned(),
        "|---|--:|--:|--:|--:|--:|".to_owned(),
    ];
    let mut edits = trial.edits().iter();
    for row in TABLE_1 {
        let (time, vertex, anchors) = match row.task {
            Task::Extraction => (extraction, String::new(), String::new()),
            Task::Generation => (generation, String::new(), String::new()),
            Task::Edit { .. } => {
                let edit = edits.next().expect("invariant: a finished trial has an edit for each row");
                let [a, b] = edit.plan.anchors;
                (edit.time, edit.plan.vertex.to_string(), format!("{a}, {b}"))
            }
        };
        let ([first, second], seconds) = (row.seconds, time.as_secs_f64());
        lines.push(format!("| {} | {first:.3} | {second:.3} | {seconds:.6} | {vertex} | {anchors} |", row.name));
    }
    lines.join("\n")
}

fn note(runs: usize, folder: &Path) -> String {
    format!(
        "Each edit includes operator, factorisation, solve and displacement; its time is the median of {REPETITIONS} \
         repetitions. The statistics cover {runs} runs with random vertices and anchors, as median [quartiles]. The meshes \
         of Figures 3 to 5 and a plot of the times are in {}.",
        terminal::escaped(&folder.display().to_string())
    )
}

/// Times of the paper's method by degree and offset.
fn times(edits: &[&TimedEdit]) -> String {
    let mut lines =
        vec![format!("| Time per edit (ms) | {} | {} |", ROUND_NAMES[0], ROUND_NAMES[1]), "|---|--:|--:|".to_owned()];
    for degree in DEGREES {
        let cell = |round| spread(spread_ms(edits, Some(degree), Some(round)), 3);
        lines.push(format!("| degree {degree} | {} | {} |", cell(0), cell(1)));
    }
    lines.join("\n")
}

/// The paper's claims, each with its measured value.
fn claims(claims: &Claims) -> String {
    [
        format!(
            "- Time depends little on the degree: the slowest degree's median is {:.2} times the fastest's.",
            claims.degree_ratio
        ),
        format!(
            "- Time depends little on the offset: the slower offset's median is {:.2} times the faster's.",
            claims.offset_ratio
        ),
        format!("- The surface rises gradually, without peaks: true of {} of {} edits.", claims.smooth, claims.edits),
    ]
    .join("\n")
}

/// Comparison of operators and constraints: times, and effects of the six edits on the mesh.
fn methods(outcomes: &[MethodOutcome]) -> String {
    let mut lines = vec![
        "| Operator | Constraint | Time per edit (ms) | Bending ‖δ′ − δ‖ | Longest edge (×) | Flipped triangles | Edits without peaks |"
            .to_owned(),
        "|---|---|--:|--:|--:|--:|--:|".to_owned(),
    ];
    for outcome in outcomes {
        let constraint = match outcome.method.constraint {
            ConstraintKind::Soft { .. } => "soft",
            ConstraintKind::Hard => "exact",
        };
        lines.push(format!(
            "| {} | {constraint} | {} | {} | {} | {} | {} of {} |",
            outcome.method.operator.id(),
            spread(outcome.time_ms, 3),
            spread(outcome.bent, 4),
            spread(outcome.stretch, 2),
            spread(outcome.flipped, 0),
            outcome.smooth,
            outcome.edits,
        ));
    }
    lines.join("\n")
}

fn spread(spread: Spread, digits: usize) -> String {
    format!("{:.digits$} [{:.digits$}, {:.digits$}]", spread.median, spread.lower, spread.upper)
}
