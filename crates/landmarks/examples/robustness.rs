//! `cargo run --release -p rosto-landmarks --example robustness [-- FAMILY…]`
//!
//! Prints the tables of docs/robustness.md: what is found in pictures in which it is known where the faces are, by this
//! crate and by MediaPipe, whose answers are `tests/golden/robustness.json`.

#[path = "../tests/support/mod.rs"]
mod support;

use std::error::Error;

use rosto_landmarks::{FaceFinder, FindOptions};
use serde_json::Value;
use support::scenes::verdict::Verdict;
use support::scenes::{self, Model, families};

const GOLDEN: &str = include_str!("../../../tests/golden/robustness.json");

/// A family's answers, ours and MediaPipe's.
struct Row {
    family: &'static str,
    names: Vec<String>,
    verdicts: Vec<[Verdict; 2]>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let finder = support::attentive_finder();
    let model = Model::new(&finder, &support::assets::portrait());
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let rows = rows(&finder, &model, &wanted)?;
    print_found(&rows);
    print_errors(&rows);
    print_not_right(&rows);
    print_spread(&finder, &model)
}

fn rows(finder: &FaceFinder, model: &Model, wanted: &[String]) -> Result<Vec<Row>, Box<dyn Error>> {
    let golden: Value = serde_json::from_str(GOLDEN)?;
    let mut rows: Vec<Row> = Vec::new();
    let is_wanted = |family: &str| wanted.is_empty() || wanted.iter().any(|name| name == family);
    for scene in families::all().into_iter().filter(|scene| is_wanted(scene.family)) {
        let photo = scene.picture(model);
        let faces = finder.find(&photo, &FindOptions { max_faces: 30, ..FindOptions::default() })?;
        let own = Verdict::of(&scene, model, &photo, &faces);
        let theirs = Verdict::of_mediapipe(&scene, &golden);
        let name = scene.name.clone();
        match rows.last_mut().filter(|row| row.family == scene.family) {
            Some(row) => row.add(name, [own, theirs]),
            None => rows.push(Row::new(scene.family, name, [own, theirs])),
        }
    }
    Ok(rows)
}

impl Row {
    fn new(family: &'static str, name: String, verdicts: [Verdict; 2]) -> Self {
        Self { family, names: vec![name], verdicts: vec![verdicts] }
    }

    fn add(&mut self, name: String, verdicts: [Verdict; 2]) {
        self.names.push(name);
        self.verdicts.push(verdicts);
    }

    fn sum(&self, count: impl Fn(&[Verdict; 2]) -> usize) -> usize {
        self.verdicts.iter().map(count).sum()
    }

    /// Median and worst error of the right ones, as they are printed.
    fn errors(&self, whose: usize) -> [String; 2] {
        let of = |pair: &[Verdict; 2]| pair[whose].errors.iter().flatten().copied().collect::<Vec<f64>>();
        let mut all: Vec<f64> = self.verdicts.iter().flat_map(of).collect();
        all.sort_by(f64::total_cmp);
        let percent = |error: Option<&f64>| error.map_or("—".to_owned(), |error| format!("{:.1}", 100.0 * error));
        [percent(all.get(all.len() / 2)), percent(all.last())]
    }
}

fn print_found(rows: &[Row]) {
    println!(
        "| family | pictures | faces | right: Rosto | MediaPipe | wrong: Rosto | MediaPipe | twice | MediaPipe right, Rosto not |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---:|---:|");
    for row in rows {
        let both = |count: fn(&Verdict) -> usize| [0, 1].map(|whose| row.sum(|pair| count(&pair[whose])));
        let ([right, right_theirs], [wrong, wrong_theirs]) = (both(Verdict::right), both(|verdict| verdict.wrong));
        let (pictures, faces) = (row.verdicts.len(), row.sum(|pair| pair[0].errors.len()));
        let (twice, behind) = (row.sum(|pair| pair[0].twice), row.sum(|[own, theirs]| own.behind(theirs)));
        let family = row.family;
        println!(
            "| {family} | {pictures} | {faces} | {right} | {right_theirs} | {wrong} | {wrong_theirs} | {twice} | {behind} |"
        );
    }
}

fn print_errors(rows: &[Row]) {
    println!("\n| % of the distance between the eyes | median: Rosto | MediaPipe | worst: Rosto | MediaPipe |");
    println!("|---|---:|---:|---:|---:|");
    for row in rows.iter().filter(|row| row.sum(|pair| pair[0].errors.len()) > 0) {
        let ([median, worst], [median_theirs, worst_theirs]) = (row.errors(0), row.errors(1));
        println!("| {} | {median} | {median_theirs} | {worst} | {worst_theirs} |", row.family);
    }
}

/// The pictures in which not everything is right, by name.
fn print_not_right(rows: &[Row]) {
    let is_right = |own: &Verdict| own.errors.iter().all(Option::is_some) && own.wrong + own.twice == 0;
    let pictures = rows.iter().flat_map(|row| row.names.iter().zip(&row.verdicts));
    let names: Vec<&str> = pictures.filter(|(_, [own, _])| !is_right(own)).map(|(name, _)| name.as_str()).collect();
    println!("\nNot all right in: {}.", names.join(", "));
}

/// How far the landmarks of variants of one face lie from those of the face itself, at 62 px between the eyes.
fn print_spread(finder: &FaceFinder, model: &Model) -> Result<(), Box<dyn Error>> {
    println!("\n| px at 62 px between the eyes | mean | worst |");
    println!("|---|---:|---:|");
    for (name, options) in [
        ("one look, one pass, as MediaPipe does", FindOptions::mediapipe()),
        ("until passes agree", FindOptions { max_faces: 1, ..FindOptions::default() }),
    ] {
        let first = |photo: &rosto_photo::Photo| -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
            Ok(scenes::landmarks_px(finder.find(photo, &options)?.first().ok_or("no face")?, photo))
        };
        let upright = first(&model.portrait)?;
        let mut distances_px = Vec::new();
        for scene in families::variants() {
            let truth = model.carried(&upright, &scene.faces[0]);
            let share = scenes::error(&first(&scene.picture(model))?, &truth, &scene.faces[0], scene.size_px);
            distances_px.push(share * scenes::EYE_DISTANCE_PX);
        }
        let mean = distances_px.iter().sum::<f64>() / distances_px.len() as f64;
        println!("| {name} | {mean:.2} | {:.2} |", distances_px.into_iter().fold(0.0, f64::max));
    }
    Ok(())
}
