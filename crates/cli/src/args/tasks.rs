use std::path::PathBuf;

use clap::Args;
use clap::builder::RangedU64ValueParser;
use rosto_export::{BaseColour, Eyes, Material, Solid, TextureSize, Units};
use rosto_face::Triangulation;
use rosto_studio::{DEFAULT_FALLOFF_BAND, SMOOTH_DENSITY};
use rosto_warp::Dab;

use super::{CameraArguments, EditArguments, FindArguments, SettingsArguments};
use crate::choices::one_of;
use crate::error::endings;
use crate::settings;

/// How many photos are worked on.
#[derive(Debug, Args)]
pub struct ManyArguments {
    /// How many photos are worked on at a time, each in a thread
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true,
        value_parser = RangedU64ValueParser::<usize>::new().range(1..=1024))]
    pub jobs: usize,
    /// Replaces files that are there already, whoever wrote them, and does what is done again. Photos and --edits stay
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, Args)]
pub struct LandmarksTask {
    /// JPEG, PNG or WebP; - reads standard input. A folder stands for all photos in it and in its folders: regular files named
    /// .jpg, .jpeg, .jpe, .jfif, .pjpeg, .png or .webp
    #[arg(required = true, value_name = "PHOTO|DIR")]
    pub photos: Vec<PathBuf>,
    /// The file of JSON lines to write in place of standard output, with a line for each photo that could not be read, too
    ///
    /// If the file is there, the run is resumed: photos that have a line are left out, and those that failed are tried again. A
    /// file that was not written by the same request is refused. Only one process at a time can write it.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub many: ManyArguments,
    /// How many faces to tell of each photo at most, the most prominent ones first; 20 if nothing is said, 1 with --mediapipe
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = RangedU64ValueParser::<usize>::new().range(1..))]
    pub max_faces: Option<usize>,
    #[command(flatten)]
    pub find: FindArguments,
}

/// The mesh that edits are made on.
#[derive(Debug, Args)]
pub struct MeshArguments {
    /// How the landmarks are joined: with holes for eyes and mouth, or closed
    #[arg(long, default_value = Triangulation::Canonical.id(),
        value_parser = one_of("triangulation", Triangulation::ALL, Triangulation::id, Triangulation::from_id))]
    pub topology: Triangulation,
    /// How often every triangle is cut in four, smoothly and through the landmarks; 0 is the 468 landmarks, as in the paper
    #[arg(long, value_name = "TIMES", default_value_t = SMOOTH_DENSITY, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(0..=4))]
    pub density: u32,
}

#[derive(Debug, Args)]
pub struct MeshTask {
    /// JPEG, PNG or WebP; - reads standard input. One photo, or up to five of one face, turned to the camera, to its left, to
    /// its right
    ///
    /// With {} in the name of the output, a mesh is made of each photo by itself, and a folder stands for all photos in it and in
    /// its folders.
    ///
    /// Of several photos the one in which the face looks at the camera leads: the mesh lies on it, and its picture colours it.
    /// The others tell how deep each landmark lies.
    #[arg(required = true, value_name = "PHOTO")]
    pub photos: Vec<PathBuf>,
    /// The file to write, whole or not at all; its name ends as its format is called
    #[arg(short, long, value_name = "FILE", long_help = output_help())]
    pub output: PathBuf,
    #[command(flatten)]
    pub many: ManyArguments,
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// The coordinates that edits are made in, and that JSON is written in
    ///
    /// "mm": the model's millimetres, +Y up, +Z out of the face, the subject's left towards +X. "image": MediaPipe's normalised
    /// ones, x/W, y/H, z/W, as in the paper; for .json alone, since other formats hold the model.
    #[arg(long, default_value = Units::default().id(),
        value_parser = one_of("export.units", Units::ALL, Units::id, Units::from_id))]
    pub units: Units,
    /// What paints a .glb, .gltf, .obj, .usdz or .png
    #[arg(long, default_value = BaseColour::default().id(),
        value_parser = one_of("base-colour", BaseColour::ALL, BaseColour::id, BaseColour::from_id))]
    pub base_colour: BaseColour,
    /// How long the longest side of that picture is at most, in px
    #[arg(long, value_name = "PX", default_value = TextureSize::default().id(),
        value_parser = one_of("texture-size", TextureSize::ALL, TextureSize::id, TextureSize::from_id))]
    pub texture_size: TextureSize,
    /// What is printed, for .stl and .3mf: thickness:MM is a mask with a wall so thick, flat:MM a relief with a flat back so
    /// far behind its deepest point, surface the surface alone (.stl)
    #[arg(long, value_name = "SOLID", default_value_t = Solid::default())]
    pub solid: Solid,
    /// How light falls on a GLB or glTF
    #[arg(long, default_value = Material::default().id(),
        value_parser = one_of("material", Material::ALL, Material::id, Material::from_id))]
    pub material: Material,
    /// What fills eyes and mouth in a .glb, .gltf, .obj, .ply or .usdz of a closed face: the skin going on, or pieces of their own
    /// behind lids and lips, the eyes round as balls are
    #[arg(long, default_value = Eyes::default().id(), value_parser = one_of("eyes", Eyes::ALL, Eyes::id, Eyes::from_id))]
    pub eyes: Eyes,
    /// Writes the face unedited, with each edit as a named morph target at weight 1; for .glb and .gltf
    #[arg(long)]
    pub morph_targets: bool,
    /// Writes every expression as a morph target by ARKit's name, at the weights of --expression, with eyes and mouth in pieces of
    /// their own; for .glb and .gltf
    #[arg(long = "expressions")]
    pub expression_targets: bool,
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
    #[arg(long, value_name = "SHARE", default_value_t = DEFAULT_FALLOFF_BAND, allow_negative_numbers = true, value_parser = settings::falloff_band)]
    pub falloff_band: f64,
    /// Keeps what lies within a radius of a place as it is, all three in px of the upright photo; repeatable
    #[arg(long = "keep", value_name = "X,Y,RADIUS", allow_hyphen_values = true, value_parser = settings::dab)]
    pub kept: Vec<Dab>,
    /// Shows the face as a camera sees it from so many cm
    #[arg(long = "seen-from", value_name = "CM", allow_negative_numbers = true, value_parser = settings::seen_from)]
    pub seen_from_m: Option<f64>,
    #[command(flatten)]
    pub mesh: MeshArguments,
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
pub struct PaperTask {
    /// JPEG, PNG or WebP; - reads standard input
    pub photo: PathBuf,
    /// Folder for the meshes of Figures 3 to 5 and the plot of times; made if it is not there
    #[arg(short, long, value_name = "DIR", default_value = "rosto-paper")]
    pub output: PathBuf,
    /// Replaces files of the same names in that folder, even if Rosto did not write them
    #[arg(long)]
    pub force: bool,
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

fn output_help() -> String {
    format!(
        "The file to write, whole or not at all; its name ends as its format is called. {{}} in it stands for the name of each photo, without its extension.\n\nWith {{}} a run can be resumed: meshes that the same request has made are left as they are. What was made of which photo is in the file .rosto-NAME.jsonl beside the meshes. A file that Rosto did not write is replaced only with --force, and so is one beside FILE, such as an OBJ's picture.\n\nFormats: {}",
        endings()
    )
}
