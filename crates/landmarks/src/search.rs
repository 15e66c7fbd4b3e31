//! The regions of the picture that the detector processes.

use std::f32::consts::{FRAC_PI_2, PI};

use rosto_photo::Photo;

use crate::detection::Detection;
use crate::detector::Detector;
use crate::pyramid::Pyramid;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::{LandmarksError, suppression};

/// Distance between tiles, relative to their side. Faces larger than the overlap are found at the previous level.
const STRIDE: f32 = 0.7;
/// Detector score from which a detection counts as a face while searching.
pub(crate) const CONFIDENT_SCORE: f32 = 0.75;
/// Smallest face that the detector finds, relative to its region.
const MIN_FACE_SHARE: f32 = 0.12;
/// Ratio of face sizes beyond which smaller faces are not searched for.
const MAX_SIZE_RATIO: f32 = 5.0;
/// Maximum number of proposals. A picture with more has uncertain detections everywhere, and no faces.
const MAX_PROPOSALS: usize = 100;
/// Range of values, of 255, below which a tile is skipped as uniform.
const FLAT_RANGE: u8 = 10;

/// Returns the possible faces, highest score first, without duplicates.
///
/// Runs the detector on the whole picture, upright as MediaPipe does and rotated by multiples of 90°. Then runs it on
/// smaller and smaller upright tiles, since it finds faces rotated by up to about 100°, and on upside-down tiles at
/// levels without an upright face. Stops when it has `enough` faces larger than those of the next level, or when the
/// next level's faces would be less than a fifth as large as the smallest one found. Calls `report` with the completed
/// fraction.
pub(crate) fn proposals(
    detector: &Detector,
    pyramid: &Pyramid<'_>,
    enough: usize,
    mut report: impl FnMut(f32),
) -> Result<Vec<Detection>, LandmarksError> {
    let mut found = whole(detector, pyramid)?;
    for level in 1..pyramid.copies.len() {
        let done = |share: f32| (level as f32 + share) / pyramid.copies.len() as f32;
        report(done(0.0));
        let confident: Vec<Detection> =
            found.iter().filter(|detection| detection.score >= CONFIDENT_SCORE).copied().collect();
        if confident.len() >= enough || !is_worthwhile(&confident, &pyramid.copies[0], level) {
            break;
        }
        let upright = in_tiles(detector, pyramid, level, 0.0, &confident, |share| report(done(share / 2.0)))?;
        let nothing = confident.is_empty() && !upright.iter().any(|detection| detection.score >= CONFIDENT_SCORE);
        found.extend(upright);
        if nothing {
            found.extend(in_tiles(detector, pyramid, level, -PI, &confident, |share| report(done(0.5 + share / 2.0)))?);
        }
        found = suppression::best_only(found);
    }
    found.truncate(MAX_PROPOSALS);
    Ok(found)
}

fn whole(detector: &Detector, pyramid: &Pyramid<'_>) -> Result<Vec<Detection>, LandmarksError> {
    let photo = pyramid.photo;
    let mut found = detector.detect(photo, &RegionPx::whole(PictureSize::of(photo)))?;
    let small = &pyramid.copies[0];
    for rotation_rad in [FRAC_PI_2, -PI, -FRAC_PI_2] {
        let region = RegionPx { rotation_rad, ..RegionPx::whole(PictureSize::of(small)) };
        found.extend(detector.detect(small, &region)?);
    }
    Ok(suppression::best_only(found))
}

/// Whether a level can contain faces that are not much smaller than the ones found.
fn is_worthwhile(confident: &[Detection], picture: &Photo, level: usize) -> bool {
    let largest_new = MIN_FACE_SHARE * Pyramid::tile_share(level - 1);
    confident
        .iter()
        .map(|detection| share(detection, picture))
        .reduce(f32::min)
        .is_none_or(|smallest| smallest < MAX_SIZE_RATIO * largest_new)
}

/// The longer side of a detection, relative to that of the picture.
fn share(detection: &Detection, picture: &Photo) -> f32 {
    let PictureSize { width, height } = PictureSize::of(picture);
    let side = |axis: usize| detection.max[axis] - detection.min[axis];
    (side(0) * width).max(side(1) * height) / width.max(height)
}

fn in_tiles(
    detector: &Detector,
    pyramid: &Pyramid<'_>,
    level: usize,
    rotation_rad: f32,
    known: &[Detection],
    mut report: impl FnMut(f32),
) -> Result<Vec<Detection>, LandmarksError> {
    let copy = &pyramid.copies[level];
    let tiles = tiles(PictureSize::of(copy), level);
    let mut found = Vec::new();
    for (index, tile) in tiles.iter().enumerate() {
        if !is_inside_known_face(tile, known, copy) && !is_flat(tile, copy) {
            found.extend(detector.detect(copy, &RegionPx { rotation_rad, ..*tile })?);
        }
        report((index + 1) as f32 / tiles.len() as f32);
    }
    Ok(found)
}

/// Overlapping square tiles that cover the picture.
fn tiles(picture: PictureSize, level: usize) -> Vec<RegionPx> {
    let side = picture.width.max(picture.height) * Pyramid::tile_share(level);
    let (columns, rows) = (centres(picture.width, side), centres(picture.height, side));
    let tile = |x: f32, y: f32| RegionPx { centre: [x, y], size: [side, side], rotation_rad: 0.0 };
    rows.iter().flat_map(|&y| columns.iter().map(move |&x| tile(x, y))).collect()
}

/// Centres of overlapping intervals that cover `0..extent`; a single, central one if it suffices.
fn centres(extent: f32, side: f32) -> Vec<f32> {
    let steps = ((extent - side) / (side * STRIDE)).ceil().max(0.0);
    let centre = |i: usize| if steps == 0.0 { extent / 2.0 } else { side / 2.0 + (extent - side) * i as f32 / steps };
    (0..=steps as usize).map(centre).collect()
}

/// Whether a known face covers the tile.
fn is_inside_known_face(tile: &RegionPx, known: &[Detection], picture: &Photo) -> bool {
    let PictureSize { width, height } = PictureSize::of(picture);
    let inside = |detection: &Detection, axis: usize, extent: f32| {
        let half = tile.size[axis] / 2.0;
        detection.min[axis] * extent <= tile.centre[axis] - half
            && detection.max[axis] * extent >= tile.centre[axis] + half
    };
    known.iter().any(|detection| inside(detection, 0, width) && inside(detection, 1, height))
}

fn is_flat(tile: &RegionPx, picture: &Photo) -> bool {
    const EVERY: usize = 3;
    let range = |axis: usize, extent: u32| {
        let half = tile.size[axis] / 2.0;
        let at = |value: f32| (value.max(0.0) as u32).min(extent);
        at(tile.centre[axis] - half)..at((tile.centre[axis] + half).ceil())
    };
    let mut extremes = [u8::MAX, 0];
    for y in range(1, picture.height()).step_by(EVERY) {
        for x in range(0, picture.width()).step_by(EVERY) {
            let [_, green, _] = picture.pixel(x, y);
            extremes = [extremes[0].min(green), extremes[1].max(green)];
        }
    }
    extremes[1].saturating_sub(extremes[0]) < FLAT_RANGE
}
