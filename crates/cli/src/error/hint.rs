use std::borrow::Cow;
use std::io::{self, ErrorKind};

use rosto_export::{ExportError, SolidError};
use rosto_laplacian::LaplacianError;
use rosto_photo::PhotoError;
use rosto_studio::StudioError;

use super::CliError;
use crate::input::ReadError;

impl CliError {
    /// What to do, where something can be done.
    pub(crate) fn hint(&self) -> Option<Cow<'static, str>> {
        if let Self::Edit { reason: StudioError::Laplacian(reason), .. } = self {
            return edit_hint(reason);
        }
        self.fixed_hint().map(Cow::Borrowed)
    }

    fn fixed_hint(&self) -> Option<&'static str> {
        match self {
            Self::OverInput { .. } => Some("Give -o another name."),
            Self::Unreadable { reason: ReadError::Empty, .. } => Some(PhotoError::NotAPicture.hint()),
            Self::Unreadable { reason, .. } | Self::EditsUnreadable { reason, .. } => read_hint(reason),
            Self::NoPicture { reason, .. } => Some(reason.hint()),
            Self::NoPhotos { .. } => {
                Some("Photos are regular files named .jpg, .jpeg, .jpe, .jfif, .pjpeg, .png or .webp.")
            }
            Self::TooManyPhotos { .. } => Some("To make a mesh of each photo, put {} into the name of the output."),
            Self::Broke { .. } => Some("Tell us of it, with the photo if it may be seen: it should not have."),
            Self::AnotherJournal { .. } => {
                Some("Give the options that the file was begun with, another name, or --force; it is as it was.")
            }
            Self::InUse { .. } => Some("Wait until that process ends, or give another name."),
            Self::Foreign { .. } => Some("Move it, give another name, or replace it with --force."),
            Self::SameOutput { .. } => Some("Rename one of the photos, or write their meshes to different folders."),
            Self::NoFace { .. } => Some("The face should fill a tenth of the picture or more and look at the camera."),
            Self::AnotherFace { .. } => Some("Give photos of one face, each with no other face in front."),
            Self::EditsFile { .. } => {
                Some(r#"It should hold a list such as [{"vertex": 4, "offset": [0, 0, 1], "anchors": [10, 152]}]."#)
            }
            Self::EditsUtf16 { .. } => Some("Save it as UTF-8."),
            Self::Edit { reason: StudioError::NoMirror | StudioError::NoExpressions { .. }, .. } => {
                Some("Add --units mm; a vertex of a denser mesh also needs --topology canonical.")
            }
            Self::Edit { reason: StudioError::TooCoarse { .. }, .. } => Some("Give --density as many or more."),
            Self::Export(ExportError::Solid(SolidError::TooThick { .. })) => {
                Some("Give --solid a smaller thickness, or flat:MM.")
            }
            Self::Export(ExportError::Solid(_)) => Some("Edit the face less, or print it at a lower --density."),
            Self::UnknownFormat { .. } | Self::NoPictureFormat { .. } => Some("End its name so."),
            Self::Unwritable { reason, .. } => Some(write_hint(reason)),
            Self::Output(reason) if is_full(reason) => Some("The disk is full: make room, or write elsewhere."),
            Self::NetworksMissing { .. } => Some(
                "Run `cargo xtask setup` in the source tree and build again, or name their folder with --networks.",
            ),
            Self::NetworkMissing { .. } | Self::NetworkUnreadable { .. } => {
                Some("Run `cargo xtask setup` to obtain both, or name another folder with --networks.")
            }
            Self::Networks(_) | Self::NoPlace { .. } => Some("Run `cargo xtask setup` to obtain them again."),
            _ => None,
        }
    }
}

fn read_hint(reason: &ReadError) -> Option<&'static str> {
    let ReadError::Io(reason) = reason else { return None };
    match reason.kind() {
        ErrorKind::NotFound => Some("Check the file's name."),
        ErrorKind::IsADirectory => Some("Name a file in that folder."),
        ErrorKind::PermissionDenied => Some("Check that you may read it."),
        _ => None,
    }
}

fn write_hint(reason: &io::Error) -> &'static str {
    match reason.kind() {
        _ if is_full(reason) => {
            "The disk is full: make room, or write elsewhere. A file that was there before is as it was."
        }
        ErrorKind::FileTooLarge => "The system's limit on the length of files is too low for it.",
        ErrorKind::IsADirectory => "Name a file in that folder.",
        ErrorKind::NotADirectory => "Name a folder.",
        ErrorKind::InvalidFilename => "Give a shorter name.",
        _ => "Check that the folder is there and may be written to.",
    }
}

fn is_full(reason: &io::Error) -> bool {
    matches!(reason.kind(), ErrorKind::StorageFull | ErrorKind::QuotaExceeded)
}

fn edit_hint(reason: &LaplacianError) -> Option<Cow<'static, str>> {
    match *reason {
        LaplacianError::NoSuchVertex { vertex_count, .. } => Some(Cow::Owned(format!(
            "That mesh's vertices are numbered 0 to {}; VERTEX@LEVEL is one of a denser mesh.",
            vertex_count.saturating_sub(1)
        ))),
        LaplacianError::PinnedHandle { .. } => Some("Name anchors other than the vertex that is moved.".into()),
        LaplacianError::Repeated { .. } => Some("Name each anchor once.".into()),
        LaplacianError::NotFinite { .. } => Some("Give smaller offsets.".into()),
        _ => None,
    }
}
