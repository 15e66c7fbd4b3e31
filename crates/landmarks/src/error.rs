use thiserror::Error;

/// Reasons why a search for faces fails. A picture without a face is not an error.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LandmarksError {
    /// A network's file is not valid, or its output is not finite.
    #[error("the {network} network is damaged: {reason}")]
    NetworkDamaged {
        /// Name of the network.
        network: &'static str,
        /// The reader's message, or the invalid output.
        reason: String,
    },
    /// A valid network could not be run.
    #[error("the {network} network could not be run: {reason}")]
    NetworkFailed {
        /// Name of the network.
        network: &'static str,
        /// The runtime's message.
        reason: String,
    },
}
