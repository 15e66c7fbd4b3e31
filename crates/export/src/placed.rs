//! Pictures in files, which hold only the part around the face.

use std::borrow::Cow;

use base64::prelude::{BASE64_STANDARD, Engine};
use glam::DVec2;
use image::RgbImage;
use image::imageops::{FilterType, overlay, resize};
use rosto_face::{MAX_PICTURE_SIDE_PX, Observation, Photo, Triangulation};
use rosto_photo::{Limits, decode};
use serde_json::{Value, json};

use crate::texture::Crop;

/// Limits of a picture in a file: those of a model's picture.
const LIMITS: Limits =
    Limits { max_bytes: 40_000_000, max_pixels: MAX_PICTURE_SIDE_PX as u64 * MAX_PICTURE_SIDE_PX as u64 };

/// Maximum side of the face in a painted picture, in px.
const FACE_SIDE_PX: f64 = 512.0;

/// Maximum side of a painted picture, in px.
const PAINTED_SIDE_PX: f64 = 2048.0;

/// An encoded picture in a file, and its place in the whole upright picture. Another program may have resized it.
pub(crate) struct PlacedPicture<'a> {
    /// PNG or JPEG.
    encoded: Cow<'a, [u8]>,
    /// Size of the whole upright picture, and place of the part in it; `None` if the part is the whole.
    place: Option<Place>,
}

struct Place {
    picture_size_px: [u32; 2],
    /// Left and top, in px; negative if the part extends beyond the picture.
    at_px: [i64; 2],
    size_px: [u32; 2],
}

/// The placement of a crop as JSON.
pub(crate) fn placement(crop: &Crop) -> Value {
    json!({"size_px": crop.picture_size_px, "crop_at_px": crop.at_px, "crop_size_px": crop.size_px})
}

impl<'a> PlacedPicture<'a> {
    /// A whole picture.
    pub fn whole(encoded: &'a [u8]) -> Self {
        Self { encoded: Cow::Borrowed(encoded), place: None }
    }

    /// A part with this placement.
    pub fn part(encoded: &'a [u8], placement: &Value) -> Option<Self> {
        Some(Self { encoded: Cow::Borrowed(encoded), place: Some(place(placement)?) })
    }

    /// A part in base64 within its placement.
    pub fn embedded(placement: &Value) -> Option<Self> {
        let encoded = BASE64_STANDARD.decode(placement["jpeg"].as_str()?).ok()?;
        Some(Self { encoded: Cow::Owned(encoded), place: Some(place(placement)?) })
    }

    /// Decodes the part and puts it in its place; black and transparent around it. `None` if it is damaged.
    pub fn picture(&self) -> Option<Photo> {
        let part = decode(&self.encoded, &LIMITS).ok()?;
        let Some(Place { picture_size_px: [width, height], at_px, size_px }) = self.place else { return Some(part) };
        if [width, height] == size_px && size_px == [part.width(), part.height()] && at_px == [0, 0] {
            return Some(part);
        }
        let pixels = RgbImage::from_raw(part.width(), part.height(), part.pixels().to_vec())?;
        let pixels = match [part.width(), part.height()] == size_px {
            true => pixels,
            false => resize(&pixels, size_px[0], size_px[1], FilterType::Triangle),
        };
        let mut whole = RgbImage::new(width, height);
        overlay(&mut whole, &pixels, at_px[0], at_px[1]);
        let is_inside =
            |at: u32, axis: usize| (at_px[axis]..at_px[axis] + i64::from(size_px[axis])).contains(&at.into());
        let alpha = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let alpha = alpha.map(|(x, y)| if is_inside(x, 0) && is_inside(y, 1) { u8::MAX } else { 0 });
        Photo::from_rgb(width, height, whole.into_raw()).ok()?.with_alpha(alpha.collect()).ok()
    }
}

fn place(placement: &Value) -> Option<Place> {
    let [left, top] = placement["crop_at_px"].as_array()?.as_slice() else { return None };
    let coordinate = |value: &Value| value.as_i64().filter(|at| at.unsigned_abs() <= MAX_PICTURE_SIDE_PX.into());
    let size = |value: &Value| {
        let [width, height] = value.as_array()?.as_slice() else { return None };
        let side = |value: &Value| value.as_u64().filter(|side| (1..=MAX_PICTURE_SIDE_PX.into()).contains(side));
        Some([side(width)? as u32, side(height)? as u32])
    };
    Some(Place {
        picture_size_px: size(&placement["size_px"])?,
        at_px: [coordinate(left)?, coordinate(top)?],
        size_px: size(&placement["crop_size_px"])?,
    })
}

/// A substitute for a photo: the landmarks' colours blended over the triangles between them; black and transparent
/// outside the face.
pub(crate) fn painted(face: &Observation, triangulation: Triangulation) -> Photo {
    let scale = scale(&face.landmarks, face.photo_size_px);
    let [width, height] = face.photo_size_px.map(|side| (f64::from(side) * scale).round().max(1.0) as u32);
    let size = DVec2::new(width.into(), height.into());
    let position = |&[x, y, _]: &[f32; 3]| DVec2::new(x.into(), y.into()) * size;
    let positions: Vec<DVec2> = face.landmarks.iter().map(position).collect();
    let mut picture = Canvas::new(width, height);
    for corners in triangulation.triangles() {
        let corners = corners.map(|corner| corner as usize);
        picture.fill(corners.map(|corner| positions[corner]), corners.map(|corner| face.colours_srgb[corner]));
    }
    picture.photo()
}

/// Scale from the photo to the painted picture.
fn scale(landmarks: &[[f32; 3]], photo_size_px: [u32; 2]) -> f64 {
    let photo = DVec2::from(photo_size_px.map(f64::from));
    let positions = landmarks.iter().map(|&[x, y, _]| DVec2::new(x.into(), y.into()).clamp(DVec2::ZERO, DVec2::ONE));
    let low = positions.clone().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
    let high = positions.reduce(DVec2::max).unwrap_or(DVec2::ONE);
    let face_px = ((high - low) * photo).max_element().max(1.0);
    (FACE_SIDE_PX / face_px).min(PAINTED_SIDE_PX / photo.max_element()).min(1.0)
}

/// A picture that is being painted.
struct Canvas {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
    alpha: Vec<u8>,
}

impl Canvas {
    fn new(width: u32, height: u32) -> Self {
        let pixels = width as usize * height as usize;
        Self { width, height, rgb: vec![0; pixels * 3], alpha: vec![0; pixels] }
    }

    /// Fills the pixels whose centre lies in the triangle.
    fn fill(&mut self, corners: [DVec2; 3], colours: [[u8; 3]; 3]) {
        let [a, b, c] = corners;
        let area = (b - a).perp_dot(c - a);
        if area == 0.0 {
            return;
        }
        let low = a.min(b).min(c).max(DVec2::ZERO);
        let high = a.max(b).max(c).min(DVec2::new(self.width.into(), self.height.into()));
        for y in low.y as u32..high.y.ceil() as u32 {
            for x in low.x as u32..high.x.ceil() as u32 {
                let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let weight = |from: DVec2, to: DVec2| (to - from).perp_dot(centre - from) / area;
                let weights = [weight(b, c), weight(c, a), weight(a, b)];
                if weights.iter().all(|&weight| weight >= 0.0) {
                    let mixed =
                        |channel: usize| (0..3).map(|i| weights[i] * f64::from(colours[i][channel])).sum::<f64>();
                    let at = y as usize * self.width as usize + x as usize;
                    self.rgb[at * 3..at * 3 + 3]
                        .copy_from_slice(&[0, 1, 2].map(|channel| mixed(channel).round() as u8));
                    self.alpha[at] = u8::MAX;
                }
            }
        }
    }

    fn photo(self) -> Photo {
        let photo = Photo::from_rgb(self.width, self.height, self.rgb).expect("invariant: three bytes per pixel");
        photo.with_alpha(self.alpha).expect("invariant: one byte per pixel")
    }
}
