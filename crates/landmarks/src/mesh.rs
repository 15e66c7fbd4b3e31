//! The landmark networks: map a face region to landmarks and a face flag.

use rosto_photo::Photo;

use crate::LandmarksError;
use crate::attention::Attention;
use crate::detector::sigmoid;
use crate::network::Network;
use crate::outline::Outline;
use crate::raw_mesh::{LANDMARK_COUNT, NAME, RawMesh, SIDE};
use crate::region_of_interest::{PictureSize, RegionOfInterest, RegionPx};
use crate::warp::{self, Outside};

/// Output of the landmark network for a region.
pub(crate) struct Mesh {
    /// Probability of a face, 0..1.
    pub(crate) presence: f32,
    /// x/W, y/H, z/W.
    pub(crate) landmarks: Vec<[f32; 3]>,
}

/// A landmark network, as its ONNX file.
#[derive(Debug, Clone, Copy)]
pub enum LandmarkNetwork<'a> {
    /// `face_landmarks.onnx`: the 468 landmarks.
    Plain(&'a [u8]),
    /// `face_landmarks_attention.onnx`: 478 points, with refined lips and eyes and with the irises.
    Attention(&'a [u8]),
}

/// A landmark network with its pre- and post-processing.
pub(crate) struct MeshNetwork {
    network: Kind,
}

enum Kind {
    Plain(Network),
    Attention(Attention),
}

/// Scale and offset from u8 to 0..1.
const SCALE_AND_OFFSET: [f32; 2] = [1.0 / 255.0, 0.0];
/// Outer corners of the eyes, on the picture's left and right; they define a face's horizontal.
pub(crate) const EYE_CORNERS: [usize; 2] = [33, 263];

impl MeshNetwork {
    pub(crate) fn new(network: LandmarkNetwork<'_>) -> Result<Self, LandmarksError> {
        let network = match network {
            LandmarkNetwork::Plain(onnx) => {
                Kind::Plain(Network::of_picture(NAME, onnx, SIDE, &["conv2d_21", "conv2d_31"])?)
            }
            LandmarkNetwork::Attention(onnx) => Kind::Attention(Attention::new(onnx)?),
        };
        Ok(Self { network })
    }

    /// Runs on a region of the picture.
    pub(crate) fn look(&self, photo: &Photo, region: &RegionOfInterest) -> Result<Mesh, LandmarksError> {
        let RawMesh { points, flag } = self.raw(photo, region)?;
        let landmarks: Vec<[f32; 3]> = points.into_iter().map(|point| in_picture(point, region)).collect();
        // A damaged network's finite outputs can overflow here.
        Network::check_finite(NAME, landmarks.as_flattened().iter())?;
        Ok(Mesh { presence: sigmoid(flag), landmarks })
    }

    /// Returns the network's raw output.
    pub(crate) fn raw(&self, photo: &Photo, region: &RegionOfInterest) -> Result<RawMesh, LandmarksError> {
        let region_px = region.px(PictureSize::of(photo));
        let fill = |planes: &mut [f32]| fill_planes(planes, photo, &region_px);
        match &self.network {
            Kind::Plain(network) => {
                let [points, flag] = network.run(|_, planes| fill(planes), [LANDMARK_COUNT * 3, 1])?;
                Ok(RawMesh { points: points.as_chunks::<3>().0.to_vec(), flag: flag[0] })
            }
            Kind::Attention(attention) => attention.run(fill),
        }
    }
}

fn fill_planes(planes: &mut [f32], photo: &Photo, region: &RegionPx) {
    warp::fill_planes(planes, photo, region, Outside::NearestEdge, SCALE_AND_OFFSET);
}

/// Maps px of the network's input to normalised coordinates of the picture.
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

/// The region given by landmarks: around all of them, rotated so that the eyes are level.
pub(crate) fn region_of(landmarks: &[[f32; 3]], picture: PictureSize) -> RegionOfInterest {
    let outline = Outline::around(landmarks.iter().map(|&[x, y, _]| [x, y]));
    let eyes = EYE_CORNERS.map(|corner| [landmarks[corner][0], landmarks[corner][1]]);
    RegionOfInterest::around(outline, eyes, picture)
}
