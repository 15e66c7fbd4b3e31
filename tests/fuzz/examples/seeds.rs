//! Writes the seeds of the fuzz targets into a folder, as the initial corpus of `cargo fuzz`.

use std::path::PathBuf;

use rosto_fuzz::Kind;

fn main() -> std::io::Result<()> {
    let corpus = PathBuf::from(std::env::args_os().nth(1).expect("usage: seeds FOLDER"));
    for kind in Kind::ALL {
        let folder = corpus.join(format!("{kind:?}").to_lowercase());
        std::fs::create_dir_all(&folder)?;
        for (number, seed) in kind.seeds().iter().enumerate() {
            std::fs::write(folder.join(format!("seed-{number}")), seed)?;
        }
    }
    Ok(())
}
