use rosto_photo::Photo;

use crate::detection::Detection;
use crate::detector::Detector;
use crate::face::Face;
use crate::verification::Verifier;
use crate::mesh::{LandmarkNetwork, Mesh, MeshNetwork};
use crate::pyramid::Pyramid;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::{LandmarksError, prominence, search, suppression};

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
    /// networks agree on ([`Face::confidence`]). Finds heads turned by any angle, down to about 15 px between the eyes. Faces
    /// with a confidence of 0.9 or more come first, then those of 0.8 or more, each group sorted by prominence: large, and
    /// near the middle.
    #[default]
    Thorough,
}

/// Faces found in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundFaces {
    /// At most [`FindOptions::max_faces`], in the order of [`Search`].
    pub faces: Vec<Face>,
    /// Lower bound for the number of faces in the picture; above `faces.len()` where the limit left some out.
    pub at_least: usize,
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
/// In the scenes of docs/detection.md, right meshes have 0.8 and more, but for faces of which the border leaves little.
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
        Ok(self.find_with_progress(photo, options, |_| ())?.faces)
    }

    /// [`Self::find`] with a lower bound for the number of faces; calls `report` before each stage.
    ///
    /// # Errors
    /// As [`Self::find`].
    pub fn find_with_progress(
        &self,
        photo: &Photo,
        options: &FindOptions,
        mut report: impl FnMut(Stage),
    ) -> Result<FoundFaces, LandmarksError> {
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
    ) -> Result<FoundFaces, LandmarksError> {
        let picture = PictureSize::of(photo);
        let mut detections = self.detector.detect(photo, &RegionPx::whole(picture))?;
        let left_out = detections.split_off(max_faces.min(detections.len()));
        let mut faces = Vec::with_capacity(detections.len());
        for (index, detection) in detections.iter().enumerate() {
            report(Stage::Meshing { face: index, of: detections.len() });
            let region = detection.face_region(picture);
            let Mesh { presence, landmarks } = self.mesh.look(photo, &region)?;
            faces.push(Face { score: detection.score, presence, confidence: presence, landmarks, region });
        }
        faces.retain(|face| face.presence > MIN_PRESENCE);
        let at_least = faces.len() + count_further(&left_out, &faces);
        Ok(FoundFaces { faces, at_least })
    }

    fn thoroughly(
        &self,
        photo: &Photo,
        max_faces: usize,
        mut report: impl FnMut(Stage),
    ) -> Result<FoundFaces, LandmarksError> {
        let pyramid = Pyramid::new(photo);
        let verifier = Verifier { detector: &self.detector, mesh: &self.mesh, pyramid: &pyramid };
        let proposals =
            search::proposals(&self.detector, &pyramid, max_faces, |share| report(Stage::Detecting { share }))?;
        let ended_early = proposals.iter().filter(|seen| seen.score >= search::SURE).count() >= max_faces;
        let found = judged(&verifier, proposals, max_faces, &mut report)?;
        // Some of what ended the search may be no faces after all: search on.
        if ended_early && certain_count(&found.faces) < max_faces {
            let proposals = search::proposals(&self.detector, &pyramid, usize::MAX, |_| ())?;
            return judged(&verifier, proposals, max_faces, &mut |_| ());
        }
        Ok(found)
    }
}

/// Takes the proposals by prominence until enough of them are certain faces.
fn judged(
    verifier: &Verifier<'_>,
    mut proposals: Vec<Detection>,
    max_faces: usize,
    report: &mut impl FnMut(Stage),
) -> Result<FoundFaces, LandmarksError> {
    let picture = PictureSize::of(verifier.pyramid.photo);
    prominence::sort(&mut proposals, picture, Detection::outline);
    let (mut faces, mut looked_at) = (Vec::<Face>::new(), 0);
    while looked_at < proposals.len() && certain_count(&faces) < max_faces {
        let proposal = &proposals[looked_at];
        report(Stage::Meshing { face: looked_at, of: proposals.len() });
        looked_at += 1;
        if !prominence::is_among(proposal, &faces) {
            let face = verifier.face(proposal)?;
            faces = prominence::with(faces, face.filter(|face| face.confidence > MIN_CONFIDENCE));
        }
    }
    let at_least = faces.len() + count_further(&proposals[looked_at..], &faces);
    rank(&mut faces, picture);
    faces.truncate(max_faces);
    Ok(FoundFaces { faces, at_least })
}

fn certain_count(faces: &[Face]) -> usize {
    faces.iter().filter(|face| !face.is_doubtful()).count()
}

/// Sorts by doubt, then by prominence.
fn rank(faces: &mut [Face], picture: PictureSize) {
    prominence::sort(faces, picture, Face::outline);
    faces.sort_by_key(Face::doubt);
}

/// Number of detections that are surely faces and not among these.
fn count_further(detections: &[Detection], faces: &[Face]) -> usize {
    let is_further = |seen: &&Detection| seen.score >= search::SURE && !prominence::is_among(seen, faces);
    suppression::best_only(detections.iter().filter(is_further).copied().collect()).len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RegionOfInterest;

    /// A face in the middle of the picture, so large as a share of it.
    fn face(size: f32, confidence: f32) -> Face {
        let corners = [0.5 - size / 2.0, 0.5 + size / 2.0].map(|at| [at, at, 0.0]);
        let region = RegionOfInterest { centre: [0.5; 2], size: [size; 2], rotation_rad: 0.0 };
        Face { score: confidence, presence: 1.0, confidence, landmarks: corners.to_vec(), region }
    }

    #[test]
    fn doubt_outranks_prominence() {
        let mut faces =
            vec![face(0.9, 0.79), face(0.8, 0.89), face(0.1, 0.9), face(0.3, 0.8), face(0.2, 0.99), face(0.1, 0.7)];
        rank(&mut faces, PictureSize { width: 100.0, height: 100.0 });
        let order: Vec<f32> = faces.iter().map(|face| face.confidence).collect();
        assert_eq!(order, [0.99, 0.9, 0.89, 0.8, 0.79, 0.7]);
    }
}
