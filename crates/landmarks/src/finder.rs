use rosto_photo::Photo;

use crate::detector::{Detection, Detector};
use crate::mesh::{LandmarkNetwork, MeshNetwork, region_of};
use crate::region_of_interest::{PictureSize, RegionOfInterest};
use crate::{LandmarksError, search};

/// Finds faces in pictures. The networks are prepared once and kept.
pub struct FaceFinder {
    detector: Detector,
    mesh: MeshNetwork,
}

/// How to look for faces. The defaults are MediaPipe's in its static image mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FindOptions {
    /// Look at no more than this many of the best detections. 1 by default.
    pub max_faces: usize,
    /// Where to look.
    pub search: Search,
    /// How often to run the landmark network on each face.
    pub passes: Passes,
}

/// Where to look for faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Search {
    /// Once over the whole picture, as MediaPipe does: heads up to about 90° from upright that fill a tenth of the
    /// picture or more.
    #[default]
    Once,
    /// Over the whole picture turned by 0°, 90°, 180° and 270°; if that shows no face, over smaller and smaller tiles.
    /// Finds faces that stand on their head and small ones, at several times the cost.
    Thorough,
}

/// How often to run the landmark network on each face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Passes {
    /// On the detector's region only, as MediaPipe does with single pictures.
    #[default]
    One,
    /// Again on the region that the first landmarks suggest. Steadier between pictures of one face (0.7 px spread
    /// instead of 1.7), but not what MediaPipe answers.
    Two,
}

/// One face in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// The detector's, 0.5..1.
    pub score: f32,
    /// The landmark network's, above 0.5 and up to 1.
    pub presence: f32,
    /// 468 points in MediaPipe's normalised convention: x/W, y/H, z/W; y points down, smaller z is nearer, z is about 0
    /// in the mean. With [`LandmarkNetwork::Attention`] 478: ten of the irises follow, the right one first, each its middle
    /// and four points of its border.
    pub landmarks: Vec<[f32; 3]>,
    /// Where the landmark network looked.
    pub region: RegionOfInterest,
}

/// What is being worked on while faces are looked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stage {
    /// The detector looks at the picture.
    Detecting,
    /// The landmark network looks at one of the detections.
    Meshing {
        /// Which detection, from 0.
        face: usize,
        /// How many there are.
        of: usize,
    },
}

const MIN_PRESENCE: f32 = 0.5;

impl FindOptions {
    /// MediaPipe's in its static image mode, for one face.
    pub fn mediapipe() -> Self {
        Self { max_faces: 1, search: Search::Once, passes: Passes::One }
    }
}

impl Default for FindOptions {
    fn default() -> Self {
        Self::mediapipe()
    }
}

impl FaceFinder {
    /// Prepares the networks from their ONNX files.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`] if one of them is not the network it should be.
    pub fn new(detector_onnx: &[u8], landmarks: LandmarkNetwork<'_>) -> Result<Self, LandmarksError> {
        Ok(Self { detector: Detector::new(detector_onnx)?, mesh: MeshNetwork::new(landmarks)? })
    }

    /// The faces in a picture, best detection first; none is an answer, not an error.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkFailed`] if a network cannot be run, [`LandmarksError::NetworkDamaged`] if it answers with
    /// numbers that are not finite: the landmarks of a face are finite always.
    pub fn find(&self, photo: &Photo, options: &FindOptions) -> Result<Vec<Face>, LandmarksError> {
        self.find_with_progress(photo, options, |_| ())
    }

    /// [`Self::find`], telling `report` what it is about to do.
    ///
    /// # Errors
    /// As [`Self::find`].
    pub fn find_with_progress(
        &self,
        photo: &Photo,
        options: &FindOptions,
        mut report: impl FnMut(Stage),
    ) -> Result<Vec<Face>, LandmarksError> {
        report(Stage::Detecting);
        let mut detections = search::detections(&self.detector, photo, options.search)?;
        detections.truncate(options.max_faces);
        let mut faces = Vec::with_capacity(detections.len());
        for (index, detection) in detections.iter().enumerate() {
            report(Stage::Meshing { face: index, of: detections.len() });
            faces.extend(self.face(photo, detection, options.passes)?);
        }
        Ok(faces)
    }

    /// The face of one detection, unless the landmark network sees none there.
    fn face(&self, photo: &Photo, detection: &Detection, passes: Passes) -> Result<Option<Face>, LandmarksError> {
        let picture = PictureSize::of(photo);
        let mut region = detection.face_region(picture);
        let mut mesh = self.mesh.look(photo, &region)?;
        if passes == Passes::Two && mesh.presence > MIN_PRESENCE {
            region = region_of(&mesh.landmarks, picture);
            mesh = self.mesh.look(photo, &region)?;
        }
        let face = Face { score: detection.score, presence: mesh.presence, landmarks: mesh.landmarks, region };
        Ok((face.presence > MIN_PRESENCE).then_some(face))
    }
}
