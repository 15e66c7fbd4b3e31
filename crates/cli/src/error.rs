use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use rosto_export::ExportError;
use rosto_face::FaceError;
use rosto_landmarks::LandmarksError;
use rosto_laplacian::LaplacianError;
use rosto_photo::PhotoError;
use rosto_studio::StudioError;
use thiserror::Error;

/// Why the program cannot do what it was asked.
#[derive(Debug, Error)]
pub enum CliError {
    #[error("{}: {reason}", path.display())]
    Unreadable { path: PathBuf, reason: io::Error },
    #[error("{}: {reason}", path.display())]
    NoPicture { path: PathBuf, reason: PhotoError },
    #[error("{}: no face found", path.display())]
    NoFace { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    NoModel { path: PathBuf, reason: FaceError },
    #[error("{count} of the photos could not be read")]
    SomePhotosFailed { count: usize },
    #[error("{}: {reason}", path.display())]
    EditsFile { path: PathBuf, reason: String },
    #[error("edit {number} ({what}): {reason}")]
    Edit { number: usize, what: String, reason: StudioError },
    #[error("{}: unknown kind of file", path.display())]
    UnknownFormat { path: PathBuf },
    #[error("{}: {reason}", path.display())]
    Unwritable { path: PathBuf, reason: io::Error },
    #[error("standard output: {0}")]
    Output(io::Error),
    #[error("the face networks are not in {}", looked_in.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", nor in "))]
    NetworksMissing { looked_in: Vec<PathBuf> },
    #[error(transparent)]
    Networks(#[from] LandmarksError),
    #[error(transparent)]
    Export(#[from] ExportError),
    #[error(transparent)]
    Studio(#[from] StudioError),
}

impl CliError {
    /// Says on standard error what went wrong and what to do.
    pub fn report(&self) {
        eprintln!("rosto: {self}");
        if let Some(hint) = self.hint() {
            eprintln!("  {hint}");
        }
    }

    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Output(reason) if reason.kind() == io::ErrorKind::BrokenPipe)
    }

    /// As `--help` lists them.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::EditsFile { .. } | Self::UnknownFormat { .. } => 2,
            Self::Unreadable { .. } | Self::NoPicture { .. } | Self::SomePhotosFailed { .. } => 3,
            Self::NoFace { .. } => 4,
            // An offset of 1e300 can be made, but not written.
            Self::Edit { .. } | Self::Export(ExportError::NotFinite { .. }) => 5,
            Self::Unwritable { .. } | Self::Output(_) => 6,
            Self::NetworksMissing { .. } | Self::Networks(LandmarksError::NetworkDamaged { .. }) => 7,
            Self::NoModel { .. } | Self::Networks(_) | Self::Export(_) | Self::Studio(_) => 1,
        })
    }

    fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Unreadable { reason, .. } if reason.kind() == io::ErrorKind::NotFound => {
                Some("Check the file's name.")
            }
            Self::NoPicture { reason, .. } => Some(reason.hint()),
            Self::NoFace { .. } => Some("The face should fill a tenth of the picture or more and look at the camera."),
            Self::EditsFile { .. } => {
                Some(r#"It should hold a list such as [{"vertex": 4, "offset": [0, 0, 1], "anchors": [10, 152]}]."#)
            }
            Self::Edit { reason: StudioError::Laplacian(reason), .. } => edit_hint(reason),
            Self::Edit { reason: StudioError::NoMirror, .. } => {
                Some("Add --units mm; a vertex of a denser mesh also needs --topology canonical.")
            }
            Self::Edit { reason: StudioError::TooCoarse { .. }, .. } => Some("Give --density as many or more."),
            Self::UnknownFormat { .. } => Some("End its name in .glb, .gltf, .obj, .ply, .stl or .json."),
            Self::Unwritable { .. } => Some("Check that the folder is there and may be written to."),
            Self::NetworksMissing { .. } => {
                Some("Run `cargo xtask setup` in the source tree, or name their folder with --networks.")
            }
            Self::Networks(LandmarksError::NetworkDamaged { .. }) => {
                Some("Run `cargo xtask setup` to obtain them again.")
            }
            _ => None,
        }
    }
}

fn edit_hint(reason: &LaplacianError) -> Option<&'static str> {
    match reason {
        LaplacianError::NoSuchVertex { .. } => {
            Some("The landmarks are numbered 0 to 467; VERTEX@LEVEL is one of a denser mesh.")
        }
        LaplacianError::PinnedHandle { .. } => Some("Name anchors other than the vertex that is moved."),
        LaplacianError::Repeated { .. } => Some("Name each anchor once."),
        _ => None,
    }
}
