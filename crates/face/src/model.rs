mod fitting;
mod seen;
mod several;
mod pose_fit;
mod views;

use glam::{DMat3, DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::camera::Camera;
use crate::irises::eye_centres;
use crate::size::Scale;
use crate::{FaceError, LANDMARK_COUNT, PhotoLens, Triangulation};
use fitting::Fitted;
use seen::check_count;
pub use seen::check_landmarks;
pub use several::{LeftOut, Reprojection, drawn_out_m};
pub use pose_fit::PoseFit;
pub use views::{MOST_PHOTOS, View};

/// What a model is made from.
#[derive(Debug)]
pub struct FaceInput<'a> {
    /// 468 landmarks, or 478 with the irises, in MediaPipe's normalised convention: x/W, y/H, z/W, x to the right, y down,
    /// z away.
    pub landmarks: &'a [[f32; 3]],
    /// Width in px of the upright picture that the landmarks were found in.
    pub width: u32,
    /// Height in px of that picture.
    pub height: u32,
    /// 468 sRGB colours: the pixel under each landmark at full resolution, as in the paper.
    pub colours: &'a [[u8; 3]],
    /// The upright picture for the texture; it may be a scaled-down copy.
    pub picture: Photo,
    /// Lens data.
    pub lens: PhotoLens,
}

/// A face from one photo: a metric, coloured and textured triangle mesh.
///
/// The model's frame is the canonical face's: metres, right-handed, +Y up, +Z out of the face towards the viewer, the
/// subject's left towards +X. The head's pose is taken out: the face looks along +Z, upright, however the photo was
/// tilted. What perspective did to it is taken out, too, so that the model, seen by [`Self::camera`], lies on the photo. It
/// is as large as its irises say or, where they cannot be seen, as the canonical head.
#[derive(Debug, Clone)]
pub struct FaceModel {
    triangulation: Triangulation,
    topology: Topology,
    positions_m: Vec<DVec3>,
    irises_m: Vec<DVec3>,
    positions_image: Vec<DVec3>,
    image_from_model: DMat3,
    scale: Scale,
    /// The leading photo first, then the others in input order.
    views: Vec<View>,
}

impl FaceModel {
    /// Takes the perspective out of the landmarks, fits them into the canonical face's frame and takes the photo's colours
    /// along.
    ///
    /// The fit is the weighted Procrustes problem over MediaPipe's 33 weighted landmarks in px, (x·W, −y·H, −z·W), with
    /// each on its ray from the camera, estimated from the canonical face to the picture as MediaPipe does, then inverted.
    /// Depths lean on the canonical face's δ-coordinates, unless the lens is [`PhotoLens::Parallel`].
    ///
    /// # Errors
    /// [`FaceError`] if there are not 468 or 478 landmarks and 468 colours, if a number is not finite, if the picture has no
    /// area, if there is no such lens, or if the weighted landmarks lie on one line.
    pub fn new(input: FaceInput<'_>, triangulation: Triangulation) -> Result<Self, FaceError> {
        let fitted = Fitted::new(input.landmarks, [input.width, input.height], input.lens)?;
        check_count("colours", LANDMARK_COUNT, input.colours.len())?;
        let view = View::new(input, (0, fitted.camera, Reprojection::default()));
        Ok(Self::made_of(triangulation, fitted, vec![view]))
    }

    fn made_of(triangulation: Triangulation, fitted: Fitted, views: Vec<View>) -> Self {
        let Fitted { mut positions_m, scale, image_from_model, .. } = fitted;
        let irises_m = positions_m.split_off(LANDMARK_COUNT);
        let landmarks = views[0].landmarks[..LANDMARK_COUNT].iter();
        let positions_image = landmarks.map(|p| DVec3::from(p.map(f64::from))).collect();
        let topology = triangulation.topology();
        Self { triangulation, topology, positions_m, irises_m, positions_image, image_from_model, scale, views }
    }

    /// How the landmarks are joined.
    pub fn triangulation(&self) -> Triangulation {
        self.triangulation
    }

    /// The mesh of the 468 landmarks.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Width and height in px of the upright picture that the landmarks were found in.
    pub fn photo_size_px(&self) -> [u32; 2] {
        self.views[0].photo_size_px
    }

    /// 468 positions in metres in the model's frame.
    pub fn positions_m(&self) -> &[DVec3] {
        &self.positions_m
    }

    /// The irises in the same frame: ten points, five of the right one and five of the left, each its middle and four on its
    /// border ([`iris_id`](crate::iris_id)); none if they were not looked for.
    pub fn irises_m(&self) -> &[DVec3] {
        &self.irises_m
    }

    /// The middles of the right and the left eye in the same frame, which stay when the gaze wanders.
    pub fn eye_centres_m(&self) -> [DVec3; 2] {
        eye_centres(&self.positions_m)
    }

    /// 468 positions in MediaPipe's normalised convention (x/W, y/H, z/W), the paper's coordinates.
    pub fn positions_image(&self) -> &[DVec3] {
        &self.positions_image
    }

    /// The landmarks, and the irises if they were looked for, bit for bit as they came in.
    pub fn landmarks(&self) -> &[[f32; 3]] {
        &self.views[0].landmarks
    }

    /// What a small way in the model's metres is in the coordinates of [`Self::positions_image`], in the middle of the face.
    pub fn image_from_model(&self) -> DMat3 {
        self.image_from_model
    }

    /// The camera that took the photo, and where it stood.
    pub fn camera(&self) -> &Camera {
        &self.views[0].camera
    }

    /// That camera gone back, or come nearer, to a distance from the middle of the face: the face stays where it is in the photo,
    /// as large as it is.
    pub fn seen_from(&self, distance_m: f64) -> Camera {
        let middle_m = self.positions_m.iter().sum::<DVec3>() / self.positions_m.len() as f64;
        self.camera().at_distance(distance_m, middle_m)
    }

    /// What was known of its lens.
    pub fn lens(&self) -> PhotoLens {
        self.views[0].lens
    }

    /// How well the face's size is known.
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// 468 sRGB colours, the photo's pixel under each landmark.
    pub fn colours_srgb(&self) -> &[[u8; 3]] {
        &self.views[0].colours_srgb
    }

    /// 468 texture coordinates in the upright picture, origin at the top left. A landmark outside the picture is
    /// outside 0..=1.
    pub fn uvs(&self) -> &[DVec2] {
        &self.views[0].uvs
    }

    /// The sRGB colours of a mesh whose first vertices are the landmarks, as a denser one's are: these have their own, and those
    /// added between them the photo's under their texture coordinates; taken from [`Self::picture`], whose resolution may be lower
    /// than the photo's.
    pub fn colours_under(&self, uvs: &[DVec2]) -> Vec<[u8; 3]> {
        let added = uvs.iter().skip(LANDMARK_COUNT).map(|uv| self.picture().colour_under(uv.x, uv.y));
        self.colours_srgb().iter().copied().chain(added).collect()
    }

    /// The upright picture.
    pub fn picture(&self) -> &Photo {
        &self.views[0].picture
    }
}
