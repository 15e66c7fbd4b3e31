mod fitting;
mod joint_fit;
mod observed;
mod pose_fit;
mod turned;
mod views;

use glam::{DMat3, DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::camera::Camera;
use crate::irises::eye_centres;
use crate::size::Scale;
use crate::{CardCorners, FaceError, LANDMARK_COUNT, Observation, PhotoLens, Triangulation};
use fitting::Fitted;
pub use joint_fit::{LeftOut, Reprojection, depth_bias_m};
pub use observed::check_landmarks;
use observed::{PhotoInput, check_count};
pub(crate) use observed::{fit_canonical_to, in_px};
pub use pose_fit::PoseFit;
pub use views::{MAX_PHOTOS, View};

/// A metric, coloured and textured triangle mesh of a face from one or more photos.
///
/// The model's frame is that of the canonical face: metres, right-handed, +Y up, +Z out of the face, +X to the
/// subject's left. The pose is removed, so the face looks along +Z. Perspective is removed too: seen by
/// [`Self::camera`], landmarks that face it coincide with the photo. The size comes from a card, from the irises and the
/// canonical head or, if the irises are not visible, from the canonical head.
#[derive(Debug, Clone)]
pub struct FaceModel {
    triangulation: Triangulation,
    topology: Topology,
    positions_m: Vec<DVec3>,
    irises_m: Vec<DVec3>,
    positions_image: Vec<DVec3>,
    image_from_model: DMat3,
    scale: Scale,
    /// The lead photo first, then the others in input order.
    views: Vec<View>,
}

impl FaceModel {
    /// Builds a model from the landmarks and colours of one photo.
    ///
    /// The fit is a weighted Procrustes problem over MediaPipe's 33 weighted landmarks, each unprojected on its ray
    /// from the camera: px, (x·W, −y·H, −z·W). As in MediaPipe, the transform from the canonical face to the picture is
    /// estimated and then inverted. Unless the lens is [`PhotoLens::Parallel`], depths are regularised towards the
    /// canonical face's δ-coordinates, and the errors of a turned head are corrected.
    ///
    /// # Errors
    /// [`FaceError`] if there are not 468 or 478 landmarks and 468 colours, a number is not finite, the picture has no
    /// area, the lens is invalid, the weighted landmarks are collinear, or the corners of the card are not those of a card.
    pub fn new(observation: Observation, triangulation: Triangulation) -> Result<Self, FaceError> {
        let fitted = Fitted::new(PhotoInput::of(&observation))?;
        check_count("colours", LANDMARK_COUNT, observation.colours_srgb.len())?;
        let view = View::new(observation, (0, fitted.camera, Reprojection::default()));
        Ok(Self::from_fitted(triangulation, fitted, vec![view]))
    }

    fn from_fitted(triangulation: Triangulation, fitted: Fitted, views: Vec<View>) -> Self {
        let Fitted { mut positions_m, scale, image_from_model, .. } = fitted;
        let irises_m = positions_m.split_off(LANDMARK_COUNT);
        let landmarks = views[0].observation.landmarks[..LANDMARK_COUNT].iter();
        let positions_image = landmarks.map(|p| DVec3::from(p.map(f64::from))).collect();
        let topology = triangulation.topology();
        Self { triangulation, topology, positions_m, irises_m, positions_image, image_from_model, scale, views }
    }

    /// Changes the triangulation of the landmarks.
    pub fn set_triangulation(&mut self, triangulation: Triangulation) {
        (self.triangulation, self.topology) = (triangulation, triangulation.topology());
    }

    /// Triangulation of the landmarks.
    pub fn triangulation(&self) -> Triangulation {
        self.triangulation
    }

    /// Topology of the mesh of 468 landmarks.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Width and height in px of the upright picture in which the landmarks were found.
    pub fn photo_size_px(&self) -> [u32; 2] {
        self.views[0].observation.photo_size_px
    }

    /// 468 positions in metres, in the model's frame.
    pub fn positions_m(&self) -> &[DVec3] {
        &self.positions_m
    }

    /// Iris points in the model's frame: five of the right iris, then five of the left, each its centre and four on the
    /// border ([`iris_id`](crate::iris_id)). Empty if irises were not detected.
    pub fn irises_m(&self) -> &[DVec3] {
        &self.irises_m
    }

    /// Centres of the right and the left eye in the model's frame, which do not move with the gaze.
    pub fn eye_centres_m(&self) -> [DVec3; 2] {
        eye_centres(&self.positions_m)
    }

    /// 468 positions in MediaPipe's normalised coordinates (x/W, y/H, z/W), as in the paper.
    pub fn positions_image(&self) -> &[DVec3] {
        &self.positions_image
    }

    /// The input landmarks, with the irises if detected, unchanged bit for bit.
    pub fn landmarks(&self) -> &[[f32; 3]] {
        &self.views[0].observation.landmarks
    }

    /// Linear map from a displacement in the model, in metres, to one in the coordinates of [`Self::positions_image`],
    /// at the centre of the face.
    pub fn image_from_model(&self) -> DMat3 {
        self.image_from_model
    }

    /// The camera that took the photo.
    pub fn camera(&self) -> &Camera {
        &self.views[0].camera
    }

    /// The camera at another distance from the face's centre; the face keeps its position and size in the photo
    /// ([`Camera::at_distance`]).
    pub fn seen_from(&self, distance_m: f64) -> Camera {
        let middle_m = self.positions_m.iter().sum::<DVec3>() / self.positions_m.len() as f64;
        self.camera().at_distance(distance_m, middle_m)
    }

    /// Lens of the photo, as passed.
    pub fn lens(&self) -> PhotoLens {
        self.views[0].observation.lens
    }

    /// Corners of the card that measures the face.
    pub fn card(&self) -> Option<CardCorners> {
        self.views[0].observation.card
    }

    /// Source and accuracy of the face's size.
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// 468 sRGB colours: the photo's pixel at each landmark.
    pub fn colours_srgb(&self) -> &[[u8; 3]] {
        &self.views[0].observation.colours_srgb
    }

    /// 468 texture coordinates in the upright picture, origin at the top left; outside 0..=1 for landmarks outside the
    /// picture.
    pub fn uvs(&self) -> &[DVec2] {
        &self.views[0].uvs
    }

    /// sRGB colours of a subdivided mesh whose first vertices are the landmarks. Added vertices sample
    /// [`Self::picture`] at `uvs`, possibly at a lower resolution than the photo's. `None` without a picture.
    pub fn colours_under(&self, uvs: &[DVec2]) -> Option<Vec<[u8; 3]>> {
        let picture = self.picture()?;
        let added = uvs.iter().skip(LANDMARK_COUNT).map(|uv| picture.colour_under(uv.x, uv.y));
        Some(self.colours_srgb().iter().copied().chain(added).collect())
    }

    /// The upright picture, if the model was built with its pixels.
    pub fn picture(&self) -> Option<&Photo> {
        self.views[0].observation.picture.as_ref()
    }
}
