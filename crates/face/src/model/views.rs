//! The photos of a face model.

use glam::{DVec2, DVec3};
use rosto_photo::Photo;

use super::fitting::Fitted;
use super::joint_fit::{self, JointFit, LeftOut, PhotoInput, Reprojection};
use super::{FaceInput, FaceModel, check_count};
use crate::camera::Camera;
use crate::{FaceError, LANDMARK_COUNT, PhotoLens, Triangulation};

/// Largest number of photos of one face.
pub const MAX_PHOTOS: usize = 5;

/// A photo of a face.
#[derive(Debug, Clone)]
pub struct View {
    /// Index of the photo, in input order.
    pub photo: usize,
    /// The upright picture, possibly a scaled-down copy.
    pub picture: Photo,
    /// Width and height in px of the upright picture in which the landmarks were found.
    pub photo_size_px: [u32; 2],
    /// The input landmarks, with the irises if detected, unchanged bit for bit.
    pub landmarks: Vec<[f32; 3]>,
    /// Texture coordinates of the 468 landmarks, x/W and y/H, origin at the top left.
    pub uvs: Vec<DVec2>,
    /// The camera, in px of [`Self::photo_size_px`].
    pub camera: Camera,
    /// Lens data of the photo, as passed.
    pub lens: PhotoLens,
    /// 468 sRGB colours: the photo's pixel at each landmark.
    pub colours_srgb: Vec<[u8; 3]>,
    /// Reprojection error of the model; 0 for the lead photo, with which the model coincides.
    pub reprojection: Reprojection,
}

impl FaceModel {
    /// Builds a model from 1 to [`MAX_PHOTOS`] photos, which may differ in expression, distance and lens.
    ///
    /// The lead photo is the most frontal one, among those that show the face at least half as large as the largest.
    /// Its landmarks, colours, picture, lens and size are the model's, and the model coincides with it as for a single
    /// photo. The other photos determine the depths along its rays. The displacements z and the other cameras π
    /// minimise
    ///
    /// `Σₖ Σᵢ wₖᵢ ρ(|πₖ(xᵢ + (zᵢ + dᵢ) rᵢ) − sₖᵢ| / σₖ) + |z / 20 mm|² + |L z / 0.15 mm|²`
    ///
    /// x is the shape from the lead photo alone, r its rays, s the observations in the other photos, ρ a robust cost, σ
    /// the estimated errors, d the network's bias on turned heads ([`depth_bias_m`](crate::depth_bias_m)), and L the
    /// random-walk graph Laplacian. If the other photos give no information, the δ-coordinates are preserved.
    /// Landmarks that face away, and parts that move with the expression, weigh less; photos from one direction weigh
    /// as one. `docs/several-photos.md` has the measured accuracy.
    ///
    /// The order of the photos does not matter, except that the first of equally frontal photos leads.
    ///
    /// # Errors
    /// [`FaceError::PhotoCount`] for no photos or too many, [`FaceError::InPhoto`] with the error of [`Self::new`] for
    /// one photo, and [`FaceError::AnotherFace`] for a photo that shows another face.
    pub fn from_photos(inputs: Vec<FaceInput<'_>>, triangulation: Triangulation) -> Result<Self, FaceError> {
        if !(1..=MAX_PHOTOS).contains(&inputs.len()) {
            return Err(FaceError::PhotoCount { found: inputs.len(), most: MAX_PHOTOS });
        }
        for (photo, input) in inputs.iter().enumerate() {
            check_count("colours", LANDMARK_COUNT, input.colours.len())
                .map_err(|reason| FaceError::InPhoto { photo, reason: Box::new(reason) })?;
        }
        let photo_inputs: Vec<PhotoInput<'_>> = inputs.iter().map(PhotoInput::of).collect();
        let JointFit { lead, fitted, others: mut seen } = joint_fit::fit(&photo_inputs)?;
        seen.insert(lead, (lead, fitted.camera, Reprojection::default()));
        let mut views: Vec<View> = inputs.into_iter().zip(seen).map(|(input, seen)| View::new(input, seen)).collect();
        views[..=lead].rotate_right(1);
        Ok(Self::from_fitted(triangulation, fitted, views))
    }

    /// Adds a photo after the existing ones. The result is the same as with [`Self::from_photos`].
    ///
    /// # Errors
    /// See [`Self::from_photos`].
    pub fn with_photo(&self, input: FaceInput<'_>) -> Result<Self, FaceError> {
        let inputs = self.inputs().into_iter().chain([input]);
        Self::from_photos(inputs.collect(), self.triangulation)
    }

    /// Removes a photo, by its index in input order. The result is the same as with [`Self::from_photos`]; an unknown
    /// index has no effect.
    ///
    /// # Errors
    /// See [`Self::from_photos`]; [`FaceError::PhotoCount`] for the only photo.
    pub fn without_photo(&self, photo: usize) -> Result<Self, FaceError> {
        let inputs = self.inputs().into_iter().enumerate();
        let others = inputs.filter(|(other, _)| *other != photo).map(|(_, input)| input);
        Self::from_photos(others.collect(), self.triangulation)
    }

    /// Changes the lens of the lead photo. The shape is refitted to all photos; the others keep their lenses.
    ///
    /// # Errors
    /// [`FaceError::Lens`] if the lens is invalid.
    pub fn with_lens(&self, lens: PhotoLens) -> Result<Self, FaceError> {
        let (fitted, others) = match self.views() {
            [only] => (Fitted::new(&only.landmarks, only.photo_size_px, lens)?, Vec::new()),
            _ => {
                let JointFit { fitted, others, .. } = joint_fit::fit(&self.photo_inputs(lens))?;
                (fitted, others)
            }
        };
        let mut views = self.views.clone();
        (views[0].lens, views[0].camera) = (lens, fitted.camera);
        for (view, (_, camera, reprojection)) in views[1..].iter_mut().zip(others) {
            (view.camera, view.reprojection) = (camera, reprojection);
        }
        Ok(Self::from_fitted(self.triangulation, fitted, views))
    }

    /// The photos of the face: the lead photo first, then the others in input order.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// The original inputs, in input order.
    fn inputs(&self) -> Vec<FaceInput<'_>> {
        let mut views: Vec<&View> = self.views.iter().collect();
        views.sort_by_key(|view| view.photo);
        views.into_iter().map(View::input).collect()
    }

    /// Leaves out each photo in turn, and measures how well the others predict it; empty for fewer than three.
    ///
    /// # Errors
    /// See [`Self::from_photos`].
    pub fn left_out(&self) -> Result<Vec<LeftOut>, FaceError> {
        joint_fit::left_out(&self.photo_inputs(self.lens()))
    }

    /// Facts about each photo in input order, with `lens` for the lead photo.
    fn photo_inputs(&self, lens: PhotoLens) -> Vec<PhotoInput<'_>> {
        let mut inputs: Vec<PhotoInput<'_>> = self.inputs().iter().map(PhotoInput::of).collect();
        inputs[self.views[0].photo].lens = lens;
        inputs
    }
}

impl<'a> PhotoInput<'a> {
    fn of(input: &FaceInput<'a>) -> Self {
        Self { landmarks: input.landmarks, size_px: [input.width, input.height], lens: input.lens }
    }
}

impl View {
    pub(super) fn new(input: FaceInput<'_>, (photo, camera, reprojection): (usize, Camera, Reprojection)) -> Self {
        let uv = |p: &[f32; 3]| DVec3::from(p.map(f64::from)).truncate();
        Self {
            photo,
            picture: input.picture,
            photo_size_px: [input.width, input.height],
            landmarks: input.landmarks.to_vec(),
            uvs: input.landmarks[..LANDMARK_COUNT].iter().map(uv).collect(),
            camera,
            lens: input.lens,
            colours_srgb: input.colours.to_vec(),
            reprojection,
        }
    }

    fn input(&self) -> FaceInput<'_> {
        FaceInput {
            landmarks: &self.landmarks,
            width: self.photo_size_px[0],
            height: self.photo_size_px[1],
            colours: &self.colours_srgb,
            picture: self.picture.clone(),
            lens: self.lens,
        }
    }
}
