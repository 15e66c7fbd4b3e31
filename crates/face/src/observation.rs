use rosto_photo::Photo;

use crate::irises::POINT_COUNT;
use crate::{CardCorners, FaceError, LANDMARK_COUNT, PhotoLens, check_landmarks, plausibility};

/// A face found in one photo: all that a model is built from, and all that files, the database and the worker's answers
/// store of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Observation {
    /// 468 landmarks, or 478 with the irises, in MediaPipe's normalised coordinates: x/W, y/H, z/W; x to the right, y
    /// down, z away from the camera.
    pub landmarks: Vec<[f32; 3]>,
    /// Width and height in px of the upright photo in which the landmarks were found.
    pub photo_size_px: [u32; 2],
    /// 468 sRGB colours: the photo's pixel at each landmark at full resolution, as in the paper.
    pub colours_srgb: Vec<[u8; 3]>,
    /// Lens by the photo's own data: [`PhotoLens::Exif`], or [`PhotoLens::Estimated`] without them.
    pub found_lens: PhotoLens,
    /// Lens to use: [`Self::found_lens`], unless the user has chosen another.
    pub lens: PhotoLens,
    /// Corners of a bank card that is held against the forehead or the chin, which measures the face.
    pub card: Option<CardCorners>,
    /// The upright picture for the texture, possibly a scaled-down copy of the photo; `None` where the pixels are not
    /// needed.
    pub picture: Option<Photo>,
}

/// Version of the bytes that is written and read.
const VERSION: u8 = 1;

/// Largest side of a model's picture, in px; a model scales larger ones down.
pub const MAX_PICTURE_SIDE_PX: u32 = 2048;

/// Largest landmark coordinate, in picture widths or heights.
const MAX_COORDINATE: f32 = 300.0;

/// Smallest extent of a face, in picture widths or heights: below it, a face has less than one pixel.
const MIN_EXTENT: f32 = 1e-5;

impl Observation {
    /// The observation of landmarks found in `photo`, with colours at full resolution and a picture of at most
    /// [`MAX_PICTURE_SIDE_PX`].
    pub fn in_photo(photo: &Photo, landmarks: Vec<[f32; 3]>) -> Self {
        Self { picture: Some(photo.scaled_down(MAX_PICTURE_SIDE_PX)), ..Self::without_picture(photo, landmarks) }
    }

    /// Like [`Self::in_photo`], without the picture.
    pub fn without_picture(photo: &Photo, landmarks: Vec<[f32; 3]>) -> Self {
        let lens = photo.focal_length_35mm().map_or(PhotoLens::Estimated, PhotoLens::Exif);
        let colour = |&[x, y, _]: &[f32; 3]| photo.colour_under(x.into(), y.into());
        Self {
            colours_srgb: landmarks.iter().take(LANDMARK_COUNT).map(colour).collect(),
            photo_size_px: [photo.width(), photo.height()],
            found_lens: lens,
            lens,
            card: None,
            picture: None,
            landmarks,
        }
    }

    /// The observation with another lens chosen by the user.
    pub fn with_lens(self, lens: PhotoLens) -> Self {
        Self { lens, ..self }
    }

    /// The observation with the corners of a card, in px of the upright photo from its top left.
    pub fn with_card_px(self, corners_px: [[f64; 2]; 4]) -> Self {
        let [width, height] = self.photo_size_px.map(f64::from);
        Self { card: Some(corners_px.map(|[x, y]| [x / width, y / height])), ..self }
    }

    /// Checks counts, lenses, and that the landmarks form a face.
    ///
    /// # Errors
    /// [`FaceError`] as of [`FaceModel::new`](crate::FaceModel::new), [`FaceError::Implausible`] if a coordinate is far
    /// outside the photo or the face is smaller than a pixel, and [`FaceError::NotAFace`] or [`FaceError::Folded`] if
    /// the landmarks cannot be those of a face.
    pub fn checked(self) -> Result<Self, FaceError> {
        let [width, height] = self.photo_size_px;
        check_landmarks(&self.landmarks, width, height)?;
        if self.colours_srgb.len() != LANDMARK_COUNT {
            let (expected, found) = (LANDMARK_COUNT, self.colours_srgb.len());
            return Err(FaceError::WrongCount { what: "colours", expected, found });
        }
        let corners = self.card.iter().flatten().flatten();
        if !corners.into_iter().all(|number| number.abs() <= f64::from(MAX_COORDINATE)) {
            return Err(FaceError::NotACard);
        }
        let is_near = self.landmarks.as_flattened().iter().all(|number| number.abs() <= MAX_COORDINATE);
        if !is_near || extent(&self.landmarks) < MIN_EXTENT {
            return Err(FaceError::Implausible);
        }
        plausibility::check(&self.landmarks, self.photo_size_px)?;
        self.found_lens.checked()?;
        self.lens.checked()?;
        Ok(self)
    }

    /// The observation as bytes, without its picture: the version, the photo's size in px as two `u32`, the number of
    /// landmarks as `u16` and their coordinates as `f32`, 468 × 3 colours, both lenses as texts, each after its
    /// length as `u8`, and the corners of a card as eight `f64`, if there is one. Numbers are little-endian.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = vec![VERSION];
        bytes.extend(self.photo_size_px.iter().flat_map(|side| side.to_le_bytes()));
        bytes.extend((self.landmarks.len() as u16).to_le_bytes());
        bytes.extend(self.landmarks.iter().flatten().flat_map(|number| number.to_le_bytes()));
        bytes.extend(self.colours_srgb.as_flattened());
        for lens in [self.found_lens, self.lens] {
            let text = lens.to_string();
            bytes.push(text.len() as u8);
            bytes.extend(text.as_bytes());
        }
        bytes.extend(self.card.iter().flatten().flatten().flat_map(|number| number.to_le_bytes()));
        bytes
    }

    /// Reads the result of [`Self::to_bytes`] and checks it.
    ///
    /// # Errors
    /// [`FaceError::RecordVersion`], [`FaceError::Record`] for missing or surplus bytes, or an error of
    /// [`Self::checked`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FaceError> {
        match bytes.first() {
            Some(&VERSION) => {}
            Some(&found) => return Err(FaceError::RecordVersion { found, known: VERSION }),
            None => return Err(FaceError::Record { bytes: 0 }),
        }
        let read = Reader(&bytes[1..]).observation();
        read.ok_or(FaceError::Record { bytes: bytes.len() })?.checked()
    }
}

/// Longer side of the landmarks' bounding box, in picture widths or heights.
fn extent(landmarks: &[[f32; 3]]) -> f32 {
    let side = |axis: usize| {
        let along = || landmarks.iter().map(|point| point[axis]);
        along().fold(f32::NEG_INFINITY, f32::max) - along().fold(f32::INFINITY, f32::min)
    };
    side(0).max(side(1))
}

/// The bytes that have not been read yet.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn observation(mut self) -> Option<Observation> {
        let photo_size_px = [self.side()?, self.side()?];
        let count = usize::from(u16::from_le_bytes(*self.take(2)?.first_chunk()?));
        if count != LANDMARK_COUNT && count != POINT_COUNT {
            return None;
        }
        let numbers = self.take(count * 3 * 4)?.as_chunks::<4>().0.iter().map(|&bytes| f32::from_le_bytes(bytes));
        let numbers: Vec<f32> = numbers.collect();
        let landmarks = numbers.as_chunks::<3>().0.to_vec();
        let colours_srgb = self.take(LANDMARK_COUNT * 3)?.as_chunks::<3>().0.to_vec();
        let (found_lens, lens) = (self.lens()?, self.lens()?);
        let card = if self.0.is_empty() { None } else { Some(self.card()?) };
        let observation = Observation { landmarks, photo_size_px, colours_srgb, found_lens, lens, card, picture: None };
        self.0.is_empty().then_some(observation)
    }

    fn take(&mut self, count: usize) -> Option<&[u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    fn side(&mut self) -> Option<u32> {
        Some(u32::from_le_bytes(*self.take(4)?.first_chunk()?))
    }

    fn card(&mut self) -> Option<CardCorners> {
        let numbers = self.take(8 * 8)?.as_chunks::<8>().0.iter().map(|&bytes| f64::from_le_bytes(bytes));
        let numbers: Vec<f64> = numbers.collect();
        numbers.as_chunks::<2>().0.try_into().ok()
    }

    fn lens(&mut self) -> Option<PhotoLens> {
        let length = usize::from(*self.take(1)?.first()?);
        std::str::from_utf8(self.take(length)?).ok()?.parse().ok()
    }
}
