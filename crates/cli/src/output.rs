//! Output files, written completely or not at all.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use rosto_export::NamedFile;
use same_file::Handle;
use tempfile::{Builder, NamedTempFile};

use crate::error::CliError;
use crate::input;

/// Prefix of temporary files, which remain next to the output if the program is killed while writing.
const UNFINISHED: &str = ".rosto-unfinished-";

/// Placeholder for the photo's name in an output path.
pub const PHOTO_NAME: &str = "{}";

/// Whether the output path contains [`PHOTO_NAME`].
pub fn is_pattern(output: &Path) -> bool {
    output.to_str().is_some_and(|output| output.contains(PHOTO_NAME))
}

/// Refuses an output that is also an input, or whose folder does not exist, before any work is done.
pub fn check(path: &Path, inputs: &[&Path]) -> Result<(), CliError> {
    if let Some(input) = inputs.iter().find(|input| is_same_file(input, path)) {
        return Err(CliError::OverwritesInput { path: path.to_owned(), input: input.to_path_buf() });
    }
    let refused = |reason: io::Error| CliError::Unwritable { path: path.to_owned(), reason };
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => Err(refused(ErrorKind::IsADirectory.into())),
        Ok(_) => Ok(()),
        Err(_) => followed(path).and_then(|path| fs::metadata(folder_of(&path))).map(|_| ()).map_err(refused),
    }
}

/// Compares the files themselves, so links and different spellings of a path count as the same file.
fn is_same_file(input: &Path, output: &Path) -> bool {
    // Opening a pipe would block, and a device can be both input and output.
    let is_regular = |path: &Path| fs::metadata(path).is_ok_and(|there| there.is_file());
    let input = match input::is_standard_input(input) {
        true => Handle::stdin(),
        false if is_regular(input) => Handle::from_path(input),
        false => return false,
    };
    let output = is_regular(output).then(|| Handle::from_path(output));
    matches!((input, output), (Ok(input), Some(Ok(output))) if input == output)
}

/// Writes a file atomically: an existing file stays unchanged until all bytes are on disk. Devices and pipes are
/// written to directly.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    write_together(path, bytes, &[])
}

/// Writes a file and its sidecar files. All are on disk before the first is renamed into place; the main file comes
/// last, because it refers to the others.
pub fn write_together(path: &Path, bytes: &[u8], sidecars: &[NamedFile]) -> Result<(), CliError> {
    let others = sidecars.iter().map(|file| (path.with_file_name(&file.name), file.bytes.as_slice()));
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

/// An output that is not yet in place.
enum Unfinished {
    /// Temporary file, renamed into place by `put`.
    Whole { file: NamedTempFile, path: PathBuf },
    /// Device or pipe, written by `put`.
    Open(File),
}

impl Unfinished {
    fn new(path: &Path, bytes: &[u8]) -> io::Result<Self> {
        // Opened without truncation, to find out whether it is a regular file and writable.
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
        let unfinished = unfinished_for(&path)?;
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

/// Creates a temporary file in the folder of `path`.
pub fn unfinished_for(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(UNFINISHED);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The default mode of new files; the umask applies.
        builder.permissions(Permissions::from_mode(0o666));
    }
    // Only the kind: the full message would name the temporary file.
    builder.tempfile_in(folder_of(path)).map_err(|reason| reason.kind().into())
}

/// Target of a dangling link, so that writing creates the target and keeps the link.
fn followed(path: &Path) -> io::Result<PathBuf> {
    /// Linux' limit.
    const MAX_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MAX_LINKS {
        let Ok(target) = fs::read_link(&path) else { return Ok(path) };
        path = folder_of(&path).join(target);
    }
    Err(io::Error::other("too many levels of symbolic links"))
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
