use crate::tables::LANDMARK_COUNT;

/// Landmarks of the midline, ascending.
pub const MIDLINE: [u32; 28] =
    [0, 1, 2, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 94, 151, 152, 164, 168, 175, 195, 197, 199, 200];

/// First landmark of the left side; these are the partners of the right ones, in the same order.
const FIRST_LEFT: u32 = 248;

/// Mirror partner of a landmark; a landmark of the midline is its own partner.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`].
pub fn mirror_of(landmark: u32) -> u32 {
    assert!((landmark as usize) < LANDMARK_COUNT, "landmark {landmark} of {LANDMARK_COUNT}");
    match MIDLINE.binary_search(&landmark) {
        Ok(_) => landmark,
        Err(before) if landmark < FIRST_LEFT => FIRST_LEFT + landmark - before as u32,
        Err(_) => MIDLINE.iter().fold(landmark - FIRST_LEFT, |right, &middle| right + u32::from(middle <= right)),
    }
}
