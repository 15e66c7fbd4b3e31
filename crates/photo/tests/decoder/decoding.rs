//! Decoding of valid files.

use crate::support::{FORMATS, Format, blocks, blocks_with_restarts, exif, file, stored_for, with_chunk};
use image::metadata::Orientation;
use image::{DynamicImage, ImageFormat};
use rosto_photo::{Limits, Photo, decode};

fn read(bytes: &[u8]) -> Photo {
    decode(bytes, &Limits::default()).unwrap()
}

fn largest_difference(photo: &Photo, expected: &[u8]) -> u8 {
    assert_eq!(photo.pixels().len(), expected.len());
    photo.pixels().iter().zip(expected).map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}

fn png(picture: impl Into<DynamicImage>) -> Vec<u8> {
    file_of(picture, ImageFormat::Png)
}

fn file_of(picture: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.into().write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

#[test]
fn each_of_the_eight_orientations_is_applied_once_in_each_format() {
    let upright = blocks();
    for format in FORMATS {
        let tolerance = if format == Format::Jpeg { 4 } else { 0 };
        for exif in 1..=8 {
            let orientation = Orientation::from_exif(exif).unwrap();
            let photo = read(&file(&stored_for(&upright, orientation), format, orientation));
            assert_eq!((photo.width(), photo.height()), upright.dimensions(), "{format:?} {exif}");
            assert!(largest_difference(&photo, &upright) <= tolerance, "{format:?} {exif}");
        }
    }
}

#[test]
fn an_exif_header_left_in_a_webp_is_skipped() {
    let orientation = Orientation::Rotate90;
    let bytes = file(&stored_for(&blocks(), orientation), Format::WebP, orientation);
    let chunk = bytes.windows(4).position(|window| window == b"EXIF").unwrap();
    let mut with_header = bytes[..chunk + 4].to_vec();
    let length = u32::from_le_bytes(bytes[chunk + 4..chunk + 8].try_into().unwrap()) + 6;
    with_header.extend(length.to_le_bytes());
    with_header.extend(b"Exif\0\0");
    with_header.extend(&bytes[chunk + 8..]);
    let riff_length = with_header.len() as u32 - 8;
    with_header[4..8].copy_from_slice(&riff_length.to_le_bytes());
    assert_eq!(read(&with_header).pixels(), blocks().as_raw().as_slice());
}

#[test]
fn transparency_is_blended_over_white() {
    let pixels = vec![100, 50, 0, 255, 100, 50, 0, 0, 100, 50, 0, 51];
    let eight_bit = DynamicImage::from(image::RgbaImage::from_raw(3, 1, pixels).unwrap());
    let files = [
        file_of(eight_bit.clone(), ImageFormat::Png),
        file_of(eight_bit.clone(), ImageFormat::WebP),
        file_of(eight_bit.into_rgba16(), ImageFormat::Png),
    ];
    for file in files {
        assert_eq!(read(&file).pixels(), [[100, 50, 0], [255, 255, 255], [224, 214, 204]].concat());
    }
}

#[test]
fn opacity_is_stored_separately_and_rotated_with_the_pixels() {
    let pixels = vec![100, 50, 0, 255, 9, 9, 9, 0, 100, 50, 0, 51];
    let picture = DynamicImage::from(image::RgbaImage::from_raw(3, 1, pixels).unwrap());
    let expected = vec![100, 50, 0, 255, 255, 255, 255, 0, 100, 50, 0, 51];
    for (file, name) in [(ImageFormat::Png, "eXIf"), (ImageFormat::WebP, "EXIF")] {
        let photo = read(&file_of(picture.clone(), file));
        assert_eq!(photo.alpha(), Some([255, 0, 51].as_slice()), "{name}");
        assert_eq!(photo.rgba(), expected);
        assert_eq!(photo.scaled_down(1024).alpha(), None, "the scaled copy is opaque");
    }
    let turned = with_chunk(&file_of(picture, ImageFormat::Png), b"eXIf", &exif(Orientation::Rotate180));
    assert_eq!(read(&turned).alpha(), Some([51, 0, 255].as_slice()));
    let opaque = read(&png(image::RgbaImage::from_raw(1, 1, vec![1, 2, 3, 255]).unwrap()));
    assert_eq!((opaque.alpha(), opaque.rgba()), (None, vec![1, 2, 3, 255]));
    let grey = read(&png(image::GrayAlphaImage::from_raw(2, 1, vec![7, 255, 200, 128]).unwrap()));
    // At an opacity of 50 %, a value keeps about seven of its eight bits.
    assert!(grey.rgba().iter().zip([7, 7, 7, 255, 200, 200, 200, 128]).all(|(a, b)| a.abs_diff(b) <= 1));
    let tall = Photo::from_rgb(1, 3, (0..9).collect()).unwrap().with_alpha(vec![255, 9, 90]).unwrap();
    assert_eq!([tall.rgba_rows(0..1), tall.rgba_rows(1..3)].concat(), tall.rgba());
    assert!(Photo::from_rgb(2, 1, vec![0; 6]).unwrap().with_alpha(vec![0; 3]).is_err());
}

#[test]
fn sixteen_bits_are_rounded_to_eight() {
    let samples = vec![0, 257, 65_535, 128, 129, 32_896];
    let photo = read(&png(DynamicImage::ImageRgb16(image::ImageBuffer::from_raw(2, 1, samples).unwrap())));
    assert_eq!(photo.pixels(), [0, 1, 255, 0, 1, 128]);
}

#[test]
fn grey_is_repeated() {
    let photo = read(&png(image::GrayImage::from_raw(2, 1, vec![7, 200]).unwrap()));
    assert_eq!(photo.pixels(), [7, 7, 7, 200, 200, 200]);
}

#[test]
fn sixteen_bit_grey_with_alpha_is_decoded() {
    let samples = vec![0, 65_535, 0, 0];
    let photo = read(&png(DynamicImage::ImageLumaA16(image::ImageBuffer::from_raw(2, 1, samples).unwrap())));
    assert_eq!(photo.pixels(), [0, 0, 0, 255, 255, 255]);
}

#[test]
fn cmyk_and_ycck_are_converted_to_rgb() {
    let [inks, luminance_and_black] =
        [include_bytes!("../fixtures/cmyk.jpg").as_slice(), include_bytes!("../fixtures/ycck.jpg")];
    // Adobe's segment has 14 bytes after its marker. Without it, inks are read as inverted.
    let adobe = inks.windows(2).position(|two| two == [0xFF, 0xEE]).unwrap();
    let unnamed = [&inks[..adobe], &inks[adobe + 16..]].concat();
    for file in [inks, luminance_and_black, &unnamed] {
        let photo = read(file);
        assert_eq!((photo.width(), photo.height()), (16, 8));
        let [red, blue] = [photo.pixel(1, 4), photo.pixel(14, 4)];
        assert!(red[0] > 200 && red[1] < 60 && red[2] < 60, "{red:?}");
        assert!(blue[0] < 60 && blue[1] < 60 && blue[2] > 200, "{blue:?}");
    }
}

#[test]
fn a_progressive_jpeg_is_decoded() {
    let photo = read(include_bytes!("../fixtures/progressive.jpg"));
    assert!(largest_difference(&photo, &[180, 60, 20].repeat(256)) <= 3);
}

#[test]
fn an_animation_decodes_to_its_first_frame() {
    let photo = read(include_bytes!("../fixtures/animated.webp"));
    assert_eq!((photo.width(), photo.height()), (12, 10));
    assert_eq!(photo.pixels(), [10, 200, 30].repeat(120));
}

#[test]
fn a_file_that_lacks_only_its_end_is_accepted() {
    let picture = blocks();
    let jpeg = file(&picture, Format::Jpeg, Orientation::Rotate90);
    let png = file(&picture, Format::Png, Orientation::Rotate90);
    let progressive = include_bytes!("../fixtures/progressive.jpg");
    let cmyk = include_bytes!("../fixtures/cmyk.jpg");
    // The end marker of a JPEG takes 2 bytes. A PNG ends with a 4-byte checksum of the pixel data (and 4 bytes for
    // Adler-32) before a 12-byte end chunk.
    let cases: [(&[u8], &[usize]); 4] =
        [(&jpeg, &[1, 2]), (progressive, &[1, 2]), (cmyk, &[1, 2]), (&png, &[1, 4, 8, 12, 14, 16])];
    for (whole, endings) in cases {
        let expected = read(whole);
        for &missing in endings {
            let cut = &whole[..whole.len() - missing];
            assert_eq!(read(cut), expected, "{:?} without its last {missing} bytes", &whole[1..4]);
            if whole[0] == 0xFF {
                assert_eq!(read(&[cut, &[0; 100]].concat()), expected, "padded with zeros");
            }
        }
    }
}

#[test]
fn a_jpeg_with_restart_markers_may_lack_its_end_marker_but_not_an_interval() {
    let unmarked = blocks_with_restarts(11);
    let whole = read(&[unmarked.as_slice(), &[0xFF, 0xD9]].concat());
    assert_eq!((whole.width(), whole.height()), (8, 88));
    assert_eq!(read(&unmarked), whole);
    // Cut after a block, within a marker, and after a marker.
    for missing in 1..=9 {
        let cut = &unmarked[..unmarked.len() - missing];
        assert!(decode(cut, &Limits::default()).is_err(), "without its last {missing} bytes");
    }
}

#[test]
fn an_interlaced_png_is_decoded_and_may_lack_its_end() {
    let bytes = include_bytes!("../fixtures/interlaced.png");
    assert_eq!(bytes[28], 1, "the file is interlaced");
    let photo = read(bytes);
    assert_eq!((photo.width(), photo.height()), (13, 11));
    for (x, y) in [(0, 0), (12, 10), (5, 7)] {
        assert_eq!(photo.pixel(x, y), [20 * x as u8, 20 * y as u8, 60]);
    }
    assert_eq!(read(&bytes[..bytes.len() - 12]), photo);
    assert!(decode(&bytes[..bytes.len() - 60], &Limits::default()).is_err());
}
