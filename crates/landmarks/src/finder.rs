use rosto_photo::Photo;

use crate::detector::{Detection, Detector};
use crate::judgement::Judge;
use crate::mesh::{LandmarkNetwork, Mesh, MeshNetwork};
use crate::pyramid::Pyramid;
use crate::region_of_interest::{PictureSize, RegionOfInterest, RegionPx};
use crate::{LandmarksError, prominence, search};

/// Finds faces in pictures. The networks are prepared once and kept.
pub struct FaceFinder {
    pub(crate) detector: Detector,
    pub(crate) mesh: MeshNetwork,
}

/// How to look for faces. The default is thorough; [`Self::mediapipe`] is what MediaPipe does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FindOptions {
    /// How many faces are wanted at most; of more, the first. 20 by default.
    pub max_faces: usize,
    /// Where to look, and how often.
    pub search: Search,
}

/// Where to look for faces, and how often.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Search {
    /// As MediaPipe does with single pictures: the detector once over the whole picture, the landmark network once on each of
    /// the best detections. A face is what the landmark network calls one. Finds heads up to about 90° from upright that fill
    /// an eighth of the picture or more; the best detection comes first.
    Once,
    /// Turns and tiles of the picture at several sizes; the landmark network until its answers agree; faces are what both
    /// networks agree on ([`Face::confidence`]). Finds heads turned by any angle, down to about 15 px between the eyes. The
    /// most prominent one comes first: large, and near the middle.
    #[default]
    Thorough,
}

/// One face in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// The detector's, 0.5..1.
    pub score: f32,
    /// The landmark network's, 0.5..1.
    pub presence: f32,
    /// How sure it is that this is a face and that the landmarks lie on it: of [`Search::Once`], the presence alone;
    /// of [`Search::Thorough`], above 0.7, a product of weights for the presence, for how well the last two passes agree,
    /// for how sure the detector is from near, for how well its eyes, nose and mouth agree with those of the mesh, and for
    /// how much more a face the right way up it is to the detector than one on its head.
    pub confidence: f32,
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
    Detecting {
        /// How much of that is done, 0..1; it never falls.
        share: f32,
    },
    /// The landmark network looks at one of the detections.
    Meshing {
        /// Which detection, from 0.
        face: usize,
        /// How many there are.
        of: usize,
    },
}

/// What the landmark network is less sure of is no face, as in MediaPipe.
pub(crate) const MIN_PRESENCE: f32 = 0.5;
/// In the scenes of docs/robustness.md, right meshes have 0.8 and more, but for faces of which the border leaves little.
const MIN_CONFIDENCE: f32 = 0.7;

impl Default for FindOptions {
    fn default() -> Self {
        Self { max_faces: 20, search: Search::Thorough }
    }
}

impl FindOptions {
    /// MediaPipe's static image mode: one look, one pass, one face.
    pub fn mediapipe() -> Self {
        Self { max_faces: 1, search: Search::Once }
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

    /// The faces in a picture in the order of [`Search`]; none is an answer, not an error.
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
        report(Stage::Detecting { share: 0.0 });
        match options.search {
            Search::Once => self.once(photo, options.max_faces, report),
            Search::Thorough => self.thoroughly(photo, options.max_faces, report),
        }
    }

    fn once(
        &self,
        photo: &Photo,
        max_faces: usize,
        mut report: impl FnMut(Stage),
    ) -> Result<Vec<Face>, LandmarksError> {
        let picture = PictureSize::of(photo);
        let mut detections = self.detector.detect(photo, &RegionPx::whole(picture))?;
        detections.truncate(max_faces);
        let mut faces = Vec::with_capacity(detections.len());
        for (index, detection) in detections.iter().enumerate() {
            report(Stage::Meshing { face: index, of: detections.len() });
            let region = detection.face_region(picture);
            let Mesh { presence, landmarks } = self.mesh.look(photo, &region)?;
            faces.push(Face { score: detection.score, presence, confidence: presence, landmarks, region });
        }
        faces.retain(|face| face.presence > MIN_PRESENCE);
        Ok(faces)
    }

    fn thoroughly(
        &self,
        photo: &Photo,
        max_faces: usize,
        mut report: impl FnMut(Stage),
    ) -> Result<Vec<Face>, LandmarksError> {
        let pyramid = Pyramid::new(photo);
        let judge = Judge { detector: &self.detector, mesh: &self.mesh, pyramid: &pyramid };
        let picture = PictureSize::of(photo);
        let mut proposals =
            search::proposals(&self.detector, &pyramid, max_faces, |share| report(Stage::Detecting { share }))?;
        prominence::sort(&mut proposals, picture, Detection::outline);
        let mut faces: Vec<Face> = Vec::new();
        for (index, proposal) in proposals.iter().enumerate() {
            report(Stage::Meshing { face: index, of: proposals.len() });
            if faces.len() < max_faces && !prominence::is_among(proposal, &faces) {
                let face = judge.face(proposal)?;
                faces = prominence::with(faces, face.filter(|face| face.confidence > MIN_CONFIDENCE));
            }
        }
        prominence::sort(&mut faces, picture, Face::outline);
        Ok(faces)
    }
}
