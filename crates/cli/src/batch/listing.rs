use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::error::CliError;
use crate::input;

/// Extensions that make a file in a folder a photo.
const EXTENSIONS: [&str; 7] = ["jpg", "jpeg", "jpe", "jfif", "pjpeg", "png", "webp"];

/// Given photos without duplicates.
#[derive(Debug, Default)]
pub struct Listing {
    pub photos: Vec<Listed>,
    pub skipped: Skipped,
    identities: HashSet<PathBuf>,
    /// Number of photos and folders visited, including duplicates.
    visited: usize,
}

/// A photo and the path under which it was given or found.
#[derive(Debug)]
pub struct Listed {
    pub path: PathBuf,
    /// Path relative to the given folder.
    pub name: PathBuf,
}

/// Files skipped in folders, counted by lower-case extension; empty for none.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Skipped(BTreeMap<String, usize>);

/// Lists the given photos and those in given folders and their subfolders, in the order of the arguments and then of
/// file names.
///
/// In a folder, photos are regular files with one of [`EXTENSIONS`]. Hidden files and links to folders are skipped. A
/// photo reached twice, for example through `photos` and `./photos`, is listed once.
pub fn photos(given: &[PathBuf]) -> Result<Listing, CliError> {
    let mut listing = Listing::default();
    for path in given {
        if !path.is_dir() {
            listing.add(path.clone(), path.parent().unwrap_or(Path::new("")));
            continue;
        }
        let (visited, skipped) = (listing.visited, listing.skipped.count());
        listing.add_folder(path, path)?;
        if listing.visited == visited {
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
        self.visited += 1;
        if self.identities.insert(input::identity(&path)) {
            let name = path.strip_prefix(folder).unwrap_or(&path).to_owned();
            self.photos.push(Listed { path, name });
        }
    }

    fn add_folder(&mut self, folder: &Path, given: &Path) -> Result<(), CliError> {
        let unreadable = |reason: io::Error| CliError::Unreadable { path: folder.to_owned(), reason: reason.into() };
        if !self.identities.insert(folder.canonicalize().map_err(unreadable)?) {
            self.visited += 1;
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

    /// Text for a summary, such as `; 3 other files skipped (2 .heic, 1 .txt)`; empty without skipped files.
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
