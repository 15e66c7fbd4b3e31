use image::metadata::Orientation;

use crate::photo::Photo;

/// Turns a picture upright.
pub(crate) fn apply(photo: Photo, orientation: Orientation) -> Photo {
    if orientation == Orientation::NoTransforms {
        return photo;
    }
    let [width, height] = [photo.width(), photo.height()];
    let [upright_width, upright_height] = if swaps_sides(orientation) { [height, width] } else { [width, height] };
    let pixels = turned(photo.pixels().as_chunks::<3>().0, [width, height], orientation).into_flattened();
    let alpha = photo.alpha().map(|alpha| turned(alpha, [width, height], orientation));
    Photo::from_valid(upright_width, upright_height, pixels).with_valid_alpha(alpha)
}

/// The values of stored pixels in the order of the upright ones.
fn turned<T: Copy>(stored: &[T], [width, height]: [u32; 2], orientation: Orientation) -> Vec<T> {
    let [upright_width, upright_height] = if swaps_sides(orientation) { [height, width] } else { [width, height] };
    let places = (0..upright_height).flat_map(|y| (0..upright_width).map(move |x| (x, y)));
    let mut values = Vec::with_capacity(stored.len());
    values.extend(places.map(|(x, y)| {
        let (x, y) = stored_from_upright(orientation, x, y, width, height);
        stored[y as usize * width as usize + x as usize]
    }));
    values
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
