use crate::tables::MIRROR;

/// The landmark on the other side of the face; a landmark of the midline is its own.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn mirror_of(landmark: u32) -> u32 {
    u32::from(MIRROR[landmark as usize])
}

/// The 28 landmarks of the midline, ascending.
pub fn midline() -> Vec<u32> {
    landmarks().filter(|&landmark| mirror_of(landmark) == landmark).collect()
}

/// The 220 pairs off the midline as `[right, left]` of the subject, by ascending right landmark.
pub fn mirror_pairs() -> Vec<[u32; 2]> {
    landmarks().map(|right| [right, mirror_of(right)]).filter(|[right, left]| right < left).collect()
}

fn landmarks() -> std::ops::Range<u32> {
    0..MIRROR.len() as u32
}
