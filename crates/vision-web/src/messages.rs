//! Plain objects of the worker's requests and answers, with their TypeScript types.

use js_sys::{Float32Array, Uint8Array, Uint8ClampedArray, Uint32Array};
use rosto::{Photo, Region};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};

use crate::error::{self, Result};

/// An edited face.
#[derive(Debug, Clone, Deserialize, Tsify)]
pub struct FaceRequest {
    /// The photos, as text of the studio's `savedPhotos`.
    pub photos: String,
    /// The edits, as text of the studio's `savedEdits`; undefined for a newly found face.
    pub edits: Option<String>,
    /// Name of the kept picture of each photo.
    pub pictures: Vec<String>,
}

/// Contents of an opened file.
#[derive(Debug, Clone, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct OpenedFile {
    /// Kind of the file.
    pub kind: OpenedKind,
    /// The faces, the most prominent first; a photo can have none.
    pub faces: Vec<OpenedFace>,
    /// Whether another program has changed the mesh; the face opens as it was saved.
    pub changed_elsewhere: bool,
}

/// Kind of an opened file.
#[derive(Debug, Clone, Copy, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum OpenedKind {
    /// A photo.
    Photo,
    /// A GLB or project that Rosto wrote.
    Saved,
}

/// A face in an opened file.
#[derive(Debug, Clone, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct OpenedFace {
    /// The photos, as text for the studio's `open`.
    pub photos: String,
    /// The edits, as text for the studio's `open`; undefined for a newly found face.
    pub edits: Option<String>,
    /// Name of the kept picture of each photo.
    pub pictures: Vec<String>,
    /// Index of the lead photo.
    pub lead: usize,
    /// Width and height of the upright lead photo, in px.
    pub size_px: [u32; 2],
    /// Landmarks in the lead photo, 468 or 478 × (x/width, y/height, z/width), one after the other.
    pub landmarks: Vec<f32>,
    /// Remarks on the face in the lead photo, the most important first; none for a saved face.
    pub remarks: Vec<PhotoRemark>,
}

/// A reason why a face may look worse than usual, by the id of its words and the values in them.
#[derive(Debug, Clone, Copy, Serialize, Tsify)]
#[serde(tag = "id", rename_all = "kebab-case", rename_all_fields = "camelCase")]
pub enum PhotoRemark {
    /// The detection may not be a face.
    MayNotBeAFace,
    /// The face has few pixels.
    TinyFace {
        /// Width of the face, in px of the photo.
        width_px: u32,
    },
    /// Something covers a part of the subject's left cheek.
    CoveredLeftCheek,
    /// Something covers a part of the subject's right cheek.
    CoveredRightCheek,
}

impl From<rosto::PhotoRemark> for PhotoRemark {
    fn from(remark: rosto::PhotoRemark) -> Self {
        match remark {
            rosto::PhotoRemark::MayNotBeAFace { .. } => Self::MayNotBeAFace,
            rosto::PhotoRemark::TinyFace { width_px } => Self::TinyFace { width_px },
            rosto::PhotoRemark::CoveredCheek { cheek: Region::LeftCheek } => Self::CoveredLeftCheek,
            rosto::PhotoRemark::CoveredCheek { .. } => Self::CoveredRightCheek,
        }
    }
}

/// An upright picture.
#[derive(Debug, Clone, Serialize, Tsify)]
pub struct RawPicture {
    /// Width in px.
    pub width: u32,
    /// Height in px.
    pub height: u32,
    /// RGBA, row by row from the top, straight alpha.
    #[serde(with = "tsify::serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint8ClampedArray<ArrayBuffer>")]
    pub rgba: Uint8ClampedArray,
}

/// An exported file; an archive if there are sidecar files.
#[derive(Debug, Clone, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct WrittenFile {
    /// Contents of the file.
    #[serde(with = "tsify::serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint8Array<ArrayBuffer>")]
    pub bytes: Uint8Array,
    /// Extension of the file's name.
    pub extension: String,
    /// Media type.
    pub media_type: String,
}

/// Measures of a body for printing.
#[derive(Debug, Clone, Copy, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SolidFacts {
    /// Enclosed volume, in cm³.
    pub volume_cm3: f64,
    /// Sides of the bounding box, in mm: x, y, z.
    pub size_mm: [f64; 3],
    /// Requested wall thickness, in mm.
    pub asked_mm: f64,
    /// Smallest wall thickness, in mm.
    pub thinnest_mm: f64,
    /// Share of the face, 0 to 1, where the wall is notably thinner than requested.
    pub thin_share: f64,
    /// Distance by which sharp folds were rounded to make room for the wall, in mm; 0 if none were.
    pub moved_mm: f64,
    /// Mass in g if printed in PLA, with shells of 1.2 mm and 15 % infill.
    pub pla_grams: f64,
    /// Whether to print it upright rather than lying on its back.
    pub is_upright: bool,
    /// Area that needs supports, in cm²; 0 if none does.
    pub overhang_cm2: f64,
}

/// A body for printing, for display in place of the face, and its measures.
#[derive(Debug, Clone, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct PrintedBody {
    /// Its measures, in the size of the print.
    pub facts: SolidFacts,
    /// Positions of its vertices in metres, as large as the face: x, y, z.
    #[serde(with = "tsify::serde_wasm_bindgen::preserve")]
    #[tsify(type = "Float32Array<ArrayBuffer>")]
    pub positions_m: Float32Array,
    /// Vertices of its triangles.
    #[serde(with = "tsify::serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint32Array<ArrayBuffer>")]
    pub triangles: Uint32Array,
    /// sRGB colour of each vertex: clay, and amber where the wall is notably thinner than requested.
    #[serde(with = "tsify::serde_wasm_bindgen::preserve")]
    #[tsify(type = "Uint8Array<ArrayBuffer>")]
    pub colours: Uint8Array,
}

/// Converts an answer to a plain object.
pub(crate) fn sent<T: Tsify + Serialize>(answer: &T) -> Result<Ts<T>> {
    answer.into_ts().map_err(|reason| error::internal(&reason.to_string()))
}

/// Reads a plain object.
///
/// # Errors
/// Throws `bad-choice` if it is not of this type.
pub(crate) fn received<T: Tsify + DeserializeOwned>(request: &Ts<T>) -> Result<T> {
    T::from_js(request.js_value()).map_err(|reason| error::bad_choice(&reason.to_string()))
}

impl RawPicture {
    /// Converts a picture in parts, so that only the result exists in full.
    pub(crate) fn of(photo: &Photo) -> Self {
        const ROWS: u32 = 64;
        let (width, height) = (photo.width(), photo.height());
        let rgba = Uint8ClampedArray::new_with_length(4 * width * height);
        for first in (0..height).step_by(ROWS as usize) {
            let last = (first + ROWS).min(height);
            rgba.subarray(4 * width * first, 4 * width * last).copy_from(&photo.rgba_rows(first..last));
        }
        Self { width, height, rgba }
    }
}

impl PrintedBody {
    pub(crate) fn of(printed: &rosto::PrintedBody, solid: rosto::Solid) -> Self {
        let positions_m: Vec<[f32; 3]> =
            printed.face_sized_m().iter().map(|position| position.as_vec3().to_array()).collect();
        Self {
            facts: rosto::SolidFacts::of(&printed.body, solid).into(),
            positions_m: positions_m.as_flattened().into(),
            triangles: printed.body.topology().triangles().as_flattened().into(),
            colours: printed.thinness_colours(solid).as_flattened().into(),
        }
    }
}

impl From<rosto::SolidFacts> for SolidFacts {
    fn from(facts: rosto::SolidFacts) -> Self {
        let rosto::SolidFacts { volume_cm3, asked_mm, thinnest_mm, thin_share, moved_mm, overhang_cm2, .. } = facts;
        let (size_mm, pla_grams) = (facts.size_mm.to_array(), facts.pla_g);
        let is_upright = facts.pose == rosto::PrintPose::Upright;
        Self { volume_cm3, size_mm, asked_mm, thinnest_mm, thin_share, moved_mm, pla_grams, is_upright, overhang_cm2 }
    }
}
