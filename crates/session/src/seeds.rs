/// Seeds for random anchors, one after the other, all from one; exact as JavaScript's and JSON's numbers.
#[derive(Clone, Copy)]
pub(crate) struct Seeds {
    state: u64,
}

impl Seeds {
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// The next one, without taking it.
    pub fn peek(&self) -> u64 {
        mixed(self.state.wrapping_add(STEP))
    }

    /// Takes the next one.
    pub fn draw(&mut self) -> u64 {
        self.state = self.state.wrapping_add(STEP);
        mixed(self.state)
    }
}

const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// SplitMix64's output function (Steele, Lea and Flood 2014), its upper 53 bits.
fn mixed(state: u64) -> u64 {
    let state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (state ^ (state >> 31)) >> 11
}
