use std::path::PathBuf;

use clap::{Parser, Subcommand};

mod edits;
mod finding;
mod tasks;

pub use edits::{EditArguments, SettingsArguments};
pub use finding::{CameraArguments, FindArguments};
pub use tasks::{LandmarksTask, MeshTask, PaperTask, PhotoTask};

const EXIT_CODES: &str = "\
Exit codes:
  0  done; for `landmarks`, also when a picture shows no face
  1  internal error
    2  invalid options or edits file, an option without effect, or an output that is an input or another program's file
    3  a photo cannot be read: missing, not a picture, damaged or too large; in a batch, at least one failed
    4  no face in the photo
    5  an edit or a body cannot be made, for example because of an unknown vertex or a wall that is too thick
    6  a result cannot be written: disk full, folder missing, or another process is writing the same file
    7  the face networks are missing or damaged";

/// Turns photos of faces into landmarks and edited, coloured 3D meshes.
#[derive(Debug, Parser)]
#[command(name = "rosto", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// Folder with face_detector.onnx, face_landmarks.onnx and face_landmarks_attention.onnx
    ///
    /// Default: the environment variable ROSTO_NETWORKS; without it, the networks embedded in a release. A build
    /// without networks looks next to the program and, if it is a debug build, in web/assets of the source tree.
    #[arg(long, global = true, value_name = "DIR")]
    pub networks: Option<PathBuf>,
    #[command(subcommand)]
    pub task: Task,
}

#[derive(Debug, Subcommand)]
pub enum Task {
    /// Print the landmarks of the faces in each photo, one line of JSON per photo
    #[command(after_help = EXIT_CODES)]
    Landmarks(LandmarksTask),
    /// Write the face in a photo as a mesh, optionally edited
    #[command(after_help = EXIT_CODES)]
    Mesh(Box<MeshTask>),
    /// Write the photo with its face edited
    #[command(after_help = EXIT_CODES)]
    Photo(Box<PhotoTask>),
    /// Repeat the paper's experiment on a photo and on this machine
    #[command(after_help = EXIT_CODES)]
    Paper(PaperTask),
}
