//! The photos of a face that was seen in several.

use glam::{DVec2, DVec3};
use rosto_photo::Photo;

use super::fitting::Fitted;
use super::several::{self, Known, LeftOut, Reprojection, Together};
use super::{FaceInput, FaceModel, check_count};
use crate::camera::Camera;
use crate::{FaceError, LANDMARK_COUNT, PhotoLens, Triangulation};

/// As many photos of a face are read together at most.
pub const MOST_PHOTOS: usize = 5;

/// One of the photos that a face was seen in.
#[derive(Debug, Clone)]
pub struct View {
    /// Which of them, in the order that they were given in.
    pub photo: usize,
    /// The upright picture; it may be a scaled-down copy.
    pub picture: Photo,
    /// Width and height in px of the upright picture that the landmarks were found in.
    pub photo_size_px: [u32; 2],
    /// The landmarks, and the irises if they were looked for, bit for bit as they came in.
    pub landmarks: Vec<[f32; 3]>,
    /// Where the 468 landmarks were found in it, x/W and y/H, origin at the top left.
    pub uvs: Vec<DVec2>,
    /// The camera that took it, in px of [`Self::photo_size_px`], and where that stood before the model.
    pub camera: Camera,
    /// What was known of its lens.
    pub lens: PhotoLens,
    /// 468 sRGB colours, its pixel under each landmark.
    pub colours_srgb: Vec<[u8; 3]>,
    /// How well the model agrees with it; nothing is left of that for the photo that leads, on which the model lies.
    pub reprojection: Reprojection,
}

impl FaceModel {
    /// A face from 1 to [`MOST_PHOTOS`] photos of it, which may show it with other expressions, from other distances and
    /// through other lenses.
    ///
    /// The photo in which the face looks at its camera the most leads, of those that show it at least half as large as the
    /// largest: its landmarks, colours, picture, lens and size are the model's, and the model lies on it as if it were the only
    /// one. How deep the landmarks lie on their rays the others tell: the depths z and the others' cameras π minimise
    ///
    /// `Σₖ Σᵢ wₖᵢ ρ(|πₖ(xᵢ + (zᵢ + dᵢ) rᵢ) − sₖᵢ| / σₖ) + |z / 20 mm|² + |L z / 0.15 mm|²`
    ///
    /// with the places x by the photo that leads alone, its rays r, what the others show s, a robust ρ, the errors σ as large as
    /// they prove to be, how far the network draws parts of turned heads out d ([`drawn_out_m`](crate::drawn_out_m)), and the
    /// random-walk graph Laplacian L: where no other photo tells better, the δ-coordinates stay. Landmarks that are turned away,
    /// and parts that move with the expression, weigh less; photos from one direction weigh as one. `docs/several-photos.md` has
    /// what that is worth.
    ///
    /// The order of the photos does not matter, but that the first of those leads that are turned alike.
    ///
    /// # Errors
    /// [`FaceError::PhotoCount`] for none or too many, [`FaceError::InPhoto`] with what [`Self::new`] has to say of one of them,
    /// and [`FaceError::AnotherFace`] for one that shows another face.
    pub fn of_several(inputs: Vec<FaceInput<'_>>, triangulation: Triangulation) -> Result<Self, FaceError> {
        if !(1..=MOST_PHOTOS).contains(&inputs.len()) {
            return Err(FaceError::PhotoCount { found: inputs.len(), most: MOST_PHOTOS });
        }
        for (photo, input) in inputs.iter().enumerate() {
            check_count("colours", LANDMARK_COUNT, input.colours.len())
                .map_err(|reason| FaceError::InPhoto { photo, reason: Box::new(reason) })?;
        }
        let known: Vec<Known<'_>> = inputs.iter().map(Known::of).collect();
        let Together { lead, fitted, others: mut seen } = several::together(&known)?;
        seen.insert(lead, (lead, fitted.camera, Reprojection::default()));
        let mut views: Vec<View> = inputs.into_iter().zip(seen).map(|(input, seen)| View::new(input, seen)).collect();
        views[..=lead].rotate_right(1);
        Ok(Self::made_of(triangulation, fitted, views))
    }

    /// The same face with a further photo of it, the last of them: as if all had been given to [`Self::of_several`] together.
    ///
    /// # Errors
    /// As [`Self::of_several`].
    pub fn with_photo(&self, input: FaceInput<'_>) -> Result<Self, FaceError> {
        let inputs = self.inputs().into_iter().chain([input]);
        Self::of_several(inputs.collect(), self.triangulation)
    }

    /// The same face without one of its photos, in the order that they were given in: as if that one had never been given. Where
    /// there is no such photo, nothing is left out.
    ///
    /// # Errors
    /// As [`Self::of_several`]; [`FaceError::PhotoCount`] for the only one.
    pub fn without_photo(&self, photo: usize) -> Result<Self, FaceError> {
        let inputs = self.inputs().into_iter().enumerate();
        let others = inputs.filter(|(other, _)| *other != photo).map(|(_, input)| input);
        Self::of_several(others.collect(), self.triangulation)
    }

    /// The same face with another lens for the leading photo. The other photos keep theirs, and the shape is fitted to all of
    /// them again.
    ///
    /// # Errors
    /// [`FaceError::Lens`] if there is no such lens.
    pub fn with_lens(&self, lens: PhotoLens) -> Result<Self, FaceError> {
        let (fitted, others) = match self.views() {
            [only] => (Fitted::new(&only.landmarks, only.photo_size_px, lens)?, Vec::new()),
            _ => {
                let Together { fitted, others, .. } = several::together(&self.known(lens))?;
                (fitted, others)
            }
        };
        let mut views = self.views.clone();
        (views[0].lens, views[0].camera) = (lens, fitted.camera);
        for (view, (_, camera, reprojection)) in views[1..].iter_mut().zip(others) {
            (view.camera, view.reprojection) = (camera, reprojection);
        }
        Ok(Self::made_of(self.triangulation, fitted, views))
    }

    /// The photos of the face: the leading one first, then the others in input order.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// What the model was made from, in the order that it was given in.
    fn inputs(&self) -> Vec<FaceInput<'_>> {
        let mut views: Vec<&View> = self.views.iter().collect();
        views.sort_by_key(|view| view.photo);
        views.into_iter().map(View::input).collect()
    }

    /// Leaves out each photo in turn and tells how well the others foresee it; nothing for fewer than three.
    ///
    /// # Errors
    /// As [`Self::of_several`].
    pub fn left_out(&self) -> Result<Vec<LeftOut>, FaceError> {
        several::left_out(&self.known(self.lens()))
    }

    /// The facts about each photo in input order; the leading photo has the given lens.
    fn known(&self, lens: PhotoLens) -> Vec<Known<'_>> {
        let mut known: Vec<Known<'_>> = self.inputs().iter().map(Known::of).collect();
        known[self.views[0].photo].lens = lens;
        known
    }
}

impl<'a> Known<'a> {
    fn of(input: &FaceInput<'a>) -> Self {
        Self { landmarks: input.landmarks, size_px: [input.width, input.height], lens: input.lens }
    }
}

impl View {
    pub(super) fn new(input: FaceInput<'_>, (photo, camera, reprojection): (usize, Camera, Reprojection)) -> Self {
        let place = |p: &[f32; 3]| DVec3::from(p.map(f64::from)).truncate();
        Self {
            photo,
            picture: input.picture,
            photo_size_px: [input.width, input.height],
            landmarks: input.landmarks.to_vec(),
            uvs: input.landmarks[..LANDMARK_COUNT].iter().map(place).collect(),
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
