use rosto_export::Units;
use rosto_face::{FaceModel, Observation, Triangulation};
#[cfg(feature = "find")]
use rosto_landmarks::{FaceFinder, FindOptions};
#[cfg(feature = "find")]
use rosto_photo::Photo;
use rosto_studio::{
    AnchorKind, Anchors, Command, CoordinateFrame, Document, EditSpec, Rest, SMOOTH_DENSITY, Settings, StudioError,
};

use crate::{Error, FaceMesh};

/// A mesh to be made: the face in one photo, or in up to five of the same face, with edits.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshRequest {
    /// The photos of the face, each with the lens to use.
    pub photos: Vec<Observation>,
    /// Triangulation of the landmarks.
    pub triangulation: Triangulation,
    /// Subdivision level, 0 to 4; 0 is the 468 landmarks.
    pub density: u32,
    /// Coordinates of the edits: metres in the model's frame for [`Units::Mm`], or MediaPipe's normalised coordinates.
    pub units: Units,
    /// The edits, in order.
    pub edits: Vec<Command>,
}

impl MeshRequest {
    /// The unedited, smooth face in these photos.
    pub fn of(photos: Vec<Observation>) -> Self {
        Self {
            photos,
            triangulation: Triangulation::Canonical,
            density: SMOOTH_DENSITY,
            units: Units::Mm,
            edits: Vec::new(),
        }
    }

    /// The unedited, smooth face of which each photo shows the most prominent one.
    ///
    /// # Errors
    /// [`Error::NoFace`] for the first photo without one, or [`Error::Landmarks`].
    #[cfg(feature = "find")]
    pub fn found_in(photos: &[Photo], finder: &FaceFinder, options: &FindOptions) -> Result<Self, Error> {
        let observe = |(index, photo): (usize, &Photo)| {
            let first = finder.find(photo, options)?.into_iter().next().ok_or(Error::NoFace { photo: index })?;
            Ok(Observation::in_photo(photo, first.landmarks))
        };
        Ok(Self::of(photos.iter().enumerate().map(observe).collect::<Result<_, Error>>()?))
    }

    /// Adds moves of vertices and regions with these settings. Random anchors get their seed plus the number of the
    /// move; a move with [`Anchors::explicit`] keeps its anchors and gets the pins in addition.
    pub fn add_moves(&mut self, moves: impl IntoIterator<Item = Command>, settings: &Settings) {
        let with_settings = |(number, command): (u64, Command)| match command {
            Command::Move { mut spec, offsets } => {
                spec.settings =
                    Settings { anchors: anchors(spec.settings.anchors, settings, number), ..settings.clone() };
                Command::Move { spec, offsets }
            }
            other => other,
        };
        self.edits.extend((0..).zip(moves).map(with_settings));
    }

    /// Builds the face and applies the edits.
    ///
    /// # Errors
    /// [`Error::Face`] if the photos do not show one face, [`Error::SeveralPhotos`] for several photos in image
    /// coordinates, [`Error::Edit`] for the first edit that has no solution, or [`Error::Studio`] if the density is too
    /// high.
    pub fn open(self) -> Result<FaceMesh, Error> {
        if self.units == Units::Image && self.photos.len() > 1 {
            return Err(Error::SeveralPhotos);
        }
        let face = FaceModel::from_photos(self.photos, self.triangulation)?;
        let rest = match self.units {
            Units::Image => {
                Rest::of_landmarks(face.topology().clone(), face.positions_image().to_vec(), CoordinateFrame::Other)
            }
            Units::Mm => Rest::of_face(&face),
        };
        let mut document = Document::new(rest)?;
        document.set_density(self.density)?;
        for (index, command) in self.edits.into_iter().enumerate() {
            let target = name_of(&command);
            apply(&mut document, command).map_err(|reason| Error::Edit { number: index + 1, target, reason })?;
        }
        Ok(FaceMesh::new(face, document, self.units))
    }
}

/// Anchors of the move with this number.
fn anchors(own: Anchors, settings: &Settings, number: u64) -> Anchors {
    let Anchors { kind, pins } = settings.anchors.clone();
    if own.kind == AnchorKind::PinsOnly && !own.pins.is_empty() {
        let added = pins.into_iter().filter(|pin| !own.pins.contains(pin));
        return Anchors::explicit(own.pins.iter().copied().chain(added).collect());
    }
    match kind {
        AnchorKind::Random { seed } => Anchors { kind: AnchorKind::Random { seed: seed.wrapping_add(number) }, pins },
        kind => Anchors { kind, pins },
    }
}

/// Name of an edit in errors.
fn name_of(command: &Command) -> String {
    match command {
        Command::Move { spec: EditSpec { level, handles, .. }, .. } if handles.len() == 1 => match level {
            0 => format!("vertex {}", handles[0]),
            level => format!("vertex {}@{level}", handles[0]),
        },
        _ => command.target().to_string(),
    }
}

/// Applies an edit. A document would let an edit of a denser mesh wait for it; a request has only one density. The
/// labels are those of the page.
fn apply(document: &mut Document, command: Command) -> Result<(), StudioError> {
    match &command {
        Command::Move { spec, .. } if spec.level > document.density() => {
            Err(StudioError::TooCoarse { level: spec.level, density: document.density() })
        }
        _ => document.apply(&command.target().to_string(), command),
    }
}
