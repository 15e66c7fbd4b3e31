use clap::Args;
use rosto::networks::Landmarks;
use rosto_face::PhotoLens;
use rosto_landmarks::FindOptions;

use crate::settings;

/// Options about the photo's camera.
#[derive(Debug, Args)]
#[command(next_help_heading = "Camera (default: the photo's lens data, or an estimate from the face)")]
pub struct CameraArguments {
    /// Distance from the camera to the face, in cm
    #[arg(long, value_name = "CM", allow_negative_numbers = true, value_parser = settings::distance)]
    pub distance: Option<PhotoLens>,
    /// Focal length in mm, for a frame of 36 × 24 mm; the photo must not be cropped
    #[arg(long = "focal-35mm", value_name = "MM", allow_negative_numbers = true, conflicts_with = "distance",
        value_parser = settings::focal_length)]
    pub focal_length: Option<PhotoLens>,
    /// Corners of a bank card held flat against the forehead or the chin, in px of the upright photo: it measures the face
    ///
    /// Four corners in any order, such as "812,340 1204,352 1196,600 806,588".
    #[arg(long, value_name = "X,Y X,Y X,Y X,Y", value_parser = rosto::card_px)]
    pub card_px: Option<[[f64; 2]; 4]>,
}

impl CameraArguments {
    /// Lens given by these options.
    pub fn lens(&self) -> Option<PhotoLens> {
        self.distance.or(self.focal_length)
    }
}

/// Options of face detection.
#[derive(Debug, Args)]
#[command(next_help_heading = "Face detection")]
pub struct FindArguments {
    /// Reproduce MediaPipe's Face Mesh on a single picture: one detection, one pass, 468 landmarks
    ///
    /// By default, Rosto also searches rotated and enlarged parts of the picture, repeats the landmark pass until it
    /// converges, and refines lips, eyes and irises.
    #[arg(long)]
    pub mediapipe: bool,
    /// With --mediapipe: use MediaPipe's refined lips, eyes and irises (478 landmarks)
    #[arg(long)]
    pub refine: bool,
}

impl FindArguments {
    /// Landmark network for these options.
    pub fn landmarks(&self) -> Landmarks {
        if self.mediapipe && !self.refine { Landmarks::Plain } else { Landmarks::Attention }
    }

    /// Detection options for up to `max_faces` faces.
    pub fn options(&self, max_faces: Option<usize>) -> FindOptions {
        let defaults = if self.mediapipe { FindOptions::mediapipe() } else { FindOptions::default() };
        FindOptions { max_faces: max_faces.unwrap_or(defaults.max_faces), ..defaults }
    }
}
