//! Unsupported variants of the formats, and precedence among a file's segments.

use crate::support::{Format, blocks, exif, file, read, with_chunk};
use image::metadata::Orientation;
use rosto_photo::PhotoError;

/// An upright JPEG without its EXIF segment.
fn jpeg() -> Vec<u8> {
    let file = file(&blocks(), Format::Jpeg, Orientation::NoTransforms);
    let start = file.windows(2).position(|two| two == [0xFF, 0xE1]).unwrap();
    let length = usize::from(u16::from_be_bytes([file[start + 2], file[start + 3]]));
    [&file[..start], &file[start + 2 + length..]].concat()
}

fn segment(marker: u8, content: &[u8]) -> Vec<u8> {
    [&[0xFF, marker], &(content.len() as u16 + 2).to_be_bytes()[..], content].concat()
}

/// Inserts segments before the first segment with the marker `before`.
fn with_segments(file: &[u8], before: u8, segments: &[Vec<u8>]) -> Vec<u8> {
    let at = file.windows(2).position(|two| two == [0xFF, before]).unwrap();
    [&file[..at], &segments.concat(), &file[at..]].concat()
}

/// Replaces the byte at offset `at` from the marker of the frame header.
fn with_header_byte(file: &[u8], at: usize, byte: u8) -> Vec<u8> {
    let mut changed = file.to_vec();
    let header = file.windows(2).position(|two| two == [0xFF, 0xC0]).unwrap();
    changed[header + at] = byte;
    changed
}

fn unsupported(file: &[u8]) -> String {
    match read(file) {
        Err(error @ PhotoError::UnsupportedFeature { .. }) => {
            assert!(error.hint().starts_with("Save it as"), "{}", error.hint());
            error.to_string()
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn unsupported_jpeg_processes_are_named() {
    let jpeg = jpeg();
    let frames = [
        (0xC3, "lossless"),
        (0xC5, "hierarchical"),
        (0xC6, "hierarchical"),
        (0xC7, "hierarchical"),
        (0xC9, "arithmetic"),
        (0xCA, "arithmetic"),
        (0xCB, "arithmetic"),
        (0xCD, "arithmetic"),
        (0xCF, "arithmetic"),
        (0xF7, "JPEG-LS"),
    ];
    for (marker, name) in frames {
        let message = unsupported(&with_header_byte(&jpeg, 1, marker));
        assert!(
            message.starts_with("this kind of JPEG is not supported") && message.contains(name),
            "{marker:X}: {message}"
        );
    }
    assert!(unsupported(&with_segments(&jpeg, 0xC0, &[segment(0xDE, &[8, 0, 32, 0, 48, 0])])).contains("hierarchical"));
    assert!(unsupported(&with_header_byte(&jpeg, 4, 12)).contains("12 bits"));
    // The low byte of the height.
    let unknown = with_header_byte(&jpeg, 6, 0);
    assert!(unsupported(&unknown).contains("height"));
    let two = [0xFF, 0xC0, 0, 14, 8, 0, 32, 0, 48, 2, 1, 0x11, 0, 2, 0x11, 0];
    let header = jpeg.windows(2).position(|two| two == [0xFF, 0xC0]).unwrap();
    assert!(unsupported(&[&jpeg[..header], &two, &jpeg[header + 19..]].concat()).contains("2 components"));
    let mut without_tables = jpeg.clone();
    while let Some(table) = without_tables.windows(2).position(|two| two == [0xFF, 0xC4]) {
        let length = usize::from(u16::from_be_bytes([without_tables[table + 2], without_tables[table + 3]]));
        without_tables.drain(table..table + 2 + length);
    }
    assert!(unsupported(&without_tables).contains("tables"));
}

#[test]
fn an_inconsistent_frame_header_is_damaged() {
    let jpeg = jpeg();
    for (at, byte) in [(9, 0), (11, 0x51), (11, 0x01), (12, 9)] {
        let mut broken = with_header_byte(&jpeg, at, byte);
        if at == 9 {
            broken = with_header_byte(&with_header_byte(&jpeg, 7, 0), 8, 0);
        }
        let found = read(&broken);
        assert!(matches!(found, Err(PhotoError::Damaged { .. })), "byte {at}: {found:?}");
    }
}

#[test]
fn a_height_repeated_after_the_scan_is_ignored() {
    let jpeg = jpeg();
    let end = jpeg.len() - 2;
    let repeated = [&jpeg[..end], &segment(0xDC, &[0, 32]), &jpeg[end..]].concat();
    assert_eq!(read(&repeated), read(&jpeg));
}

#[test]
fn unsupported_png_variants_are_named() {
    let png = file(&blocks(), Format::Png, Orientation::NoTransforms);
    assert!(unsupported(&with_chunk(&png, b"CgBI", &[0x30, 0, 0x20, 0x06])).contains("CgBI"));
    assert!(unsupported(&with_chunk(&png, b"JDAT", &[])).starts_with("this kind of PNG is not supported"));
    for method in [10, 11, 12] {
        let mut content = png[16..29].to_vec();
        content[method] = 2;
        let header = with_chunk(&[&png[..8], &[0; 4], b"IDAT"].concat(), b"IHDR", &content);
        let changed = [&header[..33], &png[33..]].concat();
        assert!(unsupported(&changed).contains("method"), "{method}");
        // The old checksum makes the header damaged.
        let mut damaged = png.clone();
        damaged[16 + method] = 2;
        assert!(matches!(read(&damaged), Err(PhotoError::Damaged { .. })));
    }
    assert!(read(&with_chunk(&png, b"neWt", b"anything")).is_ok(), "ancillary chunks are ignored");
}

#[test]
fn jfif_takes_precedence_over_adobes_segment() {
    let jpeg = jpeg();
    let expected = read(&jpeg).unwrap();
    let jfif = segment(0xE0, b"JFIF\0\x01\x02\0\0\x01\0\x01\0\0");
    assert!(jpeg.windows(5).any(|five| five == b"JFIF\0"));
    let adobe = segment(0xEE, b"Adobe\0\x64\0\0\0\0\0");
    assert_eq!(read(&with_segments(&jpeg, 0xDB, std::slice::from_ref(&adobe))).unwrap(), expected);
    let start = jpeg.windows(2).position(|two| two == [0xFF, 0xE0]).unwrap();
    let bare = [&jpeg[..start], &jpeg[start + 18..]].concat();
    assert_eq!(read(&bare).unwrap(), expected, "YCbCr is the default");
    assert_ne!(read(&with_segments(&bare, 0xDB, std::slice::from_ref(&adobe))).unwrap(), expected);
    assert_eq!(read(&with_segments(&bare, 0xDB, &[adobe, jfif])).unwrap(), expected, "in either order");
}

#[test]
fn the_first_of_two_exif_segments_is_used() {
    let jpeg = jpeg();
    let block = |orientation| segment(0xE1, &[b"Exif\0\0".as_slice(), &exif(orientation)].concat());
    let with_exif =
        |orientations: [Orientation; 2]| read(&with_segments(&jpeg, 0xDB, &orientations.map(block))).unwrap();
    let upright = read(&jpeg).unwrap();
    assert_eq!(with_exif([Orientation::NoTransforms, Orientation::Rotate90]), upright);
    let rotated = with_exif([Orientation::Rotate90, Orientation::NoTransforms]);
    assert_eq!([rotated.width(), rotated.height()], [upright.height(), upright.width()]);
    // Other metadata in an APP1 segment is skipped.
    let other = segment(0xE1, b"http://ns.adobe.com/xap/1.0/\0<x/>");
    let both = with_segments(&jpeg, 0xDB, &[other, block(Orientation::Rotate90)]);
    assert_eq!(read(&both).unwrap(), rotated);
}
