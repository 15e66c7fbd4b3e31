use rosto_export::{Reopened, reopen};
use rosto_face::Triangulation;
use rosto_studio::project;
use wasm_bindgen::prelude::*;

use crate::modes::TriangulationName;
use crate::trouble::Trouble;

/// What a GLB of ours holds, for `openFace` and `openEdits`. `free()` it when everything has been taken out.
#[wasm_bindgen]
#[derive(Debug)]
pub struct ReopenedFace {
    photo_size_px: [u32; 2],
    landmarks: Vec<f32>,
    colours: Vec<u8>,
    triangulation: Triangulation,
    density: u32,
    edits: String,
    picture_size_px: [u32; 2],
    crop_at_px: [i32; 2],
    pixels: Pixels,
}

/// The picture, in the form in which the file leaves it.
#[derive(Debug)]
enum Pixels {
    /// A JPEG that belongs at its place in the picture.
    Jpeg(Vec<u8>),
    /// The whole picture, RGBA.
    Painted(Vec<u8>),
}

/// Reads a GLB that was downloaded here or written by the command line. No picture is decoded.
///
/// # Errors
/// `damaged-glb`, `foreign-glb` or `newer-glb`.
#[wasm_bindgen(js_name = reopenGlb)]
pub fn reopen_glb(bytes: &[u8]) -> Result<ReopenedFace, JsValue> {
    Ok(reopen(bytes).map_err(Trouble::from)?.into())
}

impl From<Reopened<'_>> for ReopenedFace {
    fn from(face: Reopened<'_>) -> Self {
        let (picture_size_px, crop_at_px, pixels) = match face.texture {
            Some(texture) => (texture.picture_size_px, texture.at_px, Pixels::Jpeg(texture.encoded.to_vec())),
            None => {
                let painted = face.painted();
                ([painted.width, painted.height], [0, 0], Pixels::Painted(painted.rgba))
            }
        };
        Self {
            photo_size_px: face.photo_size_px,
            landmarks: face.landmarks.concat(),
            colours: face.colours_srgb.concat(),
            triangulation: face.triangulation,
            density: face.density,
            edits: face.history.unwrap_or_else(|| project::to_json(&[])),
            picture_size_px,
            crop_at_px,
            pixels,
        }
    }
}

#[wasm_bindgen]
impl ReopenedFace {
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

    /// 468 × (x/W, y/H, z/W).
    pub fn landmarks(&self) -> Vec<f32> {
        self.landmarks.clone()
    }

    /// 468 × (red, green, blue), sRGB.
    pub fn colours(&self) -> Vec<u8> {
        self.colours.clone()
    }

    /// How the landmarks are joined.
    #[wasm_bindgen(getter)]
    pub fn triangulation(&self) -> TriangulationName {
        self.triangulation.into()
    }

    /// How often the mesh was subdivided, for `setDensity`.
    #[wasm_bindgen(getter)]
    pub fn density(&self) -> u32 {
        self.density
    }

    /// The edits, for `openEdits`.
    #[wasm_bindgen(getter)]
    pub fn edits(&self) -> String {
        self.edits.clone()
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

    /// Left of the part of the picture that the file holds, in px.
    #[wasm_bindgen(getter, js_name = cropLeft)]
    pub fn crop_left(&self) -> i32 {
        self.crop_at_px[0]
    }

    /// Top of that part in px.
    #[wasm_bindgen(getter, js_name = cropTop)]
    pub fn crop_top(&self) -> i32 {
        self.crop_at_px[1]
    }

    /// That part as a JPEG file; undefined where the file holds no photo.
    #[wasm_bindgen(js_name = takeJpeg)]
    pub fn take_jpeg(&mut self) -> Option<Vec<u8>> {
        match &mut self.pixels {
            Pixels::Jpeg(jpeg) => Some(std::mem::take(jpeg)),
            Pixels::Painted(_) => None,
        }
    }

    /// What stands in for the photo where the file holds none: the landmarks' colours blended over the face, RGBA.
    #[wasm_bindgen(js_name = takePainted)]
    pub fn take_painted(&mut self) -> Option<Vec<u8>> {
        match &mut self.pixels {
            Pixels::Jpeg(_) => None,
            Pixels::Painted(rgba) => Some(std::mem::take(rgba)),
        }
    }
}
