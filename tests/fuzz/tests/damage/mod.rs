//! Valid files with a few changes.

mod json;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use rosto_fuzz::Kind;

/// What is done to which seed.
#[derive(Debug, Clone)]
pub struct Damage {
    seed: Index,
    edits: Vec<Edit>,
    is_repaired: bool,
}

#[derive(Debug, Clone)]
enum Edit {
    /// Overwrites bytes.
    Set(Index, Vec<u8>),
    Cut(Index),
    Remove(Index, usize),
    /// Inserts a copy of bytes of this file.
    Copy(Index, usize, Index),
    Json(json::Edit),
}

/// Up to four changes, after which checksums and lengths are mostly put right.
pub fn damage(kind: Kind) -> impl Strategy<Value = Damage> {
    (any::<Index>(), vec(edit(kind), 1..=4), prop::bool::weighted(0.75)).prop_map(|(seed, edits, is_repaired)| Damage {
        seed,
        edits,
        is_repaired,
    })
}

fn edit(kind: Kind) -> impl Strategy<Value = Edit> {
    let length = || prop_oneof![1..9_usize, 1..300_usize];
    let of_json = match kind {
        Kind::Picture | Kind::Profile => 0,
        Kind::Glb | Kind::Project => 18,
        Kind::Edits => 63,
    };
    prop_oneof![
        3 => (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Edit::Set(at, vec![byte])),
        3 => (any::<Index>(), number()).prop_map(|(at, number)| Edit::Set(at, number)),
        1 => any::<Index>().prop_map(Edit::Cut),
        1 => (any::<Index>(), length()).prop_map(|(at, length)| Edit::Remove(at, length)),
        1 => (any::<Index>(), length(), any::<Index>()).prop_map(|(at, length, from)| Edit::Copy(at, length, from)),
        of_json => json::edit().prop_map(Edit::Json),
    ]
}

/// A number at which readers stumble, as it is written in files.
fn number() -> impl Strategy<Value = Vec<u8>> {
    const NUMBERS: [u32; 14] =
        [0, 1, 2, 63, 0x7F, 0x80, 0xFF, 0x100, 0x7FFF, 0xFFFF, 1 << 16, 1 << 24, 1 << 31, i32::MAX as u32];
    let number = prop_oneof![select(&NUMBERS[..]), (0..9_u32).prop_map(|less| u32::MAX - less), 0..1024_u32];
    (number, select(&[1_usize, 2, 4][..]), any::<bool>()).prop_map(|(number, width, is_little)| match is_little {
        true => number.to_le_bytes()[..width].to_vec(),
        false => number.to_be_bytes()[4 - width..].to_vec(),
    })
}

impl Damage {
    pub fn apply(&self, kind: Kind, seeds: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = self.seed.get(seeds).clone();
        for edit in &self.edits {
            edit.apply(kind, &mut bytes);
        }
        if self.is_repaired { kind.repaired(bytes) } else { bytes }
    }
}

impl Edit {
    fn apply(&self, kind: Kind, bytes: &mut Vec<u8>) {
        let length = bytes.len();
        let place = |at: &Index| at.index(length.max(1));
        let range = |at: &Index, count: usize| place(at)..length.min(place(at) + count);
        match self {
            Self::Set(at, with) => {
                let range = range(at, with.len());
                bytes[range.clone()].copy_from_slice(&with[..range.len()]);
            }
            Self::Cut(at) => bytes.truncate(place(at)),
            Self::Remove(at, count) => drop(bytes.drain(range(at, *count))),
            Self::Copy(at, count, from) => {
                let copy = bytes[range(from, *count)].to_vec();
                bytes.splice(place(at)..place(at), copy);
            }
            Self::Json(edit) => edit.apply(kind, bytes).unwrap_or(()),
        }
    }
}
