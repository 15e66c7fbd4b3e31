use std::env;
use std::path::{Path, PathBuf};

use rosto_landmarks::{FaceFinder, LandmarkNetwork};

use crate::error::CliError;
use crate::input;

const DETECTOR: &str = "face_detector.onnx";

/// 16 times the size of the three networks.
const MAX_BYTES: usize = 64_000_000;

/// Choice of the landmark network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Landmarks {
    /// 468 landmarks.
    Plain,
    /// 478 landmarks, with refined lips, eyes and irises.
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

/// Embedded networks as pairs of file name and content.
pub type EmbeddedNetworks = &'static [(&'static str, &'static [u8])];

/// Sources of the networks, by priority: the folder in `named`, the folder in ROSTO_NETWORKS, the embedded networks,
/// folders near the program.
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
        (folder, _) => load_files(&folder.map_or_else(default_folders, |folder| vec![folder]), names, landmarks),
    }
}

fn load_files(folders: &[PathBuf], names: [&str; 2], landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    let folder = find_folder(folders, names)?;
    let [detector, onnx] = names.map(|name| read(&folder.join(name)));
    Ok(FaceFinder::new(&detector?, landmarks.network(&onnx?))?)
}

/// First folder with both networks. If none has both, a folder with one of them gives a more precise error.
fn find_folder<'a>(folders: &'a [PathBuf], names: [&str; 2]) -> Result<&'a Path, CliError> {
    let files = |folder: &Path| names.map(|name| folder.join(name));
    let missing = |folder: &PathBuf| files(folder).into_iter().filter(|file| !file.is_file()).collect::<Vec<_>>();
    if let Some(folder) = folders.iter().find(|folder| missing(folder).is_empty()) {
        return Ok(folder);
    }
    let half = folders.iter().map(missing).find(|missing| missing.len() == 1).and_then(|mut missing| missing.pop());
    Err(match half {
        Some(path) => CliError::NetworkMissing { path },
        None => CliError::NetworksMissing { looked_in: folders.to_vec() },
    })
}

fn default_folders() -> Vec<PathBuf> {
    let program_folder = env::current_exe().ok().and_then(|program| program.parent().map(Path::to_owned));
    program_folder.into_iter().chain(source_tree()).collect()
}

/// Only in debug builds: a release must not contain a path of the build machine.
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
    fn a_given_folder_overrides_embedded_networks() {
        let load = |named, landmarks| load(Networks { named, embedded: EMBEDDED }, landmarks);
        assert!(load(None, Landmarks::Plain).is_ok());
        let nowhere = Path::new("no such folder");
        assert!(matches!(load(Some(nowhere), Landmarks::Plain), Err(CliError::NetworksMissing { .. })));
    }
}
