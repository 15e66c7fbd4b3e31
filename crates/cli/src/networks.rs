use std::env;
use std::path::{Path, PathBuf};

use rosto::networks::{DETECTOR, Landmarks};
use rosto_landmarks::FaceFinder;

use crate::error::CliError;
use crate::input;

/// 16 times the size of the three networks.
const MAX_BYTES: usize = 64_000_000;

/// Loads the detector and a landmark network. Sources, by priority: the folder given by the user, the folder in
/// ROSTO_NETWORKS, the embedded networks, folders near the program.
pub fn load(given: Option<&Path>, landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    let by_variable = || env::var_os("ROSTO_NETWORKS").filter(|folder| !folder.is_empty()).map(PathBuf::from);
    match given.map(Path::to_owned).or_else(by_variable) {
        Some(folder) => load_files(&[folder], landmarks),
        None => load_default(landmarks),
    }
}

#[cfg(feature = "embed-networks")]
fn load_default(landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    Ok(rosto::networks::embedded(landmarks)?)
}

#[cfg(not(feature = "embed-networks"))]
fn load_default(landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    load_files(&default_folders(), landmarks)
}

fn load_files(folders: &[PathBuf], landmarks: Landmarks) -> Result<FaceFinder, CliError> {
    let names = [DETECTOR, landmarks.file()];
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

#[cfg(not(feature = "embed-networks"))]
fn default_folders() -> Vec<PathBuf> {
    let program_folder = env::current_exe().ok().and_then(|program| program.parent().map(Path::to_owned));
    program_folder.into_iter().chain(source_tree()).collect()
}

/// Only in debug builds: a release must not contain a path of the build machine.
#[cfg(not(feature = "embed-networks"))]
fn source_tree() -> Option<PathBuf> {
    #[cfg(debug_assertions)]
    return Some(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets"));
    #[cfg(not(debug_assertions))]
    None
}

fn read(path: &Path) -> Result<Vec<u8>, CliError> {
    input::read(path, MAX_BYTES).map_err(|reason| CliError::NetworkUnreadable { path: path.to_owned(), reason })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Also with embedded networks.
    #[test]
    fn a_given_folder_overrides_other_networks() {
        assert!(load(None, Landmarks::Plain).is_ok());
        let nowhere = Path::new("no such folder");
        assert!(matches!(load(Some(nowhere), Landmarks::Plain), Err(CliError::NetworksMissing { .. })));
    }
}
