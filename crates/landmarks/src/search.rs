//! Which regions of the picture the detector looks at.

use std::f32::consts::{FRAC_PI_2, PI};

use rosto_photo::Photo;

use crate::detector::{Detection, Detector};
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::{LandmarksError, Search, suppression};

/// Everything that looks like a face, best first.
pub(crate) fn detections(detector: &Detector, photo: &Photo, search: Search) -> Result<Vec<Detection>, LandmarksError> {
    let whole = RegionPx::whole(PictureSize::of(photo));
    if search == Search::Once {
        return detector.detect(photo, &whole);
    }
    let mut found = among(detector, photo, &turned(&whole))?;
    for level in 1..=LEVELS {
        if !found.is_empty() {
            break;
        }
        found = among(detector, photo, &tiles(&whole, PictureSize::of(photo), level))?;
    }
    Ok(found)
}

/// How often tiles are halved.
const LEVELS: u32 = 3;

/// What the detector finds in any of the regions, each face once.
fn among(detector: &Detector, photo: &Photo, regions: &[RegionPx]) -> Result<Vec<Detection>, LandmarksError> {
    let mut found = Vec::new();
    for region in regions {
        found.extend(detector.detect(photo, region)?);
    }
    Ok(suppression::best_only(found))
}

/// The region in four orientations.
fn turned(region: &RegionPx) -> Vec<RegionPx> {
    [0.0, FRAC_PI_2, -PI, -FRAC_PI_2].map(|rotation_rad| RegionPx { rotation_rad, ..*region }).to_vec()
}

/// Squares of side 1/2^level of the whole one, half overlapping, that cover the picture.
fn tiles(whole: &RegionPx, picture: PictureSize, level: u32) -> Vec<RegionPx> {
    let side = whole.size[0] / 2_f32.powi(level as i32);
    let (columns, rows) = (centres(picture.width, side), centres(picture.height, side));
    let tile = |x: f32, y: f32| RegionPx { centre: [x, y], size: [side, side], rotation_rad: 0.0 };
    rows.iter().flat_map(|&y| columns.iter().map(move |&x| tile(x, y))).collect()
}

/// Centres of half overlapping intervals that cover `0..extent`; one in the middle if that is enough.
fn centres(extent: f32, side: f32) -> Vec<f32> {
    let steps = ((extent - side) / (side / 2.0)).ceil().max(0.0);
    let centre = |i: usize| if steps == 0.0 { extent / 2.0 } else { side / 2.0 + (extent - side) * i as f32 / steps };
    (0..=steps as usize).map(centre).collect()
}
