//! What the page switches on; these become TypeScript string unions. What it merely passes on, such as what a panel
//! offers, stays a text: see [`rosto_session::Choice`].

#![expect(missing_docs, reason = "wasm-bindgen adds a variant and functions of its own, without words")]

use rosto_session::Changed;
use rosto_stage::Pointer;
use wasm_bindgen::prelude::*;

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

/// Why what is selected cannot be moved.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RefusalName {
    /// Nothing else is held, so that the whole face would follow.
    Unanchored = "unanchored",
    /// Any other reason.
    Other = "other",
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
