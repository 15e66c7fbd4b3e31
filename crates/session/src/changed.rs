/// What carrying out an intent has changed. Each takes in those before it: what shows a document also shows a tick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Changed {
    /// Nothing.
    #[default]
    Nothing,
    /// What is seen, such as the camera or what the pointer is on: draw.
    View,
    /// How far the edit in progress has gone: show [`Tick`](crate::Tick).
    Tick,
    /// What is selected, chosen, held or done: show the whole [`State`](crate::State).
    Document,
    /// The mesh itself: vertices, triangles or the face.
    Mesh,
}
