use thiserror::Error;

/// Reasons why a network cannot be imported.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The loader script does not contain `loadPackage({…})` with a list of files.
    #[error("cannot read the list of files in the loader script: {reason}")]
    NoFileList {
        /// The missing or invalid part.
        reason: String,
    },
    /// The list of files does not contain the requested file.
    #[error("the package does not contain {name}")]
    NoSuchFile {
        /// File name without folder.
        name: String,
    },
    /// The list of files refers to bytes outside the package.
    #[error("{name} should be bytes {start}..{end}, but the package has {available} bytes")]
    OutsidePackage {
        /// File name without folder.
        name: String,
        /// First byte.
        start: usize,
        /// One past the last byte.
        end: usize,
        /// Length of the packed bytes.
        available: usize,
    },
    /// The file differs from the version that the conversion was tested with.
    #[error("{name} has SHA-256 {found}; expected {expected}")]
    OtherFile {
        /// File name without folder.
        name: String,
        /// Expected SHA-256, in hexadecimal.
        expected: String,
        /// Actual SHA-256, in hexadecimal.
        found: String,
    },
    /// The bytes are not a well-formed TFLite file.
    #[error("damaged TFLite file: invalid {what} at byte {offset}")]
    Damaged {
        /// The invalid part.
        what: &'static str,
        /// Byte offset in the file.
        offset: usize,
    },
    /// The network does not contain the requested tensor.
    #[error("the network does not contain the tensor {name}")]
    NoSuchTensor {
        /// The name.
        name: String,
    },
    /// The network uses an unsupported feature.
    #[error("operator {operator} ({output}): {what} is not supported")]
    Unsupported {
        /// TFLite's number for the operator.
        operator: i32,
        /// Name of the operator's output tensor.
        output: String,
        /// The unsupported feature.
        what: String,
    },
}
