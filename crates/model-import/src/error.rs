use thiserror::Error;

/// Why a network could not be imported.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The loader script has no `loadPackage({…})` with a list of files.
    #[error("the loader script has no list of files: {reason}")]
    NoFileList {
        /// What was missing or wrong.
        reason: String,
    },
    /// The list of files does not name this one.
    #[error("the package has no file {name}")]
    NoSuchFile {
        /// File name without its folder.
        name: String,
    },
    /// The list of files points outside the packed bytes.
    #[error("{name} is said to be bytes {start}..{end}, but there are {available}")]
    OutsidePackage {
        /// File name without its folder.
        name: String,
        /// First byte.
        start: usize,
        /// One past the last byte.
        end: usize,
        /// Length of the packed bytes.
        available: usize,
    },
    /// The file is not the one this conversion was checked on.
    #[error("{name} has sha256 {found}, expected {expected}")]
    OtherFile {
        /// File name without its folder.
        name: String,
        /// Hexadecimal SHA-256 wanted.
        expected: String,
        /// Hexadecimal SHA-256 of the bytes.
        found: String,
    },
    /// The bytes are no well-formed TFLite file.
    #[error("damaged TFLite file: {what} at byte {offset}")]
    Damaged {
        /// What was being read.
        what: &'static str,
        /// Where in the file.
        offset: usize,
    },
    /// The network has no tensor of this name to be cut at.
    #[error("the network has no tensor {name}")]
    NoSuchTensor {
        /// The name.
        name: String,
    },
    /// The network uses something this converter does not know.
    #[error("operator {operator} ({output}): {what} is not supported")]
    Unsupported {
        /// TFLite's number of the operator.
        operator: i32,
        /// Name of the tensor it makes.
        output: String,
        /// What about it.
        what: String,
    },
}
