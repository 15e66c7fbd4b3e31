//! Values of options that the core crates list, with the interface's English descriptions.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Interface text by id.
static WORDS: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../../web/words/en.json")).expect("invariant: a test parses the same file")
});

/// Parses the ids of `all`. `kind` is the prefix of their keys in the interface text, such as `operator`.
pub fn one_of<T, const N: usize>(
    kind: &'static str,
    all: [T; N],
    id: fn(T) -> &'static str,
    from_id: fn(&str) -> Option<T>,
) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let values = all.map(|one| PossibleValue::new(id(one)).help(description(kind, id(one))));
    PossibleValuesParser::new(values).map(move |text| from_id(&text).expect("invariant: clap accepts only these ids"))
}

/// Returns the help text of an entry, or its label if it has none.
pub fn description(kind: &str, id: &str) -> &'static str {
    let text = |key: String| WORDS.get(&key).map(String::as_str);
    text(format!("{kind}.{id}.help")).or_else(|| text(format!("{kind}.{id}"))).unwrap_or_default()
}

/// The ids, separated by commas.
pub fn listed<T, const N: usize>(all: [T; N], id: fn(T) -> &'static str) -> String {
    all.map(id).join(", ")
}
