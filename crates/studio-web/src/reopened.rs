use rosto_export::{FileKind, FurtherPhoto, Painted, PlacedTexture, Reopened, project, reopen, sniff};
use rosto_face::PhotoLens;
use wasm_bindgen::prelude::*;

use crate::error::FacadeError;
use crate::modes::FileKindName;
use crate::readable::readable;

readable! {
    /// Contents of a Rosto file, for `openWork`. `free()` it after taking its parts.
    pub struct ReopenedFace {
        /// Triangulation of the landmarks.
        triangulation: String,
        /// Density of the mesh.
        density: u32,
        /// The edits as versioned JSON.
        edits: String,
        /// Photo-edit data for `openWork`; undefined without photo edits.
        in_photo as inPhoto: Option<String>,
        /// Whether another program has changed the mesh; it reopens as it was saved.
        changed_elsewhere as changedElsewhere: bool,
        /// Index of the lead photo.
        leads: u32,
    } hidden {
        photos: Vec<ReopenedPhoto>,
    }
}

readable! {
    /// A photo of the face. `free()` it after taking its parts.
    pub struct ReopenedPhoto {
        /// Width in px of the upright photo in which the landmarks were found.
        width: u32,
        /// Height of that photo in px.
        height: u32,
        /// Lens of the photo.
        lens: String,
        /// 468 or 478 × (x/W, y/H, z/W).
        landmarks: Vec<f32>,
        /// 468 × (red, green, blue), sRGB.
        colours: Vec<u8>,
        /// Width of the upright picture in px; the file can contain only a part of it.
        picture_width as pictureWidth: u32,
        /// Height of the upright picture in px.
        picture_height as pictureHeight: u32,
        /// Position in the picture of the part that the file contains, in px: left, top, width, height.
        place: Vec<i32>,
        /// Media type of that part; undefined if the file contains no photo.
        media_type as mediaType: Option<String>,
    } hidden {
        picture: Vec<u8>,
    }
}

/// Detects the kind of a file from its first 4,096 bytes.
#[wasm_bindgen(js_name = sniffFile)]
pub fn sniff_file(start: &[u8]) -> FileKindName {
    match sniff(start) {
        FileKind::Glb => FileKindName::Glb,
        FileKind::Project => FileKindName::Project,
        FileKind::Other => FileKindName::Other,
    }
}

/// Reads a GLB written by the page or the command line. Does not decode its pictures.
///
/// # Errors
/// `damaged-glb`, `foreign-glb` or `other-version`.
#[wasm_bindgen(js_name = reopenGlb)]
pub fn reopen_glb(bytes: &[u8]) -> Result<ReopenedFace, JsValue> {
    Ok(reopen(bytes).map_err(FacadeError::of_glb)?.into())
}

/// Reads a project file. Does not decode its picture.
///
/// # Errors
/// `bad-project` or `other-version`.
#[wasm_bindgen(js_name = reopenProject)]
pub fn reopen_project(bytes: &[u8]) -> Result<ReopenedFace, JsValue> {
    Ok(project::read(bytes).map_err(FacadeError::of_project)?.into())
}

impl From<Reopened<'_>> for ReopenedFace {
    fn from(mut face: Reopened<'_>) -> Self {
        let (leads, further) = face.further.take().map_or((0, Vec::new()), |further| (further.leads, further.photos));
        let lead = ReopenedPhoto::new(face.photo_size_px, &face.landmarks, face.lens, &face.colours_srgb);
        let lead = match face.texture.take() {
            Some(texture) => lead.placed(texture),
            None => lead.painted(face.painted()),
        };
        let mut photos: Vec<ReopenedPhoto> = further.into_iter().map(ReopenedPhoto::from).collect();
        photos.insert(leads, lead);
        Self {
            triangulation: face.triangulation.id().to_owned(),
            density: face.density,
            edits: face.history.unwrap_or_else(|| rosto_studio::project::to_json(&[])),
            in_photo: face.in_photo,
            changed_elsewhere: face.changed_elsewhere,
            leads: leads as u32,
            photos,
        }
    }
}

impl From<FurtherPhoto> for ReopenedPhoto {
    fn from(mut photo: FurtherPhoto) -> Self {
        let found = Self::new(photo.photo_size_px, &photo.landmarks, photo.lens, &photo.colours_srgb);
        match photo.texture.take() {
            Some(texture) => found.placed(texture),
            None => found.painted(photo.painted()),
        }
    }
}

impl ReopenedPhoto {
    fn new([width, height]: [u32; 2], landmarks: &[[f32; 3]], lens: PhotoLens, colours_srgb: &[[u8; 3]]) -> Self {
        Self {
            width,
            height,
            lens: lens.to_string(),
            landmarks: landmarks.concat(),
            colours: colours_srgb.concat(),
            picture_width: 0,
            picture_height: 0,
            place: Vec::new(),
            media_type: None,
            picture: Vec::new(),
        }
    }

    fn placed(self, texture: PlacedTexture<'_>) -> Self {
        let ([picture_width, picture_height], [left, top]) = (texture.picture_size_px, texture.at_px);
        let [width, height] = texture.size_px.map(|side| side as i32);
        Self {
            picture_width,
            picture_height,
            place: vec![left, top, width, height],
            media_type: Some(texture.media_type().to_owned()),
            picture: texture.encoded.into_owned(),
            ..self
        }
    }

    fn painted(self, painted: Painted) -> Self {
        let Painted { width: picture_width, height: picture_height, rgba: picture } = painted;
        let place = vec![0, 0, picture_width as i32, picture_height as i32];
        Self { picture_width, picture_height, place, picture, ..self }
    }
}

#[wasm_bindgen]
impl ReopenedFace {
    /// Takes the photos, in the order in which they were added; empty on later calls.
    #[wasm_bindgen(js_name = takePhotos)]
    pub fn take_photos(&mut self) -> Vec<ReopenedPhoto> {
        std::mem::take(&mut self.photos)
    }
}

#[wasm_bindgen]
impl ReopenedPhoto {
    /// Takes the encoded picture or, if the file contains none, a substitute of the landmarks' colours blended over the
    /// face, as RGBA.
    #[wasm_bindgen(js_name = takePicture)]
    pub fn take_picture(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.picture)
    }
}
