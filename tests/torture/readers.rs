//! The program's own readers, in the order in which the program calls them, and what they promise.

use rosto_export::{Reopened, reopen};
use rosto_face::{FaceInput, FaceModel};
use rosto_landmarks::{FaceFinder, FindOptions, LandmarkNetwork};
use rosto_photo::{Limits, Photo, decode};
use rosto_studio::{Document, Rest, project};

use crate::kinds::Verdict;
use crate::seeds::{Seeds, canonical_rest, with_profile};

/// Smaller than the program's own, so that what a reader may need is far below what nobody may need.
const LIMITS: Limits = Limits { max_bytes: 40_000_000, max_pixels: 1 << 18 };

/// A picture, as a photo that was dropped.
pub fn picture(bytes: &[u8]) -> Verdict {
    match decode(bytes, &LIMITS) {
        Ok(photo) => checked(sound(&photo)),
        Err(error) => checked(explained(&error.to_string(), error.hint())).or_refused(),
    }
}

/// A colour profile, in a JPEG that is whole.
pub fn profile(bytes: &[u8], seeds: &Seeds) -> Verdict {
    match picture(&with_profile(&seeds.jpegs[0], bytes)) {
        Verdict::Refused => Verdict::Broken("a broken profile is a reason to refuse the picture".to_owned()),
        verdict => verdict,
    }
}

/// A GLB: the face in it, its texture, its history.
pub fn glb(bytes: &[u8]) -> Verdict {
    match reopen(bytes) {
        Ok(opened) => face(&opened),
        Err(_) => Verdict::Refused,
    }
}

/// A project: the same.
pub fn project(bytes: &[u8]) -> Verdict {
    match rosto_export::project::read(bytes) {
        Ok(opened) => face(&opened),
        Err(_) => Verdict::Refused,
    }
}

/// A history over the canonical face.
pub fn edits(bytes: &[u8]) -> Verdict {
    match std::str::from_utf8(bytes) {
        Ok(text) => history(text, canonical_rest()),
        Err(_) => Verdict::Refused,
    }
}

/// Two networks, and what they see in a portrait.
pub fn networks(detector: &[u8], landmarks: &[u8], portrait: &Photo) -> Verdict {
    let found = FaceFinder::new(detector, LandmarkNetwork::Attention(landmarks))
        .and_then(|finder| finder.find(portrait, &FindOptions::default()));
    let Ok(faces) = found else { return Verdict::Refused };
    let landmarks = faces.iter().flat_map(|face| &face.landmarks).flatten();
    checked(promise(landmarks.into_iter().all(|number| number.is_finite()), "a landmark is not finite"))
}

fn face(opened: &Reopened<'_>) -> Verdict {
    let picture = match &opened.texture {
        Some(texture) => decode(&texture.encoded, &LIMITS),
        None => {
            let painted = opened.painted();
            let rgb = painted.rgba.as_chunks::<4>().0.iter().flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]);
            Photo::from_rgb(painted.width, painted.height, rgb.collect())
        }
    };
    let Ok(picture) = picture else { return Verdict::Refused };
    let [width, height] = opened.photo_size_px;
    let (landmarks, colours) = (&opened.landmarks, &opened.colours_srgb);
    let input = FaceInput { landmarks, width, height, colours, picture, lens: opened.lens };
    let Ok(model) = FaceModel::new(input, opened.triangulation) else { return Verdict::Refused };
    let finite = model.positions_m().iter().all(|position| position.is_finite());
    match (checked(promise(finite, "a face has a position that is not finite")), &opened.history) {
        (Verdict::Accepted, Some(text)) => history(text, Rest::of_face(&model)),
        (verdict, _) => verdict,
    }
}

fn history(text: &str, rest: Rest) -> Verdict {
    let Ok(entries) = project::from_json(text) else { return Verdict::Refused };
    let again = project::from_json(&project::to_json(&entries));
    if again.as_ref() != Ok(&entries) {
        return Verdict::Broken(format!("a history is not what it was when written and read again: {again:?}"));
    }
    let Ok(document) = Document::replay(rest, entries) else { return Verdict::Refused };
    let finite = document.positions().iter().all(|position| position.is_finite());
    checked(promise(finite, "an accepted history moves a vertex to where there are no numbers"))
}

fn sound(photo: &Photo) -> Result<(), String> {
    let (width, height) = (u64::from(photo.width()), u64::from(photo.height()));
    promise(photo.pixels().len() as u64 == width * height * 3, "a photo has not three bytes for each pixel")?;
    promise(width * height > 0 && width * height <= LIMITS.max_pixels, "a photo is larger than the limit")?;
    let small = photo.scaled_down(8);
    promise(small.width().max(small.height()) <= 8, "a photo was not scaled down")
}

fn explained(said: &str, hint: &str) -> Result<(), String> {
    promise(!said.is_empty() && !hint.is_empty(), "a refusal says nothing")
}

fn promise(kept: bool, otherwise: &str) -> Result<(), String> {
    if kept { Ok(()) } else { Err(otherwise.to_owned()) }
}

fn checked(promises: Result<(), String>) -> Verdict {
    promises.map_or_else(Verdict::Broken, |()| Verdict::Accepted)
}

impl Verdict {
    fn or_refused(self) -> Self {
        if self == Self::Accepted { Self::Refused } else { self }
    }
}
