//! The photos of a face model.

use glam::{DVec2, DVec3};

use super::fitting::Fitted;
use super::joint_fit::{self, JointFit, LeftOut, Reprojection};
use super::{FaceModel, PhotoInput, check_count};
use crate::camera::Camera;
use crate::{
    CardCorners, FaceError, LANDMARK_COUNT, MAX_PICTURE_SIDE_PX, Observation, Photo, PhotoLens, Triangulation,
};

/// Largest number of photos of one face.
pub const MAX_PHOTOS: usize = 5;

/// A photo of a face.
#[derive(Debug, Clone)]
pub struct View {
    /// Index of the photo, in input order.
    pub photo: usize,
    /// The face as found in the photo.
    pub observation: Observation,
    /// Texture coordinates of the 468 landmarks, x/W and y/H, origin at the top left.
    pub uvs: Vec<DVec2>,
    /// The camera, in px of the photo.
    pub camera: Camera,
    /// Reprojection error of the model; 0 for the lead photo.
    pub reprojection: Reprojection,
}

impl FaceModel {
    /// Builds a model from 1 to [`MAX_PHOTOS`] photos, which may differ in expression, distance and lens.
    ///
    /// The lead photo is the most frontal one, among those that show the face at least half as large as the largest.
    /// Its landmarks, colours, picture, lens and size are the model's, and the model matches it as for a single
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
    pub fn from_photos(photos: Vec<Observation>, triangulation: Triangulation) -> Result<Self, FaceError> {
        if !(1..=MAX_PHOTOS).contains(&photos.len()) {
            return Err(FaceError::PhotoCount { found: photos.len(), most: MAX_PHOTOS });
        }
        for (photo, observation) in photos.iter().enumerate() {
            check_count("colours", LANDMARK_COUNT, observation.colours_srgb.len())
                .map_err(|reason| FaceError::InPhoto { photo, reason: Box::new(reason) })?;
        }
        let inputs: Vec<PhotoInput<'_>> = photos.iter().map(PhotoInput::of).collect();
        let JointFit { lead, fitted, others: mut seen } = joint_fit::fit(&inputs)?;
        seen.insert(lead, (lead, fitted.camera, Reprojection::default()));
        let mut views: Vec<View> = photos.into_iter().zip(seen).map(|(photo, seen)| View::new(photo, seen)).collect();
        views[..=lead].rotate_right(1);
        Ok(Self::from_fitted(triangulation, fitted, views))
    }

    /// Adds a photo after the existing ones. The result is the same as with [`Self::from_photos`].
    ///
    /// # Errors
    /// See [`Self::from_photos`].
    pub fn with_photo(&self, photo: Observation) -> Result<Self, FaceError> {
        let photos = self.photos().into_iter().cloned().chain([photo]);
        Self::from_photos(photos.collect(), self.triangulation)
    }

    /// Removes a photo, by its index in input order. The result is the same as with [`Self::from_photos`]; an unknown
    /// index has no effect.
    ///
    /// # Errors
    /// See [`Self::from_photos`]; [`FaceError::PhotoCount`] for the only photo.
    pub fn without_photo(&self, photo: usize) -> Result<Self, FaceError> {
        let photos = self.photos().into_iter().enumerate();
        let others = photos.filter(|(other, _)| *other != photo).map(|(_, photo)| photo.clone());
        Self::from_photos(others.collect(), self.triangulation)
    }

    /// Changes the lens of the lead photo. The shape is refitted to all photos; the others keep their lenses.
    ///
    /// # Errors
    /// [`FaceError::Lens`] if the lens is invalid.
    pub fn with_lens(&self, lens: PhotoLens) -> Result<Self, FaceError> {
        self.refitted(lens, self.card())
    }

    /// Measures the face by a card in the lead photo, or without one.
    ///
    /// # Errors
    /// [`FaceError::NotACard`] if the corners are not those of a card.
    pub fn with_card(&self, card: Option<CardCorners>) -> Result<Self, FaceError> {
        self.refitted(self.lens(), card)
    }

    fn refitted(&self, lens: PhotoLens, card: Option<CardCorners>) -> Result<Self, FaceError> {
        let (fitted, others) = match self.views() {
            [only] => (Fitted::new(PhotoInput { lens, card, ..PhotoInput::of(&only.observation) })?, Vec::new()),
            _ => {
                let JointFit { fitted, others, .. } = joint_fit::fit(&self.photo_inputs(lens, card))?;
                (fitted, others)
            }
        };
        let mut views = self.views.clone();
        (views[0].observation.lens, views[0].observation.card, views[0].camera) = (lens, card, fitted.camera);
        for (view, (_, camera, reprojection)) in views[1..].iter_mut().zip(others) {
            (view.camera, view.reprojection) = (camera, reprojection);
        }
        Ok(Self::from_fitted(self.triangulation, fitted, views))
    }

    /// The photos of the face: the lead photo first, then the others in input order.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// The photos, in input order.
    pub fn photos(&self) -> Vec<&Observation> {
        let view_of = |photo| self.views.iter().find(|view| view.photo == photo);
        (0..self.views.len()).filter_map(view_of).map(|view| &view.observation).collect()
    }

    /// Leaves out each photo in turn, and measures how well the others predict it; empty for fewer than three.
    ///
    /// # Errors
    /// See [`Self::from_photos`].
    pub fn left_out(&self) -> Result<Vec<LeftOut>, FaceError> {
        joint_fit::left_out(&self.photo_inputs(self.lens(), self.card()))
    }

    /// Facts about each photo in input order, with `lens` and `card` for the lead photo.
    fn photo_inputs(&self, lens: PhotoLens, card: Option<CardCorners>) -> Vec<PhotoInput<'_>> {
        let mut inputs: Vec<PhotoInput<'_>> = self.photos().into_iter().map(PhotoInput::of).collect();
        let lead = &mut inputs[self.views[0].photo];
        (lead.lens, lead.card) = (lens, card);
        inputs
    }
}

impl<'a> PhotoInput<'a> {
    pub(super) fn of(photo: &'a Observation) -> Self {
        let Observation { landmarks, photo_size_px, lens, card, .. } = photo;
        Self { landmarks, size_px: *photo_size_px, lens: *lens, card: *card }
    }
}

impl View {
    pub(super) fn new(
        mut observation: Observation,
        (photo, camera, reprojection): (usize, Camera, Reprojection),
    ) -> Self {
        let uv = |p: &[f32; 3]| DVec3::from(p.map(f64::from)).truncate();
        let uvs = observation.landmarks[..LANDMARK_COUNT].iter().map(uv).collect();
        let is_large = |picture: &Photo| picture.width().max(picture.height()) > MAX_PICTURE_SIDE_PX;
        if let Some(large) = observation.picture.take_if(|picture| is_large(picture)) {
            observation.picture = Some(large.scaled_down(MAX_PICTURE_SIDE_PX));
        }
        Self { photo, observation, uvs, camera, reprojection }
    }
}
