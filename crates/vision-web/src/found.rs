use rosto_landmarks::{Face, LANDMARK_COUNT};
use rosto_photo::Photo;
use wasm_bindgen::prelude::*;

/// Faces found in a photo. Call `free()` after reading the results.
#[wasm_bindgen]
pub struct Found {
    width: u32,
    height: u32,
    focal_length_35mm: Option<f64>,
    faces: Vec<FoundFace>,
    picture_width: u32,
    picture_height: u32,
    picture: Vec<u8>,
}

struct FoundFace {
    is_doubtful: bool,
    landmarks: Vec<f32>,
    colours: Vec<u8>,
}

/// Maximum side of the texture in px. Devices support at least 2048 px.
const MAX_PICTURE_SIDE_PX: u32 = 2048;

impl Found {
    pub(crate) fn new(photo: &Photo, faces: &[Face]) -> Self {
        let picture = photo.scaled_down(MAX_PICTURE_SIDE_PX);
        Self {
            width: photo.width(),
            height: photo.height(),
            focal_length_35mm: photo.focal_length_35mm(),
            faces: faces.iter().map(|face| FoundFace::new(photo, face)).collect(),
            picture_width: picture.width(),
            picture_height: picture.height(),
            picture: picture.rgba(),
        }
    }

    fn face(&self, index: u32) -> Option<&FoundFace> {
        self.faces.get(index as usize)
    }
}

impl FoundFace {
    /// Reads the colours at full resolution.
    fn new(photo: &Photo, face: &Face) -> Self {
        let colour = |&[x, y, _]: &[f32; 3]| photo.colour_under(x.into(), y.into());
        Self {
            is_doubtful: face.is_doubtful(),
            landmarks: face.landmarks.concat(),
            colours: face.landmarks.iter().take(LANDMARK_COUNT).flat_map(colour).collect(),
        }
    }
}

#[wasm_bindgen]
impl Found {
    /// Width of the upright photo in px.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height of the upright photo in px.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// 35 mm equivalent focal length in mm, if the EXIF data has it.
    #[wasm_bindgen(getter, js_name = focalLength35mm)]
    pub fn focal_length_35mm(&self) -> Option<f64> {
        self.focal_length_35mm
    }

    /// Number of faces, which can be 0.
    #[wasm_bindgen(getter, js_name = faceCount)]
    pub fn face_count(&self) -> u32 {
        self.faces.len() as u32
    }

    /// Whether the detection may not be a face; true for an invalid index.
    #[wasm_bindgen(js_name = isDoubtful)]
    pub fn is_doubtful(&self, face: u32) -> bool {
        self.face(face).is_none_or(|face| face.is_doubtful)
    }

    /// 478 × (x/W, y/H, z/W), irises last; empty for an invalid index.
    pub fn landmarks(&self, face: u32) -> Vec<f32> {
        self.face(face).map_or_else(Vec::new, |face| face.landmarks.clone())
    }

    /// 468 × (red, green, blue) at the landmarks, sRGB; empty for an invalid index.
    pub fn colours(&self, face: u32) -> Vec<u8> {
        self.face(face).map_or_else(Vec::new, |face| face.colours.clone())
    }

    /// Width of the picture in px.
    #[wasm_bindgen(getter, js_name = pictureWidth)]
    pub fn picture_width(&self) -> u32 {
        self.picture_width
    }

    /// Height of the picture in px.
    #[wasm_bindgen(getter, js_name = pictureHeight)]
    pub fn picture_height(&self) -> u32 {
        self.picture_height
    }

    /// The upright photo, scaled down to at most 2048 px, as opaque RGBA. The second call returns an empty array.
    #[wasm_bindgen(js_name = takePicture)]
    pub fn take_picture(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.picture)
    }
}
