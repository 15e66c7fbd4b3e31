//! The words the page uses for choices; they become TypeScript string unions.

#![expect(missing_docs, reason = "wasm-bindgen adds a variant and functions of its own, without words")]

use rosto_face::{Language, Triangulation};
use rosto_session::{AnchorChoice, Changed, Preset, SelectionMode};
use rosto_stage::{Axis, NamedView, Pointer, ShadingMode, Theme};
use rosto_studio::{ConstraintKind, Details, Operator};
use wasm_bindgen::prelude::*;

use crate::error::{FacadeError, Result};

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

/// Choices that go together.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PresetName {
    /// What a hand expects.
    Sculpt = "sculpt",
    /// The paper's edit.
    Paper = "paper",
}

/// What an intent has changed, and so what is to be read again.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeName {
    /// Nothing.
    Nothing = "nothing",
    /// What is seen: draw.
    View = "view",
    /// How far the edit in progress has gone: draw, and read `tick()`.
    Tick = "tick",
    /// Anything: draw, and read `state()` as well.
    Document = "document",
}

/// Why what is selected cannot be moved.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RefusalName {
    /// Nothing else is held, so that the whole face would follow.
    Unanchored = "unanchored",
    /// Any other reason.
    Other = "other",
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

/// What a file is.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKindName {
    /// Binary glTF.
    Glb = "glb",
    /// A project that was saved here.
    Project = "project",
    /// Anything else, such as a photo.
    Other = "other",
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

impl PaintName {
    pub(crate) fn paint(self) -> Result<ShadingMode> {
        match self {
            Self::Photo => Ok(ShadingMode::Photo),
            Self::Colours => Ok(ShadingMode::Colours),
            Self::Clay => Ok(ShadingMode::Clay),
            Self::Normals => Ok(ShadingMode::Normals),
            Self::Response => Ok(ShadingMode::Response),
            Self::Distortion => Ok(ShadingMode::Distortion),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<ShadingMode> for PaintName {
    fn from(shading: ShadingMode) -> Self {
        match shading {
            ShadingMode::Photo | ShadingMode::Bare => Self::Photo,
            ShadingMode::Colours => Self::Colours,
            ShadingMode::Clay => Self::Clay,
            ShadingMode::Normals => Self::Normals,
            ShadingMode::Response => Self::Response,
            ShadingMode::Distortion => Self::Distortion,
        }
    }
}

impl ViewName {
    pub(crate) fn view(self) -> Result<NamedView> {
        match self {
            Self::Front => Ok(NamedView::Front),
            Self::Left => Ok(NamedView::Left),
            Self::Top => Ok(NamedView::Top),
            Self::Reset => Ok(NamedView::Reset),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl ThemeName {
    pub(crate) fn theme(self) -> Result<Theme> {
        match self {
            Self::Light => Ok(Theme::Light),
            Self::Dark => Ok(Theme::Dark),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl LanguageName {
    pub(crate) fn language(self) -> Result<Language> {
        match self {
            Self::English => Ok(Language::English),
            Self::Portuguese => Ok(Language::Portuguese),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl AxisName {
    pub(crate) fn axis(self) -> Result<Axis> {
        match self {
            Self::X => Ok(Axis::X),
            Self::Y => Ok(Axis::Y),
            Self::Z => Ok(Axis::Z),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<SelectionMode> for HandName {
    fn from(value: SelectionMode) -> Self {
        match value {
            SelectionMode::Landmark => Self::Landmark,
            SelectionMode::Region => Self::Region,
            SelectionMode::Point => Self::Point,
        }
    }
}

impl HandName {
    pub(crate) fn mode(self) -> Result<SelectionMode> {
        match self {
            Self::Landmark => Ok(SelectionMode::Landmark),
            Self::Region => Ok(SelectionMode::Region),
            Self::Point => Ok(SelectionMode::Point),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<Operator> for OperatorName {
    fn from(value: Operator) -> Self {
        match value {
            Operator::UniformSymmetric => Self::UniformSymmetric,
            Operator::Uniform => Self::Uniform,
            Operator::Degree => Self::Degree,
            Operator::InverseLength => Self::InverseLength,
            Operator::Cotangent => Self::Cotangent,
        }
    }
}

impl OperatorName {
    pub(crate) fn operator(self) -> Result<Operator> {
        match self {
            Self::UniformSymmetric => Ok(Operator::UniformSymmetric),
            Self::Uniform => Ok(Operator::Uniform),
            Self::Degree => Ok(Operator::Degree),
            Self::InverseLength => Ok(Operator::InverseLength),
            Self::Cotangent => Ok(Operator::Cotangent),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<Details> for DetailsName {
    fn from(value: Details) -> Self {
        match value {
            Details::Kept => Self::Kept,
            Details::AsRigidAsPossible => Self::Turned,
        }
    }
}

impl DetailsName {
    pub(crate) fn details(self) -> Result<Details> {
        match self {
            Self::Kept => Ok(Details::Kept),
            Self::Turned => Ok(Details::AsRigidAsPossible),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<AnchorChoice> for AnchorsName {
    fn from(value: AnchorChoice) -> Self {
        match value {
            AnchorChoice::Random => Self::Random,
            AnchorChoice::Oval => Self::Oval,
            AnchorChoice::PinsOnly => Self::Pinned,
        }
    }
}

impl AnchorsName {
    pub(crate) fn anchors(self) -> Result<AnchorChoice> {
        match self {
            Self::Random => Ok(AnchorChoice::Random),
            Self::Oval => Ok(AnchorChoice::Oval),
            Self::Pinned => Ok(AnchorChoice::PinsOnly),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<Preset> for PresetName {
    fn from(value: Preset) -> Self {
        match value {
            Preset::Sculpt => Self::Sculpt,
            Preset::Paper => Self::Paper,
        }
    }
}

impl PresetName {
    pub(crate) fn preset(self) -> Result<Preset> {
        match self {
            Self::Sculpt => Ok(Preset::Sculpt),
            Self::Paper => Ok(Preset::Paper),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<Triangulation> for TriangulationName {
    fn from(value: Triangulation) -> Self {
        match value {
            Triangulation::Tessellation => Self::Tessellation,
            Triangulation::Canonical => Self::Canonical,
        }
    }
}

impl TriangulationName {
    pub(crate) fn triangulation(self) -> Result<Triangulation> {
        match self {
            Self::Tessellation => Ok(Triangulation::Tessellation),
            Self::Canonical => Ok(Triangulation::Canonical),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<ConstraintKind> for HoldName {
    fn from(constraint: ConstraintKind) -> Self {
        if constraint == ConstraintKind::Hard { Self::Exact } else { Self::Soft }
    }
}

impl HoldName {
    pub(crate) fn hold(self) -> Result<ConstraintKind> {
        match self {
            Self::Soft => Ok(ConstraintKind::default()),
            Self::Exact => Ok(ConstraintKind::Hard),
            _ => Err(FacadeError::bad_choice()),
        }
    }
}

impl From<Changed> for ChangeName {
    fn from(changed: Changed) -> Self {
        match changed {
            Changed::Nothing => Self::Nothing,
            Changed::View => Self::View,
            Changed::Tick => Self::Tick,
            Changed::Document | Changed::Mesh => Self::Document,
        }
    }
}
