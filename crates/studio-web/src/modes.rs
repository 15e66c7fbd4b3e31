//! The words the page uses for choices; they become TypeScript string unions.

#![expect(missing_docs, reason = "wasm-bindgen adds a variant and functions of its own, without words")]

use rosto_face::{Language, Triangulation};
use rosto_studio::Operator;
use rosto_viewport::{Axis, Pointer};
use wasm_bindgen::prelude::*;

use crate::trouble::{Outcome, Trouble};

/// How the surface is coloured.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PaintName {
    /// The photo itself, as texture.
    Photo = "photo",
    /// The colour under each landmark, blended between them: the paper's way.
    Colours = "colours",
    /// A plain, warm grey material.
    Clay = "clay",
    /// The direction the surface faces, as colour.
    Normals = "normals",
    /// How far each vertex follows the selected one.
    Response = "response",
    /// How much the edits bent the surface.
    Distortion = "distortion",
}

/// A named direction to look from.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ViewName {
    /// Straight at the face.
    Front = "front",
    /// The face's own left side.
    Left = "left",
    /// From above.
    Top = "top",
    /// Front, centred, at the first distance.
    Reset = "reset",
}

/// Light or dark page.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThemeName {
    /// Dark marks on a light ground.
    Light = "light",
    /// Light marks on a dark ground.
    Dark = "dark",
}

/// Language of names.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LanguageName {
    /// English.
    English = "en",
    /// Portuguese.
    Portuguese = "pt",
}

/// Units of a mesh written as JSON.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitsName {
    /// MediaPipe's normalised picture coordinates, as in the paper.
    Image = "image",
    /// The model's millimetres.
    Millimetres = "mm",
}

/// An axis of the model: x to the face's left, y up, z out of the face.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisName {
    /// Towards the face's left.
    X = "x",
    /// Up.
    Y = "y",
    /// Out of the face.
    Z = "z",
}

/// What a click or a drag on the face takes in hand.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HandName {
    /// The landmark itself.
    Landmark = "landmark",
    /// The named part of the face around it.
    Region = "region",
    /// Any vertex of the mesh that is shown.
    Point = "point",
}

/// What points at the canvas, as the browser's pointer events name it.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointerName {
    /// A mouse.
    Mouse = "mouse",
    /// A pen.
    Pen = "pen",
    /// A finger.
    Touch = "touch",
}

impl From<PointerName> for Pointer {
    fn from(pointer: PointerName) -> Self {
        if pointer == PointerName::Touch { Self::Coarse } else { Self::Fine }
    }
}

/// How the mesh's details are described while it is edited.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OperatorName {
    /// `L_s = D − Adj`, the paper's default.
    UniformSymmetric = "L_s",
    /// `L = I − D⁻¹Adj`.
    Uniform = "L",
    /// Weighted by degree.
    Degree = "degree",
    /// Weighted by inverse edge length.
    InverseLength = "length",
    /// Cotangent weights.
    Cotangent = "cotangent",
}

/// How firmly handles and anchors are held.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HoldName {
    /// Unit weights, as in the paper: a handle reaches part of its offset.
    Soft = "soft",
    /// The handle lands on its target and anchors stay.
    Exact = "exact",
}

/// Whether details turn with the surface that carries them.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DetailsName {
    /// They keep their direction, as in the paper.
    Kept = "kept",
    /// They turn, as rigid as possible; each tick solves several times.
    Turned = "turned",
}

/// What stays where it is during an edit.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AnchorsName {
    /// Two random vertices, new for each selection: the paper's way.
    Random = "random",
    /// The outline of the face.
    Oval = "oval",
    /// Only vertices pinned by hand.
    Pinned = "pinned",
}

/// What a downloaded model carries as colour.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExportPaintName {
    /// A crop of the photo as texture.
    Texture = "texture",
    /// Linear vertex colours.
    VertexColours = "colours",
}

/// Whether light falls on a downloaded model.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExportShadingName {
    /// As on any other object.
    Lit = "lit",
    /// None: every colour as photographed.
    Unlit = "unlit",
}

/// How a downloaded model carries the edits.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExportEditsName {
    /// The edited face is the mesh.
    Shape = "shape",
    /// The unedited face is the mesh, and each edit a named morph target at weight 1.
    MorphTargets = "morph-targets",
}

/// Kinds of file beside GLB that a mesh is written to.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeshFormatName {
    /// Wavefront OBJ: metres, with colours by custom.
    Obj = "obj",
    /// Binary PLY: metres, with colours.
    Ply = "ply",
    /// Binary STL for printing: millimetres, without colours.
    Stl = "stl",
}

/// Which triangulation joins the 468 landmarks.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TriangulationName {
    /// MediaPipe's drawing tessellation: eyes and mouth open.
    Tessellation = "tessellation",
    /// The canonical face model: eyes and mouth filled.
    Canonical = "canonical",
}

impl From<Triangulation> for TriangulationName {
    fn from(triangulation: Triangulation) -> Self {
        match triangulation {
            Triangulation::Tessellation => Self::Tessellation,
            Triangulation::Canonical => Self::Canonical,
        }
    }
}

/// What the paper's Table 1 times.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskName {
    /// Photo to landmarks.
    Extraction = "extraction",
    /// Landmarks to coloured mesh.
    Generation = "generation",
    /// Moving a vertex by the small offset.
    SmallEdit = "small-edit",
    /// Moving a vertex by the large offset.
    LargeEdit = "large-edit",
}

impl From<Operator> for OperatorName {
    fn from(operator: Operator) -> Self {
        match operator {
            Operator::UniformSymmetric => Self::UniformSymmetric,
            Operator::Uniform => Self::Uniform,
            Operator::Degree => Self::Degree,
            Operator::InverseLength => Self::InverseLength,
            Operator::Cotangent => Self::Cotangent,
        }
    }
}

impl From<Axis> for AxisName {
    fn from(axis: Axis) -> Self {
        match axis {
            Axis::X => Self::X,
            Axis::Y => Self::Y,
            Axis::Z => Self::Z,
        }
    }
}

impl AxisName {
    pub(crate) fn axis(self) -> Outcome<Axis> {
        match self {
            Self::X => Ok(Axis::X),
            Self::Y => Ok(Axis::Y),
            Self::Z => Ok(Axis::Z),
            _ => Err(Trouble::bad_choice()),
        }
    }
}

impl LanguageName {
    pub(crate) fn language(self) -> Outcome<Language> {
        match self {
            Self::English => Ok(Language::English),
            Self::Portuguese => Ok(Language::Portuguese),
            _ => Err(Trouble::bad_choice()),
        }
    }
}
