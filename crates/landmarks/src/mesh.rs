//! The landmark network: a face region → 468 points and how sure it is that there is a face.

use rosto_photo::Photo;

use crate::LandmarksError;
use crate::detector::sigmoid;
use crate::network::Network;
use crate::region_of_interest::{PictureSize, RegionOfInterest};
use crate::warp::{self, Outside};

/// Number of landmarks of a face.
pub const LANDMARK_COUNT: usize = 468;

/// What the network says of one region.
pub(crate) struct Mesh {
    /// That there is a face, 0..1.
    pub(crate) presence: f32,
    /// x/W, y/H, z/W.
    pub(crate) landmarks: Vec<[f32; 3]>,
}

/// The landmark network with what surrounds it.
pub(crate) struct MeshNetwork {
    network: Network,
}

const SIDE: usize = 192;
/// u8 to 0..1.
const SCALE_AND_OFFSET: [f32; 2] = [1.0 / 255.0, 0.0];
/// Outer corners of the eyes, on the picture's left and right: the horizontal of a face.
const EYE_CORNERS: [usize; 2] = [33, 263];

impl MeshNetwork {
    pub(crate) fn new(onnx: &[u8]) -> Result<Self, LandmarksError> {
        Ok(Self { network: Network::new("landmark", onnx, SIDE, ["conv2d_21", "conv2d_31"])? })
    }

    /// Looks at one region of the picture.
    pub(crate) fn look(&self, photo: &Photo, region: &RegionOfInterest) -> Result<Mesh, LandmarksError> {
        let [points, flag] = self.raw(photo, region)?;
        let landmarks: Vec<[f32; 3]> =
            points.as_chunks::<3>().0.iter().map(|&point| in_picture(point, region)).collect();
        // Numbers of a damaged network may be finite and leave the numbers here.
        self.network.check_finite(landmarks.as_flattened().iter())?;
        Ok(Mesh { presence: sigmoid(flag[0]), landmarks })
    }

    /// The network's outputs, undecoded: points `[468, 3]` in px of its input, and the logit of the face flag.
    pub(crate) fn raw(&self, photo: &Photo, region: &RegionOfInterest) -> Result<[Vec<f32>; 2], LandmarksError> {
        let region_px = region.px(PictureSize::of(photo));
        let fill =
            |planes: &mut [f32]| warp::fill_planes(planes, photo, &region_px, Outside::NearestEdge, SCALE_AND_OFFSET);
        self.network.run(fill, [LANDMARK_COUNT * 3, 1])
    }
}

/// From px of the network's input to the picture's normalised coordinates.
fn in_picture(point: [f32; 3], region: &RegionOfInterest) -> [f32; 3] {
    let [x, y, z] = point.map(|value| value / SIDE as f32);
    let (dx, dy) = (x - 0.5, y - 0.5);
    let (sin, cos) = (region.rotation_rad.sin(), region.rotation_rad.cos());
    [
        (cos * dx - sin * dy) * region.size[0] + region.centre[0],
        (sin * dx + cos * dy) * region.size[1] + region.centre[1],
        z * region.size[0],
    ]
}

/// The region that landmarks themselves suggest: around all of them, the eyes level.
pub(crate) fn region_of(landmarks: &[[f32; 3]], picture: PictureSize) -> RegionOfInterest {
    let along = |axis: usize| landmarks.iter().map(move |landmark| landmark[axis]);
    let min = [0, 1].map(|axis| along(axis).fold(f32::INFINITY, f32::min));
    let max = [0, 1].map(|axis| along(axis).fold(f32::NEG_INFINITY, f32::max));
    let size = [0, 1].map(|axis| max[axis] - min[axis]);
    let centre = [0, 1].map(|axis| min[axis] + size[axis] / 2.0);
    RegionOfInterest::around(
        centre,
        size,
        EYE_CORNERS.map(|corner| [landmarks[corner][0], landmarks[corner][1]]),
        picture,
    )
}
