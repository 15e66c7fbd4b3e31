//! The face and its edits as JSON, shared by GLB and project files.

use base64::prelude::{BASE64_STANDARD, Engine};
use rosto_face::{FaceError, FaceModel, MAX_DENSITY, MAX_PHOTOS, Observation, Photo, Triangulation, View};
use serde_json::{Value, json};

use crate::placed::{PlacedPicture, painted, placement};
use crate::reopen_error::field;
use crate::{ExportError, Picture, ReopenError, about, texture};

/// A face as files, the browser's database and the worker's messages hold it.
#[derive(Debug, Clone, PartialEq)]
pub struct SavedFace {
    /// The photos of the face, in the order in which they were added. Their pictures can be only the parts around the
    /// face.
    pub photos: Vec<Observation>,
    /// The edits; `None` for a newly found face.
    pub edits: Option<SavedEdits>,
}

/// The edits of a face, and the mesh that they were made on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SavedEdits {
    /// Triangulation of the landmarks.
    pub triangulation: Triangulation,
    /// Subdivision level, 0 to 4.
    pub density: u32,
    /// Edits as the text of a JSON object, in a format that this crate does not interpret; `None` if there are none.
    pub history: Option<String>,
    /// Edits of the photo, in the same form.
    pub photo_edit: Option<String>,
}

/// A face with its edits to be written, from which [`reopen`](crate::reopen) restores them.
///
/// It is stored in a GLB's scene as `extras`, which other programs preserve or drop, and as a project's first line:
/// ```json
/// {"photos": [{"observation": "…", "picture": {"size_px": [512, 512], "crop_at_px": [96, 0], "crop_size_px": [256, 256]}}],
///  "triangulation": "canonical", "density": 0, "history": {}, "photo_edit": {}, "about": {}}
/// ```
/// The photos are in the order in which they were added; `observation` is [`Observation::to_bytes`] in base64.
/// `picture` places the face's part in the upright picture and holds it as `jpeg`, in base64. Without `jpeg`, the
/// part is the GLB's texture; without `picture`, it is the project's PNG, and in a GLB there is none. `about` is
/// [`about`](crate::about), for readers other than Rosto.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// The unedited face.
    pub face: &'a FaceModel,
    /// The edits, and the mesh in the file.
    pub edits: &'a SavedEdits,
}

/// Whether a file includes the pictures of photos other than the lead one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pictures {
    /// The face's part of each, with a longest side of at most this many px.
    UpTo(u32),
    /// No pictures, because the file should not contain photos.
    Left,
}

/// Writes the fields, with `lead` as the lead photo's picture.
pub(crate) fn fields(source: &Source<'_>, lead: Option<Value>, others: Pictures) -> Result<Value, ExportError> {
    let face = source.face;
    let mut photos = vec![Value::Null; face.views().len()];
    for (index, view) in face.views().iter().enumerate() {
        let picture = if index == 0 { lead.clone() } else { picture_of(view, others)? };
        photos[view.photo] = photo(&view.observation, picture);
    }
    let mut fields = source.edits.fields()?;
    fields["photos"] = photos.into();
    fields["about"] = about(face, face.positions_m());
    Ok(fields)
}

fn photo(observation: &Observation, picture: Option<Value>) -> Value {
    let mut photo = json!({"observation": BASE64_STANDARD.encode(observation.to_bytes())});
    if let Some(picture) = picture {
        photo["picture"] = picture;
    }
    photo
}

fn picture_of(view: &View, pictures: Pictures) -> Result<Option<Value>, ExportError> {
    match (pictures, &view.observation.picture) {
        (Pictures::UpTo(max_px), Some(pixels)) => part_of(&Picture { pixels, uvs: &view.uvs }, max_px).map(Some),
        _ => Ok(None),
    }
}

/// The face's part of a photo, with its placement.
pub(crate) fn part_of(photo: &Picture<'_>, max_px: u32) -> Result<Value, ExportError> {
    let (part, crop) = texture::crop(photo, max_px)?;
    let mut picture = placement(&crop);
    picture["jpeg"] = BASE64_STANDARD.encode(texture::jpeg(&part.pixels)?).into();
    Ok(picture)
}

fn object(text: &str) -> Result<Value, ExportError> {
    serde_json::from_str(text).ok().filter(Value::is_object).ok_or(ExportError::HistoryNotAnObject)
}

impl SavedFace {
    /// The photos as text, without their pictures.
    pub fn photos_json(&self) -> String {
        self.photos.iter().map(|observation| photo(observation, None)).collect::<Value>().to_string()
    }

    /// Reads the results of [`Self::photos_json`] and [`SavedEdits::to_json`].
    ///
    /// # Errors
    /// [`ReopenError::NotJson`], [`ReopenError::Field`] or [`ReopenError::Face`].
    pub fn from_json(photos: &str, edits: Option<&str>) -> Result<Self, ReopenError> {
        let value = |text| serde_json::from_str(text).map_err(|_| ReopenError::NotJson);
        let photos = read_photos(&value(photos)?, observation)?;
        let edits = edits.map(|edits| read_edits(&value(edits)?)).transpose()?;
        Ok(Self { photos, edits })
    }

    /// Paints a picture from the landmarks' colours for each photo without one.
    pub(crate) fn painted(mut self) -> Self {
        let triangulation = self.edits.as_ref().map_or(Triangulation::Canonical, |edits| edits.triangulation);
        for photo in self.photos.iter_mut().filter(|photo| photo.picture.is_none()) {
            photo.picture = Some(painted(photo, triangulation));
        }
        self
    }
}

impl SavedEdits {
    /// No edits, on a mesh with this triangulation and density.
    pub fn none(triangulation: Triangulation, density: u32) -> Self {
        Self { triangulation, density, history: None, photo_edit: None }
    }

    /// The edits as text.
    ///
    /// # Errors
    /// [`ExportError::HistoryNotAnObject`].
    pub fn to_json(&self) -> Result<String, ExportError> {
        Ok(self.fields()?.to_string())
    }

    fn fields(&self) -> Result<Value, ExportError> {
        let mut fields = json!({"triangulation": self.triangulation.id(), "density": self.density});
        for (name, text) in [("history", &self.history), ("photo_edit", &self.photo_edit)] {
            if let Some(text) = text {
                fields[name] = object(text)?;
            }
        }
        Ok(fields)
    }
}

/// Reads a file's fields. `own` returns the file's own picture for the placement of a photo without `jpeg`, if there is
/// one.
pub(crate) fn read<'a>(
    fields: &Value,
    own: impl Fn(Option<&Value>) -> Result<Option<PlacedPicture<'a>>, ReopenError>,
) -> Result<SavedFace, ReopenError> {
    let with_picture =
        |photo: &Value| Ok(Observation { picture: picture(photo.get("picture"), &own)?, ..observation(photo)? });
    Ok(SavedFace { photos: read_photos(&fields["photos"], with_picture)?, edits: Some(read_edits(fields)?) })
}

fn read_photos(
    photos: &Value,
    photo: impl Fn(&Value) -> Result<Observation, ReopenError>,
) -> Result<Vec<Observation>, ReopenError> {
    let photos = photos.as_array().ok_or_else(field("photos"))?;
    if !(1..=MAX_PHOTOS).contains(&photos.len()) {
        return Err(FaceError::PhotoCount { found: photos.len(), most: MAX_PHOTOS }.into());
    }
    photos.iter().map(photo).collect()
}

fn read_edits(fields: &Value) -> Result<SavedEdits, ReopenError> {
    let density = fields["density"].as_u64().filter(|&density| density <= MAX_DENSITY.into());
    let triangulation = fields["triangulation"].as_str().and_then(Triangulation::from_id);
    let text = |name: &'static str| match fields.get(name) {
        None => Ok(None),
        Some(value) if value.is_object() => Ok(Some(value.to_string())),
        Some(_) => Err(ReopenError::Field { field: name }),
    };
    Ok(SavedEdits {
        triangulation: triangulation.ok_or_else(field("triangulation"))?,
        density: density.ok_or_else(field("density"))? as u32,
        history: text("history")?,
        photo_edit: text("photo_edit")?,
    })
}

/// A photo without its picture.
fn observation(photo: &Value) -> Result<Observation, ReopenError> {
    let text = photo["observation"].as_str();
    let bytes = text.and_then(|text| BASE64_STANDARD.decode(text).ok()).ok_or_else(field("observation"))?;
    Ok(Observation::from_bytes(&bytes)?)
}

fn picture<'a>(
    placement: Option<&Value>,
    own: impl Fn(Option<&Value>) -> Result<Option<PlacedPicture<'a>>, ReopenError>,
) -> Result<Option<Photo>, ReopenError> {
    let placed = match placement.filter(|picture| picture.get("jpeg").is_some()) {
        Some(embedded) => Some(PlacedPicture::embedded(embedded).ok_or_else(field("picture"))?),
        None => own(placement)?,
    };
    placed.map(|placed| placed.picture().ok_or_else(field("picture"))).transpose()
}
