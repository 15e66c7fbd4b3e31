//! Files that once made a reader panic, hold too much memory, take too long or break a promise.

use rosto_fuzz::Kind::{Edits, Picture};

#[test]
fn every_file_that_was_found_is_refused() {
    // `png` 0.18.1 copies the palette in threes and panics over the two bytes left.
    assert!(!Picture.check(include_bytes!("../found/png-palette-of-20-bytes")));
    // The size that an EXIF chunk claims was allocated before the file was found to be shorter.
    assert!(!Picture.check(include_bytes!("../found/webp-metadata-of-4-gb")));
    // A lossy picture's own header claims 16 383 × 16 383 px, which were allocated before they were compared with the
    // file's 33 × 17.
    assert!(!Picture.check(include_bytes!("../found/webp-picture-larger-than-its-file")));
    // A handle that was listed twice in a mirrored edit came once next to its partner, and its second offset had no place.
    assert!(!Edits.check(include_bytes!("../found/edits-handle-twice-on-both-sides")));
}
