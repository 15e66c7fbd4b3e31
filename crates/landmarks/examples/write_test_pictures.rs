//! `cargo run -p rosto-landmarks --example write_test_pictures -- FOLDER`
//!
//! Writes the pictures of the golden landmarks as PNG files, the input of `tests/reference/mediapipe_landmarks.py`.

#[path = "../tests/support/mod.rs"]
mod support;

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("usage: write_test_pictures FOLDER")?);
    std::fs::create_dir_all(&folder)?;
    for picture in support::pictures::all(&support::assets::portrait()) {
        let path = folder.join(format!("{}.{}.png", picture.name, picture.max_faces));
        let photo = &picture.photo;
        image::save_buffer(&path, photo.pixels(), photo.width(), photo.height(), image::ColorType::Rgb8)?;
    }
    Ok(())
}
