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
  1  something failed that should not have
  2  the command line or the edits file is not understood, or asks for what would change nothing or overwrite a file of yours
  3  a photo cannot be read: missing, not a picture, damaged or too large; of several, at least one
  4  no face in the photo
  5  an edit or a body cannot be made: no such vertex, an anchor that is the handle, no number, a wall too thick
  6  a result cannot be written: the disk is full, the folder is missing, or another process writes the same file
  7  the face networks are missing or damaged";

/// Photos of faces to landmarks and edited, coloured 3D meshes.
#[derive(Debug, Parser)]
#[command(name = "rosto", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// Folder with face_detector.onnx, face_landmarks.onnx and face_landmarks_attention.onnx.
    ///
    /// Otherwise the environment variable ROSTO_NETWORKS names it. Otherwise a program that was built for release uses the
    /// networks that it holds; any other looks for them next to itself, then in web/assets of the source tree.
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
    /// Write the face in a photo as a mesh, edited on request
    #[command(after_help = EXIT_CODES)]
    Mesh(Box<MeshTask>),
    /// Write the photo with its face edited
    #[command(after_help = EXIT_CODES)]
    Photo(Box<PhotoTask>),
    /// Repeat the experiment of the paper on a photo and on this machine
    #[command(after_help = EXIT_CODES)]
    Paper(PaperTask),
}
