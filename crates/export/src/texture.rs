//! Textures of exported files.

use std::borrow::Cow;

use glam::DVec2;
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use rosto_face::{MAX_PICTURE_SIDE_PX, Photo};

use crate::{ExportError, Model, Picture};

rosto_mesh::named! {
    /// Source of the face's colours. A file has either a texture or vertex colours, since glTF multiplies the two.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum BaseColour {
        /// The whole-face texture, encoded as JPEG.
        #[default]
        Whole = "whole",
        /// The photo: a power-of-two crop around the face, encoded as JPEG.
        Photo = "photo",
        /// One linear colour per vertex, 16 bits per channel.
        VertexColours = "colours",
    }
}

/// High enough to avoid visible blocks on skin.
const JPEG_QUALITY: u8 = 92;

/// Margin around the face in px, so that texture filtering at the rim does not reach the crop's edge.
const MARGIN_PX: f64 = 4.0;

/// A smaller limit would leave no room for the margin.
const SMALLEST_MAX_PX: u32 = 64;

/// A texture to encode, with the UV of each vertex.
pub(crate) struct Texture<'a> {
    pub pixels: Cow<'a, Photo>,
    pub uvs: Cow<'a, [DVec2]>,
}

/// Placement of a texture crop in the photo.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crop {
    /// Width and height of the whole picture in px, at the texture's scale.
    pub picture_size_px: [u32; 2],
    /// Left and top of the crop in that picture, in px; negative if the crop is larger than the picture.
    pub at_px: [i64; 2],
    /// Width and height of the crop in px.
    pub size_px: [u32; 2],
}

/// Crops the face from the photo, with power-of-two sides of at most `max_px` (rounded down to a power of two) and
/// [`MAX_PICTURE_SIDE_PX`]. The photo is scaled down only if the face does not fit.
pub(crate) fn crop<'a>(photo: &Picture<'a>, max_px: u32) -> Result<(Texture<'a>, Crop), ExportError> {
    let max_px = 1 << max_px.clamp(SMALLEST_MAX_PX, MAX_PICTURE_SIDE_PX).ilog2();
    let pixels = fitting(photo, max_px);
    let size = DVec2::new(pixels.width().into(), pixels.height().into());
    let (low, high) = face_box(photo.uvs);
    let (low, high) = (low * size - MARGIN_PX, high * size + MARGIN_PX);
    let [width, height] = (high - low).to_array().map(|side| power_of_two(side, max_px));
    let x0 = origin(low.x, high.x, width, pixels.width());
    let y0 = origin(low.y, high.y, height, pixels.height());
    let crop_size = DVec2::new(width.into(), height.into());
    let uv = |uv: &DVec2| (*uv * size - DVec2::new(x0 as f64, y0 as f64)) / crop_size;
    let crop = Crop { picture_size_px: [pixels.width(), pixels.height()], at_px: [x0, y0], size_px: [width, height] };
    let cut =
        Photo::from_rgb(width, height, cut(&pixels, &crop)).map_err(|_| ExportError::Texture { width, height })?;
    Ok((Texture { pixels: Cow::Owned(cut), uvs: photo.uvs.iter().map(uv).collect() }, crop))
}

/// The whole picture, scaled down to a longest side of at most `max_px`.
pub(crate) fn whole<'a>(picture: &Picture<'a>, max_px: u32) -> Texture<'a> {
    let pixels = match picture.pixels.width().max(picture.pixels.height()) > max_px {
        true => Cow::Owned(picture.pixels.scaled_down(max_px)),
        false => Cow::Borrowed(picture.pixels),
    };
    Texture { pixels, uvs: Cow::Borrowed(picture.uvs) }
}

/// Returns a model's texture with sides of at most `max_px`; `None` for vertex colours.
///
/// # Errors
/// [`ExportError::NoWholePicture`], or as [`crop`].
pub(crate) fn of<'a>(
    model: &Model<'a>,
    base_colour: BaseColour,
    max_px: u32,
) -> Result<Option<Texture<'a>>, ExportError> {
    Ok(match base_colour {
        BaseColour::Whole => Some(whole(&model.whole.ok_or(ExportError::NoWholePicture)?, max_px)),
        BaseColour::Photo => Some(crop(model.photo.as_ref().ok_or(ExportError::NoPicture)?, max_px)?.0),
        BaseColour::VertexColours => None,
    })
}

/// Encodes a picture as PNG.
///
/// Fast compression is implemented by the `png` crate itself, so the bytes do not depend on the build. Slower levels
/// use a compressor that other crates' features select.
pub(crate) fn png(pixels: &Photo) -> Result<Vec<u8>, ExportError> {
    let (width, height, mut file) = (pixels.width(), pixels.height(), Vec::new());
    let encoder = PngEncoder::new_with_quality(&mut file, CompressionType::Fast, FilterType::Adaptive);
    let written = match pixels.alpha() {
        Some(_) => encoder.write_image(&pixels.rgba(), width, height, ExtendedColorType::Rgba8),
        None => encoder.write_image(pixels.pixels(), width, height, ExtendedColorType::Rgb8),
    };
    written.map_err(|_| ExportError::Texture { width, height })?;
    Ok(file)
}

/// Encodes a picture as JPEG.
pub(crate) fn jpeg(pixels: &Photo) -> Result<Vec<u8>, ExportError> {
    let (width, height, mut file) = (pixels.width(), pixels.height(), Vec::new());
    JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY)
        .encode(pixels.pixels(), width, height, ExtendedColorType::Rgb8)
        .map_err(|_| ExportError::Texture { width, height })?;
    Ok(file)
}

/// The photo, scaled down if the face is larger than the largest texture.
fn fitting<'a>(picture: &Picture<'a>, max_px: u32) -> Cow<'a, Photo> {
    let photo = picture.pixels;
    let (low, high) = face_box(picture.uvs);
    let face = (high - low) * DVec2::new(photo.width().into(), photo.height().into());
    let room = f64::from(max_px) - 2.0 * MARGIN_PX - 1.0;
    let scale = (room / face.max_element()).min(1.0);
    if scale >= 1.0 {
        return Cow::Borrowed(photo);
    }
    Cow::Owned(photo.scaled_down((f64::from(photo.width().max(photo.height())) * scale).floor() as u32))
}

/// Bounding box of the face, clamped to the photo.
fn face_box(uvs: &[DVec2]) -> (DVec2, DVec2) {
    let inside = |uv: DVec2| uv.clamp(DVec2::ZERO, DVec2::ONE);
    let low = uvs.iter().copied().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
    let high = uvs.iter().copied().reduce(DVec2::max).unwrap_or(DVec2::ONE);
    (inside(low), inside(high))
}

fn power_of_two(side_px: f64, max_px: u32) -> u32 {
    (side_px.ceil().max(1.0) as u32).next_power_of_two().min(max_px)
}

/// Start of a crop of `side` px: centred on the face, then shifted into the photo as far as possible.
fn origin(low: f64, high: f64, side: u32, photo_side: u32) -> i64 {
    let centred = ((low + high - f64::from(side)) / 2.0).round() as i64;
    let last = i64::from(photo_side) - i64::from(side);
    if last >= 0 { centred.clamp(0, last) } else { last / 2 }
}

/// Pixels of the crop; edge pixels extend beyond the photo.
fn cut(photo: &Photo, crop: &Crop) -> Vec<u8> {
    let ([x0, y0], [width, height]) = (crop.at_px, crop.size_px);
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
