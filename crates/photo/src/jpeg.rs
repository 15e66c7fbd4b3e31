//! JPEG files, those too that lack only their end.
//!
//! The decoder fills what is missing with grey and calls it a success, as browsers do; half a face is no use here. So what
//! is there is found out beforehand.

mod ending;

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Cursor;

use image::ImageDecoder;
use image::codecs::jpeg::JpegDecoder;

use crate::decode::{Stored, damaged, refused};
use crate::format::Format;
use crate::{Limits, Photo, PhotoError};
use ending::{END, Ending, LastScan, ending};

/// One row of so many may be missing.
const ROWS_FOR_EACH_MISSING: usize = 20;

pub(crate) fn decode(bytes: &[u8], limits: &Limits) -> Result<Photo, PhotoError> {
    let (width, height) = decoder(bytes)?.dimensions();
    limits.check_size(width, height)?;
    match ending(bytes) {
        Ending::Marked => stored(bytes, limits)?.upright(),
        Ending::Unmarked { last_scan, nearly_all } => decode_unmarked(last_scan, nearly_all, limits),
    }
}

/// A file that ends without saying so: with the rows that its last scan shows, or else without that scan's refinements.
fn decode_unmarked(
    last_scan: Option<LastScan<'_>>,
    nearly_all: Option<&[u8]>,
    limits: &Limits,
) -> Result<Photo, PhotoError> {
    if let Some(last_scan) = last_scan
        && let Some(stored) = with_nearly_all_rows(&last_scan, limits)?
    {
        return stored.upright();
    }
    match nearly_all {
        Some(scans) => stored(&ended(scans, &[]), limits)?.upright(),
        None => Err(damaged(Format::Jpeg, "it ends before its last row".to_owned())),
    }
}

/// The rows of a last scan, those that are missing like the last one that is there; `None` if too many are.
///
/// Where the scan is whole, nothing that comes behind it is read; where it is not, whatever comes there shows in the
/// picture.
fn with_nearly_all_rows(last_scan: &LastScan<'_>, limits: &Limits) -> Result<Option<Stored>, PhotoError> {
    let ended_with = |tail: &[u8]| stored(&ended(last_scan.scanned, tail), limits);
    let mut picture = ended_with(&[])?;
    let expected = row_digests(&picture);
    let mut rows = expected.len();
    for tail in last_scan.tails() {
        let found = ended_with(&tail).map(|other| row_digests(&other)).unwrap_or_default();
        rows = rows.min(expected.iter().zip(found).take_while(|(expected, found)| *expected == found).count());
        if (expected.len() - rows) * ROWS_FOR_EACH_MISSING > expected.len() {
            return Ok(None);
        }
    }
    picture.repeat_row_below(rows - 1);
    Ok(Some(picture))
}

fn ended(scans: &[u8], tail: &[u8]) -> Vec<u8> {
    [scans, tail, &END].concat()
}

fn row_digests(picture: &Stored) -> Vec<u64> {
    let digest = |row: &[u8]| {
        let mut hasher = DefaultHasher::new();
        row.hash(&mut hasher);
        hasher.finish()
    };
    picture.rgb.chunks_exact(picture.row_bytes()).map(digest).collect()
}

fn stored(bytes: &[u8], limits: &Limits) -> Result<Stored, PhotoError> {
    Stored::read(decoder(bytes)?, Format::Jpeg, limits)
}

fn decoder(bytes: &[u8]) -> Result<JpegDecoder<Cursor<&[u8]>>, PhotoError> {
    JpegDecoder::new(Cursor::new(bytes)).map_err(|error| refused(Format::Jpeg, error))
}
