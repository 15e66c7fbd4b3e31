use std::path::PathBuf;

use clap::Args;
use clap::builder::RangedU64ValueParser;
use rosto::{
    BaseColour, EditsAs, ExpressionsAs, Eyes, FileOptions, Material, MeshRequest, Print, PrintHeight, Solid,
    TextureSize, Triangulation, Units,
};
use rosto_studio::{DEFAULT_FALLOFF_BAND, SMOOTH_DENSITY};
use rosto_warp::Dab;

use super::{CameraArguments, EditArguments, FindArguments, SettingsArguments};
use crate::choices::one_of;
use crate::error::{CliError, extensions};
use crate::settings;

/// Options shared by the commands that process several photos.
#[derive(Debug, Args)]
pub struct BatchArguments {
    /// Number of photos to process in parallel, one thread each
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true,
        value_parser = RangedU64ValueParser::<usize>::new().range(1..=1024))]
    pub jobs: usize,
    /// Replace existing files, even those that Rosto did not write, and start over. Photos and the file of --edits are
    /// not replaced
    #[arg(long)]
    pub force: bool,
}

#[derive(Debug, Args)]
pub struct LandmarksTask {
    /// JPEG, PNG or WebP files; - reads standard input. A folder means the regular files in it and its subfolders with
    /// the extension .jpg, .jpeg, .jpe, .jfif, .pjpeg, .png or .webp
    #[arg(required = true, value_name = "PHOTO|DIR")]
    pub photos: Vec<PathBuf>,
    /// Write JSON lines to this file instead of standard output, including a line for each photo that failed
    ///
    /// If the file exists, Rosto resumes the batch: it skips photos that have a line and tries failed ones again. It
    /// refuses a file that was written with other options. Only one process at a time can write the file.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// Maximum number of faces per photo, the most prominent first [default: 20, or 1 with --mediapipe]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = RangedU64ValueParser::<usize>::new().range(1..))]
    pub max_faces: Option<usize>,
    #[command(flatten)]
    pub find: FindArguments,
}

/// Mesh that the edits apply to.
#[derive(Debug, Args)]
pub struct MeshArguments {
    /// Triangulation of the landmarks: open at eyes and mouth, or closed
    #[arg(long, default_value = Triangulation::Canonical.id(),
        value_parser = one_of("triangulation", Triangulation::ALL, Triangulation::id, Triangulation::from_id))]
    pub topology: Triangulation,
    /// Subdivision level: each level splits a triangle into four, smoothly and through the landmarks. 0 is the 468
    /// landmarks, as in the paper
    #[arg(long, value_name = "TIMES", default_value_t = SMOOTH_DENSITY, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(0..=4))]
    pub density: u32,
}

impl MeshArguments {
    /// The request without its photos, with edits in these units.
    pub fn request(
        &self,
        units: Units,
        edits: &EditArguments,
        settings: &SettingsArguments,
    ) -> Result<MeshRequest, CliError> {
        let (triangulation, density) = (self.topology, self.density);
        let mut request = MeshRequest { triangulation, density, units, ..MeshRequest::of(Vec::new()) };
        edits.add_to(&mut request, settings)?;
        Ok(request)
    }
}

/// Options of the file; `effect` knows the ids of their arguments.
#[derive(Debug, Args)]
pub struct FileArguments {
    /// Texture or colours of a .glb, .gltf, .obj, .usdz or .png
    #[arg(long, default_value = BaseColour::default().id(),
        value_parser = one_of("base-colour", BaseColour::ALL, BaseColour::id, BaseColour::from_id))]
    pub base_colour: BaseColour,
    /// Maximum length of the texture's longer side, in px
    #[arg(long, value_name = "PX", default_value = TextureSize::default().id(),
        value_parser = one_of("texture-size", TextureSize::ALL, TextureSize::id, TextureSize::from_id))]
    pub texture_size: TextureSize,
    /// Body for 3D printing (.stl, .3mf): thickness:MM is a mask with a wall of MM, flat:MM a relief with a flat back,
    /// at most MM deep (flat: a third of its height), surface the open surface (.stl)
    #[arg(long, value_name = "SOLID", default_value_t = Solid::default())]
    pub solid: Solid,
    /// Height of that body in mm, or life for that of the face; a wall's thickness is that of the print
    #[arg(long, value_name = "MM", allow_negative_numbers = true, default_value_t = PrintHeight::default())]
    pub height_mm: PrintHeight,
    /// Shading of a .glb or .gltf
    #[arg(long, default_value = Material::default().id(),
        value_parser = one_of("material", Material::ALL, Material::id, Material::from_id))]
    pub material: Material,
    /// Eyes and mouth of a closed face in a .glb, .gltf, .obj, .ply or .usdz: continuous skin, or separate pieces
    /// behind lids and lips, with round eyeballs
    #[arg(long, default_value = Eyes::default().id(), value_parser = one_of("eyes", Eyes::ALL, Eyes::id, Eyes::from_id))]
    pub eyes: Eyes,
    /// Write the unedited face with each edit as a named morph target at weight 1; for .glb and .gltf
    #[arg(long)]
    pub morph_targets: bool,
    /// Write each expression as a morph target with its ARKit name, at the weight of --expression, and eyes and mouth
    /// as separate pieces; for .glb and .gltf
    #[arg(long = "expressions")]
    pub expression_targets: bool,
}

impl FileArguments {
    /// The options, with the unit of JSON.
    pub fn options(&self, units: Units) -> FileOptions {
        FileOptions {
            base_colour: self.base_colour,
            texture_size: self.texture_size,
            material: self.material,
            edits: if self.morph_targets { EditsAs::MorphTargets } else { EditsAs::Shape },
            expressions: if self.expression_targets { ExpressionsAs::MorphTargets } else { ExpressionsAs::Shape },
            eyes: self.eyes,
            units,
            print: Print { solid: self.solid, height: self.height_mm },
        }
    }
}

#[derive(Debug, Args)]
pub struct MeshTask {
    /// JPEG, PNG or WebP; - reads standard input. One photo, or up to five of the same face: frontal, turned to its
    /// left, turned to its right
    ///
    /// With {} in the output's name, Rosto makes one mesh per photo, and a folder means the photos in it and its
    /// subfolders.
    ///
    /// Without {}, several photos make one mesh. The photo whose face looks at the camera leads: the mesh matches its
    /// landmarks and takes its colours. The others improve the depth of each landmark.
    #[arg(required = true, value_name = "PHOTO")]
    pub photos: Vec<PathBuf>,
    /// Output file; its extension selects the format
    #[arg(short, long, value_name = "FILE", long_help = output_help())]
    pub output: PathBuf,
    #[command(flatten)]
    pub batch: BatchArguments,
    #[command(flatten)]
    pub mesh: MeshArguments,
    /// Coordinates of the edits and of JSON output
    ///
    /// "mm": millimetres in the model's frame, +Y up, +Z out of the face, +X to the subject's left. "image":
    /// MediaPipe's normalised coordinates x/W, y/H, z/W, as in the paper; for .json only.
    #[arg(long, default_value = Units::default().id(),
        value_parser = one_of("export.units", Units::ALL, Units::id, Units::from_id))]
    pub units: Units,
    #[command(flatten)]
    pub file: FileArguments,
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
    /// Output file: .jpg or .png, upright, in sRGB, without the photo's metadata
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Width of the band around the face in which the warp fades out, as a share of the face's longer side
    #[arg(long, value_name = "SHARE", default_value_t = DEFAULT_FALLOFF_BAND, allow_negative_numbers = true, value_parser = settings::falloff_band)]
    pub falloff_band: f64,
    /// Protect a circle of the photo from the warp: centre and radius in px of the upright photo; repeatable
    #[arg(long = "keep", value_name = "X,Y,RADIUS", allow_hyphen_values = true, value_parser = settings::dab)]
    pub protected: Vec<Dab>,
    /// Show the face as a camera at this distance sees it
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
    /// Folder for the meshes of Figures 3 to 5 and the plot of times; created if missing
    #[arg(short, long, value_name = "DIR", default_value = "rosto-paper")]
    pub output: PathBuf,
    /// Replace files with these names in that folder, even if Rosto did not write them
    #[arg(long)]
    pub force: bool,
    /// Seed of the vertices and their anchors; each further run uses the next seed
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// Number of runs, each with its own vertices and anchors
    #[arg(long, value_name = "N", default_value_t = 20, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u64).range(1..))]
    pub runs: u64,
    #[command(flatten)]
    pub find: FindArguments,
}

fn output_help() -> String {
    format!(
        "Output file, written completely or not at all; its extension selects the format. {{}} is replaced by the name of each photo, without its extension.\n\nWith {{}}, the same command resumes a batch: Rosto keeps the meshes that it made with the same options. The file .rosto-NAME.jsonl next to the meshes records which photo each mesh comes from. Rosto replaces a file that it did not write, such as an OBJ's texture, only with --force.\n\nFormats: {}",
        extensions()
    )
}
