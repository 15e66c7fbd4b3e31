//! `rosto photo`: orientation, unchanged pixels outside the edit, and no metadata.

use crate::common;
use std::fs;
use std::path::{Path, PathBuf};

use crate::common::*;
use image::codecs::jpeg::JpegEncoder;
use rosto_photo::{Limits, Photo, decode};
use serde_json::Value;

const NOSE: [&str; 2] = ["--slider", "nose-width:5"];

fn read(path: &Path) -> Photo {
    decode(&fs::read(path).unwrap(), &Limits::default()).unwrap()
}

/// Runs `rosto photo` and reads its result, a PNG of this name.
fn edited(photo: &Path, name: &str, more: &[&str]) -> Photo {
    let path = scratch(&format!("{name}.png"));
    let run = common::photo(photo, &path, more);
    assert_eq!(code(&run), 0, "{}", said(&run));
    read(&path)
}

/// The portrait as a rotated JPEG whose EXIF has the orientation and an artist.
fn rotated() -> PathBuf {
    let turned = image::open(portrait()).unwrap().to_rgb8();
    let mut jpeg = Vec::new();
    JpegEncoder::new_with_quality(&mut jpeg, 92).encode_image(&image::imageops::rotate270(&turned)).unwrap();
    // TIFF, little-endian: one directory with the orientation (6: rotate clockwise by 90°) and the artist.
    let mut exif = b"Exif\0\0II*\0\x08\0\0\0\x02\0".to_vec();
    exif.extend(b"\x12\x01\x03\0\x01\0\0\0\x06\0\0\0");
    exif.extend(b"\x3b\x01\x02\0\x0a\0\0\0\x26\0\0\0");
    exif.extend(b"\0\0\0\0Someone-X\0");
    let length = (exif.len() as u16 + 2).to_be_bytes();
    let whole = [&jpeg[..2], &[0xff, 0xe1], &length, &exif, &jpeg[2..]].concat();
    scratch_file("rotated.jpg", &whole)
}

/// Centres of the pixels that differ, in px.
fn changed(before: &Photo, after: &Photo) -> Vec<[f64; 2]> {
    assert_eq!((before.width(), before.height()), (after.width(), after.height()));
    let pixels = (0..before.height()).flat_map(|y| (0..before.width()).map(move |x| (x, y)));
    let differ = pixels.filter(|&(x, y)| before.pixel(x, y) != after.pixel(x, y));
    differ.map(|(x, y)| [f64::from(x) + 0.5, f64::from(y) + 0.5]).collect()
}

/// Landmarks of the portrait in px.
fn landmarks() -> Vec<[f64; 2]> {
    let run = rosto(["landmarks", portrait().to_str().unwrap()]);
    let line: Value = serde_json::from_slice(&run.stdout).unwrap();
    let size = read(&portrait()).width();
    triples(&line["faces"][0]["landmarks"]).into_iter().map(|[x, y, _]| [x, y].map(|at| at * f64::from(size))).collect()
}

fn distance_px(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn without_an_edit_the_pixels_do_not_change() {
    let upright = read(&rotated());
    assert_eq!(edited(&portrait(), "unedited", &[]), read(&portrait()));
    assert_eq!(edited(&rotated(), "unedited-rotated", &["--topology", "canonical", "--density", "1"]), upright);
    assert_eq!(edited(&rotated(), "unedited-slider", &["--slider", "nose-width:0"]), upright);
    // The orientation is correct: this pixel of the face matches the portrait's.
    assert!(upright.pixel(224, 120).iter().zip(read(&portrait()).pixel(224, 120)).all(|(a, b)| a.abs_diff(b) < 30));
}

#[test]
fn metadata_is_not_written() {
    let has_metadata =
        |bytes: &[u8]| [&b"Exif"[..], b"Someone-X"].map(|word| bytes.windows(word.len()).any(|at| at == word));
    assert_eq!(has_metadata(&fs::read(rotated()).unwrap()), [true; 2]);
    for extension in ["jpg", "jpeg", "JPG", "png"] {
        let output = scratch(&format!("no-metadata.{extension}"));
        let run = photo(&rotated(), &output, &NOSE);
        assert_eq!(code(&run), 0, "{}", said(&run));
        assert_eq!(has_metadata(&fs::read(&output).unwrap()), [false; 2], "{extension}");
        assert_eq!((read(&output).width(), read(&output).height()), (512, 512));
    }
}

#[test]
fn jpeg_and_png_have_the_same_content() {
    let (png, jpeg) = (scratch("same.png"), scratch("same.jpg"));
    for output in [&png, &jpeg] {
        assert_eq!(code(&photo(&portrait(), output, &NOSE)), 0);
    }
    let (png, jpeg) = (read(&png), read(&jpeg));
    let squares = png.pixels().iter().zip(jpeg.pixels()).map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2));
    let decibels = 10.0 * (255.0 * 255.0 * png.pixels().len() as f64 / squares.sum::<f64>()).log10();
    assert!(decibels > 40.0, "{decibels} dB");
}

#[test]
fn an_edit_changes_nothing_beyond_the_falloff_band() {
    let before = read(&portrait());
    let landmarks = landmarks();
    let side = |axis: usize| {
        let along = landmarks.iter().map(|landmark| landmark[axis]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let longer = side(0).max(side(1));
    let nose = [landmarks[129], landmarks[358]];
    let mut counts = Vec::new();
    for (name, falloff_band, more) in [("wide", 0.45, &[][..]), ("narrow", 0.1, &["--falloff-band", "0.1"])] {
        let pixels = changed(&before, &edited(&portrait(), name, &[&NOSE, more].concat()));
        for nostril in nose {
            assert!(pixels.iter().any(|pixel| distance_px(*pixel, nostril) < 2.0), "nostril at {nostril:?}");
        }
        let nearest =
            |pixel: &[f64; 2]| landmarks.iter().map(|landmark| distance_px(*landmark, *pixel)).fold(f64::MAX, f64::min);
        let furthest = pixels.iter().map(nearest).fold(0.0, f64::max);
        assert!(furthest < falloff_band * longer, "{furthest} px beyond the face, which is {longer} px long");
        counts.push(pixels.len());
    }
    assert!(counts[1] < counts[0], "{counts:?}");
}

#[test]
fn protected_circles_do_not_change() {
    let before = read(&portrait());
    let jaw = ["--slider", "jaw-width:-6"];
    let free = changed(&before, &edited(&portrait(), "free", &jaw));
    let keep = ["--keep", "190,170,20", "--keep", "262,168,9"];
    let protected = changed(&before, &edited(&portrait(), "protected", &[&jaw[..], &keep].concat()));
    for (centre, radius) in [([190.0, 170.0], 20.0), ([262.0, 168.0], 9.0)] {
        let within = |pixels: &[[f64; 2]]| pixels.iter().filter(|pixel| distance_px(**pixel, centre) <= radius).count();
        assert!(within(&free) > 100, "it moves without protection");
        assert_eq!(within(&protected), 0, "at {centre:?}");
    }
    assert!(!protected.is_empty());
}

#[test]
fn edits_at_each_density_move_the_photo() {
    let before = read(&portrait());
    let tip = landmarks()[1];
    let edit = ["--constraint", "exact", "--anchors", "oval", "--edit", "1:6,0,0"];
    for (name, more) in [
        ("coarse", [&edit[..], &["--density", "0"]].concat()),
        ("denser", [&edit[..], &["--density", "3", "--topology", "canonical"]].concat()),
    ] {
        let pixels = changed(&before, &edited(&portrait(), name, &more));
        let mean = |axis: usize| pixels.iter().map(|pixel| pixel[axis]).sum::<f64>() / pixels.len() as f64;
        assert!(pixels.iter().any(|pixel| distance_px(*pixel, tip) < 3.0), "{name}: the nose tip moves");
        assert!(distance_px([mean(0), mean(1)], tip) < 40.0, "{name}: centred at ({}, {})", mean(0), mean(1));
    }
}

#[test]
fn seen_from_changes_the_perspective() {
    let before = read(&portrait());
    let far = changed(&before, &edited(&portrait(), "far", &["--distance", "40", "--seen-from", "200"]));
    let near = changed(&before, &edited(&portrait(), "near", &["--distance", "40", "--seen-from", "35"]));
    assert!(near.len() > 5000 && far.len() > near.len(), "{} and {}", near.len(), far.len());
    assert_eq!(
        changed(&before, &edited(&portrait(), "same", &["--distance", "40", "--seen-from", "40"])),
        [[0.0; 2]; 0]
    );
}

#[test]
fn reduced_edits_are_reported() {
    let run = photo(&portrait(), &scratch("crossed.png"), &["--constraint", "exact", "--edit", "13:0,-40,0"]);
    assert_eq!(code(&run), 0);
    assert!(said(&run).contains("to avoid folds"), "{}", said(&run));
}

#[test]
fn invalid_requests_are_refused() {
    let refused = |output: &str, more: &[&str], words: &[&str]| {
        let target = scratch(output);
        assert_refused(&photo(&portrait(), &target, more), 2, words);
        assert!(!target.exists(), "nothing is written");
    };
    for output in ["face.webp", "face.glb", "face"] {
        refused(output, &NOSE, &["unknown file extension", ".jpg or .png"]);
    }
    for falloff_band in ["0", "0.05", "0.9", "nan", "wide"] {
        refused("a.png", &[&NOSE[..], &["--falloff-band", falloff_band]].concat(), &["--falloff-band", "0.1 to 0.8"]);
    }
    for dab in ["10,20", "10,20,0", "here"] {
        refused("a.png", &[&NOSE[..], &["--keep", dab]].concat(), &["--keep", "X,Y,RADIUS"]);
    }
    refused("a.png", &["--falloff-band", "0.2"], &["--falloff-band", "the photo is not edited"]);
    refused("a.png", &["--keep", "1,2,3"], &["--keep", "the photo is not edited"]);
    refused("a.png", &["--operator", "L"], &["--operator", "it needs --edit"]);
    refused("a.png", &["--seen-from", "3"], &["--seen-from"]);
    let copy = scratch("read.png");
    fs::copy(portrait(), &copy).unwrap();
    assert_refused(&photo(&copy, &copy, &NOSE), 2, &["read.png", "would overwrite"]);
    assert_eq!(fs::read(copy).unwrap(), fs::read(portrait()).unwrap());
    assert_refused(&photo(&faceless(), &scratch("a.png"), &[]), 4, &["no face found"]);
}

/// The portrait with its right quarter transparent.
fn partly_transparent(name: &str) -> PathBuf {
    let mut picture = image::open(portrait()).unwrap().to_rgba8();
    let width = picture.width();
    picture.enumerate_pixels_mut().filter(|(x, ..)| *x >= width * 3 / 4).for_each(|(.., pixel)| pixel[3] = 0);
    let path = scratch(name);
    picture.save(&path).unwrap();
    path
}

#[test]
fn png_keeps_transparency_and_jpeg_reports_its_loss() {
    for name in ["partly.png", "partly.webp"] {
        let input = partly_transparent(name);
        let output = scratch(&format!("{name}-edited.png"));
        let run = photo(&input, &output, &NOSE);
        assert_eq!((code(&run), said(&run).contains("transparent")), (0, false), "{}", said(&run));
        let [before, after] = [&input, &output].map(|path| image::open(path).unwrap().to_rgba8());
        let alpha = |picture: &image::RgbaImage| picture.pixels().map(|pixel| pixel[3]).collect::<Vec<_>>();
        assert_eq!(alpha(&after), alpha(&before), "the edit does not reach the transparent part");
        assert!(before.pixels().zip(after.pixels()).any(|(before, after)| before != after), "the nose changes");
    }
    let output = scratch("partly-edited.jpg");
    let run = photo(&partly_transparent("partly.png"), &output, &NOSE);
    assert_eq!(code(&run), 0);
    assert!(said(&run).contains("transparent parts become white"), "{}", said(&run));
    let white = read(&output);
    assert!(white.pixel(white.width() - 4, 9).iter().all(|&level| level > 250));
}
