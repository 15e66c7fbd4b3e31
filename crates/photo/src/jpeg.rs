//! Whether a JPEG file is whole.
//!
//! The decoder fills what is missing with grey and calls it a success, as browsers do; half a face is no use here.

const STUFFED_ZERO: u8 = 0x00;
const RESTART: std::ops::RangeInclusive<u8> = 0xD0..=0xD7;
const START_OF_IMAGE: u8 = 0xD8;
const END_OF_IMAGE: u8 = 0xD9;
const FILL: u8 = 0xFF;

/// Whether the end-of-image marker comes where it counts: after the scans, not inside an embedded thumbnail.
pub(crate) fn reaches_its_end(bytes: &[u8]) -> bool {
    let mut position = 0;
    while let Some((marker, after)) = next_marker(bytes, position) {
        position = match marker {
            END_OF_IMAGE => return true,
            START_OF_IMAGE => after,
            _ => match bytes.get(after..after + 2) {
                Some(length) => after + usize::from(u16::from_be_bytes([length[0], length[1]])),
                None => return false,
            },
        };
    }
    false
}

/// The next marker at or after `position` and the position behind it, past any entropy-coded data.
fn next_marker(bytes: &[u8], mut position: usize) -> Option<(u8, usize)> {
    loop {
        position += bytes.get(position..)?.iter().position(|&byte| byte == 0xFF)? + 1;
        match *bytes.get(position)? {
            FILL => {}
            STUFFED_ZERO => position += 1,
            restart if RESTART.contains(&restart) => position += 1,
            marker => return Some((marker, position + 1)),
        }
    }
}
