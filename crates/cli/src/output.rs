//! What is written: a file whole, or not at all.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use rosto_export::NamedFile;
use same_file::Handle;
use tempfile::{Builder, NamedTempFile};

use crate::error::CliError;
use crate::input;

/// What stays behind beside the output, and may be deleted, if the program is killed in the middle of writing.
const UNFINISHED: &str = ".rosto-unfinished-";

/// In the name of an output, the place of a photo's name.
pub const PHOTO_NAME: &str = "{}";

/// Whether an output stands for one of each photo.
pub fn is_pattern(output: &Path) -> bool {
    output.to_str().is_some_and(|output| output.contains(PHOTO_NAME))
}

/// Refuses, before any work is done, an output that is one of the inputs, or whose folder is not there.
pub fn check(path: &Path, inputs: &[&Path]) -> Result<(), CliError> {
    if let Some(input) = inputs.iter().find(|input| is_same_file(input, path)) {
        return Err(CliError::OverInput { path: path.to_owned(), input: input.to_path_buf() });
    }
    let refused = |reason: io::Error| CliError::Unwritable { path: path.to_owned(), reason };
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => Err(refused(ErrorKind::IsADirectory.into())),
        Ok(_) => Ok(()),
        Err(_) => followed(path).and_then(|path| fs::metadata(folder_of(&path))).map(|_| ()).map_err(refused),
    }
}

/// By name, through a link, or by another name of the same file.
fn is_same_file(input: &Path, output: &Path) -> bool {
    // To open a pipe would wait for its other end, and a device may be both.
    let is_regular = |path: &Path| fs::metadata(path).is_ok_and(|there| there.is_file());
    let input = match input::is_standard_input(input) {
        true => Handle::stdin(),
        false if is_regular(input) => Handle::from_path(input),
        false => return false,
    };
    let output = is_regular(output).then(|| Handle::from_path(output));
    matches!((input, output), (Ok(input), Some(Ok(output))) if input == output)
}

/// Replaces the file at once when all bytes are on the disk; until then what was there stays as it was. A device or a
/// pipe is written to as it comes.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    write_together(path, bytes, &[])
}

/// The same of a file with those that lie beside it: all are on the disk before the first is put in its place, and the one
/// that names the others comes last.
pub fn write_together(path: &Path, bytes: &[u8], beside: &[NamedFile]) -> Result<(), CliError> {
    let others = beside.iter().map(|file| (path.with_file_name(&file.name), file.bytes.as_slice()));
    let files: Vec<(PathBuf, &[u8])> = others.chain([(path.to_owned(), bytes)]).collect();
    let refused = |path: &Path| {
        let path = path.to_owned();
        move |reason| CliError::Unwritable { path, reason }
    };
    let prepare = |(path, bytes): &(PathBuf, &'_ [u8])| Unfinished::new(path, bytes).map_err(refused(path));
    let ready: Vec<Unfinished> = files.iter().map(prepare).collect::<Result<_, _>>()?;
    let put = |(file, (path, bytes)): (Unfinished, &(PathBuf, &[u8]))| file.put(bytes).map_err(refused(path));
    ready.into_iter().zip(&files).try_for_each(put)
}

/// A file that is on the disk, and not yet in its place.
enum Unfinished {
    /// It will take its place at once.
    Whole { file: NamedTempFile, path: PathBuf },
    /// A device or a pipe takes bytes as they come.
    Open(File),
}

impl Unfinished {
    fn new(path: &Path, bytes: &[u8]) -> io::Result<Self> {
        // Opened without being cut, to see what it is and whether it may be written to.
        let file = match OpenOptions::new().write(true).open(path) {
            Ok(file) => file,
            Err(reason) if reason.kind() == ErrorKind::NotFound => return Self::whole(followed(path)?, bytes, None),
            Err(reason) => return Err(reason),
        };
        let there = file.metadata()?;
        match there.is_file() {
            true => Self::whole(path.canonicalize()?, bytes, Some(there.permissions())),
            false => Ok(Self::Open(file)),
        }
    }

    fn whole(path: PathBuf, bytes: &[u8], permissions: Option<Permissions>) -> io::Result<Self> {
        let unfinished = unfinished_beside(&path)?;
        let mut file: &File = unfinished.as_file();
        file.write_all(bytes)?;
        if let Some(permissions) = permissions {
            file.set_permissions(permissions)?;
        }
        file.sync_all()?;
        Ok(Self::Whole { file: unfinished, path })
    }

    fn put(self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Whole { file, path } => file.persist(path).map(|_| ()).map_err(|unmoved| unmoved.error),
            Self::Open(mut file) => file.write_all(bytes),
        }
    }
}

pub fn unfinished_beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(UNFINISHED);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any new file; the user's mask takes its part.
        builder.permissions(Permissions::from_mode(0o666));
    }
    // The kind alone: the words would name a file that nobody asked for.
    builder.tempfile_in(folder_of(path)).map_err(|reason| reason.kind().into())
}

/// Where a link to nothing leads, so that the file is made there and the link stays one.
fn followed(path: &Path) -> io::Result<PathBuf> {
    /// As many as Linux follows.
    const MOST_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(target) = fs::read_link(&path) else { return Ok(path) };
        path = folder_of(&path).join(target);
    }
    Err(io::Error::other("the links lead in a circle"))
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
