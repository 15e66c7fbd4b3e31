//! Pictures derived from the portrait by fixed rules, so that they need not be stored.
//!
//! After a change to a rule, recompute the golden landmarks with `tests/reference/mediapipe_landmarks.py`.

use rosto_photo::Photo;

/// A named picture, with the maximum number of faces to ask MediaPipe for.
pub struct Picture {
    pub name: &'static str,
    pub max_faces: usize,
    pub photo: Photo,
}

/// The pictures of the golden file, in its order.
pub fn all(portrait: &Photo) -> Vec<Picture> {
    let close = cropped(portrait, 85, 0, 280, 280);
    let two_faces = side_by_side(&close, &flipped(&close));
    let one = |name, photo| Picture { name, max_faces: 1, photo };
    vec![
        one("portrait", portrait.clone()),
        one("turned_15", turned(portrait, 15.0)),
        one("turned_-20", turned(portrait, -20.0)),
        one("turned_30", turned(portrait, 30.0)),
        one("turned_-45", turned(portrait, -45.0)),
        one("turned_60", turned(portrait, 60.0)),
        one("turned_90", turned(portrait, 90.0)),
        one("turned_-100", turned(portrait, -100.0)),
        one("turned_135", turned(portrait, 135.0)),
        one("turned_180", turned(portrait, 180.0)),
        one("flipped", flipped(portrait)),
        one("scaled_256", scaled(portrait, 256, 256)),
        one("scaled_130", scaled(portrait, 130, 130)),
        one("scaled_48", scaled(portrait, 48, 48)),
        one("scaled_1000", scaled(portrait, 1000, 1000)),
        one("squeezed_450x702", scaled(portrait, 450, 702)),
        one("squeezed_601x357", scaled(&close, 601, 357)),
        one("scaled_2001x1999", scaled(&close, 2001, 1999)),
        one("padded_1600x900", padded(&scaled(&close, 850, 850), 1600, 900, 375, 25)),
        one("padded_1600x900_small", padded(portrait, 1600, 900, 700, 200)),
        one("padded_900x1600", padded(&scaled(&close, 870, 870), 900, 1600, 15, 400)),
        one("padded_702x514", padded(portrait, 702, 514, 3, 1)),
        one("cropped_face", cropped(portrait, 160, 40, 130, 150)),
        one("cropped_half_face", cropped(portrait, 225, 0, 200, 300)),
        one("no_face", cropped(portrait, 280, 240, 200, 200)),
        one("black", toned(portrait, |_| 0.0)),
        one("blurred_1", blurred(portrait, 1)),
        one("blurred_4", blurred(portrait, 4)),
        one("dark", toned(portrait, |value| value.powf(2.2))),
        one("bright", toned(portrait, |value| value.powf(0.5))),
        one("low_contrast", toned(portrait, |value| 0.4 + 0.2 * value)),
        one("grey", grey(portrait)),
        Picture { name: "two_faces", max_faces: 2, photo: two_faces },
    ]
}

fn picture_from(width: u32, height: u32, colour: impl Fn(u32, u32) -> [u8; 3]) -> Photo {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).flat_map(|(x, y)| colour(x, y)).collect();
    Photo::from_rgb(width, height, pixels).expect("there are three bytes per pixel")
}

/// Rotates clockwise about the centre, with black outside.
pub fn turned(photo: &Photo, degrees: f64) -> Photo {
    // Rounded, so that all mathematics libraries give the same pixels.
    let rounded = |value: f64| (value * 65_536.0).round() / 65_536.0;
    let (cos, sin) = (rounded(degrees.to_radians().cos()), rounded(degrees.to_radians().sin()));
    let centre = [photo.width(), photo.height()].map(|side| (f64::from(side) - 1.0) / 2.0);
    picture_from(photo.width(), photo.height(), |x, y| {
        let (dx, dy) = (f64::from(x) - centre[0], f64::from(y) - centre[1]);
        bilinear(photo, centre[0] + cos * dx + sin * dy, centre[1] - sin * dx + cos * dy)
    })
}

/// Resamples to another size; downscaling averages a grid of samples.
pub fn scaled(photo: &Photo, width: u32, height: u32) -> Photo {
    const SAMPLES: u32 = 2;
    let source = |at: u32, sample: u32, extent: u32, full: u32| {
        let part = (f64::from(sample) + 0.5) / f64::from(SAMPLES);
        let position = (f64::from(at) + part) * f64::from(full) / f64::from(extent) - 0.5;
        position.clamp(0.0, f64::from(full) - 1.0)
    };
    picture_from(width, height, |x, y| {
        let mut sums = [0_u32; 3];
        for sample in 0..SAMPLES * SAMPLES {
            let colour = bilinear(
                photo,
                source(x, sample % SAMPLES, width, photo.width()),
                source(y, sample / SAMPLES, height, photo.height()),
            );
            (0..3).for_each(|channel| sums[channel] += u32::from(colour[channel]));
        }
        sums.map(|sum| ((sum + SAMPLES * SAMPLES / 2) / (SAMPLES * SAMPLES)) as u8)
    })
}

fn bilinear(photo: &Photo, x: f64, y: f64) -> [u8; 3] {
    let (left, top) = (x.floor(), y.floor());
    let (fx, fy) = (x - left, y - top);
    let tap = |dx: i64, dy: i64| pixel_or_black(photo, left as i64 + dx, top as i64 + dy).map(f64::from);
    let (a, b, c, d) = (tap(0, 0), tap(1, 0), tap(0, 1), tap(1, 1));
    std::array::from_fn(|i| {
        let (upper, lower) = (a[i] + (b[i] - a[i]) * fx, c[i] + (d[i] - c[i]) * fx);
        (upper + (lower - upper) * fy).round() as u8
    })
}

fn pixel_or_black(photo: &Photo, x: i64, y: i64) -> [u8; 3] {
    let inside = (0..i64::from(photo.width())).contains(&x) && (0..i64::from(photo.height())).contains(&y);
    if inside { photo.pixel(x as u32, y as u32) } else { [0; 3] }
}

/// Mirrors left and right.
pub fn flipped(photo: &Photo) -> Photo {
    picture_from(photo.width(), photo.height(), |x, y| photo.pixel(photo.width() - 1 - x, y))
}

/// Places the picture on a larger grey canvas, with its top left corner at (`left`, `top`).
pub fn padded(photo: &Photo, width: u32, height: u32, left: u32, top: u32) -> Photo {
    picture_from(width, height, |x, y| match (x.checked_sub(left), y.checked_sub(top)) {
        (Some(x), Some(y)) if x < photo.width() && y < photo.height() => photo.pixel(x, y),
        _ => [110, 120, 130],
    })
}

/// Crops a part of the picture.
pub fn cropped(photo: &Photo, left: u32, top: u32, width: u32, height: u32) -> Photo {
    picture_from(width, height, |x, y| photo.pixel(left + x, top + y))
}

/// Three box blurs, which approximate a Gaussian.
pub fn blurred(photo: &Photo, radius: u32) -> Photo {
    (0..3).fold(photo.clone(), |photo, _| box_blurred(&photo, i64::from(radius)))
}

fn box_blurred(photo: &Photo, radius: i64) -> Photo {
    let nearest = |at: i64, extent: u32| at.clamp(0, i64::from(extent) - 1) as u32;
    let count = ((2 * radius + 1) * (2 * radius + 1)) as u32;
    picture_from(photo.width(), photo.height(), |x, y| {
        let mut sums = [0_u32; 3];
        for dy in -radius..=radius {
            for dx in -radius..=radius {
                let near_x = nearest(i64::from(x) + dx, photo.width());
                let near_y = nearest(i64::from(y) + dy, photo.height());
                let colour = photo.pixel(near_x, near_y);
                (0..3).for_each(|channel| sums[channel] += u32::from(colour[channel]));
            }
        }
        sums.map(|sum| ((sum + count / 2) / count) as u8)
    })
}

/// Maps each channel by a curve from 0..1 to 0..1.
pub fn toned(photo: &Photo, curve: impl Fn(f64) -> f64) -> Photo {
    let table: Vec<u8> = (0..=255).map(|value| (curve(f64::from(value) / 255.0) * 255.0).round() as u8).collect();
    picture_from(photo.width(), photo.height(), |x, y| photo.pixel(x, y).map(|value| table[usize::from(value)]))
}

/// Converts to greyscale.
pub fn grey(photo: &Photo) -> Photo {
    picture_from(photo.width(), photo.height(), |x, y| {
        let [r, g, b] = photo.pixel(x, y).map(u32::from);
        [((299 * r + 587 * g + 114 * b + 500) / 1000) as u8; 3]
    })
}

/// Two pictures of equal height, side by side.
pub fn side_by_side(left: &Photo, right: &Photo) -> Photo {
    picture_from(left.width() + right.width(), left.height(), |x, y| match x.checked_sub(left.width()) {
        None => left.pixel(x, y),
        Some(x) => right.pixel(x, y),
    })
}
