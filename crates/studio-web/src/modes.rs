//! Ids on which the page branches, as TypeScript string unions. Ids that the page only passes on, such as the values of
//! a setting, are strings; see [`rosto_session::Choice`].

#![expect(missing_docs, reason = "wasm-bindgen adds an undocumented variant and functions")]

use rosto_session::Changed;
use rosto_stage::Pointer;
use wasm_bindgen::prelude::*;

/// Type of a pointer, named as in the browser's pointer events.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointerName {
    /// A mouse.
    Mouse = "mouse",
    /// A pen.
    Pen = "pen",
    /// Touch.
    Touch = "touch",
}

impl From<PointerName> for Pointer {
    fn from(pointer: PointerName) -> Self {
        if pointer == PointerName::Touch { Self::Coarse } else { Self::Fine }
    }
}

/// Extent of an intent's change, which determines what to read again.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeName {
    /// No change.
    Nothing = "nothing",
    /// The view: draw.
    View = "view",
    /// The edit in progress: draw, and read `tick()`.
    Tick = "tick",
    /// The document: draw, and read `state()` and `tick()`.
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

/// Why the selection cannot be moved.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RefusalName {
    /// No anchor is set, so the whole face would move.
    Unanchored = "unanchored",
    /// Any other reason.
    Other = "other",
}

/// Kind of a file.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKindName {
    /// Binary glTF.
    Glb = "glb",
    /// Rosto project.
    Project = "project",
    /// Another file, such as a photo.
    Other = "other",
}

/// A task that Table 1 of the paper times.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskName {
    /// Photo to landmarks.
    Extraction = "extraction",
    /// Landmarks to the coloured mesh.
    Generation = "generation",
    /// Moving a vertex by the small offset.
    SmallEdit = "small-edit",
    /// Moving a vertex by the large offset.
    LargeEdit = "large-edit",
}
