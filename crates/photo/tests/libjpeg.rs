//! JPEG files of all kinds that are read, to the bit as libjpeg decodes them.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod support;

use support::read;

/// Written by `tests/reference/libjpeg.py`, which says how.
const PACKED: &[u8] = include_bytes!("fixtures/libjpeg.bin");

struct Entry<'a> {
    name: &'a str,
    file: &'a [u8],
    rgb_crc32: u32,
}

impl Entry<'static> {
    /// The first entry, and what comes after it.
    fn split(packed: &'static [u8]) -> Option<(Self, &'static [u8])> {
        let number = |bytes: &[u8; 4]| u32::from_be_bytes(*bytes);
        let (&length, rest) = packed.split_first()?;
        let (name, rest) = rest.split_at_checked(length.into())?;
        let (length, rest) = rest.split_first_chunk()?;
        let (file, rest) = rest.split_at_checked(number(length) as usize)?;
        let (checksum, rest) = rest.split_first_chunk()?;
        Some((Self { name: std::str::from_utf8(name).ok()?, file, rgb_crc32: number(checksum) }, rest))
    }
}

fn entries() -> Vec<Entry<'static>> {
    let mut rest = PACKED;
    let entries = std::iter::from_fn(|| {
        let (entry, after) = Entry::split(rest)?;
        rest = after;
        Some(entry)
    });
    let entries = entries.collect();
    assert!(rest.is_empty(), "the fixture is read to its end");
    entries
}

#[test]
fn every_sampling_factor_and_order_of_scans_gives_the_pixels_of_libjpeg() {
    let entries = entries();
    assert_eq!(entries.len(), 219);
    let differs =
        |entry: &&Entry<'_>| read(entry.file).map(|photo| crc32fast::hash(photo.pixels())) != Ok(entry.rgb_crc32);
    let different: Vec<&str> = entries.iter().filter(differs).map(|entry| entry.name).collect();
    assert!(different.is_empty(), "{} of {}: {different:#?}", different.len(), entries.len());
}

#[test]
fn a_component_that_is_sampled_in_fractions_of_another_is_not_supported() {
    // libjpeg does not read it either: two samples across next to three.
    let mut file = entries().iter().find(|entry| entry.name.contains("3x1,1x1,1x1")).unwrap().file.to_vec();
    let frame = file.windows(2).position(|two| two[0] == 0xFF && (0xC0..=0xC2).contains(&two[1])).unwrap();
    assert_eq!(file[frame + 14], 0x11);
    file[frame + 14] = 0x21;
    assert!(read(&file).unwrap_err().to_string().contains("not supported: a component sampled 2×1 next to 3×1"));
}
