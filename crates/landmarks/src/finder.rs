use rosto_photo::Photo;

use crate::detection::Detection;
use crate::detector::Detector;
use crate::face::Face;
use crate::mesh::{LandmarkNetwork, Mesh, MeshNetwork};
use crate::pyramid::Pyramid;
use crate::region_of_interest::{PictureSize, RegionPx};
use crate::verification::Verifier;
use crate::{LandmarksError, prominence, search, suppression};

/// Finds faces in pictures. Prepares the networks once.
pub struct FaceFinder {
    pub(crate) detector: Detector,
    pub(crate) mesh: MeshNetwork,
}

/// Search options. The default is thorough; [`Self::mediapipe`] reproduces MediaPipe.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FindOptions {
    /// Maximum number of faces; 20 by default. Faces that come first are returned.
    pub max_faces: usize,
    /// Extent of the search.
    pub search: Search,
}

/// Extent of the search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Search {
    /// As MediaPipe processes single pictures: one pass of the detector over the whole picture, then one pass of the
    /// landmark network per detection, which decides whether it is a face. Finds faces rotated by up to about 90° that
    /// fill at least an eighth of the picture. Sorted by detector score.
    Once,
    /// Searches rotations and tiles of the picture at several sizes, repeats the landmark network until its output
    /// converges, and requires both networks to agree ([`Face::confidence`]). Finds faces at any rotation, down to
    /// about 15 px between the eyes. Faces with a confidence of at least 0.9 come first, then those of at least 0.8.
    /// Each group is sorted by prominence, which favours large faces near the centre.
    #[default]
    Thorough,
}

/// Faces found in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundFaces {
    /// At most [`FindOptions::max_faces`] faces, in the order of [`Search`].
    pub faces: Vec<Face>,
    /// Lower bound on the number of faces in the picture; exceeds `faces.len()` if the limit omitted faces.
    pub at_least: usize,
}

/// Progress of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stage {
    /// The detector is running.
    Detecting {
        /// Completed fraction of the detection, 0..1; does not decrease.
        share: f32,
    },
    /// The landmark network is running on a detection.
    Meshing {
        /// Index of the detection.
        face: usize,
        /// Number of detections.
        of: usize,
    },
}

/// Least presence of a face, as in MediaPipe.
pub(crate) const MIN_PRESENCE: f32 = 0.5;
/// Least confidence of a face. In the scenes of docs/accuracy.md, correct meshes reach at least 0.8, except for faces
/// largely cut off by the border.
const MIN_CONFIDENCE: f32 = 0.7;

impl Default for FindOptions {
    fn default() -> Self {
        Self { max_faces: 20, search: Search::Thorough }
    }
}

impl FindOptions {
    /// MediaPipe's static image mode: one detector pass, one landmark pass, one face.
    pub fn mediapipe() -> Self {
        Self { max_faces: 1, search: Search::Once }
    }
}

impl FaceFinder {
    /// Prepares the networks from their ONNX files.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkDamaged`] if a file is not a valid network of its kind.
    pub fn new(detector_onnx: &[u8], landmarks: LandmarkNetwork<'_>) -> Result<Self, LandmarksError> {
        Ok(Self { detector: Detector::new(detector_onnx)?, mesh: MeshNetwork::new(landmarks)? })
    }

    /// Returns the faces in a picture, in the order of [`Search`]; an empty list if there are none.
    ///
    /// # Errors
    /// [`LandmarksError::NetworkFailed`] if a network cannot be run, [`LandmarksError::NetworkDamaged`] if its output
    /// is not finite.
    pub fn find(&self, photo: &Photo, options: &FindOptions) -> Result<Vec<Face>, LandmarksError> {
        Ok(self.find_with_progress(photo, options, |_| ())?.faces)
    }

    /// [`Self::find`] with a lower bound on the number of faces. Calls `report` before each stage.
    ///
    /// # Errors
    /// The errors of [`Self::find`].
    pub fn find_with_progress(
        &self,
        photo: &Photo,
        options: &FindOptions,
        mut report: impl FnMut(Stage),
    ) -> Result<FoundFaces, LandmarksError> {
        report(Stage::Detecting { share: 0.0 });
        match options.search {
            Search::Once => self.find_once(photo, options.max_faces, report),
            Search::Thorough => self.find_thoroughly(photo, options.max_faces, report),
        }
    }

    fn find_once(
        &self,
        photo: &Photo,
        max_faces: usize,
        mut report: impl FnMut(Stage),
    ) -> Result<FoundFaces, LandmarksError> {
        let picture = PictureSize::of(photo);
        let mut detections = self.detector.detect(photo, &RegionPx::whole(picture))?;
        let omitted = detections.split_off(max_faces.min(detections.len()));
        let mut faces = Vec::with_capacity(detections.len());
        for (index, detection) in detections.iter().enumerate() {
            report(Stage::Meshing { face: index, of: detections.len() });
            let region = detection.face_region(picture);
            let Mesh { presence, landmarks } = self.mesh.look(photo, &region)?;
            faces.push(Face { score: detection.score, presence, confidence: presence, landmarks, region });
        }
        faces.retain(|face| face.presence > MIN_PRESENCE);
        let at_least = faces.len() + count_others(&omitted, &faces);
        Ok(FoundFaces { faces, at_least })
    }

    fn find_thoroughly(
        &self,
        photo: &Photo,
        max_faces: usize,
        mut report: impl FnMut(Stage),
    ) -> Result<FoundFaces, LandmarksError> {
        let pyramid = Pyramid::new(photo);
        let verifier = Verifier { detector: &self.detector, mesh: &self.mesh, pyramid: &pyramid };
        let proposals =
            search::proposals(&self.detector, &pyramid, max_faces, |share| report(Stage::Detecting { share }))?;
        let stopped_early = proposals.iter().filter(|seen| seen.score >= search::CONFIDENT_SCORE).count() >= max_faces;
        let found = verified(&verifier, proposals, max_faces, &mut report)?;
        // Proposals that ended the search early can turn out not to be faces; then search the whole picture.
        if stopped_early && certain_count(&found.faces) < max_faces {
            let proposals = search::proposals(&self.detector, &pyramid, usize::MAX, |_| ())?;
            return verified(&verifier, proposals, max_faces, &mut |_| ());
        }
        Ok(found)
    }
}

/// Verifies proposals in the order of prominence until enough faces are certain.
fn verified(
    verifier: &Verifier<'_>,
    mut proposals: Vec<Detection>,
    max_faces: usize,
    report: &mut impl FnMut(Stage),
) -> Result<FoundFaces, LandmarksError> {
    let picture = PictureSize::of(verifier.pyramid.photo);
    prominence::sort(&mut proposals, picture, Detection::outline);
    let (mut faces, mut processed) = (Vec::<Face>::new(), 0);
    while processed < proposals.len() && certain_count(&faces) < max_faces {
        let proposal = &proposals[processed];
        report(Stage::Meshing { face: processed, of: proposals.len() });
        processed += 1;
        if !prominence::is_known(proposal, &faces) {
            let face = verifier.face(proposal)?;
            faces = prominence::add(faces, face.filter(|face| face.confidence > MIN_CONFIDENCE));
        }
    }
    let at_least = faces.len() + count_others(&proposals[processed..], &faces);
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

/// Number of high-scoring detections that are not among `faces`.
fn count_others(detections: &[Detection], faces: &[Face]) -> usize {
    let is_other = |seen: &&Detection| seen.score >= search::CONFIDENT_SCORE && !prominence::is_known(seen, faces);
    suppression::best_only(detections.iter().filter(is_other).copied().collect()).len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RegionOfInterest;

    /// A face in the centre of the picture, `size` as a fraction of its extent.
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
