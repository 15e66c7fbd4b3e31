use std::env;
use std::path::{Path, PathBuf};

use rosto_landmarks::{FaceFinder, LandmarkNetwork};

use crate::error::CliError;
use crate::input;

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

/// Networks within the program, by the names of their files.
pub type EmbeddedNetworks = &'static [(&'static str, &'static [u8])];

/// Where networks come from: the folder that the command line names, or else the one that ROSTO_NETWORKS names, or else the
/// program itself, or else a folder near it.
#[derive(Debug, Clone, Copy)]
pub struct Networks<'a> {
    pub named: Option<&'a Path>,
    pub embedded: EmbeddedNetworks,
}

/// Loads the detector and a landmark network.
pub fn load(from: Networks<'_>, landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    let by_variable = || env::var_os("ROSTO_NETWORKS").filter(|folder| !folder.is_empty()).map(PathBuf::from);
    let names = [DETECTOR, landmarks.file()];
    let embedded = names.map(|name| from.embedded.iter().find(|(known, _)| *known == name).map(|(_, onnx)| *onnx));
    match (from.named.map(Path::to_owned).or_else(by_variable), embedded) {
        (None, [Some(detector), Some(onnx)]) => Ok(FaceFinder::new(detector, landmarks.network(onnx))?),
        (folder, _) => load_files(&folder.map_or_else(usual_places, |folder| vec![folder]), names, landmarks),
    }
}

fn load_files(places: &[PathBuf], names: [&str; 2], landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    let folder = place(places, names)?;
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
    beside_program.into_iter().chain(source_tree()).collect()
}

/// Only for who develops Rosto: no folder of the machine that built it is in a program that others get.
#[cfg(debug_assertions)]
fn source_tree() -> Option<PathBuf> {
    Some(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets"))
}

#[cfg(not(debug_assertions))]
fn source_tree() -> Option<PathBuf> {
    None
}

fn read(path: &Path) -> Result<Vec<u8>, CliError> {
    input::read(path, MAX_BYTES).map_err(|reason| CliError::NetworkUnreadable { path: path.to_owned(), reason })
}

#[cfg(test)]
mod tests {
    use super::*;

    const EMBEDDED: EmbeddedNetworks = &[
        (DETECTOR, include_bytes!("../../../web/assets/face_detector.onnx")),
        ("face_landmarks.onnx", include_bytes!("../../../web/assets/face_landmarks.onnx")),
    ];

    #[test]
    fn a_program_with_networks_needs_no_folder_but_obeys_one_that_is_named() {
        let load = |named, landmarks| load(Networks { named, embedded: EMBEDDED }, landmarks);
        assert!(load(None, Landmarks::Plain).is_ok());
        let nowhere = Path::new("no such folder");
        assert!(matches!(load(Some(nowhere), Landmarks::Plain), Err(CliError::NetworksMissing { .. })));
    }
}
