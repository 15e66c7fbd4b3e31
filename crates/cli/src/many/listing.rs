use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::CliError;
use crate::input;

/// Extensions of the files that a folder stands for.
const EXTENSIONS: [&str; 7] = ["jpg", "jpeg", "jpe", "jfif", "pjpeg", "png", "webp"];

/// The photos that are given, each once.
#[derive(Debug, Default)]
pub struct Listing {
    pub photos: Vec<Listed>,
    pub skipped: Skipped,
    identities: HashSet<PathBuf>,
    /// How many photos and folders were met, repeated ones included.
    met: usize,
}

/// A photo, by the path that it was given or found by.
#[derive(Debug)]
pub struct Listed {
    pub path: PathBuf,
    /// Its path below the folder that was given.
    pub name: PathBuf,
}

/// Files in folders that were left out, counted by extension; without an extension under the empty one.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Skipped(BTreeMap<String, usize>);

/// Lists the photos that are given, each folder's and its subfolders' in the order of their names in place of it.
///
/// In a folder, photos are the regular files with one of [`EXTENSIONS`]. Names that begin with a dot are ignored, and links to
/// folders are not followed. A photo that is reached twice, say through `photos` and `./photos`, is listed once.
pub fn photos(given: &[PathBuf]) -> Result<Listing, CliError> {
    let mut listing = Listing::default();
    for path in given {
        if !path.is_dir() {
            listing.add(path.clone(), path.parent().unwrap_or(Path::new("")));
            continue;
        }
        let (met, skipped) = (listing.met, listing.skipped.count());
        listing.add_folder(path, path)?;
        if listing.met == met {
            return Err(CliError::NoPhotos { path: path.clone(), skipped: listing.skipped.count() - skipped });
        }
    }
    Ok(listing)
}

impl Listing {
    /// Whether a photo with this identity ([`input::identity`]) is listed.
    pub fn has(&self, identity: &Path) -> bool {
        self.identities.contains(identity)
    }

    fn add(&mut self, path: PathBuf, folder: &Path) {
        self.met += 1;
        if self.identities.insert(input::identity(&path)) {
            let name = path.strip_prefix(folder).unwrap_or(&path).to_owned();
            self.photos.push(Listed { path, name });
        }
    }

    fn add_folder(&mut self, folder: &Path, given: &Path) -> Result<(), CliError> {
        let unreadable = |reason: io::Error| CliError::Unreadable { path: folder.to_owned(), reason: reason.into() };
        if !self.identities.insert(folder.canonicalize().map_err(unreadable)?) {
            self.met += 1;
            return Ok(());
        }
        let entries = fs::read_dir(folder).map_err(unreadable)?;
        let mut entries: Vec<_> = entries.collect::<Result<_, _>>().map_err(unreadable)?;
        entries.sort_by_key(|entry| entry.file_name());
        for entry in entries.into_iter().filter(|entry| !entry.file_name().as_encoded_bytes().starts_with(b".")) {
            let path = entry.path();
            if entry.file_type().map_err(unreadable)?.is_dir() {
                self.add_folder(&path, given)?;
            } else if has_photo_extension(&path) && path.is_file() {
                self.add(path, given);
            } else if !path.is_dir() {
                self.skipped.add(&path);
            }
        }
        Ok(())
    }
}

impl Skipped {
    pub fn count(&self) -> usize {
        self.0.values().sum()
    }

    fn add(&mut self, path: &Path) {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        *self.0.entry(extension).or_default() += 1;
    }

    /// For a summary: `; 3 other files skipped (2 .heic, 1 .txt)`, or nothing.
    pub fn summary(&self) -> String {
        let of_kind = |(extension, count): (&String, &usize)| match extension.as_str() {
            "" => format!("{count} without an extension"),
            extension => format!("{count} .{extension}"),
        };
        match self.count() {
            0 => String::new(),
            count => {
                let kinds: Vec<String> = self.0.iter().map(of_kind).collect();
                let files = if count == 1 { "file" } else { "files" };
                format!("; {count} other {files} skipped ({})", kinds.join(", "))
            }
        }
    }
}

fn has_photo_extension(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str());
    extension.is_some_and(|extension| EXTENSIONS.iter().any(|known| known.eq_ignore_ascii_case(extension)))
}
