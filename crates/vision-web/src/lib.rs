//! Façade of the worker: everything with pixels and files. It opens photos and saved faces, keeps their pictures, bakes
//! the texture, writes files, and follows a face in a camera stream.
//!
//! Errors are thrown as `Error` with a stable `code`, a `hint` and a `message`. A panic is a bug and traps; the page
//! then restarts the worker.

mod error;
mod file_options;
mod limits;
mod messages;
mod opened;
mod paper;
mod pictures;
mod progress;
mod vision;

pub use file_options::FileOptions;
pub use limits::{check_file, check_size, sniffed_bytes};
pub use messages::{FaceRequest, OpenedFace, OpenedFile, OpenedKind, PrintedBody, RawPicture, SolidFacts, WrittenFile};
pub use paper::{PaperClaims, PaperMethod, PaperResults, PaperRow, PaperRun};
pub use vision::Vision;
