use std::ops::RangeInclusive;

/// Range of a texture's side in px; sides are powers of two.
pub const SIDES_PX: RangeInclusive<u32> = 256..=4096;

/// Maximum number of photos.
pub const MAX_SHOTS: usize = 5;
