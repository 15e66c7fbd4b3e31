use std::env;
use std::path::{Path, PathBuf};

use rosto_landmarks::{FaceFinder, LandmarkNetwork};

use crate::error::CliError;
use crate::files;

const DETECTOR: &str = "face_detector.onnx";

/// All together are a sixteenth of this.
const MAX_BYTES: usize = 64_000_000;

/// Which network finds the landmarks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Landmarks {
    /// 468 points.
    Plain,
    /// 478 points, lips, eyes and irises looked at closer.
    Attention,
}

impl Landmarks {
    fn file(self) -> &'static str {
        match self {
            Self::Plain => "face_landmarks.onnx",
            Self::Attention => "face_landmarks_attention.onnx",
        }
    }

    fn network(self, onnx: &[u8]) -> LandmarkNetwork<'_> {
        match self {
            Self::Plain => LandmarkNetwork::Plain(onnx),
            Self::Attention => LandmarkNetwork::Attention(onnx),
        }
    }
}

/// Loads the detector and a landmark network from the first place that has both; a folder that was named is the only place.
pub fn load(named: Option<&Path>, landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    let by_variable = || env::var_os("ROSTO_NETWORKS").filter(|folder| !folder.is_empty()).map(PathBuf::from);
    let places = match named.map(Path::to_owned).or_else(by_variable) {
        Some(folder) => vec![folder],
        None => usual_places(),
    };
    let names = [DETECTOR, landmarks.file()];
    let folder = place(&places, names)?;
    let [detector, onnx] = names.map(|name| read(&folder.join(name)));
    Ok(FaceFinder::new(&detector?, landmarks.network(&onnx?))?)
}

/// The first place that has both; one that has half of them is worth a word.
fn place<'a>(places: &'a [PathBuf], names: [&str; 2]) -> Result<&'a Path, CliError> {
    let files = |folder: &Path| names.map(|name| folder.join(name));
    let missing = |folder: &PathBuf| files(folder).into_iter().filter(|file| !file.is_file()).collect::<Vec<_>>();
    if let Some(folder) = places.iter().find(|folder| missing(folder).is_empty()) {
        return Ok(folder);
    }
    let half = places.iter().map(missing).find(|missing| missing.len() == 1).and_then(|mut missing| missing.pop());
    Err(match half {
        Some(path) => CliError::NetworkMissing { path },
        None => CliError::NetworksMissing { looked_in: places.to_vec() },
    })
}

fn usual_places() -> Vec<PathBuf> {
    let beside_program = env::current_exe().ok().and_then(|program| program.parent().map(Path::to_owned));
    let source_tree = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets");
    beside_program.into_iter().chain([source_tree]).collect()
}

fn read(path: &Path) -> Result<Vec<u8>, CliError> {
    files::read(path, MAX_BYTES).map_err(|reason| CliError::NetworkUnreadable { path: path.to_owned(), reason })
}
