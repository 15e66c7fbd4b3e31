use glam::{DVec2, Vec2};
use image::ExtendedColorType;
use image::codecs::jpeg::JpegEncoder;
use rosto_face::Photo;

use crate::{ExportError, Model};

/// High enough that skin shows no blocks.
const JPEG_QUALITY: u8 = 92;

/// Pixels around the face, so that filtering at its rim finds skin or background and no edge.
const MARGIN_PX: f64 = 4.0;

/// A smaller limit would leave the margin no room.
const SMALLEST_MAX_PX: u32 = 64;

/// The part of the photo that holds the face.
pub(super) struct Texture {
    pub jpeg: Vec<u8>,
    /// Each vertex's place in the crop.
    pub uvs: Vec<Vec2>,
    pub crop: Crop,
}

/// Where the texture was cut out of the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crop {
    /// Width and height of the whole picture in px, scaled as the texture is.
    pub picture_size_px: [u32; 2],
    /// The texture's left and top in that picture in px; negative where the texture is the larger one.
    pub at_px: [i64; 2],
    /// The texture's width and height in px.
    pub size_px: [u32; 2],
}

/// Cuts out the face with sides that are powers of two, at most `max_px` (rounded down to a power of two), at the photo's
/// own resolution where it fits.
pub(super) fn crop(model: &Model<'_>, max_px: u32) -> Result<Texture, ExportError> {
    let max_px = 1 << max_px.max(SMALLEST_MAX_PX).ilog2();
    let photo = fitting_photo(model, max_px);
    let size = DVec2::new(photo.width().into(), photo.height().into());
    let (low, high) = face_box(model.uvs);
    let (low, high) = (low * size - MARGIN_PX, high * size + MARGIN_PX);
    let [width, height] = (high - low).to_array().map(|side| power_of_two(side, max_px));
    let x0 = origin(low.x, high.x, width, photo.width());
    let y0 = origin(low.y, high.y, height, photo.height());
    let crop_size = DVec2::new(width.into(), height.into());
    let uv = |uv: &DVec2| ((*uv * size - DVec2::new(x0 as f64, y0 as f64)) / crop_size).as_vec2();
    let jpeg = encode(&cut(&photo, x0, y0, width, height), width, height)?;
    let crop = Crop { picture_size_px: [photo.width(), photo.height()], at_px: [x0, y0], size_px: [width, height] };
    Ok(Texture { jpeg, uvs: model.uvs.iter().map(uv).collect(), crop })
}

/// The photo, scaled down if the face in it is larger than the largest texture.
fn fitting_photo(model: &Model<'_>, max_px: u32) -> Photo {
    let photo = model.picture;
    let (low, high) = face_box(model.uvs);
    let face = (high - low) * DVec2::new(photo.width().into(), photo.height().into());
    let room = f64::from(max_px) - 2.0 * MARGIN_PX - 1.0;
    let scale = (room / face.max_element()).min(1.0);
    if scale >= 1.0 {
        return photo.clone();
    }
    photo.scaled_down((f64::from(photo.width().max(photo.height())) * scale).floor() as u32)
}

/// The corners of the face, inside the photo.
fn face_box(uvs: &[DVec2]) -> (DVec2, DVec2) {
    let inside = |uv: DVec2| uv.clamp(DVec2::ZERO, DVec2::ONE);
    let low = uvs.iter().copied().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
    let high = uvs.iter().copied().reduce(DVec2::max).unwrap_or(DVec2::ONE);
    (inside(low), inside(high))
}

fn power_of_two(side_px: f64, max_px: u32) -> u32 {
    (side_px.ceil().max(1.0) as u32).next_power_of_two().min(max_px)
}

/// Where a crop of `side` px starts: centred on the face, shifted into the photo as far as it fits.
fn origin(low: f64, high: f64, side: u32, photo_side: u32) -> i64 {
    let centred = ((low + high - f64::from(side)) / 2.0).round() as i64;
    let last = i64::from(photo_side) - i64::from(side);
    if last >= 0 { centred.clamp(0, last) } else { last / 2 }
}

/// The pixels of the crop; outside the photo its edge goes on.
fn cut(photo: &Photo, x0: i64, y0: i64, width: u32, height: u32) -> Vec<u8> {
    let inside = |at: i64, side: u32| at.clamp(0, i64::from(side) - 1) as u32;
    let mut pixels = Vec::with_capacity(width as usize * height as usize * 3);
    for y in 0..i64::from(height) {
        let y = inside(y0 + y, photo.height());
        for x in 0..i64::from(width) {
            pixels.extend(photo.pixel(inside(x0 + x, photo.width()), y));
        }
    }
    pixels
}

fn encode(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, ExportError> {
    let mut jpeg = Vec::new();
    JpegEncoder::new_with_quality(&mut jpeg, JPEG_QUALITY)
        .encode(pixels, width, height, ExtendedColorType::Rgb8)
        .map_err(|_| ExportError::Texture { width, height })?;
    Ok(jpeg)
}
