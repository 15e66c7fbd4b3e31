//! Cheeks that something in front of them covers, by the pixels of the photo.

use std::collections::{HashMap, HashSet};

use glam::{DVec2, DVec3};
use rosto_photo::Photo;

use crate::areas::Area;
use crate::camera::turn_rad;
use crate::model::{fit_canonical_to, in_px};
use crate::{Region, Triangulation, canonical_positions_m, mirror_of};

/// Distance between samples on the canonical face, and side of the square that a sample is the mean of.
const PITCH_M: f64 = 0.002;
/// Largest angle between the face's axis and the direction to the camera. Beyond it, the face itself hides a cheek.
const MAX_TURN_DEG: f64 = 35.0;
/// Smallest share of each cheek inside the picture.
const MIN_INSIDE: f64 = 0.75;
/// Smallest share of a cheek that is covered.
const MIN_COVERED: f64 = 0.15;
/// Largest share of the other cheek. Beards, glasses and freckles are on both.
const MAX_OTHER: f64 = 0.03;
/// Levels added before taking logarithms, to limit the noise of dark pixels.
const FLOOR: f64 = 6.0;
/// Smallest redness of skin, as of [`Sample::redness`]. Grey and faded photos have less.
const MIN_SKIN_REDNESS: f64 = 0.1;
/// Largest redness of a cover, relative to the skin's.
const MAX_COVER_REDNESS: f64 = 0.2;
/// Smallest logarithm of skin's brightness over a cover's. Highlights are brighter than skin.
const MIN_DARKER: f64 = 0.25;
/// Smallest step of redness at a cover's edge, relative to the skin's. Coloured light fades gradually.
const MIN_STEP: f64 = 0.5;
/// Smallest share of a cover's edge with such a step.
const MIN_SHARP: f64 = 0.6;
/// Smallest logarithm of the brightness on both sides of a strand over the strand's.
const MIN_STRAND: f64 = 0.25;

/// The cheek that something covers in part: [`Region::LeftCheek`] or [`Region::RightCheek`], the subject's.
///
/// Detects covers that are darker and less red than skin and have a sharp edge, and dark strands. Covers in the colour
/// of skin, such as a hand, are not detected. `None` if both cheeks are covered, the face is turned by more than 35° or
/// cut off by the picture's border, or 2 mm of it are less than a pixel. Shadows, coloured light and features of both
/// cheeks are not covers.
pub fn covered_cheek(photo: &Photo, landmarks: &[[f32; 3]]) -> Option<Region> {
    let landmarks_px = in_px(landmarks, [photo.width(), photo.height()]).ok()?;
    let px_from_model = fit_canonical_to(&landmarks_px).ok()?;
    let pitch_px = PITCH_M * px_from_model.scale;
    if turn_rad(px_from_model.rotation).to_degrees() > MAX_TURN_DEG || pitch_px < 1.0 {
        return None;
    }
    let places = places();
    let sides: [fn(u32) -> u32; 2] = [|landmark| landmark, mirror_of];
    let cheeks = sides.map(|side| Cheek::sampled(photo, &landmarks_px, &places, side, pitch_px));
    if cheeks.iter().any(|cheek| (cheek.0.len() as f64) < MIN_INSIDE * places.len() as f64) {
        return None;
    }
    let skin = skin(&cheeks);
    match cheeks.map(|cheek| cheek.covered_share(skin)) {
        [right, left] if right >= MIN_COVERED && left <= MAX_OTHER => Some(Region::RightCheek),
        [right, left] if left >= MIN_COVERED && right <= MAX_OTHER => Some(Region::LeftCheek),
        _ => None,
    }
}

/// Column and row of a sample.
type Cell = [i32; 2];

/// A place on the right cheek: three landmarks and their weights.
type Place = [(u32, f64); 3];

/// The grid of samples on the canonical face's right cheek, seen from the front.
fn places() -> HashMap<Cell, Place> {
    let canonical_m = canonical_positions_m();
    let triangles = Triangulation::Canonical.triangles();
    let is_cheek = |&landmark: &u32| {
        canonical_m[landmark as usize].x < 0.0 && matches!(Area::of(landmark), Area::Cheekbone | Area::Cheek)
    };
    let cheek = triangles.iter().filter(|corners| corners.iter().all(is_cheek));
    cheek
        .flat_map(|&corners| places_in(corners, corners.map(|corner| canonical_m[corner as usize].truncate())))
        .collect()
}

/// The grid's samples in a triangle.
fn places_in(corners: [u32; 3], [a, b, c]: [DVec2; 3]) -> Vec<(Cell, Place)> {
    let [first, last] = [a.min(b).min(c), a.max(b).max(c)].map(|corner| (corner / PITCH_M).floor().as_ivec2());
    let area = (b - a).perp_dot(c - a);
    let place = |cell: Cell| {
        let at = DVec2::new(f64::from(cell[0]), f64::from(cell[1])) * PITCH_M;
        let weights = [(b - at).perp_dot(c - at), (c - at).perp_dot(a - at), (a - at).perp_dot(b - at)];
        let is_inside = weights.iter().all(|weight| weight / area >= 0.0);
        is_inside.then(|| (cell, [0, 1, 2].map(|corner| (corners[corner], weights[corner] / area))))
    };
    let cells = (first.x..=last.x).flat_map(|column| (first.y..=last.y).map(move |row| [column, row]));
    cells.filter_map(place).collect()
}

#[derive(Debug, Clone, Copy)]
struct Sample {
    /// Logarithm of the level of green.
    brightness: f64,
    /// Logarithm of red over the geometric mean of green and blue: 0 for grey, 0.2 to 0.6 for skin.
    redness: f64,
}

impl Sample {
    /// Mean of a square, `None` outside the picture.
    fn at(photo: &Photo, centre_px: DVec2, side_px: f64) -> Option<Self> {
        let [first, last] = [-0.5, 0.5].map(|half| centre_px + half * side_px);
        if first.min_element() < 0.0 || last.x >= f64::from(photo.width()) || last.y >= f64::from(photo.height()) {
            return None;
        }
        let (first, last) = (first.as_uvec2(), last.as_uvec2());
        let mut sums = DVec3::ZERO;
        for y in first.y..=last.y {
            for x in first.x..=last.x {
                sums += DVec3::from(photo.pixel(x, y).map(f64::from));
            }
        }
        let count = f64::from((last.x - first.x + 1) * (last.y - first.y + 1));
        let [red, green, blue] = (sums / count).to_array().map(|level| (level + FLOOR).ln());
        Some(Self { brightness: green, redness: red - (green + blue) / 2.0 })
    }
}

/// Upper quartiles of the samples of both cheeks, which are those of skin even if one cheek is covered.
fn skin(cheeks: &[Cheek; 2]) -> Sample {
    let upper = |number: fn(&Sample) -> f64| {
        let mut numbers: Vec<f64> = cheeks.iter().flat_map(|cheek| cheek.0.values()).map(number).collect();
        numbers.sort_by(f64::total_cmp);
        numbers.get(numbers.len() * 3 / 4).copied().unwrap_or(f64::NAN)
    };
    Sample { brightness: upper(|one| one.brightness), redness: upper(|one| one.redness) }
}

/// Samples of a cheek.
struct Cheek(HashMap<Cell, Sample>);

impl Cheek {
    /// Samples the landmarks `side` of those of the right cheek.
    fn sampled(
        photo: &Photo,
        landmarks_px: &[DVec3],
        places: &HashMap<Cell, Place>,
        side: fn(u32) -> u32,
        pitch_px: f64,
    ) -> Self {
        let sample = |(&cell, place): (&Cell, &Place)| {
            let at_px: DVec3 =
                place.iter().map(|&(landmark, weight)| landmarks_px[side(landmark) as usize] * weight).sum();
            Some((cell, Sample::at(photo, DVec2::new(at_px.x, -at_px.y), pitch_px)?))
        };
        Self(places.iter().filter_map(sample).collect())
    }

    /// Share of the samples that are not skin.
    fn covered_share(&self, skin: Sample) -> f64 {
        let foreign = self.foreign(skin);
        let covered = self.0.keys().filter(|&&cell| foreign.contains(&cell) || self.is_strand(cell)).count();
        covered as f64 / self.0.len().max(1) as f64
    }

    /// Samples that are darker and less red than skin, if their edge is sharp.
    fn foreign(&self, skin: Sample) -> Vec<Cell> {
        let is_foreign = |one: &Sample| {
            one.redness < MAX_COVER_REDNESS * skin.redness && one.brightness < skin.brightness - MIN_DARKER
        };
        let foreign: Vec<Cell> = self.0.iter().filter(|(_, one)| is_foreign(one)).map(|(&cell, _)| cell).collect();
        if skin.redness < MIN_SKIN_REDNESS || !self.is_sharp(&foreign, MIN_STEP * skin.redness) {
            return Vec::new();
        }
        foreign
    }

    /// Whether the redness rises by `step` within three samples at the edge of an area.
    fn is_sharp(&self, area: &[Cell], step: f64) -> bool {
        let members: HashSet<&Cell> = area.iter().collect();
        let steps = area.iter().flat_map(|&cell| SIDES.map(|side| (cell, side))).filter_map(|(cell, side)| {
            let outside = moved(cell, side, 1);
            if members.contains(&outside) {
                return None;
            }
            let outer = self.0.get(&moved(cell, side, 2)).or_else(|| self.0.get(&outside))?;
            let inner = self.0.get(&moved(cell, side, -1)).unwrap_or(&self.0[&cell]);
            Some(outer.redness - inner.redness >= step)
        });
        let steps: Vec<bool> = steps.collect();
        let sharp = steps.iter().filter(|&&is_sharp| is_sharp).count();
        !steps.is_empty() && sharp as f64 >= MIN_SHARP * steps.len() as f64
    }

    /// Whether a sample is darker than those on both sides of it.
    fn is_strand(&self, cell: Cell) -> bool {
        let brightness = |side: Cell, steps: i32| self.0.get(&moved(cell, side, steps)).map(|one| one.brightness);
        let is_between = |side: Cell, steps: i32| match (brightness(side, steps), brightness(side, -steps)) {
            (Some(before), Some(after)) => before.min(after) - self.0[&cell].brightness >= MIN_STRAND,
            _ => false,
        };
        AXES.iter().any(|&axis| [1, 2].iter().any(|&steps| is_between(axis, steps)))
    }
}

/// Directions to the four neighbours of a sample.
const SIDES: [Cell; 4] = [[1, 0], [-1, 0], [0, 1], [0, -1]];
/// Directions across a strand.
const AXES: [Cell; 4] = [[1, 0], [0, 1], [1, 1], [1, -1]];

fn moved([column, row]: Cell, [x, y]: [i32; 2], steps: i32) -> Cell {
    [column + steps * x, row + steps * y]
}

/// Width of a face in px of the photo, if it faced the camera: between the sides of the face in front of the ears.
///
/// `None` for landmarks that [`check_landmarks`](crate::check_landmarks) rejects.
pub fn face_width_px(landmarks: &[[f32; 3]], photo_size_px: [u32; 2]) -> Option<f64> {
    const RIGHT_SIDE: u32 = 234;
    let px_from_model = fit_canonical_to(&in_px(landmarks, photo_size_px).ok()?).ok()?;
    let width_m = 2.0 * canonical_positions_m()[RIGHT_SIDE as usize].x.abs();
    Some(px_from_model.scale * width_m)
}
