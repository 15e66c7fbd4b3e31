//! Input and output of the landmark networks.

/// Number of landmarks of a face, without the irises.
pub const LANDMARK_COUNT: usize = 468;

/// Side of the networks' input, px.
pub(crate) const SIDE: usize = 192;
/// Name of the networks in errors.
pub(crate) const NAME: &str = "landmark";

/// A network's output: points in px of its input, and the logit of the face flag.
pub(crate) struct RawMesh {
    pub(crate) points: Vec<[f32; 3]>,
    pub(crate) flag: f32,
}
