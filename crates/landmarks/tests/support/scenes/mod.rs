//! Synthetic pictures with known landmarks: the portrait, composited onto backgrounds by fixed rules.

pub mod canvas;
pub mod families;
pub mod filters;
pub mod verdict;

use rosto_landmarks::{Face, FaceFinder, FindOptions};
use rosto_photo::Photo;

use super::pictures;
use canvas::Ground;

/// Position of a copy of the portrait: `picture = at_px + scale · R(degrees) · (portrait − MIDDLE)`. Pixel centres have
/// integer coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Position of the middle of the face.
    pub at_px: [f64; 2],
    pub scale: f64,
    /// Clockwise.
    pub degrees: f64,
    /// Whether the portrait is mirrored first.
    pub mirrored: bool,
}

/// The middle of the face in the portrait.
const MIDDLE: [f64; 2] = [224.0, 124.0];
/// Distance between the outer corners of the eyes in the portrait.
pub const EYE_DISTANCE_PX: f64 = 62.0;
/// The portrait's head with a small margin: left, top, width, height.
const HEAD: [u32; 4] = [124, 0, 200, 236];
const WHOLE: [u32; 4] = [0, 0, 512, 512];

impl Placement {
    pub fn upright(at_px: [f64; 2], scale: f64) -> Self {
        Self { at_px, scale, degrees: 0.0, mirrored: false }
    }

    fn middle(&self) -> [f64; 2] {
        if self.mirrored { [511.0 - MIDDLE[0], MIDDLE[1]] } else { MIDDLE }
    }

    /// Maps px of the portrait (or its mirror image) to px of the picture.
    pub fn in_picture(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (cos, sin) = self.turn();
        let [dx, dy] = [x - self.middle()[0], y - self.middle()[1]];
        [self.at_px[0] + self.scale * (cos * dx - sin * dy), self.at_px[1] + self.scale * (sin * dx + cos * dy)]
    }

    /// Inverse of [`Self::in_picture`].
    pub fn in_portrait(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (cos, sin) = self.turn();
        let [dx, dy] = [(x - self.at_px[0]) / self.scale, (y - self.at_px[1]) / self.scale];
        [self.middle()[0] + cos * dx + sin * dy, self.middle()[1] - sin * dx + cos * dy]
    }

    /// Cosine and sine, rounded so that all mathematics libraries give the same pixels.
    fn turn(&self) -> (f64, f64) {
        let rounded = |value: f64| (value * 65_536.0).round() / 65_536.0;
        (rounded(self.degrees.to_radians().cos()), rounded(self.degrees.to_radians().sin()))
    }
}

/// The portrait and its mirror image, with their landmarks as ground truth.
pub struct Model {
    pub portrait: Photo,
    mirrored: Photo,
    landmarks_px: Vec<[f64; 2]>,
    mirrored_landmarks_px: Vec<[f64; 2]>,
}

impl Model {
    pub fn new(finder: &FaceFinder, portrait: &Photo) -> Self {
        let mirrored = pictures::flipped(portrait);
        let landmarks = |photo: &Photo| {
            let faces = finder.find(photo, &FindOptions::default()).expect("the networks run");
            landmarks_px(&faces[0], photo)
        };
        Self {
            landmarks_px: landmarks(portrait),
            mirrored_landmarks_px: landmarks(&mirrored),
            portrait: portrait.clone(),
            mirrored,
        }
    }

    /// Landmarks of a placed face in the picture, px.
    pub fn truth_px(&self, placed: &Placement) -> Vec<[f64; 2]> {
        let own = if placed.mirrored { &self.mirrored_landmarks_px } else { &self.landmarks_px };
        self.placed_landmarks_px(own, placed)
    }

    /// Maps landmarks of the portrait to the picture, px.
    pub fn placed_landmarks_px(&self, landmarks_px: &[[f64; 2]], placed: &Placement) -> Vec<[f64; 2]> {
        landmarks_px.iter().map(|&at| placed.in_picture(at)).collect()
    }
}

/// x and y of each landmark, in px of the picture.
pub fn landmarks_px(face: &Face, photo: &Photo) -> Vec<[f64; 2]> {
    let (width, height) = (f64::from(photo.width()), f64::from(photo.height()));
    face.landmarks.iter().map(|&[x, y, _]| [f64::from(x) * width, f64::from(y) * height]).collect()
}

/// The description of a picture, which is rendered on demand because some are large.
pub struct Scene {
    pub family: &'static str,
    pub name: String,
    pub size_px: [u32; 2],
    pub ground: Ground,
    pub seed: u64,
    /// Visible part of the portrait.
    pub part: Part,
    pub faces: Vec<Placement>,
    pub filter: filters::Filter,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    Whole,
    Head,
}

impl Scene {
    pub fn picture(&self, model: &Model) -> Photo {
        let [width, height] = self.size_px;
        let mut pixels = self.ground.picture(width, height, self.seed, &model.portrait).pixels().to_vec();
        for placed in &self.faces {
            let source = if placed.mirrored { &model.mirrored } else { &model.portrait };
            let part = match self.part {
                Part::Whole => WHOLE,
                Part::Head if placed.mirrored => [512 - HEAD[0] - HEAD[2], HEAD[1], HEAD[2], HEAD[3]],
                Part::Head => HEAD,
            };
            canvas::put(&mut pixels, width, height, source, part, placed);
        }
        self.filter.of(&Photo::from_rgb(width, height, pixels).expect("there are three bytes per pixel"), self.seed)
    }
}

/// Mean distance of landmarks from the ground truth, relative to the distance between the eyes. Omits landmarks whose
/// ground truth is outside the picture.
pub fn error(found_px: &[[f64; 2]], truth_px: &[[f64; 2]], placed: &Placement, size_px: [u32; 2]) -> f64 {
    let inside =
        |&[x, y]: &[f64; 2]| (0.0..f64::from(size_px[0])).contains(&x) && (0.0..f64::from(size_px[1])).contains(&y);
    let distances: Vec<f64> = found_px
        .iter()
        .zip(truth_px)
        .filter(|(_, truth)| inside(truth))
        .map(|(found, truth)| (found[0] - truth[0]).hypot(found[1] - truth[1]))
        .collect();
    distances.iter().sum::<f64>() / distances.len() as f64 / (EYE_DISTANCE_PX * placed.scale)
}
