//! Values of the command line that a table of the core lists, each explained by the page's English words.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// The page's words: whatever the core has an id for is explained there, once.
static WORDS: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    serde_json::from_str(include_str!("../../../web/words/en.json")).expect("invariant: a test reads the words, too")
});

/// Takes the ids of a table's entries; `kind` is what the words call the table, such as `operator`.
pub fn one_of<T, const N: usize>(
    kind: &'static str,
    all: [T; N],
    id: fn(T) -> &'static str,
    from_id: fn(&str) -> Option<T>,
) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let values = all.map(|one| PossibleValue::new(id(one)).help(explained(kind, id(one))));
    PossibleValuesParser::new(values).map(move |text| from_id(&text).expect("invariant: clap lets only ids pass"))
}

/// What the words say of an entry: how it is explained or, failing that, what it is called.
pub fn explained(kind: &str, id: &str) -> &'static str {
    let said = |key: String| WORDS.get(&key).map(String::as_str);
    said(format!("{kind}.{id}.help")).or_else(|| said(format!("{kind}.{id}"))).unwrap_or_default()
}

/// The ids, with commas between them.
pub fn listed<T, const N: usize>(all: [T; N], id: fn(T) -> &'static str) -> String {
    all.map(id).join(", ")
}
