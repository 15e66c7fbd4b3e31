use serde::Serialize;
use tsify::Tsify;

/// Extent of a change made by an intent. Each variant includes those before it: showing a document also shows a tick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Changed {
    /// No change.
    #[default]
    Nothing,
    /// The view, such as the camera or the hovered vertex: redraw.
    View,
    /// The offset of the edit in progress: read [`Tick`](crate::Tick).
    Tick,
    /// The selection, settings, prepared edit or history: read [`State`](crate::State).
    Document,
    /// The mesh: vertices, triangles or the face.
    Mesh,
}
