//! The picture at falling sizes, so that a small part of a large picture is seen without the coarse sampling of
//! [`crate::warp`], which takes single pixels however far apart they lie.

use rosto_photo::Photo;

use crate::detector;

/// From one level to the next, tiles get smaller by this factor. The detector sees faces from an eighth of what it looks at
/// up to all of it, so that every face lies well within two levels.
const STEP: f32 = 2.17;
/// Tiles are not smaller than this, in px of the picture: an eighth of it is as little as a face can be told by.
const SMALLEST_TILE_PX: f32 = 192.0;

/// The picture, and smaller copies of it.
pub(crate) struct Pyramid<'a> {
    pub(crate) photo: &'a Photo,
    /// One for each level, from small to large: on it, one of the level's tiles is as large as what the detector takes in. Level
    /// 0 is the whole picture as one tile.
    pub(crate) copies: Vec<Photo>,
}

impl<'a> Pyramid<'a> {
    pub(crate) fn new(photo: &'a Photo) -> Self {
        let finest = (1..).take_while(|&level| tile_px(photo, level) >= SMALLEST_TILE_PX).last().unwrap_or(0);
        let mut copies: Vec<Photo> = Vec::new();
        for level in (0..=finest).rev() {
            let side = (detector::SIDE as f32 * STEP.powi(level)).round() as u32;
            copies.push(copies.last().unwrap_or(photo).scaled_down(side));
        }
        copies.reverse();
        Self { photo, copies }
    }

    /// The longer side of a level's tiles as a share of the longer side of the picture.
    pub(crate) fn tile_share(level: usize) -> f32 {
        STEP.powi(-(level as i32))
    }

    /// The smallest copy, or the picture itself, in which a part of the picture (`share` of its longer side) is at least
    /// `side` px wide.
    pub(crate) fn fitting(&self, share: f32, side: usize) -> &Photo {
        let longer = |photo: &Photo| photo.width().max(photo.height()) as f32;
        self.copies.iter().find(|copy| share * longer(copy) >= side as f32).unwrap_or(self.photo)
    }
}

fn tile_px(photo: &Photo, level: i32) -> f32 {
    photo.width().max(photo.height()) as f32 / STEP.powi(level)
}
