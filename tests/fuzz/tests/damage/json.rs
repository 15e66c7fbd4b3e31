//! Changes to the JSON in a file that leave it JSON.

use proptest::prelude::*;
use proptest::sample::{Index, select};
use rosto_fuzz::Kind;
use serde_json::Value;

/// A value, and what takes its place.
#[derive(Debug, Clone)]
pub struct Edit(Index, With);

#[derive(Debug, Clone)]
enum With {
    Text(&'static str),
    Copy(Index),
    /// In a list, several values for one.
    Repeated(usize),
}

/// At which readers of numbers, lists and choices stumble.
const TEXTS: &str = r#"0 -0.0 1 -1 2 3 0.5 1.5 1e-320 1e9 1e153 -1e308 1e400 255 467 468 1832 9999 4294967295 4294967296
    18446744073709551615 18446744073709551616 null true false "" [] {} "on" "exact" "AAAA" "\ud83d\ude00\u0000" [[]] [null]
    {"soft":0} {"random":0}"#;

pub fn edit() -> impl Strategy<Value = Edit> {
    let with = prop_oneof![
        6 => select(TEXTS.split_whitespace().collect::<Vec<_>>()).prop_map(With::Text),
        3 => any::<Index>().prop_map(With::Copy),
        1 => select(&[2_usize, 3, 8][..]).prop_map(With::Repeated),
    ];
    (any::<Index>(), with).prop_map(|(at, with)| Edit(at, with))
}

impl Edit {
    /// Changes nothing where the file holds no JSON any more.
    pub fn apply(&self, kind: Kind, bytes: &mut Vec<u8>) -> Option<()> {
        /// No seed has this text.
        const PLACE: &str = "the place that changes";
        let range = kind.json(bytes)?;
        let mut json: Value = serde_json::from_slice(&bytes[range.clone()]).ok()?;
        let mut pointers = Vec::new();
        collect(&json, String::new(), &mut pointers);
        let value = |at: &Index| json.pointer(at.get::<String>(&pointers)).map(Value::to_string);
        let with = match &self.1 {
            With::Text(text) => (*text).to_owned(),
            With::Copy(from) => value(from)?,
            With::Repeated(times) => vec![value(&self.0)?; *times].join(","),
        };
        *json.pointer_mut(self.0.get::<String>(&pointers))? = PLACE.into();
        let text = json.to_string().replacen(&format!("{PLACE:?}"), &with, 1);
        bytes.splice(range, text.into_bytes());
        Some(())
    }
}

/// Adds the pointers to this value and all within it.
fn collect(value: &Value, pointer: String, pointers: &mut Vec<String>) {
    match value {
        Value::Array(values) => {
            values.iter().enumerate().for_each(|(at, value)| collect(value, format!("{pointer}/{at}"), pointers))
        }
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| collect(value, format!("{pointer}/{key}"), pointers))
        }
        _ => {}
    }
    pointers.push(pointer);
}
