use thiserror::Error;

/// Why faces could not be looked for. That there is no face is no error.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LandmarksError {
    /// The bytes of a network are not what they should be, which may show only in what it answers.
    #[error("the {network} network is damaged: {reason}")]
    NetworkDamaged {
        /// Which network.
        network: &'static str,
        /// What the reader said, or what was answered.
        reason: String,
    },
    /// A network that was read without complaint could not be run.
    #[error("the {network} network could not be run: {reason}")]
    NetworkFailed {
        /// Which network.
        network: &'static str,
        /// What the runner said.
        reason: String,
    },
}
