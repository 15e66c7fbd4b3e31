use rosto::{PhotoEdit, SavedEdits, SavedFace};
use rosto_face::{FaceModel, MAX_DENSITY, Triangulation};
use rosto_studio::{Amount, Document, Entry, Rest, project};

use crate::error::{SessionError, within};
use crate::open_face::{MAX_OFFSET_M, OpenFace};

/// Highest density on the screen; files can have up to [`MAX_DENSITY`].
pub const MAX_SHOWN_DENSITY: u32 = 3;

/// Builds the face and applies its edits. `defaults` holds the triangulation and density of a face without earlier edits.
pub(crate) fn opened(saved: SavedFace, defaults: (Triangulation, u32)) -> Result<OpenFace, SessionError> {
    let ((triangulation, density), entries, photo) = match &saved.edits {
        Some(edits) => (mesh_of(edits)?, entries(edits)?, photo_edit(edits)?),
        None => (defaults, Vec::new(), PhotoEdit::default()),
    };
    let model = FaceModel::from_photos(saved.photos, triangulation)?;
    let document = Document::open(Rest::of_face(&model), entries, density)?;
    let mut face = OpenFace::new(model, document);
    face.restore_photo_edit(photo);
    Ok(face)
}

/// Triangulation and displayed density.
fn mesh_of(edits: &SavedEdits) -> Result<(Triangulation, u32), SessionError> {
    within("the density", edits.density.into(), 0.0, MAX_DENSITY.into())?;
    Ok((edits.triangulation, edits.density.min(MAX_SHOWN_DENSITY)))
}

fn entries(edits: &SavedEdits) -> Result<Vec<Entry>, SessionError> {
    let entries = edits.history.as_deref().map(project::from_json).transpose()?.unwrap_or_default();
    entries.iter().map(|entry| entry.command.amount()).enumerate().try_for_each(check_amount)?;
    Ok(entries)
}

/// Rejects offsets beyond the maximum.
fn check_amount((entry, amount): (usize, Amount)) -> Result<(), SessionError> {
    match amount {
        Amount::Distance(distance_m) if !distance_m.is_finite() || distance_m.abs() > MAX_OFFSET_M => {
            Err(SessionError::BadHistory { entry, distance_m, most_m: MAX_OFFSET_M })
        }
        _ => Ok(()),
    }
}

fn photo_edit(edits: &SavedEdits) -> Result<PhotoEdit, SessionError> {
    let edit = edits.photo_edit.as_deref().map(PhotoEdit::from_json).transpose();
    Ok(edit.map_err(SessionError::PhotoEdit)?.unwrap_or_default())
}

impl OpenFace {
    /// The photos as text, in the order in which they were added ([`SavedFace::photos_json`]).
    pub fn saved_photos(&self) -> String {
        let photos = self.model().photos().into_iter().cloned().collect();
        SavedFace { photos, edits: None }.photos_json()
    }

    /// The edits as text ([`SavedEdits::to_json`]).
    pub fn saved_edits(&self) -> String {
        let entries = self.document().history().entries();
        let edits = SavedEdits {
            triangulation: self.triangulation(),
            density: self.document().density(),
            history: (!entries.is_empty()).then(|| project::to_json(entries)),
            photo_edit: self.saved_photo_edit().map(|edit| edit.to_json()),
        };
        edits.to_json().expect("invariant: history and photo edit are JSON objects")
    }
}
