use glam::DVec2;
use rosto_face::Triangulation;

use super::Reopened;

/// Maximum side of the face in a painted picture, in px.
const FACE_SIDE_PX: f64 = 512.0;

/// Maximum side of the whole picture, in px.
const PICTURE_SIDE_PX: f64 = 2048.0;

/// An upright picture painted from colours: RGBA, row by row from the top, transparent outside the face.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Painted {
    /// Width in px.
    pub width: u32,
    /// Height in px.
    pub height: u32,
    /// Four bytes per pixel.
    pub rgba: Vec<u8>,
}

impl Reopened<'_> {
    /// Blends the landmarks' colours over the triangles, as a substitute if the file contains no photo.
    pub fn painted(&self) -> Painted {
        painted(&self.landmarks, self.photo_size_px, &self.colours_srgb, self.triangulation)
    }
}

/// Blends the colours of landmarks over the triangles between them.
pub(super) fn painted(
    landmarks: &[[f32; 3]],
    photo_size_px: [u32; 2],
    colours_srgb: &[[u8; 3]],
    triangulation: Triangulation,
) -> Painted {
    let scale = scale(landmarks, photo_size_px);
    let [width, height] = photo_size_px.map(|side| (f64::from(side) * scale).round().max(1.0) as u32);
    let size = DVec2::new(width.into(), height.into());
    let position = |&[x, y, _]: &[f32; 3]| DVec2::new(x.into(), y.into()) * size;
    let positions: Vec<DVec2> = landmarks.iter().map(position).collect();
    let mut picture = Painted { width, height, rgba: vec![0; width as usize * height as usize * 4] };
    for corners in triangulation.triangles() {
        let corners = corners.map(|corner| corner as usize);
        picture.fill(corners.map(|corner| positions[corner]), corners.map(|corner| colours_srgb[corner]));
    }
    picture
}

/// Scale from the photo to the painted picture.
fn scale(landmarks: &[[f32; 3]], photo_size_px: [u32; 2]) -> f64 {
    let photo = DVec2::from(photo_size_px.map(f64::from));
    let positions = landmarks.iter().map(|&[x, y, _]| DVec2::new(x.into(), y.into()).clamp(DVec2::ZERO, DVec2::ONE));
    let low = positions.clone().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
    let high = positions.reduce(DVec2::max).unwrap_or(DVec2::ONE);
    let face_px = ((high - low) * photo).max_element().max(1.0);
    (FACE_SIDE_PX / face_px).min(PICTURE_SIDE_PX / photo.max_element()).min(1.0)
}

impl Painted {
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
                    let at = (y as usize * self.width as usize + x as usize) * 4;
                    let pixel = [mixed(0).round() as u8, mixed(1).round() as u8, mixed(2).round() as u8, u8::MAX];
                    self.rgba[at..at + 4].copy_from_slice(&pixel);
                }
            }
        }
    }
}
