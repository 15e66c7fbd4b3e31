use rosto_face::{Region, covered_cheek, face_width_px, likeness};
use rosto_landmarks::Face;
use rosto_photo::Photo;

/// Width in px below which a face is tiny: a pixel is then 1.7 mm of skin.
const TINY_BELOW_PX: u32 = 90;

/// A reason why the model of a face may be worse than usual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PhotoRemark {
    /// The detection may not be a face.
    MayNotBeAFace {
        /// See [`quality`].
        quality: f64,
    },
    /// The face has too few pixels for a sharp texture.
    TinyFace {
        /// Width of the face in px of the photo.
        width_px: u32,
    },
    /// Something covers a part of a cheek, whose shape and colour are guessed.
    CoveredCheek {
        /// [`Region::LeftCheek`] or [`Region::RightCheek`], the subject's.
        cheek: Region,
    },
}

/// Quality below which a face may not be one. Cloth and photos without people reach 0.88.
const DOUBTFUL_BELOW: f64 = 0.9;

/// How likely a face found in `photo` is one and well fitted, from 0 to 1: the networks' confidence times the
/// [`likeness`] of the landmarks.
pub fn quality(photo: &Photo, face: &Face) -> f64 {
    f64::from(face.confidence) * likeness(&face.landmarks, [photo.width(), photo.height()]).unwrap_or(0.0)
}

impl PhotoRemark {
    /// Remarks on a face found in `photo`, the most important first.
    pub fn of(photo: &Photo, face: &Face) -> Vec<Self> {
        let size_px = [photo.width(), photo.height()];
        let quality = quality(photo, face);
        let doubt = (quality < DOUBTFUL_BELOW).then_some(Self::MayNotBeAFace { quality });
        let width_px = face_width_px(&face.landmarks, size_px).map(|width_px| width_px.round() as u32);
        let tiny = width_px.filter(|&width_px| width_px < TINY_BELOW_PX).map(|width_px| Self::TinyFace { width_px });
        let cover = covered_cheek(photo, &face.landmarks).map(|cheek| Self::CoveredCheek { cheek });
        [doubt, tiny, cover].into_iter().flatten().collect()
    }
}
