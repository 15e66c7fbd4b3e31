use std::path::{Path, PathBuf};
use std::{env, fs};

use rosto_landmarks::FaceFinder;

use crate::error::CliError;

const DETECTOR: &str = "face_detector.onnx";
const LANDMARKS: &str = "face_landmarks.onnx";

/// Loads both networks from the first place that has them; a folder that was named is the only place.
pub fn load(named: Option<&Path>) -> Result<FaceFinder, CliError> {
    let places = match named.map(Path::to_owned).or_else(|| env::var_os("ROSTO_NETWORKS").map(PathBuf::from)) {
        Some(folder) => vec![folder],
        None => usual_places(),
    };
    let Some(folder) = places.iter().find(|folder| folder.join(DETECTOR).is_file()) else {
        return Err(CliError::NetworksMissing { looked_in: places });
    };
    Ok(FaceFinder::new(&read(folder, DETECTOR)?, &read(folder, LANDMARKS)?)?)
}

fn usual_places() -> Vec<PathBuf> {
    let beside_program = env::current_exe().ok().and_then(|program| program.parent().map(Path::to_owned));
    let source_tree = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/assets");
    beside_program.into_iter().chain([source_tree]).collect()
}

fn read(folder: &Path, name: &str) -> Result<Vec<u8>, CliError> {
    fs::read(folder.join(name)).map_err(|_| CliError::NetworksMissing { looked_in: vec![folder.to_owned()] })
}
