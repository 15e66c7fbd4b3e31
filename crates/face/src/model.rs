use glam::{DAffine3, DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::procrustes::{self, Pair, Similarity};
use crate::tables::PROCRUSTES;
use crate::{FaceError, LANDMARK_COUNT, Triangulation, canonical_positions_m};

/// What a model is made from.
#[derive(Debug)]
pub struct FaceInput<'a> {
    /// 468 landmarks in MediaPipe's normalised convention: x/W, y/H, z/W, x to the right, y down, z away.
    pub landmarks: &'a [[f32; 3]],
    /// Width in px of the upright picture that the landmarks were found in.
    pub width: u32,
    /// Height in px of that picture.
    pub height: u32,
    /// 468 sRGB colours: the pixel under each landmark at full resolution, as in the paper.
    pub colours: &'a [[u8; 3]],
    /// The upright picture for the texture; it may be a scaled-down copy.
    pub picture: Photo,
}

/// A face from one photo: a metric, coloured and textured triangle mesh.
///
/// The model's frame is the canonical face's: metres, right-handed, +Y up, +Z out of the face towards the viewer, the
/// subject's left towards +X. The head's pose is taken out: the face looks along +Z, upright, however the photo was
/// tilted. Its size is the canonical head's, since a photo does not say how large a head is.
#[derive(Debug, Clone)]
pub struct FaceModel {
    triangulation: Triangulation,
    topology: Topology,
    photo_size_px: [u32; 2],
    positions_m: Vec<DVec3>,
    positions_image: Vec<DVec3>,
    image_from_model: DAffine3,
    colours_srgb: Vec<[u8; 3]>,
    uvs: Vec<DVec2>,
    picture: Photo,
}

impl FaceModel {
    /// Fits the landmarks into the canonical face's frame and takes the photo's colours along.
    ///
    /// The fit is the weighted Procrustes problem over MediaPipe's 33 weighted landmarks in px, (x·W, −y·H, −z·W),
    /// estimated from the canonical face to the picture as MediaPipe does, then inverted.
    ///
    /// # Errors
    /// [`FaceError`] if there are not 468 landmarks and colours, if one is not finite, if the picture has no area, or
    /// if the weighted landmarks lie on one line.
    pub fn new(input: FaceInput<'_>, triangulation: Triangulation) -> Result<Self, FaceError> {
        check_count("landmarks", input.landmarks.len())?;
        check_count("colours", input.colours.len())?;
        let (px, px_from_model) = fit(input.landmarks, input.width, input.height)?;
        let positions_image: Vec<DVec3> = input.landmarks.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let px_from_image = px_from_image(input.width, input.height);
        let model_from_px = px_from_model.inverse();
        Ok(Self {
            triangulation,
            topology: triangulation.topology(),
            photo_size_px: [input.width, input.height],
            positions_m: px.iter().map(|&p| model_from_px.apply(p)).collect(),
            image_from_model: px_from_image.inverse() * px_from_model.to_affine(),
            colours_srgb: input.colours.to_vec(),
            uvs: positions_image.iter().map(|p| p.truncate()).collect(),
            positions_image,
            picture: input.picture,
        })
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
        self.photo_size_px
    }

    /// 468 positions in metres in the model's frame.
    pub fn positions_m(&self) -> &[DVec3] {
        &self.positions_m
    }

    /// 468 positions in MediaPipe's normalised convention (x/W, y/H, z/W), the paper's coordinates.
    pub fn positions_image(&self) -> &[DVec3] {
        &self.positions_image
    }

    /// The map from the model's metres to the coordinates of [`Self::positions_image`].
    pub fn image_from_model(&self) -> DAffine3 {
        self.image_from_model
    }

    /// 468 sRGB colours, the photo's pixel under each landmark.
    pub fn colours_srgb(&self) -> &[[u8; 3]] {
        &self.colours_srgb
    }

    /// 468 texture coordinates in the upright picture, origin at the top left. A landmark outside the picture is
    /// outside 0..=1.
    pub fn uvs(&self) -> &[DVec2] {
        &self.uvs
    }

    /// The photo's sRGB colours under other texture coordinates than the landmarks', as a denser mesh has them; taken
    /// from [`Self::picture`], whose resolution may be lower than the photo's.
    pub fn colours_under(&self, uvs: &[DVec2]) -> Vec<[u8; 3]> {
        uvs.iter().map(|uv| self.picture.colour_under(uv.x, uv.y)).collect()
    }

    /// The upright picture.
    pub fn picture(&self) -> &Photo {
        &self.picture
    }
}

/// Whether landmarks found in a picture of that size, in px, are those of a face that [`FaceModel::new`] takes.
///
/// # Errors
/// As [`FaceModel::new`].
pub fn check_landmarks(landmarks: &[[f32; 3]], width: u32, height: u32) -> Result<(), FaceError> {
    fit(landmarks, width, height).map(|_| ())
}

fn check_count(what: &'static str, found: usize) -> Result<(), FaceError> {
    match found {
        LANDMARK_COUNT => Ok(()),
        _ => Err(FaceError::WrongCount { what, expected: LANDMARK_COUNT, found }),
    }
}

/// The landmarks in px, and the map to them from the model's metres.
fn fit(landmarks: &[[f32; 3]], width: u32, height: u32) -> Result<(Vec<DVec3>, Similarity), FaceError> {
    check_count("landmarks", landmarks.len())?;
    if width == 0 || height == 0 {
        return Err(FaceError::EmptyPicture { width, height });
    }
    if let Some(landmark) = landmarks.iter().position(|p| !p.iter().all(|c| c.is_finite())) {
        return Err(FaceError::NotFinite { landmark });
    }
    let px_from_image = px_from_image(width, height);
    let px: Vec<DVec3> =
        landmarks.iter().map(|p| px_from_image.transform_point3(DVec3::from(p.map(f64::from)))).collect();
    let px_from_model = fit_canonical_to(&px)?;
    Ok((px, px_from_model))
}

/// From MediaPipe's normalised coordinates to right-handed px: y up, z towards the viewer.
fn px_from_image(width: u32, height: u32) -> DAffine3 {
    let (width, height) = (f64::from(width), f64::from(height));
    DAffine3::from_scale(DVec3::new(width, -height, -width))
}

fn fit_canonical_to(px: &[DVec3]) -> Result<Similarity, FaceError> {
    let canonical = canonical_positions_m();
    let pairs: Vec<Pair> = PROCRUSTES
        .iter()
        .map(|&(landmark, weight)| {
            let landmark = usize::from(landmark);
            Pair { source: canonical[landmark], target: px[landmark], weight }
        })
        .collect();
    procrustes::fit(&pairs)
}
