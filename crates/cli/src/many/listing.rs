use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::CliError;

/// How the names of photos end.
const ENDINGS: [&str; 4] = ["jpg", "jpeg", "png", "webp"];

/// The photos that are given, each folder's and its folders' in the order of their names in place of it.
///
/// In a folder a photo is what is called so; nothing whose name begins with a dot is looked at, and no link to a folder is
/// followed.
pub fn photos(given: &[PathBuf]) -> Result<Vec<PathBuf>, CliError> {
    let mut photos = Vec::new();
    for path in given {
        if !path.is_dir() {
            photos.push(path.clone());
            continue;
        }
        let before = photos.len();
        add_folder(path, &mut photos).map_err(|(path, reason)| CliError::Unreadable { path, reason: reason.into() })?;
        if photos.len() == before {
            return Err(CliError::NoPhotos { path: path.clone() });
        }
    }
    Ok(photos)
}

fn add_folder(folder: &Path, photos: &mut Vec<PathBuf>) -> Result<(), (PathBuf, io::Error)> {
    let of_folder = |reason| (folder.to_owned(), reason);
    let entries = fs::read_dir(folder).map_err(of_folder)?;
    let mut entries: Vec<_> = entries.collect::<Result<_, _>>().map_err(of_folder)?;
    entries.sort_by_key(|entry| entry.file_name());
    for entry in entries.into_iter().filter(|entry| !entry.file_name().as_encoded_bytes().starts_with(b".")) {
        let path = entry.path();
        if entry.file_type().map_err(of_folder)?.is_dir() {
            add_folder(&path, photos)?;
        } else if is_called_as_a_photo(&path) && !path.is_dir() {
            photos.push(path);
        }
    }
    Ok(())
}

fn is_called_as_a_photo(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ENDINGS.iter().any(|known| known.eq_ignore_ascii_case(ending)))
}
