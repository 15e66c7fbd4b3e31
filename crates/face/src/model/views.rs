//! The photos of a face that was seen in several.

use glam::{DVec2, DVec3};
use rosto_photo::Photo;

use super::several::{self, Known, LeftOut, Reprojection, Together};
use super::{FaceInput, FaceModel, check_count};
use crate::camera::Camera;
use crate::{FaceError, LANDMARK_COUNT, PhotoLens, Triangulation};

/// As many photos of a face are read together at most.
pub const MOST_PHOTOS: usize = 5;

/// One of the photos that a face was seen in.
#[derive(Debug, Clone, Copy)]
pub struct View<'a> {
    /// Which of them, in the order that they were given in.
    pub photo: usize,
    /// The upright picture; it may be a scaled-down copy.
    pub picture: &'a Photo,
    /// Width and height in px of the upright picture that the landmarks were found in.
    pub photo_size_px: [u32; 2],
    /// Where the 468 landmarks were found in it, x/W and y/H, origin at the top left.
    pub uvs: &'a [DVec2],
    /// The camera that took it, in px of [`Self::photo_size_px`], and where that stood before the model.
    pub camera: &'a Camera,
    /// What was known of its lens.
    pub lens: PhotoLens,
    /// 468 sRGB colours, its pixel under each landmark.
    pub colours_srgb: &'a [[u8; 3]],
    /// How well the model agrees with it; nothing is left of that for the photo that leads, on which the model lies.
    pub reprojection: Reprojection,
}

/// A photo beside the one that leads.
#[derive(Debug, Clone)]
pub(super) struct Other {
    photo: usize,
    photo_size_px: [u32; 2],
    landmarks: Vec<[f32; 3]>,
    uvs: Vec<DVec2>,
    lens: PhotoLens,
    colours_srgb: Vec<[u8; 3]>,
    picture: Photo,
    camera: Camera,
    reprojection: Reprojection,
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
        let Together { lead, fitted, others } = several::together(&known)?;
        let (mut lead_input, mut kept) = (None, Vec::new());
        for (photo, input) in inputs.into_iter().enumerate() {
            if photo == lead { lead_input = Some(input) } else { kept.push((photo, input)) }
        }
        let input = lead_input.expect("invariant: one of the photos leads");
        let others =
            kept.into_iter().zip(others).map(|((photo, input), seen)| Other::new(photo, input, seen)).collect();
        Ok(Self { photo: lead, others, ..Self::made_of(input, triangulation, fitted) })
    }

    /// The same face with a further photo of it, the last of them: as if all had been given to [`Self::of_several`] together.
    ///
    /// # Errors
    /// As [`Self::of_several`].
    pub fn with_photo(&self, input: FaceInput<'_>) -> Result<Self, FaceError> {
        let landmarks = self.landmarks_in_order();
        let inputs = self.inputs(&landmarks).into_iter().chain([input]);
        Self::of_several(inputs.collect(), self.triangulation)
    }

    /// The same face without one of its photos, in the order that they were given in: as if that one had never been given. Where
    /// there is no such photo, nothing is left out.
    ///
    /// # Errors
    /// As [`Self::of_several`]; [`FaceError::PhotoCount`] for the only one.
    pub fn without_photo(&self, photo: usize) -> Result<Self, FaceError> {
        let landmarks = self.landmarks_in_order();
        let inputs = self.inputs(&landmarks).into_iter().enumerate();
        let others = inputs.filter(|(other, _)| *other != photo).map(|(_, input)| input);
        Self::of_several(others.collect(), self.triangulation)
    }

    /// The photos that the face was seen in: the one that leads first, the others in the order that they were given in.
    pub fn views(&self) -> Vec<View<'_>> {
        let lead = View {
            photo: self.photo,
            picture: &self.picture,
            photo_size_px: self.photo_size_px,
            uvs: &self.uvs,
            camera: &self.camera,
            lens: self.lens,
            colours_srgb: &self.colours_srgb,
            reprojection: Reprojection { rms_px: 0.0, median_px: 0.0 },
        };
        std::iter::once(lead).chain(self.others.iter().map(Other::view)).collect()
    }

    /// The landmarks of a photo, and the irises if they were looked for, bit for bit as they came in, by its place in
    /// [`Self::views`]; none where there is no such photo.
    pub fn landmarks_of(&self, view: usize) -> Option<Vec<[f32; 3]>> {
        match view {
            0 => Some(self.landmarks()),
            _ => self.others.get(view - 1).map(|other| other.landmarks.clone()),
        }
    }

    /// The landmarks of each photo, in the order that they were given in.
    fn landmarks_in_order(&self) -> Vec<Vec<[f32; 3]>> {
        let mut landmarks: Vec<_> = self.others.iter().map(|other| other.landmarks.clone()).collect();
        landmarks.insert(self.photo, self.landmarks());
        landmarks
    }

    /// What the model was made from, in the order that it was given in.
    fn inputs<'a>(&'a self, landmarks: &'a [Vec<[f32; 3]>]) -> Vec<FaceInput<'a>> {
        let mut views = self.views();
        views.sort_by_key(|view| view.photo);
        let input = |(view, landmarks): (View<'a>, &'a Vec<[f32; 3]>)| FaceInput {
            landmarks,
            width: view.photo_size_px[0],
            height: view.photo_size_px[1],
            colours: view.colours_srgb,
            picture: view.picture.clone(),
            lens: view.lens,
        };
        views.into_iter().zip(landmarks).map(input).collect()
    }

    /// Leaves out each photo in turn and tells how well the others foresee it; nothing for fewer than three.
    ///
    /// # Errors
    /// As [`Self::of_several`].
    pub fn left_out(&self) -> Result<Vec<LeftOut>, FaceError> {
        let landmarks = self.landmarks();
        several::left_out(&self.known(&landmarks, self.lens))
    }

    /// Fitted to all photos again with another lens of the one that leads.
    pub(super) fn together_with_lens(&self, lens: PhotoLens) -> Result<Self, FaceError> {
        let landmarks = self.landmarks();
        let Together { fitted, others, .. } = several::together(&self.known(&landmarks, lens))?;
        let mut again = Self { lens, ..self.clone() }.placed_as(fitted);
        for (other, (_, camera, reprojection)) in again.others.iter_mut().zip(others) {
            (other.camera, other.reprojection) = (camera, reprojection);
        }
        Ok(again)
    }

    /// What is known of each photo, in the order that they were given in.
    fn known<'a>(&'a self, landmarks: &'a [[f32; 3]], lens: PhotoLens) -> Vec<Known<'a>> {
        let mut known: Vec<Known<'_>> = self.others.iter().map(Other::known).collect();
        known.insert(self.photo, Known { landmarks, size_px: self.photo_size_px, lens });
        known
    }
}

impl<'a> Known<'a> {
    fn of(input: &FaceInput<'a>) -> Self {
        Self { landmarks: input.landmarks, size_px: [input.width, input.height], lens: input.lens }
    }
}

impl Other {
    fn new(photo: usize, input: FaceInput<'_>, (_, camera, reprojection): (usize, Camera, Reprojection)) -> Self {
        let place = |p: &[f32; 3]| DVec3::from(p.map(f64::from)).truncate();
        Self {
            photo,
            photo_size_px: [input.width, input.height],
            landmarks: input.landmarks.to_vec(),
            uvs: input.landmarks[..LANDMARK_COUNT].iter().map(place).collect(),
            lens: input.lens,
            colours_srgb: input.colours.to_vec(),
            picture: input.picture,
            camera,
            reprojection,
        }
    }

    fn known(&self) -> Known<'_> {
        Known { landmarks: &self.landmarks, size_px: self.photo_size_px, lens: self.lens }
    }

    fn view(&self) -> View<'_> {
        let Self { photo, picture, photo_size_px, uvs, camera, lens, colours_srgb, reprojection, .. } = self;
        View {
            photo: *photo,
            picture,
            photo_size_px: *photo_size_px,
            uvs,
            camera,
            lens: *lens,
            colours_srgb,
            reprojection: *reprojection,
        }
    }
}
