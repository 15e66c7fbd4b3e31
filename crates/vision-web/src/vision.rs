use js_sys::{Error, Function};
use rosto_landmarks::{FaceFinder, FindOptions, Follower, LandmarkNetwork};
use rosto_photo::{Limits, Photo, decode};
use wasm_bindgen::prelude::*;

use crate::error;
use crate::found::Found;
use crate::progress::{Progress, Step};

/// Finds faces in photos and follows one face in a camera stream. Holds the networks; create it once.
#[wasm_bindgen]
pub struct Vision {
    finder: FaceFinder,
    follower: Follower,
}

#[wasm_bindgen]
impl Vision {
    /// Loads the detector and the landmark network with attention from their ONNX files.
    ///
    /// # Errors
    /// Throws `networks-damaged`.
    #[wasm_bindgen(constructor)]
    pub fn new(detector: &[u8], landmarks: &[u8]) -> Result<Self, Error> {
        console_error_panic_hook::set_once();
        Ok(Self {
            finder: FaceFinder::new(detector, LandmarkNetwork::Attention(landmarks)).map_err(error::of_landmarks)?,
            follower: Follower::default(),
        })
    }

    /// Finds up to `max_faces` faces in a photo (the bytes of a JPEG, PNG or WebP file), the most prominent first.
    /// Calls `report` at the start of each stage with the overall fraction done, 0 to 1. If the browser has converted
    /// the photo, `original` is the file (HEIC, AVIF) from which the lens data is read.
    ///
    /// # Errors
    /// Throws `not-a-picture`, `unsupported-format`, `damaged-picture`, `too-many-bytes`, `too-many-pixels`,
    /// `networks-damaged` or `internal`. A photo without a face is not an error.
    pub fn find(
        &self,
        bytes: &[u8],
        #[wasm_bindgen(js_name = maxFaces)] max_faces: u32,
        #[wasm_bindgen(
            unchecked_param_type = "(stage: \"decode\" | \"detect\" | \"landmarks\", fraction: number) => void"
        )]
        report: &Function,
        original: Option<Box<[u8]>>,
    ) -> Result<Found, Error> {
        let progress = Progress::new(report);
        progress.report(Step::Decoding);
        let decoded = decode(bytes, &Limits::default()).map_err(error::of_photo)?;
        let photo = match original {
            Some(original) => decoded.with_lens_of(&original),
            None => decoded,
        };
        let options = FindOptions { max_faces: max_faces as usize, ..FindOptions::default() };
        let found = self
            .finder
            .find_with_progress(&photo, &options, |stage| progress.report(Step::Finding(stage)))
            .map_err(error::of_landmarks)?;
        progress.report(Step::Finishing);
        Ok(Found::new(&photo, &found.faces))
    }

    /// Follows a face into the next frame of a camera stream. Returns its 478 × (x/W, y/H, z/W), smoothed over time, or
    /// `undefined` without a face. `rgba` is the frame row by row; alpha is ignored. `time_ms` is the frame's time, from
    /// any origin.
    ///
    /// # Errors
    /// Throws `damaged-picture` if there are not four bytes per pixel, `networks-damaged` or `internal`.
    pub fn follow(
        &mut self,
        rgba: &[u8],
        width: u32,
        height: u32,
        #[wasm_bindgen(js_name = time_ms)] time_ms: f64,
    ) -> Result<Option<Vec<f32>>, Error> {
        let frame = Photo::from_rgbx(width, height, rgba).map_err(error::of_photo)?;
        let face = self.finder.follow(&mut self.follower, &frame, time_ms).map_err(error::of_landmarks)?;
        Ok(face.map(|face| face.landmarks.concat()))
    }

    /// Forgets the followed face, before another camera stream.
    #[wasm_bindgen(js_name = stopFollowing)]
    pub fn stop_following(&mut self) {
        self.follower = Follower::default();
    }
}
