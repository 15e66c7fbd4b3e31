//! A photo with its face edited: upright, its own pixels where nothing moved, and nothing in it of its file.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::*;
use image::codecs::jpeg::JpegEncoder;
use rosto_photo::{Limits, Photo, decode};
use serde_json::Value;

const NOSE: [&str; 2] = ["--slider", "nose-width:5"];

fn read(path: &Path) -> Photo {
    decode(&fs::read(path).unwrap(), &Limits::default()).unwrap()
}

/// What `rosto photo` makes of a photo, as a PNG of that name.
fn edited(photo: &Path, name: &str, more: &[&str]) -> Photo {
    let path = scratch(&format!("{name}.png"));
    let run = common::photo(photo, &path, more);
    assert_eq!(code(&run), 0, "{}", said(&run));
    read(&path)
}

/// The portrait as a camera saves it that was held on its side: lying in the file, with who and where in its EXIF.
fn lying() -> PathBuf {
    let turned = image::open(portrait()).unwrap().to_rgb8();
    let mut jpeg = Vec::new();
    JpegEncoder::new_with_quality(&mut jpeg, 92).encode_image(&image::imageops::rotate270(&turned)).unwrap();
    // TIFF, little-endian: one directory with the orientation (6: turn clockwise by 90°) and the artist.
    let mut exif = b"Exif\0\0II*\0\x08\0\0\0\x02\0".to_vec();
    exif.extend(b"\x12\x01\x03\0\x01\0\0\0\x06\0\0\0");
    exif.extend(b"\x3b\x01\x02\0\x0a\0\0\0\x26\0\0\0");
    exif.extend(b"\0\0\0\0Someone-X\0");
    let length = (exif.len() as u16 + 2).to_be_bytes();
    let whole = [&jpeg[..2], &[0xff, 0xe1], &length, &exif, &jpeg[2..]].concat();
    scratch_file("lying.jpg", &whole)
}

/// The places of two pictures' different pixels, in px.
fn changed(before: &Photo, after: &Photo) -> Vec<[f64; 2]> {
    assert_eq!((before.width(), before.height()), (after.width(), after.height()));
    let places = (0..before.height()).flat_map(|y| (0..before.width()).map(move |x| (x, y)));
    let differ = places.filter(|&(x, y)| before.pixel(x, y) != after.pixel(x, y));
    differ.map(|(x, y)| [f64::from(x) + 0.5, f64::from(y) + 0.5]).collect()
}

/// The portrait's landmarks in px.
fn landmarks() -> Vec<[f64; 2]> {
    let run = rosto(["landmarks", portrait().to_str().unwrap()]);
    let line: Value = serde_json::from_slice(&run.stdout).unwrap();
    let size = read(&portrait()).width();
    triples(&line["faces"][0]["landmarks"]).into_iter().map(|[x, y, _]| [x, y].map(|at| at * f64::from(size))).collect()
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn without_an_edit_the_photo_keeps_its_pixels() {
    let upright = read(&lying());
    assert_eq!(edited(&portrait(), "unedited", &[]), read(&portrait()));
    assert_eq!(edited(&lying(), "unedited-lying", &["--topology", "canonical", "--density", "1"]), upright);
    assert_eq!(edited(&lying(), "unedited-slider", &["--slider", "nose-width:0"]), upright);
    // By its landmarks the face is where the portrait has it.
    assert!(upright.pixel(224, 120).iter().zip(read(&portrait()).pixel(224, 120)).all(|(a, b)| a.abs_diff(b) < 30));
}

#[test]
fn what_the_file_told_of_who_and_where_is_left_behind() {
    let told = |bytes: &[u8]| [&b"Exif"[..], b"Someone-X"].map(|word| bytes.windows(word.len()).any(|at| at == word));
    assert_eq!(told(&fs::read(lying()).unwrap()), [true; 2]);
    for ending in ["jpg", "jpeg", "JPG", "png"] {
        let output = scratch(&format!("silent.{ending}"));
        let run = photo(&lying(), &output, &NOSE);
        assert_eq!(code(&run), 0, "{}", said(&run));
        assert_eq!(told(&fs::read(&output).unwrap()), [false; 2], "{ending}");
        assert_eq!((read(&output).width(), read(&output).height()), (512, 512));
    }
}

#[test]
fn a_jpeg_looks_as_the_png_does() {
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
fn an_edit_moves_what_it_is_of_and_nothing_beyond_the_ring() {
    let before = read(&portrait());
    let landmarks = landmarks();
    let side = |axis: usize| {
        let along = landmarks.iter().map(|place| place[axis]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let longer = side(0).max(side(1));
    let nose = [landmarks[129], landmarks[358]];
    let mut counts = Vec::new();
    for (name, falloff_band, more) in [("wide", 0.35, &[][..]), ("narrow", 0.1, &["--falloff-band", "0.1"])] {
        let places = changed(&before, &edited(&portrait(), name, &[&NOSE, more].concat()));
        for wing in nose {
            assert!(places.iter().any(|place| apart(*place, wing) < 2.0), "the nose's wing at {wing:?}");
        }
        let nearest = |place: &[f64; 2]| landmarks.iter().map(|at| apart(*at, *place)).fold(f64::MAX, f64::min);
        let furthest = places.iter().map(nearest).fold(0.0, f64::max);
        assert!(furthest < falloff_band * longer, "{furthest} px beyond the face, which is {longer} px long");
        counts.push(places.len());
    }
    assert!(counts[1] < counts[0], "{counts:?}");
}

#[test]
fn what_is_kept_stays() {
    let before = read(&portrait());
    let jaw = ["--slider", "jaw-width:-6"];
    let free = changed(&before, &edited(&portrait(), "free", &jaw));
    let keep = ["--keep", "190,170,20", "--keep", "262,168,9"];
    let kept = changed(&before, &edited(&portrait(), "kept", &[&jaw[..], &keep].concat()));
    for (middle, radius) in [([190.0, 170.0], 20.0), ([262.0, 168.0], 9.0)] {
        let within = |places: &[[f64; 2]]| places.iter().filter(|place| apart(**place, middle) <= radius).count();
        assert!(within(&free) > 100, "it would have moved");
        assert_eq!(within(&kept), 0, "at {middle:?}");
    }
    assert!(!kept.is_empty());
}

#[test]
fn every_density_moves_the_photo() {
    let before = read(&portrait());
    let tip = landmarks()[1];
    let edit = ["--constraint", "exact", "--anchors", "oval", "--edit", "1:6,0,0"];
    for (name, more) in [
        ("coarse", [&edit[..], &["--density", "0"]].concat()),
        ("denser", [&edit[..], &["--density", "3", "--topology", "canonical"]].concat()),
    ] {
        let places = changed(&before, &edited(&portrait(), name, &more));
        let middle = |axis: usize| places.iter().map(|place| place[axis]).sum::<f64>() / places.len() as f64;
        assert!(places.iter().any(|place| apart(*place, tip) < 3.0), "{name}: the tip of the nose");
        assert!(apart([middle(0), middle(1)], tip) < 40.0, "{name}: around ({}, {})", middle(0), middle(1));
    }
}

#[test]
fn a_face_is_shown_as_from_elsewhere() {
    let before = read(&portrait());
    let far = changed(&before, &edited(&portrait(), "far", &["--distance", "40", "--seen-from", "200"]));
    let near = changed(&before, &edited(&portrait(), "near", &["--distance", "40", "--seen-from", "35"]));
    assert!(near.len() > 5000 && far.len() > near.len(), "{} and {}", near.len(), far.len());
    assert_eq!(
        changed(&before, &edited(&portrait(), "there", &["--distance", "40", "--seen-from", "40"])),
        [[0.0; 2]; 0]
    );
}

#[test]
fn what_folds_is_said() {
    let run = photo(&portrait(), &scratch("crossed.png"), &["--constraint", "exact", "--edit", "13:0,-40,0"]);
    assert_eq!(code(&run), 0);
    assert!(said(&run).contains("px behind the edits"), "{}", said(&run));
}

#[test]
fn requests_that_cannot_be_met() {
    let refused = |output: &str, more: &[&str], words: &[&str]| {
        let target = scratch(output);
        assert_refused(&photo(&portrait(), &target, more), 2, words);
        assert!(!target.exists(), "nothing is written");
    };
    for ending in ["face.webp", "face.glb", "face"] {
        refused(ending, &NOSE, &[".jpg or .png", "End its name so"]);
    }
    for falloff_band in ["0", "0.05", "0.9", "nan", "wide"] {
        refused("a.png", &[&NOSE[..], &["--falloff-band", falloff_band]].concat(), &["--falloff-band", "0.1 to 0.8"]);
    }
    for dab in ["10,20", "10,20,0", "here"] {
        refused("a.png", &[&NOSE[..], &["--keep", dab]].concat(), &["--keep", "X,Y,RADIUS"]);
    }
    refused("a.png", &["--falloff-band", "0.2"], &["--falloff-band", "nothing in the photo is moved"]);
    refused("a.png", &["--keep", "1,2,3"], &["--keep", "nothing in the photo is moved"]);
    refused("a.png", &["--operator", "L"], &["--operator", "none is given"]);
    refused("a.png", &["--seen-from", "3"], &["--seen-from"]);
    let copy = scratch("read.png");
    fs::copy(portrait(), &copy).unwrap();
    assert_refused(&photo(&copy, &copy, &NOSE), 2, &["read.png", "overwritten"]);
    assert_eq!(fs::read(copy).unwrap(), fs::read(portrait()).unwrap());
    assert_refused(&photo(&faceless(), &scratch("a.png"), &[]), 4, &["no face found"]);
}

/// The portrait with its right quarter transparent, as a file of that name.
fn partly_transparent(name: &str) -> PathBuf {
    let mut picture = image::open(portrait()).unwrap().to_rgba8();
    let width = picture.width();
    picture.enumerate_pixels_mut().filter(|(x, ..)| *x >= width * 3 / 4).for_each(|(.., pixel)| pixel[3] = 0);
    let path = scratch(name);
    picture.save(&path).unwrap();
    path
}

#[test]
fn a_png_keeps_transparency_and_a_jpeg_says_that_it_cannot() {
    for name in ["partly.png", "partly.webp"] {
        let input = partly_transparent(name);
        let output = scratch(&format!("{name}-edited.png"));
        let run = photo(&input, &output, &NOSE);
        assert_eq!((code(&run), said(&run).contains("transparent")), (0, false), "{}", said(&run));
        let [before, after] = [&input, &output].map(|path| image::open(path).unwrap().to_rgba8());
        let alpha = |picture: &image::RgbaImage| picture.pixels().map(|pixel| pixel[3]).collect::<Vec<_>>();
        assert_eq!(alpha(&after), alpha(&before), "nothing moves there");
        assert!(before.pixels().zip(after.pixels()).any(|(before, after)| before != after), "the nose moves");
    }
    let output = scratch("partly-edited.jpg");
    let run = photo(&partly_transparent("partly.png"), &output, &NOSE);
    assert_eq!(code(&run), 0);
    assert!(said(&run).contains("transparent parts are laid over white"), "{}", said(&run));
    let white = read(&output);
    assert!(white.pixel(white.width() - 4, 9).iter().all(|&level| level > 250));
}
