//! Valid files of every kind, tiny where they can be, from which the broken ones are made.

mod faces;
mod pictures;
mod profiles;

use std::path::Path;

use rosto_photo::{Limits, Photo, decode};

pub use faces::canonical_rest;
use faces::histories;
use pictures::{jpegs, pngs, webps};
pub use pictures::{with_checksums, with_profile};
use profiles::profiles;

/// What the kinds take their seeds from, made once.
pub struct Seeds {
    pub jpegs: Vec<Vec<u8>>,
    pub pngs: Vec<Vec<u8>>,
    pub webps: Vec<Vec<u8>>,
    pub profiles: Vec<Vec<u8>>,
    pub glbs: Vec<Vec<u8>>,
    pub projects: Vec<Vec<u8>>,
    pub histories: Vec<Vec<u8>>,
    /// None where the networks have not been obtained.
    pub networks: Option<Networks>,
}

/// The two networks and a picture of a face.
pub struct Networks {
    pub detector: Vec<u8>,
    pub landmarks: Vec<u8>,
    pub portrait: Photo,
}

impl Seeds {
    /// All seeds; `assets` is the folder with the networks and the sample portrait.
    pub fn new(assets: &Path) -> Self {
        let histories = histories();
        Self {
            jpegs: jpegs(),
            pngs: pngs(),
            webps: webps(),
            profiles: profiles(),
            glbs: faces::glbs(&histories),
            projects: faces::projects(&histories),
            histories: histories.into_iter().map(String::into_bytes).collect(),
            networks: networks(assets),
        }
    }
}

fn networks(assets: &Path) -> Option<Networks> {
    let read = |name: &str| std::fs::read(assets.join(name)).ok();
    let portrait = decode(&read("sample.png")?, &Limits::default()).ok()?;
    Some(Networks {
        detector: read("face_detector.onnx")?,
        landmarks: read("face_landmarks_attention.onnx")?,
        portrait,
    })
}
