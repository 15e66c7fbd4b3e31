use std::io::{self, Write};
use std::path::{Path, PathBuf};

use rosto::Error;
use rosto_export::ExportError;
use rosto_face::{FaceError, MAX_PHOTOS};
use rosto_landmarks::LandmarksError;
use rosto_photo::PhotoError;
use rosto_studio::StudioError;
use thiserror::Error;

use crate::input::{self, ReadError};
use crate::terminal;

mod hint;

const _: () = assert!(MAX_PHOTOS == 5, "CliError::TooManyPhotos writes the limit as a word");

/// Error of a command; [`CliError::exit_code`] maps it to the exit code.
#[derive(Debug, Error)]
pub enum CliError {
    #[error("{flag} has no effect: {reason}")]
    NoEffect { flag: String, reason: String },
    #[error("standard input (-) is given more than once")]
    StandardInputTwice,
    #[error("{}: the output would overwrite the input {}", named(path), named(input))]
    OverwritesInput { path: PathBuf, input: PathBuf },
    #[error("{}: {reason}", named(path))]
    Unreadable { path: PathBuf, reason: ReadError },
    #[error("{}: {reason}", named(path))]
    InvalidPicture { path: PathBuf, reason: PhotoError },
    #[error("{}: no photos in this folder{}", named(path), other_files(*skipped))]
    NoPhotos { path: PathBuf, skipped: usize },
    #[error("a mesh takes at most five photos of one face; {given} were given")]
    TooManyPhotos { given: usize },
    #[error("{}: internal error on this photo", named(path))]
    InternalError { path: PathBuf },
    #[error("{}: line {line} was not written with these options", named(path))]
    OtherOptions { path: PathBuf, line: usize },
    #[error("{}: another process is writing this file", named(path))]
    InUse { path: PathBuf },
    #[error("{}: the file exists, and Rosto did not write it for {}", named(path), named(for_file))]
    Foreign { path: PathBuf, for_file: PathBuf },
    #[error("{} and {} have the same output, {}", named(one), named(other), named(path))]
    SameOutput { one: PathBuf, other: PathBuf, path: PathBuf },
    #[error("{}: no face found", named(path))]
    NoFace { path: PathBuf },
    #[error("{}: {reason}", named(path))]
    NoModel { path: PathBuf, reason: FaceError },
    #[error(
        "{}: this photo does not agree with the others: half of its landmarks are at least {reprojection_px:.0} px from \
         where the others place them; the limit is {most_px:.0} px",
        named(path)
    )]
    AnotherFace { path: PathBuf, reprojection_px: f64, most_px: f64 },
    #[error("photos failed: {count}")]
    SomePhotosFailed { count: usize },
    #[error("photos failed: {count}, {by_networks} of them because of the networks")]
    NetworksFailed { count: usize, by_networks: usize },
    #[error("{}: {reason}", named(path))]
    EditsUnreadable { path: PathBuf, reason: ReadError },
    #[error("{}: {reason}", named(path))]
    EditsFile { path: PathBuf, reason: String },
    #[error("{}: the file is UTF-16", named(path))]
    EditsUtf16 { path: PathBuf },
    #[error("{}: unknown file extension; use one of {}", named(path), extensions())]
    UnknownFormat { path: PathBuf },
    #[error("{}: image coordinates can only be written as .json", named(path))]
    ImageUnits { path: PathBuf },
    #[error("{}: unknown file extension; use .jpg or .png", named(path))]
    UnknownPictureFormat { path: PathBuf },
    #[error("{}: {reason}", named(path))]
    NotEncoded { path: PathBuf, reason: image::ImageError },
    #[error("{}: {reason}", named(path))]
    Unwritable { path: PathBuf, reason: io::Error },
    #[error("standard output: {0}")]
    Output(io::Error),
    #[error("face networks not found in {}", looked_in.iter().map(|path| named(path)).collect::<Vec<_>>().join(" or "))]
    NetworksMissing { looked_in: Vec<PathBuf> },
    #[error("{}: network not found, although the other one is in that folder", named(path))]
    NetworkMissing { path: PathBuf },
    #[error("{}: {reason}", named(path))]
    NetworkUnreadable { path: PathBuf, reason: ReadError },
    #[error(transparent)]
    Networks(#[from] LandmarksError),
    #[error("{}: invalid result of the networks: landmark {landmark} is not finite", named(path))]
    NonFiniteLandmark { path: PathBuf, landmark: usize },
    #[error(transparent)]
    Request(#[from] rosto::Error),
}

impl CliError {
    /// The error of a request, with the path of the photo that caused it.
    pub fn in_photos(reason: Error, paths: &[&Path]) -> Self {
        let path = |photo: usize| paths.get(photo).map_or_else(PathBuf::new, |path| path.to_path_buf());
        match reason {
            Error::Face(FaceError::InPhoto { photo, reason }) => Self::NoModel { path: path(photo), reason: *reason },
            Error::Face(FaceError::AnotherFace { photo, reprojection_px, most_px }) => {
                Self::AnotherFace { path: path(photo), reprojection_px, most_px }
            }
            Error::Face(reason) => Self::NoModel { path: path(0), reason },
            reason => Self::Request(reason),
        }
    }

    /// Writes the error and its hint to standard error.
    pub fn report(&self) {
        let mut text = format!("rosto: {}\n", terminal::escaped(&self.to_string()));
        if let Some(hint) = self.hint() {
            text += &format!("  {hint}\n");
        }
        // The exit code still reports the failure.
        let _ = io::stderr().write_all(text.as_bytes());
    }

    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Output(reason) if reason.kind() == io::ErrorKind::BrokenPipe)
    }

    /// Whether the networks caused the error, rather than the photo.
    pub fn is_network_failure(&self) -> bool {
        self.exit_code() == 7
    }

    /// Whether a result could not be written; later ones would fail as well.
    pub fn is_write_failure(&self) -> bool {
        self.exit_code() == 6
    }

    /// Exit code, as `--help` lists them.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::NoEffect { .. }
            | Self::StandardInputTwice
            | Self::OverwritesInput { .. }
            | Self::UnknownFormat { .. } => 2,
            Self::ImageUnits { .. } | Self::UnknownPictureFormat { .. } | Self::OtherOptions { .. } => 2,
            Self::SameOutput { .. } | Self::Foreign { .. } | Self::TooManyPhotos { .. } => 2,
            Self::EditsUnreadable { .. } | Self::EditsFile { .. } | Self::EditsUtf16 { .. } => 2,
            Self::Unreadable { .. } | Self::InvalidPicture { .. } | Self::NoPhotos { .. } => 3,
            Self::SomePhotosFailed { .. } => 3,
            Self::NoModel { reason: FaceError::NotACard, .. } => 2,
            Self::NoFace { .. } | Self::AnotherFace { .. } => 4,
            // An offset of 1e300 is a valid edit, but exceeds the file's precision.
            Self::Request(Error::Edit { .. } | Error::Export(ExportError::NotFinite { .. })) => 5,
            Self::Request(Error::Export(ExportError::Solid(_))) => 5,
            // Too little of the face lies in the photo to warp it.
            Self::Request(Error::Studio(StudioError::Warp(_))) => 5,
            Self::Unwritable { .. } | Self::InUse { .. } | Self::Output(_) => 6,
            Self::NetworksMissing { .. } | Self::NetworkMissing { .. } | Self::NetworkUnreadable { .. } => 7,
            Self::Networks(_) | Self::NetworksFailed { .. } | Self::NonFiniteLandmark { .. } => 7,
            Self::InternalError { .. } | Self::NoModel { .. } | Self::NotEncoded { .. } | Self::Request(_) => 1,
        }
    }
}

fn other_files(skipped: usize) -> String {
    match skipped {
        0 => String::new(),
        1 => "; it has 1 other file".to_owned(),
        _ => format!("; it has {skipped} other files"),
    }
}

fn named(path: &Path) -> String {
    match input::is_standard_input(path) {
        true => "standard input".to_owned(),
        false => path.display().to_string(),
    }
}

/// File extensions, by format.
pub fn extensions() -> String {
    rosto_export::Format::ALL.map(|format| format!(".{}", format.id())).join(", ")
}
