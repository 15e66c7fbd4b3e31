//! Photographs a head with a known texture from five directions and writes PNGs of the photos and textures to a folder.
//!
//! ```sh
//! cargo run --release -p rosto-studio --example texture_sheet -- textures
//! ```
#![allow(clippy::unwrap_used, reason = "the module shared with the tests unwraps")]

#[allow(dead_code, reason = "shared with the tests")]
#[path = "../tests/theorems/faces.rs"]
mod faces;
#[path = "../../../tests/seeded.rs"]
mod seeded;
#[allow(dead_code, reason = "shared with the tests")]
#[path = "../../../tests/texture_truth.rs"]
mod texture_truth;

use std::fs::File;
use std::path::{Path, PathBuf};

use rosto_face::{Photo, PhotoLens};
use rosto_studio::whole_texture;
use texture_truth::{DISTANCE_M, Head, face};

const SIDE_PX: u32 = 2048;
const TURNS_DEG: [f64; 5] = [0.0, 20.0, -20.0, 40.0, -40.0];
/// Angles from which the textured head is shown.
const SIDES_DEG: [f64; 2] = [-45.0, 45.0];

type Result<T = ()> = std::result::Result<T, Box<dyn std::error::Error>>;

fn main() -> Result {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("give a folder")?);
    std::fs::create_dir_all(&folder)?;
    let truth = Head::painted(SIDE_PX);
    write_sides(&folder, "truth", &truth)?;
    for turn_deg in TURNS_DEG {
        let camera = truth.camera(turn_deg);
        let photo = truth.photo(&camera);
        write(&folder, &format!("photo{turn_deg}"), &photo)?;
        let face = face(photo, &truth.landmarks(&camera), PhotoLens::Distance(DISTANCE_M));
        let projected = truth.projected(&face, SIDE_PX as usize);
        let whole = whole_texture(&face, SIDE_PX)?.picture;
        for (name, texture) in [("projected", projected), ("whole", whole)] {
            write_sides(&folder, &format!("{name}{turn_deg}"), &Head::new(&truth.landmarks_m, texture))?;
        }
    }
    Ok(())
}

fn write_sides(folder: &Path, name: &str, head: &Head) -> Result {
    SIDES_DEG
        .into_iter()
        .try_for_each(|side_deg| write(folder, &format!("{name}at{side_deg}"), &head.photo(&head.camera(side_deg))))
}

fn write(folder: &Path, name: &str, photo: &Photo) -> Result {
    let file = File::create(folder.join(format!("{name}.png")))?;
    let mut encoder = png::Encoder::new(file, photo.width(), photo.height());
    encoder.set_color(png::ColorType::Rgb);
    Ok(encoder.write_header()?.write_image_data(photo.pixels())?)
}
