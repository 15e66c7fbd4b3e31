//! Changes to a file's JSON that keep it valid.

use proptest::prelude::*;
use proptest::sample::{Index, select};
use rosto_fuzz::Kind;
use serde_json::Value;

#[derive(Debug, Clone)]
pub enum Edit {
    /// Replaces a number.
    Number(Index, &'static str),
    /// Replaces any value.
    Value(Index, &'static str),
    /// Replaces the first value with a copy of the second.
    Copy(Index, Index),
    /// Repeats a value, which lengthens a list.
    Repeat(Index, usize),
}

/// Boundary numbers.
const NUMBERS: &str = "0 -0.0 1 -1 2 3 0.5 1.5 1e-320 1e-9 1e9 1e153 -1e308 1e400 255 467 468 1832 9999 2147483648 4294967295 \
                       4294967296 18446744073709551615 18446744073709551616";
const VALUES: &str =
    r#"0 null true false "" [] {} "on" "exact" "AAAA" "\ud83d\ude00\u0000" [[]] [null] {"soft":0} {"random":0}"#;

pub fn edit() -> impl Strategy<Value = Edit> {
    let one_of = |texts: &'static str| select(texts.split_whitespace().collect::<Vec<_>>());
    prop_oneof![
        6 => (any::<Index>(), one_of(NUMBERS)).prop_map(|(at, number)| Edit::Number(at, number)),
        1 => (any::<Index>(), one_of(VALUES)).prop_map(|(at, value)| Edit::Value(at, value)),
        2 => any::<(Index, Index)>().prop_map(|(at, from)| Edit::Copy(at, from)),
        1 => (any::<Index>(), select(&[2_usize, 3, 8][..])).prop_map(|(at, times)| Edit::Repeat(at, times)),
    ]
}

impl Edit {
    /// Changes nothing if the file no longer contains JSON.
    pub fn apply(&self, kind: Kind, bytes: &mut Vec<u8>) -> Option<()> {
        /// Does not occur in the seeds.
        const PLACE: &str = "placeholder of the changed value";
        let range = kind.json(bytes)?;
        let mut json: Value = serde_json::from_slice(&bytes[range.clone()]).ok()?;
        let mut values = Vec::new();
        collect(&json, String::new(), &mut values);
        let numbers: Vec<_> = values.iter().filter(|(_, value)| value.is_number()).collect();
        let chosen = |at: &Index| at.get(&values);
        let ((pointer, _), with) = match self {
            Self::Number(_, _) if numbers.is_empty() => return None,
            Self::Number(at, number) => (*at.get(&numbers), (*number).to_owned()),
            Self::Value(at, value) => (chosen(at), (*value).to_owned()),
            Self::Copy(at, from) => (chosen(at), chosen(from).1.to_string()),
            Self::Repeat(at, times) => (chosen(at), vec![chosen(at).1.to_string(); *times].join(",")),
        };
        let pointer = pointer.clone();
        *json.pointer_mut(&pointer)? = PLACE.into();
        let text = json.to_string().replacen(&format!("{PLACE:?}"), &with, 1);
        bytes.splice(range, text.into_bytes());
        Some(())
    }
}

/// Collects this value and its descendants with their JSON pointers.
fn collect<'a>(value: &'a Value, pointer: String, values: &mut Vec<(String, &'a Value)>) {
    let listed = value.as_array().into_iter().flatten().enumerate().map(|(at, value)| (at.to_string(), value));
    let named = value.as_object().into_iter().flatten().map(|(key, value)| (key.clone(), value));
    listed.chain(named).for_each(|(key, value)| collect(value, format!("{pointer}/{key}"), values));
    values.push((pointer, value));
}
