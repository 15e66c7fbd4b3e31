//! `cargo run -p rosto-landmarks --example write_robustness_pictures -- FOLDER`
//!
//! Writes the detection pictures of `docs/accuracy.md` as PNG files and their true landmarks as `truth.json`, the input
//! of `tests/reference/mediapipe_robustness.py`.

#[path = "../tests/support/mod.rs"]
mod support;

use std::error::Error;
use std::path::PathBuf;

use serde_json::{Map, Value, json};
use support::scenes::{Model, families};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: write_robustness_pictures FOLDER")?);
    std::fs::create_dir_all(&folder)?;
    let model = Model::new(&support::finder(), &support::assets::portrait());
    let mut truth = Map::new();
    for scene in families::all() {
        let photo = scene.picture(&model);
        let path = folder.join(format!("{}.png", scene.name));
        image::save_buffer(&path, photo.pixels(), photo.width(), photo.height(), image::ColorType::Rgb8)?;
        let face = |placed| json!({ "scale": placed_scale(placed), "landmarks_px": model.truth_px(placed) });
        truth.insert(scene.name.clone(), Value::Array(scene.faces.iter().map(face).collect()));
    }
    std::fs::write(folder.join("truth.json"), serde_json::to_string(&truth)?)?;
    Ok(())
}

fn placed_scale(placed: &support::scenes::Placement) -> f64 {
    placed.scale
}
