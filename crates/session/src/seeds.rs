/// Sequence of seeds for random anchors; each is exactly representable as a number in JavaScript and JSON.
#[derive(Clone, Copy)]
pub(crate) struct Seeds {
    state: u64,
}

impl Seeds {
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Returns the next seed without advancing.
    pub fn peek(&self) -> u64 {
        mix(self.state.wrapping_add(STEP))
    }

    /// Returns the next seed.
    pub fn draw(&mut self) -> u64 {
        self.state = self.state.wrapping_add(STEP);
        mix(self.state)
    }
}

const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// Upper 53 bits of the output function of SplitMix64 (Steele, Lea and Flood 2014).
fn mix(state: u64) -> u64 {
    let state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (state ^ (state >> 31)) >> 11
}
