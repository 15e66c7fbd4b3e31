//! JPEG files that were changed on their way, in front of a valid end.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../../../tests/seeded.rs"]
mod seeded;
mod support;

use rosto_photo::{Photo, PhotoError};
use seeded::Seeded;
use support::read;

/// 96 × 384 px, written by `tests/reference/libjpeg.py`.
const FILES: [(&str, &[u8]); 3] = [
    ("baseline", include_bytes!("fixtures/whole-baseline.jpg")),
    ("progressive", include_bytes!("fixtures/whole-progressive.jpg")),
    ("restarts", include_bytes!("fixtures/whole-restarts.jpg")),
];
const END: [u8; 2] = [0xFF, 0xD9];

/// Where the data of the first scan begins.
fn data_start(file: &[u8]) -> usize {
    let at = file.windows(2).position(|two| two == [0xFF, 0xDA]).unwrap();
    at + 2 + usize::from(u16::from_be_bytes([file[at + 2], file[at + 3]]))
}

/// The first share of the scans, and an end.
fn first(file: &[u8], share: f64) -> Vec<u8> {
    let (start, end) = (data_start(file), file.len() - END.len());
    let kept = start + ((end - start) as f64 * share) as usize;
    [&file[..kept], &END].concat()
}

/// The share of rows whose samples differ from those of the whole picture by so many levels at most, in the mean.
fn intact(photo: &Photo, whole: &Photo, most: f64) -> f64 {
    let row_bytes = 3 * photo.width() as usize;
    let rows = photo.pixels().chunks(row_bytes).zip(whole.pixels().chunks(row_bytes));
    let difference = |(row, expected): (&[u8], &[u8])| {
        let differences = row.iter().zip(expected).map(|(a, b)| f64::from(a.abs_diff(*b)));
        differences.sum::<f64>() / row_bytes as f64
    };
    rows.map(difference).filter(|&difference| difference <= most).count() as f64 / f64::from(whole.height())
}

/// Levels by which a row may differ that counts as intact: a progressive picture may lack the last bits of its coefficients.
fn most(name: &str) -> f64 {
    if name == "progressive" { 6.0 } else { 0.0 }
}

#[test]
fn the_first_part_of_a_scan_with_an_end_is_damaged() {
    for (name, file) in FILES {
        assert!(read(file).is_ok(), "{name}");
        // The last scans of a progressive picture, two fifths of its bytes here, are the last bits of its coefficients.
        for percent in (2..=if name == "progressive" { 56 } else { 90 }).step_by(2) {
            let found = read(&first(file, f64::from(percent) / 100.0));
            assert!(matches!(found, Err(PhotoError::Damaged { .. })), "{name}, {percent} %: {found:?}");
        }
    }
}

#[test]
fn a_picture_that_ends_in_its_last_row_of_units_is_accepted_with_an_end_or_without() {
    for (name, file) in FILES.into_iter().filter(|(name, _)| *name != "progressive") {
        let whole = read(file).unwrap();
        // A row of units is 16 of 384 rows, 4 %; that many of the bytes are in the last one.
        let in_last_row = (file.len() - data_start(file)) / 24;
        for missing in (3..in_last_row).step_by(in_last_row / 10) {
            let cut = &file[..file.len() - END.len() - missing];
            for cut in [cut.to_vec(), [cut, &END].concat()] {
                let photo = read(&cut).unwrap_or_else(|error| panic!("{name} without {missing} bytes: {error}"));
                assert!(intact(&photo, &whole, 0.0) >= 0.95, "{name} without {missing} bytes");
            }
        }
    }
}

/// Bytes lost, repeated or written over; where the change shows nowhere, at most a twentieth of the rows differs.
#[test]
fn changed_data_is_damaged_unless_nearly_all_rows_are_intact() {
    const LENGTH: usize = 700;
    let mut seeded = Seeded::new(29);
    for (name, file) in FILES {
        let whole = read(file).unwrap();
        let start = data_start(file);
        let mut refused = 0;
        for case in 0..120 {
            let at = start + seeded.below(file.len() - END.len() - LENGTH - start);
            let mut changed = file.to_vec();
            match case % 3 {
                0 => drop(changed.drain(at..at + LENGTH)),
                1 => drop(changed.splice(at..at, file[at..at + LENGTH].to_vec())),
                _ => changed[at..at + LENGTH].fill_with(|| seeded.bits() as u8),
            }
            match read(&changed) {
                Err(PhotoError::Damaged { .. }) => refused += 1,
                Ok(photo) => {
                    let share = intact(&photo, &whole, most(name));
                    assert!(share >= 0.95, "{name}, case {case} at {at}: {share}");
                }
                Err(other) => panic!("{name}, case {case} at {at}: {other}"),
            }
        }
        assert!(refused > 60, "{name}: {refused} refused");
    }
}

#[test]
fn a_lost_interval_costs_its_rows_alone() {
    let (_, file) = FILES[2];
    let whole = read(file).unwrap();
    let is_restart = |at: &usize| file[*at] == 0xFF && (0xD0..=0xD7).contains(&file[at + 1]);
    let markers: Vec<usize> = (data_start(file)..file.len() - 2).filter(is_restart).collect();
    assert_eq!(markers.len(), 23, "an interval is a row of units");
    let without = |from: usize, to: usize| read(&[&file[..markers[from]], &file[markers[to]..]].concat());
    let photo = without(5, 6).unwrap();
    assert!(intact(&photo, &whole, 0.0) >= 0.95);
    assert_eq!(intact(&photo, &whole, 255.0), 1.0);
    assert!(without(5, 7).unwrap_err().to_string().contains("352 of its 384 rows are intact"));
    // A marker of an interval before, and none that is expected.
    let mut repeated = file.to_vec();
    repeated[markers[9] + 1] = 0xD0 + 7;
    repeated.truncate(markers[10]);
    assert!(read(&repeated).is_err());
    // Eight of them leave the markers' numbers as they should be.
    assert!(without(5, 13).is_err());
}

#[test]
fn filler_between_the_last_row_and_the_end_is_passed_over() {
    for (name, file) in FILES {
        let whole = read(file).unwrap();
        for filler in [&[0; 40][..], &[0xFF; 5], &[0x55]] {
            let filled = [&file[..file.len() - 2], filler, &END].concat();
            assert_eq!(read(&filled).unwrap(), whole, "{name}, {filler:?}");
        }
    }
}
