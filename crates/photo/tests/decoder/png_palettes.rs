//! PNG palettes with partial colours.

use crate::support::{read, reason};

/// Encodes one pixel of the first colour, with a palette of `palette_bytes`.
fn indexed_png(palette_bytes: usize, colour: png::ColorType) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(colour);
    encoder.set_palette(vec![7; palette_bytes]);
    encoder.write_header().unwrap().write_image_data(&vec![0; colour.samples()]).unwrap();
    bytes
}

#[test]
fn a_palette_has_whole_colours_and_at_most_256() {
    for palette_bytes in [3, 6, 48, 768] {
        assert_eq!(read(&indexed_png(palette_bytes, png::ColorType::Indexed)).unwrap().pixel(0, 0), [7; 3]);
    }
    for palette_bytes in [4, 5, 20, 767] {
        let message = reason(&indexed_png(palette_bytes, png::ColorType::Indexed));
        assert!(message.starts_with(&format!("{palette_bytes} bytes ")), "{message}");
    }
    for palette_bytes in [1, 2, 769, 771, 1000] {
        assert!(reason(&indexed_png(palette_bytes, png::ColorType::Indexed)).contains("PLTE"));
    }
}

#[test]
fn a_suggested_palette_may_have_any_length() {
    assert_eq!(read(&indexed_png(20, png::ColorType::Rgb)).unwrap().pixel(0, 0), [0; 3]);
}
