//! `cargo run --release -p rosto-landmarks --example robustness [-- FAMILY…]`
//!
//! Prints the detection figures of `docs/accuracy.json`: one JSON object per family of test pictures, with the faces
//! found by this crate and by MediaPipe (`tests/golden/robustness.json`). Errors are fractions of the distance between
//! the eyes. Then prints the spread of the landmarks between variants of one photo, in px.

#[path = "../tests/support/mod.rs"]
mod support;

use std::error::Error;

use rosto_landmarks::{FaceFinder, FindOptions};
use rosto_photo::Photo;
use serde_json::{Value, json};
use support::scenes::verdict::Verdict;
use support::scenes::{self, Model, families};

const GOLDEN: &str = include_str!("../../../tests/golden/robustness.json");

fn main() -> Result<(), Box<dyn Error>> {
    let finder = support::attention_finder();
    let model = Model::new(&finder, &support::assets::portrait());
    let golden: Value = serde_json::from_str(GOLDEN)?;
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let scenes = families::all();
    let same_family = |a: &scenes::Scene, b: &scenes::Scene| a.family == b.family;
    for scenes in scenes.chunk_by(same_family) {
        if wanted.is_empty() || wanted.iter().any(|name| name == scenes[0].family) {
            println!("{}", of_family(scenes, &finder, &model, &golden)?);
        }
    }
    for (passes, options) in [("one", FindOptions::mediapipe()), ("until they agree", FindOptions::default())] {
        println!("{}", spread(passes, &FindOptions { max_faces: 1, ..options }, &finder, &model)?);
    }
    Ok(())
}

fn of_family(
    scenes: &[scenes::Scene],
    finder: &FaceFinder,
    model: &Model,
    golden: &Value,
) -> Result<Value, Box<dyn Error>> {
    let (mut own, mut theirs, mut not_right) = (Vec::new(), Vec::new(), Vec::new());
    for scene in scenes {
        let photo = scene.picture(model);
        let faces = finder.find(&photo, &FindOptions { max_faces: 30, ..FindOptions::default() })?;
        let verdict = Verdict::of(scene, model, &photo, &faces);
        if verdict.right() < scene.faces.len() || verdict.wrong + verdict.twice > 0 {
            not_right.push(&scene.name);
        }
        own.push(verdict);
        theirs.push(Verdict::of_mediapipe(scene, golden));
    }
    let behind: usize = own.iter().zip(&theirs).map(|(own, theirs)| own.behind(theirs)).sum();
    let faces: usize = scenes.iter().map(|scene| scene.faces.len()).sum();
    Ok(json!({
        "family": scenes[0].family, "pictures": scenes.len(), "faces": faces, "rosto": summary(&own),
        "mediapipe": summary(&theirs), "right_only_by_mediapipe": behind, "not_all_right": not_right,
    }))
}

fn summary(verdicts: &[Verdict]) -> Value {
    let sum = |count: fn(&Verdict) -> usize| verdicts.iter().map(count).sum::<usize>();
    let mut errors: Vec<f64> = verdicts.iter().flat_map(|verdict| verdict.errors.iter().flatten().copied()).collect();
    errors.sort_by(f64::total_cmp);
    json!({
        "right": sum(Verdict::right), "wrong": sum(|verdict| verdict.wrong), "twice": sum(|verdict| verdict.twice),
        "median_error": errors.get(errors.len() / 2), "worst_error": errors.last(),
    })
}

/// Distance in px between the landmarks of variants and those of the original, at 62 px between the eyes.
fn spread(passes: &str, options: &FindOptions, finder: &FaceFinder, model: &Model) -> Result<Value, Box<dyn Error>> {
    let first = |photo: &Photo| -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
        Ok(scenes::landmarks_px(finder.find(photo, options)?.first().ok_or("no face")?, photo))
    };
    let upright = first(&model.portrait)?;
    let mut distances_px = Vec::new();
    for scene in families::variants() {
        let truth = model.placed_landmarks_px(&upright, &scene.faces[0]);
        let share = scenes::error(&first(&scene.picture(model))?, &truth, &scene.faces[0], scene.size_px);
        distances_px.push(share * scenes::EYE_DISTANCE_PX);
    }
    let mean_px = distances_px.iter().sum::<f64>() / distances_px.len() as f64;
    Ok(json!({"passes": passes, "mean_px": mean_px, "worst_px": distances_px.into_iter().fold(0.0, f64::max)}))
}
