//! Which regions of the picture the detector looks at.

use std::f32::consts::{FRAC_PI_2, PI};

use rosto_photo::Photo;

use crate::detection::Detection;
use crate::detector::Detector;
use crate::pyramid::Pyramid;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::{LandmarksError, suppression};

/// Tiles of a level lie this share of their side apart; what is larger than the rest shows at the level before.
const STRIDE: f32 = 0.7;
/// What the detector is as sure of as this is a face, when it is about where to look next.
pub(crate) const SURE: f32 = 0.75;
/// The smallest face that the detector sees, as a share of the side of what it looks at.
const SMALLEST_SHARE: f32 = 0.12;
/// Faces smaller than the next larger one by more than this are not looked for.
const LARGEST_GAP: f32 = 5.0;
/// No more than this are looked at more closely: a picture of which the detector is unsure everywhere shows no faces.
const MOST: usize = 100;
/// Something whose values all lie within so many of 255 shows no face.
const FLAT: u8 = 10;

/// Everything in the picture that may be a face, the most certain first, each once.
///
/// The whole picture first, as MediaPipe looks at it and turned by a quarter, a half and three quarters; then smaller and
/// smaller tiles, upright, since the detector sees heads up to about 100° from upright; on their head too where nothing was
/// found upright. It ends where `enough` faces were found that are larger than what smaller tiles could show, and where
/// they could only show faces less than a fifth as large as the smallest so far. `report` is told the share that is done.
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
        let sure: Vec<Detection> = found.iter().filter(|detection| detection.score >= SURE).copied().collect();
        if sure.len() >= enough || !is_worthwhile(&sure, &pyramid.copies[0], level) {
            break;
        }
        let upright = in_tiles(detector, pyramid, level, 0.0, &sure, |share| report(done(share / 2.0)))?;
        let nothing = sure.is_empty() && !upright.iter().any(|detection| detection.score >= SURE);
        found.extend(upright);
        if nothing {
            found.extend(in_tiles(detector, pyramid, level, -PI, &sure, |share| report(done(0.5 + share / 2.0)))?);
        }
        found = suppression::best_only(found);
    }
    found.truncate(MOST);
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

/// Whether a level may show faces that are not much smaller than those that were found.
fn is_worthwhile(sure: &[Detection], picture: &Photo, level: usize) -> bool {
    let largest_new = SMALLEST_SHARE * Pyramid::tile_share(level - 1);
    sure.iter()
        .map(|detection| share(detection, picture))
        .reduce(f32::min)
        .is_none_or(|smallest| smallest < LARGEST_GAP * largest_new)
}

/// The longer side of a detection as a share of the longer side of the picture.
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
        if !is_within_one(tile, known, copy) && !is_flat(tile, copy) {
            found.extend(detector.detect(copy, &RegionPx { rotation_rad, ..*tile })?);
        }
        report((index + 1) as f32 / tiles.len() as f32);
    }
    Ok(found)
}

/// Overlapping squares that cover the picture.
fn tiles(picture: PictureSize, level: usize) -> Vec<RegionPx> {
    let side = picture.width.max(picture.height) * Pyramid::tile_share(level);
    let (columns, rows) = (centres(picture.width, side), centres(picture.height, side));
    let tile = |x: f32, y: f32| RegionPx { centre: [x, y], size: [side, side], rotation_rad: 0.0 };
    rows.iter().flat_map(|&y| columns.iter().map(move |&x| tile(x, y))).collect()
}

/// Centres of overlapping intervals that cover `0..extent`; one in the middle if that is enough.
fn centres(extent: f32, side: f32) -> Vec<f32> {
    let steps = ((extent - side) / (side * STRIDE)).ceil().max(0.0);
    let centre = |i: usize| if steps == 0.0 { extent / 2.0 } else { side / 2.0 + (extent - side) * i as f32 / steps };
    (0..=steps as usize).map(centre).collect()
}

/// Whether a tile shows nothing but a part of a face that is known.
fn is_within_one(tile: &RegionPx, known: &[Detection], picture: &Photo) -> bool {
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
    extremes[1].saturating_sub(extremes[0]) < FLAT
}
