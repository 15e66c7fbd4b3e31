use std::path::PathBuf;

use clap::builder::RangedU64ValueParser;
use clap::{Args, Parser, Subcommand};
use rosto_export::BaseColour;
use rosto_face::{Photo, PhotoLens, Region, Triangulation};
use rosto_landmarks::FindOptions;
use rosto_studio::{ConstraintKind, DEFAULT_RING, FaceSlider, Operator};

use crate::choices::{listed, one_of};
use crate::edits::{Edit, RegionEdit, SliderEdit};
use crate::error::endings;
use crate::networks::Landmarks;
use crate::units::Units;
use crate::{portrait, settings};

const EXIT_CODES: &str = "\
Exit codes:
  0  done; for `landmarks`, also when a picture shows no face
  1  something failed that should not have
  2  the command line or the edits file is not understood, or asks for something that would change nothing
  3  a photo cannot be read: missing, no picture, damaged or too large
  4  no face in the photo
  5  an edit cannot be made: no such vertex, an anchor that is the handle, no number
  6  a result cannot be written
  7  the face networks are missing or damaged";

/// Photos of faces to landmarks and edited, coloured 3D meshes.
#[derive(Debug, Parser)]
#[command(name = "rosto", version, after_help = EXIT_CODES)]
pub struct Arguments {
    /// Folder with face_detector.onnx, face_landmarks.onnx and face_landmarks_attention.onnx.
    ///
    /// Otherwise the environment variable ROSTO_NETWORKS names it; otherwise they are looked for next to the program,
    /// then in web/assets of the source tree.
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

#[derive(Debug, Args)]
pub struct LandmarksTask {
    /// JPEG, PNG or WebP; - reads standard input
    #[arg(required = true, value_name = "PHOTO")]
    pub photos: Vec<PathBuf>,
    /// How many faces to tell of each photo at most, the most prominent ones first; 20 if nothing is said, 1 with --mediapipe
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = RangedU64ValueParser::<usize>::new().range(1..))]
    pub max_faces: Option<usize>,
    #[command(flatten)]
    pub find: FindArguments,
}

/// What is known of the camera.
#[derive(Debug, Args)]
#[command(next_help_heading = "How the photo was taken; without these, by its lens data or else by the face itself")]
pub struct CameraArguments {
    /// How far away the camera stood from the face, in cm
    #[arg(long, value_name = "CM", allow_negative_numbers = true, value_parser = settings::distance)]
    pub distance: Option<PhotoLens>,
    /// The lens' focal length in mm, for a frame of 36 × 24 mm; the photo must be whole, as it was taken
    #[arg(long = "focal-35mm", value_name = "MM", allow_negative_numbers = true, conflicts_with = "distance",
        value_parser = settings::focal_length)]
    pub focal_length: Option<PhotoLens>,
}

impl CameraArguments {
    /// What is known of the lens that a photo was taken through.
    pub fn lens(&self, photo: &Photo) -> PhotoLens {
        self.distance.or(self.focal_length).unwrap_or_else(|| portrait::lens_of(photo))
    }
}

/// How faces are looked for.
#[derive(Debug, Args)]
#[command(next_help_heading = "How faces are found")]
pub struct FindArguments {
    /// Does exactly what MediaPipe's Face Mesh does with a single picture: one look, one pass, 468 landmarks
    ///
    /// Otherwise turns and parts of the picture are looked at too, landmarks are found again until they agree, and lips, eyes
    /// and irises are refined.
    #[arg(long)]
    pub mediapipe: bool,
    /// With --mediapipe: its refined lips, eyes and irises, 478 landmarks; without it they are always refined
    #[arg(long)]
    pub refine: bool,
}

impl FindArguments {
    /// The landmark network that these ask for.
    pub fn landmarks(&self) -> Landmarks {
        if self.mediapipe && !self.refine { Landmarks::Plain } else { Landmarks::Attention }
    }

    /// The way of looking that these ask for, for that many faces.
    pub fn options(&self, max_faces: Option<usize>) -> FindOptions {
        let usual = if self.mediapipe { FindOptions::mediapipe() } else { FindOptions::default() };
        FindOptions { max_faces: max_faces.unwrap_or(usual.max_faces), ..usual }
    }
}

#[derive(Debug, Args)]
pub struct MeshTask {
    /// JPEG, PNG or WebP; - reads standard input
    pub photo: PathBuf,
    /// The file to write, whole or not at all; its name ends as its format is called
    #[arg(short, long, value_name = "FILE", long_help = output_help())]
    pub output: PathBuf,
    /// How the landmarks are joined: with holes for eyes and mouth, or closed
    #[arg(long, default_value = Triangulation::default().id(),
        value_parser = one_of("triangulation", Triangulation::ALL, Triangulation::id, Triangulation::from_id))]
    pub topology: Triangulation,
    /// How often every triangle is cut in four (Loop subdivision); colours come from the photo
    #[arg(long, value_name = "TIMES", default_value_t = 0, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(0..=4))]
    pub density: u32,
    /// What colours a GLB or glTF
    #[arg(long, alias = "paint", default_value = BaseColour::default().id(),
        value_parser = one_of("base-colour", BaseColour::ALL, BaseColour::id, BaseColour::from_id))]
    pub base_colour: BaseColour,
    /// Writes the face unedited, with each edit as a named morph target at weight 1; for .glb and .gltf with --units mm
    #[arg(long)]
    pub morph_targets: bool,
    #[command(flatten)]
    pub find: FindArguments,
    #[command(flatten)]
    pub camera: CameraArguments,
    #[command(flatten)]
    pub edits: EditArguments,
    #[command(flatten)]
    pub settings: SettingsArguments,
}

#[derive(Debug, Args)]
pub struct PhotoTask {
    /// JPEG, PNG or WebP; - reads standard input
    pub photo: PathBuf,
    /// The file to write, whole or not at all: .jpg or .png, upright, in sRGB, without what the photo's file told of its place
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// How far around the face the photo gives way, as a share of the face's longer side
    #[arg(long, value_name = "SHARE", default_value_t = DEFAULT_RING, allow_negative_numbers = true, value_parser = settings::ring)]
    pub ring: f64,
    /// Shows the face as a camera sees it from so many cm
    #[arg(long = "seen-from", value_name = "CM", allow_negative_numbers = true, value_parser = settings::seen_from)]
    pub seen_from_m: Option<f64>,
    /// How the landmarks are joined: with holes for eyes and mouth, or closed
    #[arg(long, default_value = Triangulation::default().id(),
        value_parser = one_of("triangulation", Triangulation::ALL, Triangulation::id, Triangulation::from_id))]
    pub topology: Triangulation,
    /// How often every triangle is cut in four (Loop subdivision)
    #[arg(long, value_name = "TIMES", default_value_t = 0, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(0..=4))]
    pub density: u32,
    #[command(flatten)]
    pub find: FindArguments,
    #[command(flatten)]
    pub camera: CameraArguments,
    #[command(flatten)]
    pub edits: EditArguments,
    #[command(flatten)]
    pub settings: SettingsArguments,
}

/// What is moved.
#[derive(Debug, Args)]
#[command(next_help_heading = "Edits, made in this order, each on the mesh that the last one left")]
pub struct EditArguments {
    /// The coordinates that edits are made in, and that JSON is written in.
    ///
    /// "image": MediaPipe's normalised ones, x/W, y/H, z/W, as in the paper. "mm": the model's millimetres, +Y up, +Z out
    /// of the face, the subject's left towards +X. The other formats always hold the model: edits made in image
    /// coordinates are carried over by the map between the two.
    #[arg(long, default_value = Units::default().id(),
        value_parser = one_of("export.units", Units::ALL, Units::id, Units::from_id))]
    pub units: Units,
    /// A JSON file of edits: [{"vertex": 4, "offset": [0, 0, 1], "anchors": [10, 152]}], with "level" for a denser mesh's
    #[arg(long = "edits", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// A vertex, its offset, and the vertices that anchor it (else those of --anchors); repeatable
    ///
    /// Vertices 0 to 467 are the landmarks. VERTEX@LEVEL is one of the mesh cut up so many times, which moves that mesh and
    /// no coarser one: 20000@3 with --density 3.
    #[arg(long = "edit", value_name = "VERTEX[@LEVEL]:DX,DY,DZ[:A,B]", allow_hyphen_values = true)]
    pub vertices: Vec<Edit>,
    /// A named region and its offset, such as nose:0,0,5; repeatable
    #[arg(long = "region", value_name = "REGION:DX,DY,DZ", allow_hyphen_values = true, long_help = region_help())]
    pub regions: Vec<RegionEdit>,
    /// A ready-made slider and its amount in mm, such as jaw-width:-4; repeatable
    #[arg(long = "slider", value_name = "SLIDER:MM", allow_hyphen_values = true, long_help = slider_help())]
    pub sliders: Vec<SliderEdit>,
    /// Brings both sides closer to each other, by a share from 0 to 1
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true, value_parser = settings::share)]
    pub symmetrise: Option<f64>,
}

/// How the mesh follows what is moved.
#[derive(Debug, Args)]
#[command(next_help_heading = "How the mesh follows")]
pub struct SettingsArguments {
    /// The Laplacian whose δ-coordinates an edit keeps
    #[arg(long, default_value = Operator::default().id(),
        value_parser = one_of("operator", Operator::ALL, Operator::id, Operator::from_id))]
    pub operator: Operator,
    /// How firmly handles and anchors are held: "exact", or the weight of a soft constraint
    #[arg(long = "hold", value_name = "exact|WEIGHT", allow_negative_numbers = true, default_value = "1", value_parser = settings::hold)]
    pub constraint: ConstraintKind,
    /// What stays in place: two random vertices, the face's oval, everything further away than a radius, or only --pin
    #[arg(long, value_name = "random|oval|outside:RADIUS|pins", default_value = "random", value_parser = settings::anchors)]
    pub anchors: settings::Rule,
    /// Chooses the random anchors
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// A vertex that stays in place, beside the others; repeatable
    #[arg(long = "pin", value_name = "VERTEX", allow_negative_numbers = true)]
    pub pins: Vec<u32>,
    /// Lets nothing move further than this from what is moved, along the surface, in the units of the edits
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true, value_parser = settings::radius)]
    pub radius: Option<f64>,
    /// Moves the other side of the face by the mirrored offset; needs --units mm
    #[arg(long)]
    pub mirror: bool,
    /// Lets details turn with the surface (as rigid as possible)
    #[arg(long)]
    pub turn_details: bool,
}

fn output_help() -> String {
    format!("The file to write, whole or not at all; its name ends as its format is called.\n\nFormats: {}", endings())
}

fn region_help() -> String {
    let names = listed(Region::ALL, Region::id);
    format!("A named region and its offset, such as nose:0,0,5; repeatable.\n\nRegions: {names}")
}

fn slider_help() -> String {
    let names = listed(FaceSlider::ALL, FaceSlider::id);
    format!(
        "A ready-made slider and its amount in mm, such as jaw-width:-4; repeatable. Needs --units mm.\n\nSliders: {names}"
    )
}

#[derive(Debug, Args)]
pub struct PaperTask {
    /// JPEG, PNG or WebP; - reads standard input
    pub photo: PathBuf,
    /// Folder for the meshes of Figures 3 to 5 and the plot of times; made if it is not there
    #[arg(short, long, value_name = "DIR", default_value = "rosto-paper")]
    pub output: PathBuf,
    /// Chooses the vertices and their anchors; each further run takes the next seed
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// How many runs, with other vertices and anchors, the statistics are over
    #[arg(long, value_name = "N", default_value_t = 20, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u64).range(1..))]
    pub runs: u64,
    #[command(flatten)]
    pub find: FindArguments,
}
