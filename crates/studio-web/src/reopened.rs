use rosto_export::{FileKind, FurtherPhoto, Painted, PlacedTexture, Reopened, project, reopen, sniff};
use rosto_face::PhotoLens;
use wasm_bindgen::prelude::*;

use crate::error::FacadeError;
use crate::modes::FileKindName;
use crate::readable::readable;

readable! {
    /// What a file of ours holds, for `openWork`. `free()` it when everything has been taken out.
    pub struct ReopenedFace {
        /// How the landmarks are joined.
        triangulation: String,
        /// How often the mesh was subdivided.
        density: u32,
        /// The edits as versioned JSON.
        edits: String,
        /// What was done to the photo alone, as `openWork` takes it; undefined where nothing was.
        in_photo as inPhoto: Option<String>,
        /// Whether another program has changed the mesh, which opens as it was saved here.
        changed_elsewhere as changedElsewhere: bool,
        /// Which of its photos leads, from 0.
        leads: u32,
    } hidden {
        photos: Vec<ReopenedPhoto>,
    }
}

readable! {
    /// One of its photos. `free()` it when everything has been taken out.
    pub struct ReopenedPhoto {
        /// Width in px of the upright photo that the landmarks were found in.
        width: u32,
        /// Height of that photo in px.
        height: u32,
        /// What was known of the photo's lens.
        lens: String,
        /// 468 or 478 × (x/W, y/H, z/W).
        landmarks: Vec<f32>,
        /// 468 × (red, green, blue), sRGB.
        colours: Vec<u8>,
        /// Width of the upright picture in px; the file may hold a part of it.
        picture_width as pictureWidth: u32,
        /// Height of the upright picture in px.
        picture_height as pictureHeight: u32,
        /// Where in the picture the file's part of it lies, in px: left, top, width, height.
        place: Vec<i32>,
        /// The media type of that part; undefined where the file holds no photo.
        media_type as mediaType: Option<String>,
    } hidden {
        picture: Vec<u8>,
    }
}

/// Tells what a file is by its first 4 096 bytes.
#[wasm_bindgen(js_name = sniffFile)]
pub fn sniff_file(start: &[u8]) -> FileKindName {
    match sniff(start) {
        FileKind::Glb => FileKindName::Glb,
        FileKind::Project => FileKindName::Project,
        FileKind::Other => FileKindName::Other,
    }
}

/// Reads a GLB that was downloaded here or written by the command line. No picture is decoded.
///
/// # Errors
/// `damaged-glb`, `foreign-glb` or `other-version`.
#[wasm_bindgen(js_name = reopenGlb)]
pub fn reopen_glb(bytes: &[u8]) -> Result<ReopenedFace, JsValue> {
    Ok(reopen(bytes).map_err(FacadeError::of_glb)?.into())
}

/// Reads a project that was saved here. Its picture is not decoded.
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
    /// Its photos in the order that they were given in; none the second time.
    #[wasm_bindgen(js_name = takePhotos)]
    pub fn take_photos(&mut self) -> Vec<ReopenedPhoto> {
        std::mem::take(&mut self.photos)
    }
}

#[wasm_bindgen]
impl ReopenedPhoto {
    /// The file's part of the picture as it is encoded or, where it holds none, what stands in for the photo: the landmarks'
    /// colours blended over the face, RGBA.
    #[wasm_bindgen(js_name = takePicture)]
    pub fn take_picture(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.picture)
    }
}
