//! The picture that the landmark networks take in, and their answer.

/// Number of landmarks of a face; a finer network adds the irises to them.
pub const LANDMARK_COUNT: usize = 468;

/// Side of the networks' picture in px.
pub(crate) const SIDE: usize = 192;
/// Name of the networks in errors.
pub(crate) const NAME: &str = "landmark";

/// A network's answer in px of its input, and the logit of the face flag.
pub(crate) struct RawMesh {
    pub(crate) points: Vec<[f32; 3]>,
    pub(crate) flag: f32,
}
