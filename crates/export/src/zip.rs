//! Uncompressed, deterministic zip archives.

/// A named file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedFile {
    /// Name, with a relative path if it is in a folder.
    pub name: String,
    /// Content.
    pub bytes: Vec<u8>,
}

impl NamedFile {
    /// Creates a named file.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), bytes: bytes.into() }
    }
}

const LOCAL_HEADER: u32 = 0x0403_4B50;
const CENTRAL_HEADER: u32 = 0x0201_4B50;
const END_OF_DIRECTORY: u32 = 0x0605_4B50;
const LOCAL_HEADER_BYTES: usize = 30;

/// Zip version required to extract stored entries.
const VERSION: u16 = 10;

/// Flag for UTF-8 names.
const UTF_8: u16 = 1 << 11;

/// 1 January 1980, the earliest date in the format. The real date is omitted, so that archives are reproducible.
const DATE: u16 = (1 << 5) | 1;

/// Id of the extra field used as padding.
const PADDING_ID: u16 = 0x1986;
const PADDING_HEADER_BYTES: usize = 4;

/// Builds an archive whose files start at multiples of `alignment` bytes: 1 for no alignment, 64 for USDZ.
pub(crate) fn stored(files: &[NamedFile], alignment: usize) -> Vec<u8> {
    let mut archive = Vec::new();
    let mut directory = Vec::new();
    for file in files {
        let at = archive.len();
        let padding = padding(at + LOCAL_HEADER_BYTES + file.name.len(), alignment);
        archive.extend(LOCAL_HEADER.to_le_bytes());
        archive.extend(header_fields(file, padding.len()));
        archive.extend_from_slice(file.name.as_bytes());
        archive.extend(padding);
        archive.extend_from_slice(&file.bytes);

        directory.extend(CENTRAL_HEADER.to_le_bytes());
        directory.extend(VERSION.to_le_bytes());
        directory.extend(header_fields(file, 0));
        // No comment, the first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend((at as u32).to_le_bytes());
        directory.extend_from_slice(file.name.as_bytes());
    }
    let (start, length, count) = (archive.len() as u32, directory.len() as u32, files.len() as u16);
    archive.extend(directory);
    archive.extend(END_OF_DIRECTORY.to_le_bytes());
    archive.extend([0; 4]);
    archive.extend([count, count].into_iter().flat_map(u16::to_le_bytes));
    archive.extend([length, start].into_iter().flat_map(u32::to_le_bytes));
    archive.extend([0; 2]);
    archive
}

/// Fields shared by the local and central header, from the version to the length of the extra field.
fn header_fields(file: &NamedFile, extra_bytes: usize) -> Vec<u8> {
    const STORED: u16 = 0;
    const TIME: u16 = 0;
    let size = file.bytes.len() as u32;
    let before = [VERSION, UTF_8, STORED, TIME, DATE].into_iter().flat_map(u16::to_le_bytes);
    let sizes = [crc32fast::hash(&file.bytes), size, size].into_iter().flat_map(u32::to_le_bytes);
    let after = [file.name.len() as u16, extra_bytes as u16].into_iter().flat_map(u16::to_le_bytes);
    before.chain(sizes).chain(after).collect()
}

/// Extra field that pads an archive from `at` to a multiple of `alignment`.
fn padding(at: usize, alignment: usize) -> Vec<u8> {
    if at.is_multiple_of(alignment) {
        return Vec::new();
    }
    let filled = (at + PADDING_HEADER_BYTES).next_multiple_of(alignment) - at;
    let mut field = vec![0; filled];
    field[..2].copy_from_slice(&PADDING_ID.to_le_bytes());
    field[2..4].copy_from_slice(&((filled - PADDING_HEADER_BYTES) as u16).to_le_bytes());
    field
}
