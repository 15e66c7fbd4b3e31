use clap::Args;
use rosto_face::{Photo, PhotoLens};
use rosto_landmarks::FindOptions;

use crate::networks::Landmarks;
use crate::{portrait, settings};

/// What is known of the camera.
#[derive(Debug, Args)]
#[command(next_help_heading = "How the photo was taken; without these, by its lens data or else by the face itself")]
pub struct CameraArguments {
    /// How far away the camera stood from the face, in cm
    #[arg(long, value_name = "CM", allow_negative_numbers = true, value_parser = settings::distance)]
    pub distance: Option<PhotoLens>,
    /// The lens' focal length in mm, for a frame of 36 × 24 mm; the photo must be whole, as it was taken
    #[arg(long = "focal-35mm", value_name = "MM", allow_negative_numbers = true, conflicts_with = "distance",
        value_parser = settings::focal_length)]
    pub focal_length: Option<PhotoLens>,
}

impl CameraArguments {
    /// Lens data of a photo.
    pub fn lens(&self, photo: &Photo) -> PhotoLens {
        self.distance.or(self.focal_length).unwrap_or_else(|| portrait::lens_of(photo))
    }
}

/// How faces are looked for.
#[derive(Debug, Args)]
#[command(next_help_heading = "How faces are found")]
pub struct FindArguments {
    /// Does exactly what MediaPipe's Face Mesh does with a single picture: one look, one pass, 468 landmarks
    ///
    /// Otherwise turns and parts of the picture are looked at too, landmarks are found again until they agree, and lips, eyes
    /// and irises are refined.
    #[arg(long)]
    pub mediapipe: bool,
    /// With --mediapipe: its refined lips, eyes and irises, 478 landmarks; without it they are always refined
    #[arg(long)]
    pub refine: bool,
}

impl FindArguments {
    /// The landmark network that these ask for.
    pub fn landmarks(&self) -> Landmarks {
        if self.mediapipe && !self.refine { Landmarks::Plain } else { Landmarks::Attention }
    }

    /// The way of looking that these ask for, for that many faces.
    pub fn options(&self, max_faces: Option<usize>) -> FindOptions {
        let usual = if self.mediapipe { FindOptions::mediapipe() } else { FindOptions::default() };
        FindOptions { max_faces: max_faces.unwrap_or(usual.max_faces), ..usual }
    }
}
