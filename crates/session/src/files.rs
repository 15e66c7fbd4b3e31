use rosto::FileOptions;
use rosto_export::{Print, PrintHeight, Solid};
use serde::Deserialize;
use tsify::Tsify;

/// Default thickness of a printed mask, in mm.
pub(crate) const THICKNESS_MM: f64 = 2.0;

/// Default height of a print, in mm: a few hours on a home printer.
pub(crate) const PRINT_MM: f64 = 80.0;

/// Stem of file names without a photo's name.
const DEFAULT_STEM: &str = "face";

/// Files that panels offer: their options, and the page's reports about them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Files {
    pub options: FileOptions,
    /// Wall of a printed mask, in mm, also while another body is chosen.
    pub thickness_mm: f64,
    /// Depth of a relief, in mm, also while another body is chosen; none depends on the height.
    pub depth_mm: Option<f64>,
    /// Whether pictures have a transparent background.
    pub is_transparent: bool,
    pub abilities: Abilities,
    pub stem: String,
    pub file: File,
    pub body: Body,
    /// Name of the file that is being made; the GLB has its own state.
    pub making: Option<String>,
    pub photo: PhotoFile,
    /// Side of the whole-face texture.
    pub texture_side_px: Option<u32>,
}

/// The GLB that was made last. A change of the face or the options removes it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum File {
    #[default]
    None,
    Making {
        is_validated: bool,
    },
    Made {
        bytes: f64,
        verdict: Option<Outcome>,
    },
}

/// The printed body.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Body {
    /// Whether it has changed since.
    pub is_stale: bool,
    pub facts: Option<BodyFacts>,
    pub error: Option<BodyError>,
}

/// The edited photo as a file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PhotoFile {
    pub is_writing: bool,
    pub saved_px: Option<[u32; 2]>,
}

/// Abilities of this browser with files.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Abilities {
    /// Whether it can share models.
    pub shares_models: bool,
    /// Whether it can share pictures.
    pub shares_pictures: bool,
    /// Whether it can copy pictures.
    pub copies_pictures: bool,
}

/// Result of a validation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// Numbers of errors, warnings and notes.
    Validated {
        /// Errors.
        errors: u32,
        /// Warnings.
        warnings: u32,
        /// Notes.
        remarks: u32,
    },
    /// The validator did not answer.
    Unchecked,
}

/// Measures of a printed body, as the worker reports them.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct BodyFacts {
    /// Enclosed volume, in cm³.
    pub volume_cm3: f64,
    /// Sides of the bounding box, in mm.
    pub size_mm: [f64; 3],
    /// Requested wall thickness, in mm.
    pub asked_mm: f64,
    /// Smallest wall thickness, in mm.
    pub thinnest_mm: f64,
    /// Share of the face, 0 to 1, where the wall is notably thinner than requested.
    pub thin_share: f64,
    /// Distance by which sharp folds were rounded, in mm.
    pub moved_mm: f64,
    /// Mass in g if printed in PLA with usual settings.
    pub pla_grams: f64,
    /// Whether to print it upright rather than lying on its back.
    pub is_upright: bool,
    /// Area that needs supports, in cm²; 0 if none does.
    pub overhang_cm2: f64,
}

/// Reason why a body cannot be made.
#[derive(Debug, Clone, PartialEq, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct BodyError {
    /// Code of the error.
    pub code: String,
    /// Thickest possible wall in mm, for `too-thick`.
    #[serde(default)]
    pub max_mm: Option<f64>,
}

/// Report of the page about its files.
#[derive(Debug, Clone, PartialEq, Deserialize, Tsify)]
#[serde(rename_all = "kebab-case", rename_all_fields = "camelCase")]
pub enum Report {
    /// Abilities of the browser.
    Abilities(Abilities),
    /// Names and pictures of the open face.
    Face {
        /// Stem of the names of its files.
        stem: String,
        /// Width and height of the photo in its saved file, in px; none if the photo's own file is open.
        saved_px: Option<[u32; 2]>,
    },
    /// Making a GLB has started.
    GlbStarted {
        /// Whether the validator will check it.
        is_validated: bool,
    },
    /// A GLB has been made.
    GlbMade {
        /// Its size in bytes.
        bytes: f64,
        /// Result of the validation, if there was one.
        verdict: Option<Outcome>,
    },
    /// Making a GLB has failed.
    GlbFailed,
    /// The name of the mesh file, other than a GLB, that is being made; none when it is done, cancelled or has failed.
    Making(Option<String>),
    /// The printed body has been measured; a surface has no measures.
    BodyMeasured(Option<BodyFacts>),
    /// Making the printed body has failed.
    BodyFailed(BodyError),
    /// Whether the edited photo is being written.
    WritingPhoto(bool),
}

impl Default for Files {
    fn default() -> Self {
        Self {
            options: FileOptions {
                print: Print { solid: Solid::Thickness { mm: THICKNESS_MM }, height: PrintHeight::Mm(PRINT_MM) },
                ..FileOptions::default()
            },
            thickness_mm: THICKNESS_MM,
            depth_mm: None,
            is_transparent: true,
            abilities: Abilities::default(),
            stem: DEFAULT_STEM.to_owned(),
            file: File::default(),
            body: Body::default(),
            making: None,
            photo: PhotoFile::default(),
            texture_side_px: None,
        }
    }
}

impl Files {
    /// Takes over a report.
    pub fn take(&mut self, report: Report) {
        match report {
            Report::Abilities(abilities) => self.abilities = abilities,
            Report::Face { stem, saved_px } => (self.stem, self.photo.saved_px) = (stem, saved_px),
            Report::GlbStarted { is_validated } => self.file = File::Making { is_validated },
            // Else the face has changed since.
            Report::GlbMade { bytes, verdict } if matches!(self.file, File::Making { .. }) => {
                self.file = File::Made { bytes, verdict };
            }
            Report::GlbMade { .. } => {}
            Report::GlbFailed => self.file = File::None,
            Report::Making(name) => self.making = name,
            Report::BodyMeasured(facts) => self.body = Body { facts, ..Body::default() },
            Report::BodyFailed(error) => self.body = Body { error: Some(error), ..Body::default() },
            Report::WritingPhoto(is_writing) => self.photo.is_writing = is_writing,
        }
    }

    /// Marks the files as those of another face.
    pub fn outdate(&mut self) {
        self.file = File::None;
        self.body.is_stale = true;
    }
}
