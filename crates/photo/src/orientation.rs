use image::metadata::Orientation;

use crate::photo::Photo;

/// Turns a picture upright.
pub(crate) fn apply(photo: Photo, orientation: Orientation) -> Photo {
    if orientation == Orientation::NoTransforms {
        return photo;
    }
    let (width, height) = (photo.width(), photo.height());
    let (upright_width, upright_height) = if swaps_sides(orientation) { (height, width) } else { (width, height) };
    let mut pixels = Vec::with_capacity(photo.pixels().len());
    for y in 0..upright_height {
        for x in 0..upright_width {
            let (stored_x, stored_y) = stored_from_upright(orientation, x, y, width, height);
            pixels.extend_from_slice(&photo.pixel(stored_x, stored_y));
        }
    }
    Photo::from_valid(upright_width, upright_height, pixels)
}

fn swaps_sides(orientation: Orientation) -> bool {
    use Orientation::{Rotate90, Rotate90FlipH, Rotate270, Rotate270FlipH};
    matches!(orientation, Rotate90 | Rotate270 | Rotate90FlipH | Rotate270FlipH)
}

/// Where in the stored picture (`width` × `height` px) the upright picture's pixel (`x`, `y`) lies.
fn stored_from_upright(orientation: Orientation, x: u32, y: u32, width: u32, height: u32) -> (u32, u32) {
    match orientation {
        Orientation::NoTransforms => (x, y),
        Orientation::FlipHorizontal => (width - 1 - x, y),
        Orientation::Rotate180 => (width - 1 - x, height - 1 - y),
        Orientation::FlipVertical => (x, height - 1 - y),
        Orientation::Rotate90FlipH => (y, x),
        Orientation::Rotate90 => (y, height - 1 - x),
        Orientation::Rotate270FlipH => (width - 1 - y, height - 1 - x),
        Orientation::Rotate270 => (width - 1 - y, x),
    }
}
