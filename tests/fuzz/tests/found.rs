//! Regression tests: files that made a reader panic, use too much memory or time, or violate a requirement.

use rosto_fuzz::Kind::{Edits, Picture};

#[test]
fn refuses_the_files_that_fuzzing_found() {
    // `png` 0.18.1 copies the palette in chunks of three bytes, and panics on the two that remain.
    assert!(!Picture.check(include_bytes!("../found/png-palette-of-20-bytes")));
    // The decoder allocated the size of the EXIF chunk before comparing it with the file's length.
    assert!(!Picture.check(include_bytes!("../found/webp-metadata-of-4-gb")));
    // The lossy stream's header states 16 383 × 16 383 px. The decoder allocated them before comparing them with the
    // container's 33 × 17.
    assert!(!Picture.check(include_bytes!("../found/webp-picture-larger-than-its-file")));
    // A handle listed twice in a mirrored edit left the second offset without a partner.
    assert!(!Edits.check(include_bytes!("../found/edits-handle-twice-on-both-sides")));
}
