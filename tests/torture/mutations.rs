//! Changes to bytes, as values: what was done can be done again, and left out one by one.

use crate::anatomy::{self, Format, Order};
use crate::json;
use crate::seeded::Seeded;

/// One change. Places are any numbers and mean a place only together with a file, so that a change can be made to what
/// other changes have left.
#[derive(Debug, Clone, PartialEq)]
pub enum Mutation {
    Flip {
        at: u64,
        bit: u8,
    },
    Set {
        at: u64,
        byte: u8,
    },
    Cut {
        at: u64,
    },
    /// A number that says how long or large something is.
    Field {
        which: u64,
        value: u64,
    },
    /// Four bytes or two or one, anywhere.
    Number {
        at: u64,
        width: usize,
        order: Order,
        value: u64,
    },
    Repeat {
        which: u64,
        before: u64,
    },
    Drop {
        which: u64,
    },
    Swap {
        which: u64,
        with: u64,
    },
    /// Bytes of another seed take the place of as many here, or come in between.
    Splice {
        seed: u64,
        from: u64,
        length: u64,
        at: u64,
        between: bool,
    },
    Fill {
        at: u64,
        length: u64,
        byte: u8,
    },
    Json(json::Change),
}

/// Files do not grow beyond this.
const MOST_BYTES: usize = 1 << 18;

impl Mutation {
    /// One of those that make sense for the format.
    pub fn random(random: &mut Seeded, format: Format) -> Self {
        let text = format == Format::Json || (matches!(format, Format::Glb | Format::Project) && random.below(4) != 0);
        if text && random.below(8) != 0 {
            return Self::Json(json::Change::random(random));
        }
        let at = random.bits();
        match random.below(14) {
            0..5 => Self::of_a_byte(random),
            5 => Self::Cut { at },
            6..9 => Self::Field { which: at, value: random.bits() },
            9 => {
                let order = [Order::Big, Order::Little][random.below(2)];
                Self::Number { at, width: [1, 2, 4][random.below(3)], order, value: random.bits() }
            }
            10 => match random.below(3) {
                0 => Self::Repeat { which: at, before: random.bits() },
                1 => Self::Drop { which: at },
                _ => Self::Swap { which: at, with: random.bits() },
            },
            11 | 12 => {
                let length = 1 + random.bits() % [4, 16, 256][random.below(3)];
                let (seed, from) = (random.bits(), random.bits());
                Self::Splice { seed, from, length, at, between: random.below(3) == 0 }
            }
            _ => Self::Fill { at, length: 1 + random.bits() % 32, byte: byte(random) },
        }
    }

    /// One that leaves everything else where it is: a file stays as it is built where that takes little of it.
    pub fn of_a_byte(random: &mut Seeded) -> Self {
        let at = random.bits();
        match random.below(5) {
            0..3 => Self::Flip { at, bit: random.below(8) as u8 },
            _ => Self::Set { at, byte: byte(random) },
        }
    }

    /// Makes the change; `seeds` are the files that bytes can be taken from.
    pub fn apply(&self, bytes: &mut Vec<u8>, format: Format, seeds: &[Vec<u8>]) {
        let place = |at: u64, count: usize| (at % count.max(1) as u64) as usize;
        let length_now = bytes.len();
        let at = |at: u64| place(at, length_now);
        match *self {
            Self::Flip { at: here, bit } => set(bytes, at(here), |byte| byte ^ 1 << bit),
            Self::Set { at: here, byte } => set(bytes, at(here), |_| byte),
            Self::Cut { at: here } => bytes.truncate(at(here)),
            Self::Field { which, value } => {
                let fields = anatomy::of(format, bytes).fields;
                let Some(&field) = fields.get(place(which, fields.len())) else { return };
                let present = field.read(bytes).unwrap_or(0);
                field.write(bytes, interesting(value, present, length_now));
            }
            Self::Number { at: here, width, order, value } => {
                let field = anatomy::Field { at: at(here), width, order };
                let present = field.read(bytes).unwrap_or(0);
                field.write(bytes, interesting(value, present, length_now));
            }
            Self::Repeat { which, before } => {
                let parts = anatomy::of(format, bytes).parts;
                let Some(part) = parts.get(place(which, parts.len())) else { return };
                let to = parts[place(before, parts.len())].start;
                if bytes.len() + part.len() <= MOST_BYTES {
                    let copy = bytes[part.clone()].to_vec();
                    bytes.splice(to..to, copy);
                }
            }
            Self::Drop { which } => {
                let parts = anatomy::of(format, bytes).parts;
                let Some(part) = parts.get(place(which, parts.len())) else { return };
                bytes.drain(part.clone());
            }
            Self::Swap { which, with } => swap(bytes, format, which, with),
            Self::Splice { seed, from, length, at: here, between } => {
                let source = &seeds[place(seed, seeds.len())];
                let start = place(from, source.len());
                let taken = &source[start..source.len().min(start + length as usize)];
                let here = at(here);
                let end = if between { here } else { bytes.len().min(here + taken.len()) };
                if bytes.len() + taken.len() <= MOST_BYTES {
                    bytes.splice(here..end, taken.iter().copied());
                }
            }
            Self::Fill { at: here, length, byte } => {
                let here = at(here);
                let end = bytes.len().min(here + length as usize);
                bytes[here..end].fill(byte);
            }
            Self::Json(change) => change_json(bytes, format, change),
        }
    }
}

fn set(bytes: &mut [u8], at: usize, change: impl Fn(u8) -> u8) {
    if let Some(byte) = bytes.get_mut(at) {
        *byte = change(*byte);
    }
}

fn swap(bytes: &mut Vec<u8>, format: Format, which: u64, with: u64) {
    let parts = anatomy::of(format, bytes).parts;
    if parts.is_empty() {
        return;
    }
    let [one, other] = [which, with].map(|which| parts[(which % parts.len() as u64) as usize].clone());
    let (first, second) = if one.start <= other.start { (one, other) } else { (other, one) };
    if first.end <= second.start {
        let between = &bytes[first.end..second.start];
        let turned = [&bytes[second.clone()], between, &bytes[first.clone()]].concat();
        bytes.splice(first.start..second.end, turned);
    }
}

/// A change to the text; in a GLB the lengths around it are put right, else nothing of it would be read.
fn change_json(bytes: &mut Vec<u8>, format: Format, change: json::Change) {
    let Some(range) = anatomy::json(format, bytes) else { return };
    let mut changed = change.apply(&bytes[range.clone()]);
    if changed.len() > MOST_BYTES {
        return;
    }
    if format == Format::Glb {
        changed.resize(changed.len().next_multiple_of(4), b' ');
        let length = changed.len() as u32;
        bytes.splice(range, changed);
        let total = bytes.len() as u32;
        bytes[8..12].copy_from_slice(&total.to_le_bytes());
        bytes[12..16].copy_from_slice(&length.to_le_bytes());
    } else {
        bytes.splice(range, changed);
    }
}

fn byte(random: &mut Seeded) -> u8 {
    const TELLING: [u8; 8] = [0, 1, 0x7F, 0x80, 0xFF, 0xFE, b'"', b'-'];
    if random.below(2) == 0 { TELLING[random.below(TELLING.len())] } else { random.bits() as u8 }
}

/// A number at which readers stumble.
fn interesting(choice: u64, present: u32, length: usize) -> u32 {
    let length = length as u32;
    let random = (choice >> 32) as u32;
    match choice % 16 {
        0 => 0,
        1 => 1,
        2 => present.wrapping_add(1),
        3 => present.wrapping_sub(1),
        4 => present.wrapping_mul(2),
        5 => length,
        6 => length.wrapping_sub(8),
        7 => u32::MAX,
        8 => u32::MAX - 7,
        9 => i32::MAX as u32,
        10 => 1 << 31,
        11 => 0xFFFF,
        12 => random % 64,
        13 => random % 1024,
        14 => random % length.max(1),
        _ => random,
    }
}
