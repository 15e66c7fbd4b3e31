//! Repairs lengths and checksums after damage, so that readers do not stop at the first check.

use std::ops::Range;

use crate::Kind;

const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

impl Kind {
    /// Repairs the checksums of PNGs and the lengths around the JSON of GLBs.
    pub fn repaired(self, mut bytes: Vec<u8>) -> Vec<u8> {
        match self {
            Self::Picture | Self::Project => checksums(&mut bytes),
            Self::Glb => lengths(&mut bytes),
            Self::Profile | Self::Edits => None,
        };
        bytes
    }

    /// Range of the JSON in a file that contains some.
    pub fn json(self, bytes: &[u8]) -> Option<Range<usize>> {
        let json = match self {
            Self::Glb => 20..find(bytes, b"BIN\0")?.checked_sub(4)?,
            Self::Project => 0..find(bytes, b"\n")?,
            Self::Edits => 0..bytes.len(),
            Self::Picture | Self::Profile => return None,
        };
        (json.start <= json.end).then_some(json)
    }
}

/// Repairs the chunks of a PNG anywhere in the file, up to the first that exceeds the file.
fn checksums(bytes: &mut [u8]) -> Option<()> {
    let mut at = find(bytes, PNG_SIGNATURE)? + PNG_SIGNATURE.len();
    loop {
        let length = u32::from_be_bytes(*bytes.get(at..)?.first_chunk()?) as usize;
        let end = at + 8 + length;
        let sum = crc32fast::hash(bytes.get(at + 4..end)?);
        bytes.get_mut(end..end + 4)?.copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}

/// Repairs the lengths of a GLB and of its JSON chunk.
fn lengths(bytes: &mut Vec<u8>) -> Option<()> {
    let json = Kind::Glb.json(bytes)?;
    let padding = json.len().next_multiple_of(4) - json.len();
    bytes.splice(json.end..json.end, vec![b' '; padding]);
    let (total, json) = (bytes.len() as u32, (json.len() + padding) as u32);
    bytes[8..16].copy_from_slice([total.to_le_bytes(), json.to_le_bytes()].as_flattened());
    Some(())
}

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|window| window == what)
}
