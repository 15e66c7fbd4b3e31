//! `rosto photo`: a photo to the same photo with its face edited.

use std::io::Cursor;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};
use rosto_export::Units;
use rosto_face::FaceModel;
use rosto_photo::Photo;
use rosto_studio::{Document, InPhoto};

use crate::args::PhotoTask;
use crate::error::CliError;
use crate::mesh::{check_files, edited, steps};
use crate::networks::Networks;
use crate::request::{self, Given};
use crate::{networks, output, portrait, terminal};

/// Whoever wants the pixels as they are asks for a PNG.
const JPEG_QUALITY: u8 = 95;

/// `rosto photo`: photo to edited photo.
pub fn run(task: &PhotoTask, given: &Given<'_>, networks: Networks<'_>) -> Result<(), CliError> {
    check_files(std::slice::from_ref(&task.photo), &task.edits, &task.output)?;
    let format = PictureFormat::of(&task.output)?;
    request::check_photo(task, given)?;
    let steps = steps(&task.edits, &task.settings, Units::Mm)?;
    let photo = portrait::open(&task.photo)?;
    let finder = networks::load(networks, task.find.landmarks())?;
    let (face, notes) = portrait::face(&photo, &task.photo, &finder, &task.find.options(None))?;
    notes.iter().for_each(|note| terminal::note(note));
    let face = portrait::model(&photo, &face, task.mesh.topology, task.camera.lens(&photo), &task.photo)?;
    let document = edited(&face, steps, Units::Mm, task.mesh.density)?;
    if photo.alpha().is_some() && matches!(format, PictureFormat::Jpeg) {
        terminal::note("transparent parts are laid over white: a JPEG cannot hold them; a PNG can");
    }
    output::write(&task.output, &format.encode(&warped(&photo, &face, &document, task)?, &task.output)?)
}

fn warped(photo: &Photo, face: &FaceModel, document: &Document, task: &PhotoTask) -> Result<Photo, CliError> {
    let mut in_photo = InPhoto::new(face, document, task.falloff_band, &task.kept)?;
    let seen_from = match task.seen_from_m {
        Some(distance_m) => face.seen_from(distance_m),
        None => *face.camera(),
    };
    in_photo.follow(document.rest(), document.positions(), face.camera(), &seen_from);
    if in_photo.limited_px() > 1.0 {
        terminal::note(&format!(
            "the photo stays up to {:.0} px behind the edits, so that nothing in it folds",
            in_photo.limited_px()
        ));
    }
    Ok(rosto_warp::drawn(photo, in_photo.warp_mesh()))
}

/// What a photo is written as.
#[derive(Debug, Clone, Copy)]
enum PictureFormat {
    Png,
    Jpeg,
}

impl PictureFormat {
    fn of(path: &Path) -> Result<Self, CliError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
        match ending.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("jpg" | "jpeg") => Ok(Self::Jpeg),
            _ => Err(CliError::NoPictureFormat { path: path.to_owned() }),
        }
    }

    /// Upright sRGB, without any of what the photo's file told of where and when it was taken.
    fn encode(self, photo: &Photo, path: &Path) -> Result<Vec<u8>, CliError> {
        let mut bytes = Cursor::new(Vec::new());
        let (pixels, width, height, colour) = (photo.pixels(), photo.width(), photo.height(), ExtendedColorType::Rgb8);
        let written = match self {
            Self::Png if photo.alpha().is_some() => {
                PngEncoder::new(&mut bytes).write_image(&photo.rgba(), width, height, ExtendedColorType::Rgba8)
            }
            Self::Png => PngEncoder::new(&mut bytes).write_image(pixels, width, height, colour),
            Self::Jpeg => {
                JpegEncoder::new_with_quality(&mut bytes, JPEG_QUALITY).write_image(pixels, width, height, colour)
            }
        };
        let refused = |reason: ImageError| CliError::NotEncoded { path: path.to_owned(), reason };
        written.map_err(refused)?;
        Ok(bytes.into_inner())
    }
}
