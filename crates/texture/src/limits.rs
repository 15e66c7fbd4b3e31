use std::ops::RangeInclusive;

/// How long a texture's side can be, in px: its powers of two.
pub const SIDES_PX: RangeInclusive<u32> = 256..=4096;

/// How many photos a texture can be made of.
pub const MOST_SHOTS: usize = 5;
