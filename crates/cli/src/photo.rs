//! Implementation of `rosto photo`.

use std::io::Cursor;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};
use rosto_export::Units;
use rosto_face::FaceModel;
use rosto_photo::Photo;
use rosto_studio::{Document, PhotoWarp};

use crate::args::PhotoTask;
use crate::error::CliError;
use crate::mesh::{check_files, edited, steps};
use crate::networks::Networks;
use crate::request::{self, Given};
use crate::{networks, output, portrait, terminal};

/// JPEG quality; PNG is lossless.
const JPEG_QUALITY: u8 = 95;

/// Runs `rosto photo`.
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
        terminal::note("transparent parts become white, because JPEG has no transparency; PNG keeps them");
    }
    output::write(&task.output, &format.encode(&warped(&photo, &face, &document, task)?, &task.output)?)
}

fn warped(photo: &Photo, face: &FaceModel, document: &Document, task: &PhotoTask) -> Result<Photo, CliError> {
    let mut warp = PhotoWarp::new(face, document, task.falloff_band, &task.protected)?;
    let seen_from = match task.seen_from_m {
        Some(distance_m) => face.seen_from(distance_m),
        None => *face.camera(),
    };
    warp.follow(document.rest(), document.positions(), face.camera(), &seen_from);
    if warp.limited_px() > 1.0 {
        terminal::note(&format!(
            "the edits in the photo are reduced by up to {:.0} px to avoid folds",
            warp.limited_px()
        ));
    }
    Ok(rosto_warp::drawn(photo, warp.warp_mesh()))
}

/// File format of a photo.
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
            _ => Err(CliError::UnknownPictureFormat { path: path.to_owned() }),
        }
    }

    /// Encodes upright sRGB pixels, without the photo's metadata.
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
