//! Changes to valid files.

mod json;

use proptest::prelude::*;
use proptest::sample::{Index, select};
use rosto_fuzz::Kind;

#[derive(Debug, Clone)]
pub enum Edit {
    /// Replaces a range of bytes.
    Replace(Index, usize, Vec<u8>),
    /// Inserts a copy of some of the file's bytes.
    Copy(Index, usize, Index),
    Json(json::Edit),
}

pub fn edit(kind: Kind) -> impl Strategy<Value = Edit> {
    let length = || prop_oneof![1..9_usize, 1..300_usize];
    let of_json = match kind {
        Kind::Picture | Kind::Profile => 0,
        Kind::Glb | Kind::Project => 18,
        Kind::Edits => 63,
    };
    prop_oneof![
        3 => (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Edit::Replace(at, 1, vec![byte])),
        3 => (any::<Index>(), number()).prop_map(|(at, number)| Edit::Replace(at, number.len(), number)),
        1 => any::<Index>().prop_map(|at| Edit::Replace(at, usize::MAX, vec![])),
        1 => (any::<Index>(), length()).prop_map(|(at, length)| Edit::Replace(at, length, vec![])),
        1 => (any::<Index>(), length(), any::<Index>()).prop_map(|(at, length, from)| Edit::Copy(at, length, from)),
        of_json => json::edit().prop_map(Edit::Json),
    ]
}

/// A boundary number as bytes, in either byte order.
fn number() -> impl Strategy<Value = Vec<u8>> {
    const NUMBERS: [u32; 14] =
        [0, 1, 2, 63, 0x7F, 0x80, 0xFF, 0x100, 0x7FFF, 0xFFFF, 1 << 16, 1 << 24, 1 << 31, i32::MAX as u32];
    let number = prop_oneof![select(&NUMBERS[..]), (0..9_u32).prop_map(|less| u32::MAX - less), 0..1024_u32];
    (number, select(&[1_usize, 2, 4][..]), any::<bool>()).prop_map(|(number, width, is_little)| match is_little {
        true => number.to_le_bytes()[..width].to_vec(),
        false => number.to_be_bytes()[4 - width..].to_vec(),
    })
}

impl Edit {
    pub fn apply(&self, kind: Kind, bytes: &mut Vec<u8>) {
        let length = bytes.len();
        let place = |at: &Index| at.index(length.max(1));
        let range = |at: &Index, count: usize| place(at)..place(at).saturating_add(count).min(length);
        match self {
            Self::Replace(at, count, with) => drop(bytes.splice(range(at, *count), with.iter().copied())),
            Self::Copy(at, count, from) => {
                let copy = bytes[range(from, *count)].to_vec();
                bytes.splice(place(at)..place(at), copy);
            }
            Self::Json(edit) => edit.apply(kind, bytes).unwrap_or(()),
        }
    }
}
