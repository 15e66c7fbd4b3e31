//! Implementation of `rosto photo`.

use std::io::Cursor;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};
use rosto::{MeshRequest, PhotoEdit, PhotoRequest, Units};
use rosto_photo::Photo;

use crate::args::PhotoTask;
use crate::effect::{self, Given};
use crate::error::CliError;
use crate::mesh::check_files;
use crate::{faces, networks, output, terminal};

/// JPEG quality; PNG is lossless.
const JPEG_QUALITY: u8 = 95;

/// Runs `rosto photo`.
pub fn run(task: &PhotoTask, given: &Given<'_>, networks: Option<&Path>) -> Result<(), CliError> {
    check_files(std::slice::from_ref(&task.photo), &task.edits, &task.output)?;
    let format = PictureFormat::of(&task.output)?;
    effect::check_photo(task, given)?;
    let request = task.mesh.request(Units::Mm, &task.edits, &task.settings)?;
    let photos = [(task.photo.clone(), faces::open(&task.photo)?)];
    let finder = networks::load(networks, task.find.landmarks())?;
    let (observations, notes) = faces::observed(&photos, &finder, &task.find, &task.camera)?;
    notes.iter().for_each(|note| terminal::note(note));
    let refused = |reason| CliError::in_photos(reason, &[&task.photo]);
    let mesh = MeshRequest { photos: observations, ..request }.open().map_err(refused)?;
    let [(_, photo)] = &photos;
    if photo.alpha().is_some() && matches!(format, PictureFormat::Jpeg) {
        terminal::note("transparent parts become white, because JPEG has no transparency; PNG keeps them");
    }
    let edit = PhotoEdit { seen_from_m: task.seen_from_m, strokes: vec![task.protected.clone()] };
    let edited = PhotoRequest { photo, mesh: &mesh, falloff_band: task.falloff_band, edit }.image()?;
    if edited.limited_px > 1.0 {
        let limited_px = edited.limited_px;
        terminal::note(&format!("the edits in the photo are reduced by up to {limited_px:.0} px to avoid folds"));
    }
    output::write(&task.output, &format.encode(&edited.photo, &task.output)?)
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
