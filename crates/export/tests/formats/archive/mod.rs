//! Reader of zip archives, by their central directory.

/// An archive entry.
pub struct Entry {
    pub name: String,
    /// Offset of the content in the archive.
    pub start: usize,
    pub bytes: Vec<u8>,
}

impl Entry {
    pub fn text(&self) -> &str {
        std::str::from_utf8(&self.bytes).unwrap()
    }
}

/// Reads all entries, and checks the local and central headers against each other and the content.
pub fn entries(archive: &[u8]) -> Vec<Entry> {
    let end = archive.len() - 22;
    let (short, long) = (
        |at: usize| usize::from(u16::from_le_bytes(archive[at..at + 2].try_into().unwrap())),
        |at: usize| u32::from_le_bytes(archive[at..at + 4].try_into().unwrap()),
    );
    assert_eq!(&archive[end..end + 4], b"PK\x05\x06");
    let (count, mut at) = (short(end + 10), long(end + 16) as usize);
    let mut found = Vec::new();
    for _ in 0..count {
        assert_eq!(&archive[at..at + 4], b"PK\x01\x02");
        let local = long(at + 42) as usize;
        assert_eq!(&archive[local..local + 4], b"PK\x03\x04");
        // Version, flags, method, time, checksum, sizes, length of the name.
        assert_eq!(archive[at + 6..at + 30], archive[local + 4..local + 28]);
        assert_eq!((short(at + 10), short(at + 12), short(at + 14)), (0, 0, 0x21), "stored, at the beginning of 1980");
        let start = local + 30 + short(local + 26) + short(local + 28);
        let bytes = archive[start..start + long(at + 24) as usize].to_vec();
        assert_eq!((long(at + 16), long(at + 20)), (crc(&bytes), bytes.len() as u32));
        let name = std::str::from_utf8(&archive[at + 46..at + 46 + short(at + 28)]).unwrap().to_owned();
        at += 46 + name.len();
        found.push(Entry { name, start, bytes });
    }
    assert_eq!(at, end, "nothing between the directory and its end");
    found
}

/// Bitwise CRC-32, as defined by the standard.
fn crc(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for &byte in bytes {
        crc ^= u32::from(byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ if crc & 1 == 1 { 0xEDB8_8320 } else { 0 };
        }
    }
    !crc
}
