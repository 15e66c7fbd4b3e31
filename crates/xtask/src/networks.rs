//! The networks: out of the published npm package, converted to ONNX once.

use crate::failure::{Doing, Result};
use crate::versions::{NETWORKS_PACKAGE, PACKED_NETWORKS};
use crate::{cache, progress, workspace};
use std::path::Path;
use std::time::Instant;

/// Names of the files below [`workspace::assets`].
pub const FILES: [&str; 3] = ["face_detector.onnx", "face_landmarks.onnx", "face_landmarks_attention.onnx"];

const LOADER: &str = "face_mesh_solution_packed_assets_loader.js";
/// Below the build folder: what the networks were made from, so that another package or converter makes them anew.
const STAMP: &str = "xtask/networks-made-from";

/// Writes the networks into `web/assets` unless they are there.
pub fn obtain(node_modules: &Path) -> Result {
    let assets = workspace::assets();
    let package = node_modules.join(NETWORKS_PACKAGE);
    let origin = format!("{}\n{}\n", PACKED_NETWORKS.sha256, converter_sha256()?);
    let stamp = workspace::target().join(STAMP);
    if std::fs::read_to_string(&stamp).is_ok_and(|made_from| made_from == origin)
        && FILES.iter().all(|file| assets.join(file).is_file())
    {
        return Ok(());
    }
    progress::announce("face networks", "the page finds the face and its landmarks with them");
    let started = Instant::now();
    let packed = std::fs::read(cache::check(&package, &PACKED_NETWORKS)?).doing("reading the packed networks")?;
    let loader = std::fs::read_to_string(package.join(LOADER)).doing("reading the list of the packed networks")?;
    let networks = rosto_model_import::import(&loader, &packed).doing("converting the networks")?;
    let files = [networks.detector_onnx, networks.landmarks_onnx, networks.attention_onnx];
    for (file, bytes) in FILES.iter().zip(files) {
        cache::write(&assets.join(file), bytes)?;
    }
    cache::write(&stamp, origin)?;
    progress::done("face networks", started);
    Ok(())
}

/// One sha256 over the sources of the converter.
fn converter_sha256() -> Result<String> {
    let folder = workspace::root().join("crates/model-import/src");
    let entries = std::fs::read_dir(&folder).doing(format!("listing {}", folder.display()))?;
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    files.sort();
    let hashes = files.iter().map(|file| cache::sha256_of(file)).collect::<Result<Vec<_>>>()?;
    Ok(cache::sha256(hashes.concat().as_bytes()))
}
