use js_sys::{Error, Function};
use rosto_landmarks::{FaceFinder, FindOptions, Follower, LandmarkNetwork};
use rosto_photo::{Limits, Photo, decode};
use wasm_bindgen::prelude::*;

use crate::error;
use crate::found::Found;
use crate::progress::{Progress, Step};

/// Finds faces in photos, and follows one in a film. Made once; holds the networks.
#[wasm_bindgen]
pub struct Vision {
    finder: FaceFinder,
    follower: Follower,
}

#[wasm_bindgen]
impl Vision {
    /// Prepares the detector and the landmark network with attention from their ONNX files.
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

    /// Looks for at most `max_faces` faces in a photo (the bytes of a JPEG, PNG or WebP file), the most prominent first.
    /// `report` is told each stage as it begins and how much of the whole is done, 0 to 1. Where the browser has decoded the photo to `bytes`, its `original` file (HEIC, AVIF) still tells the lens.
    ///
    /// # Errors
    /// Throws `not-a-picture`, `unsupported-format`, `damaged-picture`, `too-many-bytes`, `too-many-pixels`,
    /// `networks-damaged` or `internal`. No face is an answer, not an error.
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
        progress.tell(Step::Decoding);
        let decoded = decode(bytes, &Limits::default()).map_err(error::of_photo)?;
        let photo = match original {
            Some(original) => decoded.with_lens_of(&original),
            None => decoded,
        };
        let options = FindOptions { max_faces: max_faces as usize, ..FindOptions::default() };
        let found = self
            .finder
            .find_with_progress(&photo, &options, |stage| progress.tell(Step::Finding(stage)))
            .map_err(error::of_landmarks)?;
        progress.tell(Step::Finishing);
        Ok(Found::new(&photo, &found.faces))
    }
    /// Follows a face into the next frame of a film: its 478 × (x/W, y/H, z/W), smoothed over time, or nothing where there is
    /// no face. `rgba` is the frame row by row, its fourth bytes passed over; `time_ms` says when it was taken, from any
    /// beginning.
    ///
    /// # Errors
    /// Throws `damaged-picture` if there are not four bytes for each pixel, `networks-damaged` or `internal`.
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

    /// Forgets the face that is followed: the next frame belongs to another film.
    #[wasm_bindgen(js_name = stopFollowing)]
    pub fn stop_following(&mut self) {
        self.follower = Follower::default();
    }
}
