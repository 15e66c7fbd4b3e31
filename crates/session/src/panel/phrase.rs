use std::borrow::Cow;

use serde::Serialize;
use tsify::Tsify;

/// A text: the key of a word, and values for its placeholders. The page has the words.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct Phrase {
    /// Key of the word, such as "landmark.nose-tip".
    #[tsify(type = "string")]
    pub key: Cow<'static, str>,
    /// Values by placeholder.
    pub values: Vec<(&'static str, Part)>,
}

/// Value of a placeholder.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(untagged)]
pub enum Part {
    /// Text that is the same in all languages.
    Text(String),
    /// A number, and its number of decimals.
    Number(f64, u8),
    /// Another phrase.
    Phrase(Phrase),
}

impl Phrase {
    /// A word without placeholders.
    pub fn word(key: impl Into<Cow<'static, str>>) -> Self {
        Self { key: key.into(), values: Vec::new() }
    }

    /// A text that is the same in all languages.
    pub fn verbatim(text: impl Into<String>) -> Self {
        Self::word("verbatim").with("text", text.into())
    }

    /// Sets the value of a placeholder.
    pub fn with(mut self, name: &'static str, value: impl Into<Part>) -> Self {
        self.values.push((name, value.into()));
        self
    }

    /// Sets a placeholder to a number.
    pub fn number(self, name: &'static str, value: f64, decimals: u8) -> Self {
        self.with(name, Part::Number(value, decimals))
    }
}

impl From<&'static str> for Phrase {
    fn from(key: &'static str) -> Self {
        Self::word(key)
    }
}

impl From<String> for Part {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<Phrase> for Part {
    fn from(phrase: Phrase) -> Self {
        Self::Phrase(phrase)
    }
}

impl From<usize> for Part {
    fn from(count: usize) -> Self {
        Self::Number(count as f64, 0)
    }
}
