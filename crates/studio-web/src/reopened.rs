use rosto_export::{FileKind, FurtherPhoto, Painted, PlacedTexture, Reopened, project, reopen, sniff};
use rosto_face::{PhotoLens, Triangulation};
use wasm_bindgen::prelude::*;

use crate::error::FacadeError;
use crate::modes::FileKindName;

/// What a file of ours holds, for `openWork`. `free()` it when everything has been taken out.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ReopenedFace {
    triangulation: Triangulation,
    density: u32,
    edits: String,
    in_photo: Option<String>,
    changed_elsewhere: bool,
    leads: usize,
    photos: Vec<ReopenedPhoto>,
}

/// One of its photos. `free()` it when everything has been taken out.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ReopenedPhoto {
    photo_size_px: [u32; 2],
    landmarks: Vec<f32>,
    lens: String,
    colours: Vec<u8>,
    picture_size_px: [u32; 2],
    place_px: [i32; 2],
    placed_size_px: [u32; 2],
    pixels: Pixels,
}

/// The picture, in the form in which the file leaves it.
#[derive(Debug)]
enum Pixels {
    /// A JPEG or PNG that belongs at its place in the picture.
    Encoded { bytes: Vec<u8>, media_type: &'static str },
    /// The whole picture, RGBA.
    Painted(Vec<u8>),
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
            triangulation: face.triangulation,
            density: face.density,
            edits: face.history.unwrap_or_else(|| rosto_studio::project::to_json(&[])),
            in_photo: face.in_photo,
            changed_elsewhere: face.changed_elsewhere,
            leads,
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
    fn new(photo_size_px: [u32; 2], landmarks: &[[f32; 3]], lens: PhotoLens, colours_srgb: &[[u8; 3]]) -> Self {
        Self {
            photo_size_px,
            landmarks: landmarks.concat(),
            lens: lens.to_string(),
            colours: colours_srgb.concat(),
            picture_size_px: [0; 2],
            place_px: [0; 2],
            placed_size_px: [0; 2],
            pixels: Pixels::Painted(Vec::new()),
        }
    }

    fn placed(self, texture: PlacedTexture<'_>) -> Self {
        let media_type = texture.media_type();
        Self {
            picture_size_px: texture.picture_size_px,
            place_px: texture.at_px,
            placed_size_px: texture.size_px,
            pixels: Pixels::Encoded { bytes: texture.encoded.into_owned(), media_type },
            ..self
        }
    }

    fn painted(self, painted: Painted) -> Self {
        let size_px = [painted.width, painted.height];
        let pixels = Pixels::Painted(painted.rgba);
        Self { picture_size_px: size_px, placed_size_px: size_px, pixels, ..self }
    }
}

#[wasm_bindgen]
impl ReopenedFace {
    /// Its photos in the order that they were given in; none the second time.
    #[wasm_bindgen(js_name = takePhotos)]
    pub fn take_photos(&mut self) -> Vec<ReopenedPhoto> {
        std::mem::take(&mut self.photos)
    }

    /// Which of them leads, from 0.
    #[wasm_bindgen(getter)]
    pub fn leads(&self) -> u32 {
        self.leads as u32
    }

    /// How the landmarks are joined.
    #[wasm_bindgen(getter)]
    pub fn triangulation(&self) -> String {
        self.triangulation.id().to_owned()
    }

    /// How often the mesh was subdivided.
    #[wasm_bindgen(getter)]
    pub fn density(&self) -> u32 {
        self.density
    }

    /// What was done to the photo alone, as `openWork` takes it; undefined where nothing was.
    #[wasm_bindgen(getter, js_name = inPhoto)]
    pub fn in_photo(&self) -> Option<String> {
        self.in_photo.clone()
    }

    /// The edits as versioned JSON.
    #[wasm_bindgen(getter)]
    pub fn edits(&self) -> String {
        self.edits.clone()
    }

    /// Whether another program has changed the mesh, which opens as it was saved here.
    #[wasm_bindgen(getter, js_name = changedElsewhere)]
    pub fn changed_elsewhere(&self) -> bool {
        self.changed_elsewhere
    }
}

#[wasm_bindgen]
impl ReopenedPhoto {
    /// Width in px of the upright photo that the landmarks were found in.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.photo_size_px[0]
    }

    /// Height of that photo in px.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.photo_size_px[1]
    }

    /// What was known of the photo's lens.
    #[wasm_bindgen(getter)]
    pub fn lens(&self) -> String {
        self.lens.clone()
    }

    /// 468 or 478 × (x/W, y/H, z/W).
    pub fn landmarks(&self) -> Vec<f32> {
        self.landmarks.clone()
    }

    /// 468 × (red, green, blue), sRGB.
    pub fn colours(&self) -> Vec<u8> {
        self.colours.clone()
    }

    /// Width of the upright picture in px; the file may hold a part of it.
    #[wasm_bindgen(getter, js_name = pictureWidth)]
    pub fn picture_width(&self) -> u32 {
        self.picture_size_px[0]
    }

    /// Height of the upright picture in px.
    #[wasm_bindgen(getter, js_name = pictureHeight)]
    pub fn picture_height(&self) -> u32 {
        self.picture_size_px[1]
    }

    /// Where in the picture the file's part of it lies, in px: left, top, width, height.
    pub fn place(&self) -> Vec<i32> {
        let [left, top] = self.place_px;
        let [width, height] = self.placed_size_px.map(|side| side as i32);
        vec![left, top, width, height]
    }

    /// The media type of that part; undefined where the file holds no photo.
    #[wasm_bindgen(getter, js_name = mediaType)]
    pub fn media_type(&self) -> Option<String> {
        match &self.pixels {
            Pixels::Encoded { media_type, .. } => Some((*media_type).to_owned()),
            Pixels::Painted(_) => None,
        }
    }

    /// That part as an encoded picture or, where the file holds none, what stands in for the photo: the landmarks' colours
    /// blended over the face, RGBA.
    #[wasm_bindgen(js_name = takePicture)]
    pub fn take_picture(&mut self) -> Vec<u8> {
        match &mut self.pixels {
            Pixels::Encoded { bytes, .. } | Pixels::Painted(bytes) => std::mem::take(bytes),
        }
    }
}
