//! How far a whole texture is from the truth, and how long it takes on one thread of this machine.
//!
//! A head whose texture is known is photographed, a texture is made of the photos, and what they did not show is compared.
//! Prints one JSON object a line, as `peers.py` does. With a folder, the pictures are written into it; with a photo besides, that
//! photo's texture instead: of the sample portrait or, with a JSON file of its landmarks, of any other.

#[path = "../seeded.rs"]
mod seeded;
#[path = "../texture_truth.rs"]
mod texture_truth;

use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::Instant;

use glam::DVec3;
use rosto_face::{Camera, FaceModel, Photo, PhotoLens};
use rosto_studio::{Shot, Texture, whole_texture, whole_texture_of};
use serde_json::json;
use texture_truth::{DISTANCE_M, Head, errors, face, landmarks_in, portrait_landmarks};

type Result<T = ()> = std::result::Result<T, Box<dyn std::error::Error>>;

const SIDE_PX: u32 = 2048;
const YAWS_DEG: [f64; 5] = [0.0, 20.0, -20.0, 40.0, -40.0];
const TOGETHER_DEG: [f64; 3] = [0.0, 40.0, -40.0];
/// From where the pictures of textures are taken.
const SIDES_DEG: [f64; 2] = [-45.0, 45.0];
const RUNS: usize = 9;

fn main() -> Result {
    let mut arguments = std::env::args().skip(1).map(PathBuf::from);
    let (folder, photo, landmarks) = (arguments.next(), arguments.next(), arguments.next());
    let folder = folder.as_deref();
    if let Some(photo) = photo {
        let landmarks = landmarks.map(std::fs::read_to_string).transpose()?;
        let landmarks = landmarks.map_or_else(portrait_landmarks, |json| landmarks_in(&json));
        return of_photo(&read(&photo)?, &landmarks, folder);
    }
    let head = Head::painted(SIDE_PX);
    write(folder, "truth", &head.texture)?;
    for yaw_deg in SIDES_DEG {
        write(folder, &format!("truthat{yaw_deg}"), &head.photo(&head.camera(yaw_deg)))?;
    }
    for yaw_deg in YAWS_DEG {
        let face = taken(&head, yaw_deg, folder)?;
        let texture = whole_texture(&face, SIDE_PX)?;
        report(&head, &format!("{yaw_deg}"), &head.camera(yaw_deg), &face, &texture, folder)?;
    }
    together(&head, folder)?;
    timed(&head)
}

/// The face in a photo of the head.
fn taken(head: &Head, yaw_deg: f64, folder: Option<&Path>) -> Result<FaceModel> {
    let camera = head.camera(yaw_deg);
    let photo = head.photo(&camera);
    write(folder, &format!("photo{yaw_deg}"), &photo)?;
    Ok(face(photo, &head.landmarks(&camera), PhotoLens::Distance(DISTANCE_M)))
}

fn together(head: &Head, folder: Option<&Path>) -> Result {
    let faces = TOGETHER_DEG.map(|yaw_deg| taken(head, yaw_deg, None));
    let [front, faces @ ..] = faces;
    let (front, faces) = (front?, faces.into_iter().collect::<Result<Vec<_>>>()?);
    let cameras = TOGETHER_DEG.map(|yaw_deg| head.camera(yaw_deg));
    // Taken with other exposures than the first.
    let pictures = [dimmed(faces[0].picture(), [0.7, 0.72, 0.8])?, dimmed(faces[1].picture(), [0.9, 0.85, 0.8])?];
    let shots = [0, 1].map(|i| Shot { picture: &pictures[i], uvs: faces[i].uvs(), camera: &cameras[i + 1] });
    let texture = whole_texture_of(&front, &shots, SIDE_PX)?;
    report(head, "together", &cameras[0], &front, &texture, folder)
}

fn dimmed(photo: &Photo, gains: [f64; 3]) -> Result<Photo> {
    let dim = |(i, level): (usize, &u8)| (f64::from(*level) * gains[i % 3] + 0.5) as u8;
    Ok(Photo::from_rgb(photo.width(), photo.height(), photo.pixels().iter().enumerate().map(dim).collect())?)
}

/// What the face's own photo, taken by that camera, does not show, and what it does: projected from it, and in the texture.
fn report(
    head: &Head,
    name: &str,
    camera: &Camera,
    face: &FaceModel,
    texture: &Texture,
    folder: Option<&Path>,
) -> Result {
    let side = SIDE_PX as usize;
    let (seen, skin) = (head.seen(camera, side), head.skin(side));
    let hidden: Vec<bool> = (0..side * side).map(|texel| skin[texel] && !seen[texel]).collect();
    let shown: Vec<bool> = (0..side * side).map(|texel| skin[texel] && seen[texel]).collect();
    let share = hidden.iter().filter(|is| **is).count() as f64 / skin.iter().filter(|is| **is).count() as f64;
    let projected = head.projected(face, side);
    let of = |texels: &[bool], found: &Photo| errors(&head.texture, found, texels);
    println!(
        "{}",
        json!({
            "task": "texture-error", "peer": "rosto", "photos": name, "hidden_share": share,
            "hidden_before": of(&hidden, &projected), "hidden_after": of(&hidden, &texture.picture),
            "seen_before": of(&shown, &projected), "seen_after": of(&shown, &texture.picture),
            "shares": [texture.shares.seen, texture.shares.mirrored, texture.shares.filled],
        })
    );
    write(folder, &format!("projected{name}"), &projected)?;
    write(folder, &format!("whole{name}"), &texture.picture)?;
    let whole = Head::new(&head.landmarks_m, texture.picture.clone());
    let before = Head::new(&head.landmarks_m, projected);
    for yaw_deg in SIDES_DEG {
        write(folder, &format!("whole{name}at{yaw_deg}"), &whole.photo(&head.camera(yaw_deg)))?;
        write(folder, &format!("projected{name}at{yaw_deg}"), &before.photo(&head.camera(yaw_deg)))?;
    }
    Ok(())
}

fn timed(head: &Head) -> Result {
    let camera = head.camera(20.0);
    let face = face(head.photo(&camera), &head.landmarks(&camera), PhotoLens::Distance(DISTANCE_M));
    for side_px in [1024, 2048, 4096] {
        let mut times_ms = Vec::new();
        for _ in 0..RUNS {
            let run = Instant::now();
            whole_texture(&face, side_px)?;
            times_ms.push(run.elapsed().as_secs_f64() * 1e3);
        }
        times_ms.sort_by(f64::total_cmp);
        println!(
            "{}",
            json!({"task": format!("texture-{side_px}"), "peer": "rosto", "ms": times_ms[RUNS / 2], "runs": RUNS})
        );
    }
    Ok(())
}

/// What a real photo gives.
fn of_photo(photo: &Photo, landmarks: &[[f32; 3]], folder: Option<&Path>) -> Result {
    let face = face(photo.clone(), landmarks, PhotoLens::Estimated);
    let texture = whole_texture(&face, SIDE_PX)?;
    println!(
        "{}",
        json!({"task": "photo", "peer": "rosto", "shares": [texture.shares.seen, texture.shares.mirrored, texture.shares.filled]})
    );
    write(folder, "whole", &texture.picture)?;
    let places_m: Vec<DVec3> = face.positions_m().to_vec();
    let bare = Head::new(&places_m, texture.picture.clone());
    write(folder, "projected", &bare.projected(&face, SIDE_PX as usize))?;
    let before = Head::new(&places_m, bare.projected(&face, SIDE_PX as usize));
    for yaw_deg in [0.0, -45.0, 45.0] {
        write(folder, &format!("wholeat{yaw_deg}"), &bare.photo(&bare.camera(yaw_deg)))?;
        write(folder, &format!("projectedat{yaw_deg}"), &before.photo(&bare.camera(yaw_deg)))?;
    }
    Ok(())
}

fn read(path: &Path) -> Result<Photo> {
    Ok(rosto_photo::decode(&std::fs::read(path)?, &rosto_photo::Limits::default())?)
}

fn write(folder: Option<&Path>, name: &str, photo: &Photo) -> Result {
    let Some(folder) = folder else { return Ok(()) };
    std::fs::create_dir_all(folder)?;
    let mut encoder =
        png::Encoder::new(File::create(folder.join(format!("{name}.png")))?, photo.width(), photo.height());
    encoder.set_color(png::ColorType::Rgb);
    Ok(encoder.write_header()?.write_image_data(photo.pixels())?)
}
