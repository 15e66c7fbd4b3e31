//! Photos of a face to an edited, coloured 3D mesh and to files.
//!
//! A [`MeshRequest`] opens as a [`FaceMesh`], which [`FaceMesh::write`] writes in any [`Format`]; a [`PhotoRequest`]
//! gives the edited photo. The command line, the Python package and the page use the same requests.

mod check_file;
mod error;
mod face_mesh;
mod file_options;
mod mesh_request;
#[cfg(feature = "find")]
pub mod networks;
mod photo_edit;
mod photo_request;
#[cfg(feature = "find")]
mod remarks;
mod settings;
mod write;

pub use error::Error;
pub use face_mesh::{FaceMesh, landmarks_m_from_image};
pub use file_options::{EditsAs, ExpressionsAs, FileOptions};
pub use mesh_request::MeshRequest;
pub use photo_edit::{MAX_DABS, PhotoEdit};
pub use photo_request::{EditedPhoto, PhotoRequest};
#[cfg(feature = "find")]
pub use remarks::{PhotoRemark, quality};
pub use settings::{anchor_rule, card_px, constraint};

pub use rosto_export::{
    BaseColour, ExportOption, ExportedFile, Eyes, FileKind, Format, Material, Print, PrintHeight, PrintPose,
    PrintedBody, Reopened, SNIFFED_BYTES, SavedEdits, SavedFace, Solid, SolidFacts, TextureSize, Units, project,
    reopen, sniff,
};
pub use rosto_face::{FaceError, FaceModel, MAX_PHOTOS, Observation, PhotoLens, Region, Triangulation};
#[cfg(feature = "find")]
pub use rosto_landmarks::{FaceFinder, FindOptions, LandmarkNetwork};
pub use rosto_photo::{Limits, Photo, decode};
pub use rosto_studio::{
    AnchorKind, Anchors, Command, Details, Document, Entry, Expression, FaceSlider, Mirror, Operator,
    RegionOfInfluence, Settings,
};

/// Runs the README's example as a doc-test.
#[cfg(all(doctest, feature = "find"))]
#[doc = include_str!("../README.md")]
pub struct Readme;
