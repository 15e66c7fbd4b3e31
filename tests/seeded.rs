//! Reproducible random test data.

#![allow(dead_code, reason = "each test uses a part of it")]

use glam::{DQuat, DVec3};

/// SplitMix64 (Steele, Lea and Flood).
pub struct Seeded(u64);

impl Seeded {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }

    pub fn below(&mut self, limit: usize) -> usize {
        (self.bits() % limit as u64) as usize
    }

    /// Uniform in −1 to 1.
    pub fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }

    pub fn rotation(&mut self) -> DQuat {
        DQuat::from_axis_angle(self.vector().normalize_or(DVec3::Z), 3.0 * self.signed())
    }

    /// `count` distinct vertices.
    pub fn vertices(&mut self, count: usize, vertex_count: usize) -> Vec<u32> {
        let mut all: Vec<u32> = (0..vertex_count as u32).collect();
        (0..count).map(|_| all.swap_remove(self.below(all.len()))).collect()
    }
}
