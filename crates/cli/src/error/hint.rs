use std::io::{self, ErrorKind};

use rosto::Error;
use rosto_export::{ExportError, SolidError};
use rosto_photo::PhotoError;
use rosto_studio::StudioError;

use super::CliError;
use crate::input::ReadError;

impl CliError {
    /// Suggested remedy, if there is one.
    pub fn hint(&self) -> Option<String> {
        if let Some(hint) = self.fixed_hint() {
            return Some(hint.to_owned());
        }
        match self {
            Self::NoFace { .. } => Error::NoFace { photo: 0 }.hint(),
            Self::Request(reason) => reason.hint(),
            _ => None,
        }
    }

    fn fixed_hint(&self) -> Option<&'static str> {
        match self {
            Self::OverwritesInput { .. } => Some("Choose another name for -o."),
            Self::Unreadable { reason: ReadError::Empty, .. } => Some(PhotoError::NotAPicture.hint()),
            Self::Unreadable { reason, .. } | Self::EditsUnreadable { reason, .. } => read_hint(reason),
            Self::InvalidPicture { reason, .. } => Some(reason.hint()),
            Self::NoPhotos { .. } => Some("Rosto reads .jpg, .jpeg, .jpe, .jfif, .pjpeg, .png and .webp files."),
            Self::TooManyPhotos { .. } => Some("To make one mesh per photo, use {} in the output's name."),
            Self::InternalError { .. } => Some("Please report it, with the photo if you can share it."),
            Self::OtherOptions { .. } => {
                Some("Use the file's original options, another name, or --force. The file is unchanged.")
            }
            Self::InUse { .. } => Some("Wait until that process ends, or use another name."),
            Self::Foreign { .. } => Some("Move the file, use another name, or replace it with --force."),
            Self::SameOutput { .. } => Some("Rename one of the photos, or write the meshes to different folders."),
            Self::AnotherFace { .. } => Some("Use photos of one face; in each, it must be the most prominent."),
            Self::EditsFile { .. } => {
                Some(r#"Expected a list such as [{"vertex": 4, "offset": [0, 0, 1], "anchors": [10, 152]}]."#)
            }
            Self::EditsUtf16 { .. } => Some("Save the file as UTF-8."),
            Self::Request(Error::Edit { reason, .. }) => match reason {
                StudioError::NoMirror | StudioError::NoExpressions { .. } => {
                    Some("Use --units mm; for a vertex of a denser mesh, also --topology canonical.")
                }
                StudioError::TooCoarse { .. } => Some("Raise --density to that level."),
                _ => None,
            },
            Self::Request(Error::Export(ExportError::Solid(SolidError::TooThick { .. }))) => {
                Some("Use a smaller thickness in --solid, or flat:MM.")
            }
            Self::Request(Error::Export(ExportError::Solid(_))) => Some("Use smaller edits or a lower --density."),
            Self::ImageUnits { .. } => Some("Use --units mm, with offsets in millimetres."),
            Self::UnknownFormat { .. } | Self::UnknownPictureFormat { .. } => None,
            Self::Unwritable { reason, .. } => Some(write_hint(reason)),
            Self::Output(reason) if is_full(reason) => {
                Some("The disk is full: free some space, or write to another disk.")
            }
            Self::NetworksMissing { .. } => Some(
                "Run `cargo xtask networks` in the source tree and build again, or pass their folder with --networks.",
            ),
            Self::NetworkMissing { .. } | Self::NetworkUnreadable { .. } => {
                Some("Run `cargo xtask networks` to download both, or pass another folder with --networks.")
            }
            Self::Networks(_) | Self::NonFiniteLandmark { .. } => {
                Some("Run `cargo xtask networks` to download them again.")
            }
            _ => None,
        }
    }
}

fn read_hint(reason: &ReadError) -> Option<&'static str> {
    let ReadError::Io(reason) = reason else { return None };
    match reason.kind() {
        ErrorKind::NotFound => Some("Check the path."),
        ErrorKind::IsADirectory => Some("Pass a file in that folder."),
        ErrorKind::PermissionDenied => Some("Check the file's permissions."),
        _ => None,
    }
}

fn write_hint(reason: &io::Error) -> &'static str {
    match reason.kind() {
        _ if is_full(reason) => {
            "The disk is full: free some space, or write to another disk. An existing file is unchanged."
        }
        ErrorKind::FileTooLarge => "The result exceeds the system's limit on file sizes.",
        ErrorKind::IsADirectory => "Pass a file in that folder.",
        ErrorKind::NotADirectory => "Pass a folder.",
        ErrorKind::InvalidFilename => "Use a shorter name.",
        _ => "Check that the folder exists and that you can write to it.",
    }
}

fn is_full(reason: &io::Error) -> bool {
    matches!(reason.kind(), ErrorKind::StorageFull | ErrorKind::QuotaExceeded)
}
