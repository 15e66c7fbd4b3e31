use std::io::{self, Write};
use std::path::{Path, PathBuf};

use rosto_export::ExportError;
use rosto_face::{FaceError, MOST_PHOTOS};
use rosto_landmarks::LandmarksError;
use rosto_photo::PhotoError;
use rosto_studio::StudioError;
use thiserror::Error;

use crate::input::{self, ReadError};
use crate::terminal;

mod hint;

const _: () = assert!(MOST_PHOTOS == 5, "CliError::TooManyPhotos says five");

/// Why the program cannot do what it was asked.
#[derive(Debug, Error)]
pub enum CliError {
    #[error("{flag} would change nothing: {reason}")]
    Useless { flag: &'static str, reason: &'static str },
    #[error("{reason}")]
    NotUnderstood { reason: String },
    #[error("standard input is asked for twice, and can be read once")]
    StandardInputTwice,
    #[error("{}: {} is read, and would be overwritten", named(path), named(input))]
    OverInput { path: PathBuf, input: PathBuf },
    #[error("{}: {reason}", named(path))]
    Unreadable { path: PathBuf, reason: ReadError },
    #[error("{}: {reason}", named(path))]
    NoPicture { path: PathBuf, reason: PhotoError },
    #[error("{}: there are no photos in this folder{}", named(path), others(*skipped))]
    NoPhotos { path: PathBuf, skipped: usize },
    #[error("a mesh is made of at most five photos of one face, and {given} are given")]
    TooManyPhotos { given: usize },
    #[error("{}: this photo broke the program", named(path))]
    Broke { path: PathBuf },
    #[error("{}: line {line} was not written by this request", named(path))]
    AnotherJournal { path: PathBuf, line: usize },
    #[error("{}: another process is writing it", named(path))]
    InUse { path: PathBuf },
    #[error("{}: this file is there already, and Rosto did not write it for {}", named(path), named(for_file))]
    Foreign { path: PathBuf, for_file: PathBuf },
    #[error("{} and {} would both be written to {}", named(one), named(other), named(path))]
    SameOutput { one: PathBuf, other: PathBuf, path: PathBuf },
    #[error("{}: no face found", named(path))]
    NoFace { path: PathBuf },
    #[error("{}: {reason}", named(path))]
    NoModel { path: PathBuf, reason: FaceError },
    #[error(
        "{}: this does not agree with the other photos: half of its landmarks are {reprojection_px:.0} px and more from \
         where theirs would be, and {most_px:.0} px is the limit",
        named(path)
    )]
    AnotherFace { path: PathBuf, reprojection_px: f64, most_px: f64 },
    #[error("{count} of the photos failed")]
    SomePhotosFailed { count: usize },
    #[error("{count} of the photos failed, {by_networks} of them because of the networks")]
    NetworksFailed { count: usize, by_networks: usize },
    #[error("{}: {reason}", named(path))]
    EditsUnreadable { path: PathBuf, reason: ReadError },
    #[error("{}: {reason}", named(path))]
    EditsFile { path: PathBuf, reason: String },
    #[error("{}: this is UTF-16 text", named(path))]
    EditsUtf16 { path: PathBuf },
    #[error("edit {number} ({what}): {reason}")]
    Edit { number: usize, what: String, reason: StudioError },
    #[error("{}: its name does not end as a format is called: {}", named(path), endings())]
    UnknownFormat { path: PathBuf },
    #[error("{}: a photo is written as .jpg or .png", named(path))]
    NoPictureFormat { path: PathBuf },
    #[error("{}: {reason}", named(path))]
    NotEncoded { path: PathBuf, reason: image::ImageError },
    #[error("{}: {reason}", named(path))]
    Unwritable { path: PathBuf, reason: io::Error },
    #[error("standard output: {0}")]
    Output(io::Error),
    #[error("the face networks are not in {}", looked_in.iter().map(|path| named(path)).collect::<Vec<_>>().join(", nor in "))]
    NetworksMissing { looked_in: Vec<PathBuf> },
    #[error("{}: this network is missing; the other one is there", named(path))]
    NetworkMissing { path: PathBuf },
    #[error("{}: {reason}", named(path))]
    NetworkUnreadable { path: PathBuf, reason: ReadError },
    #[error(transparent)]
    Networks(#[from] LandmarksError),
    #[error("{}: the networks answer with a face that has no place: landmark {landmark} is not finite", named(path))]
    NoPlace { path: PathBuf, landmark: usize },
    #[error(transparent)]
    Export(#[from] ExportError),
    #[error(transparent)]
    Studio(#[from] StudioError),
}

impl CliError {
    /// Says on standard error what went wrong and what to do.
    pub fn report(&self) {
        let mut text = format!("rosto: {}\n", terminal::escaped(&self.to_string()));
        if let Some(hint) = self.hint() {
            text += &format!("  {hint}\n");
        }
        // Where nobody can be told, the exit code still tells.
        let _ = io::stderr().write_all(text.as_bytes());
    }

    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Output(reason) if reason.kind() == io::ErrorKind::BrokenPipe)
    }

    /// Whether the networks are to blame, and not what they were shown.
    pub fn is_of_networks(&self) -> bool {
        self.exit_code() == 7
    }

    /// Whether the result could not be written: the next one could not be either.
    pub fn is_of_output(&self) -> bool {
        self.exit_code() == 6
    }

    /// As `--help` lists them.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::NotUnderstood { .. } => 2,
            Self::Useless { .. } | Self::StandardInputTwice | Self::OverInput { .. } | Self::UnknownFormat { .. } => 2,
            Self::NoPictureFormat { .. } | Self::AnotherJournal { .. } => 2,
            Self::SameOutput { .. } | Self::Foreign { .. } | Self::TooManyPhotos { .. } => 2,
            Self::EditsUnreadable { .. } | Self::EditsFile { .. } | Self::EditsUtf16 { .. } => 2,
            Self::Unreadable { .. } | Self::NoPicture { .. } | Self::NoPhotos { .. } => 3,
            Self::SomePhotosFailed { .. } => 3,
            Self::NoFace { .. } | Self::AnotherFace { .. } => 4,
            // An offset of 1e300 can be made, but not written.
            Self::Edit { .. } | Self::Export(ExportError::NotFinite { .. }) => 5,
            Self::Export(ExportError::Solid(_)) => 5,
            // Of the face too little is in the photo to be moved there.
            Self::Studio(StudioError::Warp(_)) => 5,
            Self::Unwritable { .. } | Self::InUse { .. } | Self::Output(_) => 6,
            Self::NetworksMissing { .. } | Self::NetworkMissing { .. } | Self::NetworkUnreadable { .. } => 7,
            Self::Networks(_) | Self::NetworksFailed { .. } | Self::NoPlace { .. } => 7,
            Self::Broke { .. } | Self::NoModel { .. } | Self::NotEncoded { .. } | Self::Export(_) | Self::Studio(_) => {
                1
            }
        }
    }
}

fn others(skipped: usize) -> String {
    match skipped {
        0 => String::new(),
        1 => ", but a file that is not one".to_owned(),
        _ => format!(", but {skipped} files that are not"),
    }
}

fn named(path: &Path) -> String {
    match input::is_standard_input(path) {
        true => "standard input".to_owned(),
        false => path.display().to_string(),
    }
}

/// How the names of files end, by format.
pub fn endings() -> String {
    rosto_export::Format::ALL.map(|format| format!(".{}", format.id())).join(", ")
}
