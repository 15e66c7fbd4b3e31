//! A face as the page sends it to the worker. The library and the worker write the same bytes for it.

#![allow(dead_code, reason = "each test uses a part of it")]

use rosto_face::{LANDMARK_COUNT, Observation, PhotoLens, canonical_positions_m};

/// The lead photo, from which the worker takes the picture.
pub const PICTURE: &[u8] = include_bytes!("../web/assets/sample.png");

/// Edits of one landmark and of an expression, with a distance of the photo.
pub const EDITS: &str = r#"{"density":1,"history":{"entries":[{"label":"nose-tip","move":{"anchors":{"kind":"oval","pins":[]},"constraint":"exact","details":"kept","handles":[4],"influence":{"within":0.04},"level":0,"mirror":"on","offsets":[[0.0,0.002,0.006]],"operator":"cotangent"},"switch":"on"},{"express":{"expression":"jawOpen","weight":0.5},"label":"jawOpen","switch":"on"}],"rosto":"history","version":1},"photo_edit":{"protected_px":[[[250.0,200.0,12.5]]],"seen_from_m":1.5},"triangulation":"canonical"}"#;

/// FNV-1a of the GLB with the photo as its texture and the edits as morph targets. Single precision hides that the builds
/// round differently; in meshes with more numbers, the last bits of some would differ.
pub const GLB_FNV1A: u64 = 0x05F9_21ED_21A7_3D03;

/// The canonical face, found in the middle of the photo.
pub fn observation() -> Observation {
    let landmark = |p: &glam::DVec3| [0.5 + 3.0 * p.x, 0.5 - 3.0 * p.y, -3.0 * p.z].map(|part| part as f32);
    Observation {
        landmarks: canonical_positions_m().iter().map(landmark).collect(),
        photo_size_px: [512, 512],
        colours_srgb: vec![[180, 120, 90]; LANDMARK_COUNT],
        found_lens: PhotoLens::Exif(26.0),
        lens: PhotoLens::Distance(0.5),
        picture: None,
    }
}

/// FNV-1a with 64 bits.
pub fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}
