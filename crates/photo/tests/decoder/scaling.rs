//! Downscaling and colour lookup.

use proptest::prelude::*;
use rosto_photo::Photo;

fn photo(width: u32, height: u32, colour: impl Fn(u32, u32) -> [u8; 3]) -> Photo {
    let colour = &colour;
    let pixels = (0..height).flat_map(|y| (0..width).flat_map(move |x| colour(x, y))).collect();
    Photo::from_rgb(width, height, pixels).unwrap()
}

#[test]
fn halving_averages_blocks_of_four() {
    let original = photo(6, 4, |x, y| [(x * 40) as u8, (y * 80) as u8, (x * y) as u8]);
    let half = original.scaled_down(3);
    assert_eq!((half.width(), half.height()), (3, 2));
    for y in 0..2 {
        for x in 0..3 {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| original.pixel(2 * x + dx, 2 * y + dy));
            let mean = [0, 1, 2].map(|c| (four.iter().map(|p| f32::from(p[c])).sum::<f32>() / 4.0).round() as u8);
            assert_eq!(half.pixel(x, y), mean);
        }
    }
}

#[test]
fn fine_stripes_are_averaged_without_aliasing() {
    let stripes = photo(1000, 1000, |x, _| [if x % 2 == 0 { 0 } else { 255 }; 3]);
    let small = stripes.scaled_down(77);
    assert!(small.pixels().iter().all(|&value| (118..=137).contains(&value)));
}

#[test]
fn a_picture_within_the_limit_is_unchanged() {
    let original = photo(5, 3, |x, y| [x as u8, y as u8, 9]);
    assert_eq!(original.scaled_down(5), original);
}

#[test]
fn a_thin_picture_keeps_at_least_one_pixel_per_axis() {
    let thin = photo(1000, 1, |_, _| [1, 2, 3]).scaled_down(10);
    assert_eq!((thin.width(), thin.height()), (10, 1));
    assert_eq!(thin.pixel(9, 0), [1, 2, 3]);
}

#[test]
fn colour_lookup_rounds_positions_down() {
    let picture = photo(4, 2, |x, y| [x as u8, y as u8, 0]);
    assert_eq!(picture.colour_under(0.0, 0.0), [0, 0, 0]);
    assert_eq!(picture.colour_under(0.74, 0.49), [2, 0, 0]);
    assert_eq!(picture.colour_under(0.75, 0.5), [3, 1, 0]);
}

#[test]
fn the_fourth_byte_of_an_rgbx_pixel_is_ignored() {
    let frame: Vec<u8> = (0..24).collect();
    let photo = Photo::from_rgbx(3, 2, &frame).unwrap();
    assert_eq!((photo.pixel(0, 0), photo.pixel(2, 1)), ([0, 1, 2], [20, 21, 22]));
    assert_eq!(photo.pixels().len(), 18);
}

#[test]
fn positions_outside_are_clamped() {
    let picture = photo(4, 2, |x, y| [x as u8, y as u8, 0]);
    assert_eq!(picture.colour_under(1.0, 1.0), [3, 1, 0]);
    assert_eq!(picture.colour_under(-3.0, 7.5), [0, 1, 0]);
    assert_eq!(picture.colour_under(f64::NAN, f64::INFINITY), [0, 1, 0]);
}

proptest! {
    #[test]
    fn a_uniform_colour_is_preserved(width in 1_u32..90, height in 1_u32..90, side in 1_u32..90, colour: [u8; 3]) {
        let small = photo(width, height, |_, _| colour).scaled_down(side);
        prop_assert!(small.width().max(small.height()) <= side.max(1));
        prop_assert!(small.pixels().chunks(3).all(|pixel| pixel == colour));
    }
}
