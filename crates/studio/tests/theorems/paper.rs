//! The paper's experiment is reproducible except for its times.

use std::time::Duration;

use rosto_face::Triangulation;
use rosto_studio::paper::*;
use rosto_studio::{Anchors, Command, CoordinateFrame, Document, EditSpec, Rest, Settings};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::faces::*;

fn experiment() -> Experiment {
    Experiment::new(Triangulation::Tessellation.topology(), portrait_image()).unwrap()
}

/// A finished trial whose n-th edit takes `times_ms[n]`.
fn trial(experiment: &Experiment, method: Method, seed: u64, times_ms: [u64; 6]) -> Trial {
    let mut trial = Trial::new(experiment, method, seed);
    let mut times = times_ms.into_iter();
    while let Some(plan) = trial.next_edit(experiment) {
        let edited = trial.edit(experiment, &plan).unwrap();
        trial.go_on(experiment, plan, edited, Duration::from_millis(times.next().unwrap()));
    }
    trial
}

#[test]
fn a_trial_applies_the_small_then_the_large_offset_to_each_degree() {
    let (experiment, topology) = (experiment(), Triangulation::Tessellation.topology());
    let trial = trial(&experiment, Method::default(), 7, [1; 6]);
    let plans: Vec<(usize, usize)> = trial.edits().iter().map(|edit| (edit.plan.degree, edit.plan.round)).collect();
    assert_eq!(plans, [(3, 0), (6, 0), (8, 0), (3, 1), (6, 1), (8, 1)]);
    for edit in trial.edits() {
        assert_eq!(topology.degree(edit.plan.vertex), edit.plan.degree);
        assert!(!edit.plan.anchors.contains(&edit.plan.vertex) && edit.plan.anchors[0] != edit.plan.anchors[1]);
    }
    assert_eq!(trial.edits()[0].plan.vertex, trial.edits()[3].plan.vertex);
}

#[test]
fn the_default_edit_is_the_papers_method() {
    let experiment = experiment();
    let trial = trial(&experiment, Method::default(), 3, [1; 6]);
    let rest = Rest::of_landmarks(Triangulation::Tessellation.topology(), portrait_image(), CoordinateFrame::Other);
    let mut document = Document::new(rest).unwrap();
    for edit in trial.edits() {
        let settings = Settings { anchors: Anchors::explicit(edit.plan.anchors.to_vec()), ..Settings::default() };
        let spec = EditSpec { level: 0, handles: vec![edit.plan.vertex], settings };
        document.apply("", Command::Move { spec, offsets: vec![OFFSETS[edit.plan.round]] }).unwrap();
    }
    let after = trial.after_rounds()[1].iter().zip(document.positions());
    assert!(after.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) < 1e-12);
}

#[test]
fn trials_depend_on_seed_and_method() {
    let experiment = experiment();
    let of = |method, seed| trial(&experiment, method, seed, [1; 6]);
    for method in Method::all() {
        assert_eq!(bits(&of(method, 1).after_rounds()[1]), bits(&of(method, 1).after_rounds()[1]));
        assert_ne!(of(method, 1).edits(), of(method, 2).edits());
    }
    let ends: Vec<_> = Method::all().into_iter().map(|method| bits(&of(method, 1).after_rounds()[1])).collect();
    assert!(ends.iter().enumerate().all(|(i, end)| !ends[..i].contains(end)), "two methods gave the same result");
}

#[test]
fn the_claims_follow_the_times() {
    let experiment = experiment();
    let trials = [1, 2].map(|seed| trial(&experiment, Method::default(), seed, [2, 4, 2, 6, 12, 6]));
    let claims = Claims::of(&trials);
    assert!((claims.degree_ratio - 2.0).abs() < 1e-9 && (claims.offset_ratio - 3.0).abs() < 1e-9, "{claims:?}");
    assert_eq!(claims.edits, 12);
    let outcome = MethodOutcome::of(&experiment, Method::default(), &trials);
    assert_eq!((outcome.time_ms.median, outcome.edits, outcome.smooth), (5.0, 12, claims.smooth));
    assert!(outcome.bent.median > 0.0 && outcome.stretch.median > 1.0);
}

#[test]
fn the_plot_has_a_dot_for_each_edit_and_escapes_its_texts() {
    let experiment = experiment();
    let trials = [1, 2].map(|seed| trial(&experiment, Method::default(), seed, [2, 4, 2, 6, 12, 6]));
    let [title, degree, small, large] = ["a < b & c", "grau", "pequeno", "grande"].map(str::to_owned);
    let plot = svg(&trials, [272.0, 220.0], &PlotWords { title, degree, small, large });
    assert_eq!(plot.matches("<circle").count(), 12);
    assert!(plot.contains("a &lt; b &amp; c") && plot.contains("grau 8") && plot.contains("viewBox=\"0 0 272 220\""));
}

#[test]
fn table_1_has_a_row_for_each_task() {
    let tasks: Vec<Task> = TABLE_1.iter().map(|row| row.task).collect();
    let edits = [(3, 0), (6, 0), (8, 0), (3, 1), (6, 1), (8, 1)].map(|(degree, round)| Task::Edit { degree, round });
    assert_eq!(tasks, [&[Task::Extraction, Task::Generation][..], &edits].concat());
}
