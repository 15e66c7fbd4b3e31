//! The picture at several sizes. [`crate::warp`] samples single pixels, which would alias on a large picture.

use rosto_photo::Photo;

use crate::detector;

/// Ratio of the tile sizes of adjacent levels. The detector finds faces from an eighth to all of its region, so each
/// face size is well covered by two levels.
const STEP: f32 = 2.17;
/// Least tile size in px of the picture; a face of an eighth of it is barely recognisable.
const MIN_TILE_PX: f32 = 192.0;

/// The picture and downscaled copies.
pub(crate) struct Pyramid<'a> {
    pub(crate) photo: &'a Photo,
    /// One copy per level, from small to large, scaled so that a tile of the level has the size of the detector's
    /// input. Level 0 has one tile, the whole picture.
    pub(crate) copies: Vec<Photo>,
}

impl<'a> Pyramid<'a> {
    pub(crate) fn new(photo: &'a Photo) -> Self {
        let finest_level = (1..).take_while(|&level| tile_px(photo, level) >= MIN_TILE_PX).last().unwrap_or(0);
        let mut copies: Vec<Photo> = Vec::new();
        for level in (0..=finest_level).rev() {
            let side = (detector::SIDE as f32 * STEP.powi(level)).round() as u32;
            copies.push(copies.last().unwrap_or(photo).scaled_down(side));
        }
        copies.reverse();
        Self { photo, copies }
    }

    /// The longer side of a level's tiles, relative to that of the picture.
    pub(crate) fn tile_share(level: usize) -> f32 {
        STEP.powi(-(level as i32))
    }

    /// The smallest copy in which `share` of the picture's longer side is at least `side` px, or the picture itself.
    pub(crate) fn fitting(&self, share: f32, side: usize) -> &Photo {
        let longer = |photo: &Photo| photo.width().max(photo.height()) as f32;
        self.copies.iter().find(|copy| share * longer(copy) >= side as f32).unwrap_or(self.photo)
    }
}

fn tile_px(photo: &Photo, level: i32) -> f32 {
    photo.width().max(photo.height()) as f32 / STEP.powi(level)
}
