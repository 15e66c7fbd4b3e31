use clap::{ArgMatches, CommandFactory, FromArgMatches};
use glam::{DVec2, DVec3};
use rosto_export::{ExportedFile, Units};
use rosto_face::{FaceError, FaceModel, MAX_PHOTOS};
use rosto_landmarks::FaceFinder;
use rosto_photo::Photo;
use rosto_studio::Document;
use thiserror::Error;

use crate::args::{Arguments, MeshTask, Task};
use crate::error::CliError;
use crate::mesh::Edited;
use crate::request::{self, Given};
use crate::{encode, mesh};

/// Face mesh as `rosto mesh` makes it, from decoded photos and without writing files.
///
/// Options are the command line's words, except for photos and output.
pub struct FaceMesh {
    options: Vec<String>,
    face: FaceModel,
    document: Document,
}

/// Error message with its hint.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct FaceMeshError(String);

impl From<CliError> for FaceMeshError {
    fn from(error: CliError) -> Self {
        Self(match error.hint() {
            Some(hint) => format!("{error}. {hint}"),
            None => error.to_string(),
        })
    }
}

impl FaceMesh {
    /// Model of the face in one photo, or in several of one head, with the edits in `options`.
    ///
    /// # Errors
    /// If there are no photos or more than [`MAX_PHOTOS`], an option is invalid, a photo shows no face, the photos show
    /// different faces, or an edit cannot be made.
    pub fn new(photos: Vec<Photo>, finder: &FaceFinder, options: &[String]) -> Result<Self, FaceMeshError> {
        if !(1..=MAX_PHOTOS).contains(&photos.len()) {
            return Err(FaceMeshError(FaceError::PhotoCount { found: photos.len(), most: MAX_PHOTOS }.to_string()));
        }
        let (task, _) = task(options, "face.glb")?;
        let names: Vec<String> = (1..=photos.len()).map(|number| format!("image {number}")).collect();
        let photos = names.iter().map(AsRef::as_ref).zip(photos).collect();
        let Edited { face, document, .. } = mesh::edited_face(&task, photos, &mesh::steps_of(&task)?, finder)?;
        Ok(Self { options: options.to_vec(), face, document })
    }

    /// Vertex positions in metres, in the model's frame; the first 468 are the landmarks.
    pub fn positions_m(&self) -> &[DVec3] {
        self.document.positions()
    }

    /// Triangles, counter-clockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.document.topology().triangles()
    }

    /// Texture coordinates of each vertex in the photo, from its top left corner.
    pub fn uvs(&self) -> Vec<DVec2> {
        self.document.from_cage(self.face.uvs())
    }

    /// sRGB colour of each vertex.
    pub fn colours_srgb(&self) -> Vec<[u8; 3]> {
        self.face.colours_under(&self.uvs())
    }

    /// Encodes the mesh and its sidecar files. The extension of `name` selects the format; `options` are added to those
    /// of [`Self::new`].
    ///
    /// # Errors
    /// If the extension is unknown, an option is invalid or has no effect, or the mesh cannot be encoded.
    pub fn write(&mut self, name: &str, options: &[String]) -> Result<ExportedFile, FaceMeshError> {
        let (task, matches) = task(&[&self.options, options].concat(), name)?;
        let format = encode::format_of(name.as_ref())?;
        request::check(&task, format, &Given(matches.subcommand().map_or(&matches, |(_, given)| given)))?;
        let name = encode::name_of(name.as_ref());
        Ok(encode::encode(&self.face, &mut self.document, &task, format, &name)?)
    }
}

/// Parses options as those of `rosto mesh`.
fn task(options: &[String], output: &str) -> Result<(MeshTask, ArgMatches), CliError> {
    let words = ["rosto", "mesh", "-", "--output", output].into_iter().chain(options.iter().map(String::as_str));
    let refused = |error: clap::Error| CliError::InvalidOptions { reason: reason_of(&error) };
    let matches = Arguments::command().try_get_matches_from(words).map_err(refused)?;
    match Arguments::from_arg_matches(&matches).map_err(refused)?.task {
        Task::Mesh(task) if task.units == Units::Image => Err(CliError::ImageUnits { path: output.into() }),
        Task::Mesh(task) => Ok((*task, matches)),
        _ => Err(CliError::InvalidOptions { reason: "expected options of `rosto mesh`".to_owned() }),
    }
}

/// The first paragraph of clap's message, without the usage.
fn reason_of(error: &clap::Error) -> String {
    let text = error.to_string();
    let reason = text.split("\n\n").next().unwrap_or_default();
    reason.trim().trim_start_matches("error: ").to_owned()
}
