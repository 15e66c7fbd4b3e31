use crate::ShapePart;

/// Share by which the panel offers to make a face symmetric at first.
pub(crate) const SYMMETRY_SHARE: f64 = 0.5;

/// State that only panels have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PanelState {
    pub is_expert: bool,
    pub part: ShapePart,
    pub symmetry_share: f64,
    pub tape: Option<Tape>,
}

/// The measuring tape.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tape {
    /// Vertex at its start.
    pub from: u32,
    /// Vertex at its end, and the distance in mm: straight, and along the surface.
    pub measured: Option<(u32, [f64; 2])>,
}

impl Default for PanelState {
    fn default() -> Self {
        Self { is_expert: false, part: ShapePart::default(), symmetry_share: SYMMETRY_SHARE, tape: None }
    }
}

impl PanelState {
    /// The state for another face.
    pub fn for_another_face(self) -> Self {
        Self { is_expert: self.is_expert, part: self.part, ..Self::default() }
    }
}
