//! Changes to JSON text that mostly leave it JSON.

use std::ops::Range;

use crate::seeded::Seeded;

/// One change; the numbers choose among what the text holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// A number becomes a telling one.
    Number { which: u64, with: usize },
    /// A value of any kind becomes another kind's.
    Value { which: u64, with: usize },
    /// A value takes the place of another.
    Copy { which: u64, from: u64 },
    /// A value comes several times, which in a list makes it longer.
    Repeat { which: u64, times: usize },
    /// A key gets the name of another.
    Key { which: u64, from: u64 },
    /// One digit of a number changes.
    Digit { which: u64, at: u64, digit: u8 },
}

const NUMBERS: [&str; 29] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "3",
    "4",
    "0.5",
    "1.5",
    "1e-320",
    "1e-9",
    "1e9",
    "1e30",
    "1e153",
    "1e300",
    "-1e308",
    "1.7976931348623157e308",
    "1e400",
    "255",
    "467",
    "468",
    "1832",
    "9999",
    "65536",
    "2147483648",
    "4294967295",
    "4294967296",
    "18446744073709551615",
    "18446744073709551616",
];

const VALUES: [&str; 14] = [
    "null",
    "true",
    "false",
    "\"\"",
    "[]",
    "{}",
    "\"on\"",
    "\"exact\"",
    "\"AAAA\"",
    "\"\\ud83d\\ude00\\u0000\"",
    "[[]]",
    "[null]",
    "{\"soft\":0}",
    "{\"random\":0}",
];

impl Change {
    pub fn random(random: &mut Seeded) -> Self {
        let which = random.bits();
        match random.below(10) {
            0..3 => Self::Number { which, with: random.below(NUMBERS.len()) },
            3 => Self::Value { which, with: random.below(VALUES.len()) },
            4 | 5 => Self::Copy { which, from: random.bits() },
            6 => Self::Repeat { which, times: [1, 2, 7][random.below(3)] },
            7 => Self::Key { which, from: random.bits() },
            _ => Self::Digit { which, at: random.bits(), digit: b'0' + random.below(10) as u8 },
        }
    }

    /// The text with the change made; as it was if it holds nothing of the kind.
    pub fn apply(self, text: &[u8]) -> Vec<u8> {
        let found = Found::in_text(text);
        let all = |range: &Range<usize>| text[range.clone()].to_vec();
        let replaced = match self {
            Self::Number { which, with } => {
                choose(&found.numbers, which).map(|at| (at.clone(), NUMBERS[with].as_bytes().to_vec()))
            }
            Self::Value { which, with } => {
                choose(&found.values, which).map(|at| (at.clone(), VALUES[with].as_bytes().to_vec()))
            }
            Self::Copy { which, from } => {
                choose(&found.values, which).zip(choose(&found.values, from)).map(|(at, from)| (at.clone(), all(from)))
            }
            Self::Repeat { which, times } => choose(&found.values, which)
                .map(|at| (at.clone(), vec![text[at.clone()].to_vec(); 1 + times].join(&b','))),
            Self::Key { which, from } => {
                choose(&found.keys, which).zip(choose(&found.keys, from)).map(|(at, from)| (at.clone(), all(from)))
            }
            Self::Digit { which, at, digit } => choose(&found.numbers, which).map(|number| {
                let mut changed = all(number);
                let at = (at % changed.len() as u64) as usize;
                changed[at] = digit;
                (number.clone(), changed)
            }),
        };
        let Some((range, with)) = replaced else { return text.to_vec() };
        [&text[..range.start], &with, &text[range.end..]].concat()
    }
}

fn choose(ranges: &[Range<usize>], which: u64) -> Option<&Range<usize>> {
    ranges.get((which % ranges.len().max(1) as u64) as usize)
}

/// What stands where in text that is JSON, or was before it was changed.
#[derive(Debug, Default, PartialEq)]
struct Found {
    /// Values of every kind, numbers too.
    values: Vec<Range<usize>>,
    numbers: Vec<Range<usize>>,
    keys: Vec<Range<usize>>,
}

impl Found {
    fn in_text(text: &[u8]) -> Self {
        let mut found = Self::default();
        let mut open = Vec::new();
        let mut at = 0;
        while let Some(&byte) = text.get(at) {
            let start = at;
            match byte {
                b'"' => {
                    at = end_of_string(text, at);
                    let is_key = text.get(at) == Some(&b':');
                    if is_key { &mut found.keys } else { &mut found.values }.push(start..at);
                    continue;
                }
                b'[' | b'{' => open.push(at),
                b']' | b'}' => found.values.extend(open.pop().map(|start| start..at + 1)),
                b'-' | b'0'..=b'9' | b'a'..=b'z' => {
                    at = text[at..].iter().position(|&byte| is_end(byte)).map_or(text.len(), |length| at + length);
                    found.values.push(start..at);
                    if !byte.is_ascii_lowercase() {
                        found.numbers.push(start..at);
                    }
                    continue;
                }
                _ => {}
            }
            at += 1;
        }
        found
    }
}

fn is_end(byte: u8) -> bool {
    !(byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'+' | b'.'))
}

fn end_of_string(text: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while let Some(&byte) = text.get(at) {
        at += if byte == b'\\' { 2 } else { 1 };
        if byte == b'"' {
            break;
        }
    }
    at.min(text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &[u8] = br#"{"a":[1,-2.5e3],"b":{"c":"x\"y"},"d":null}"#;

    fn text(ranges: &[Range<usize>]) -> Vec<String> {
        ranges.iter().map(|range| String::from_utf8(TEXT[range.clone()].to_vec()).unwrap()).collect()
    }

    #[test]
    fn keys_numbers_and_values_are_told_apart() {
        let found = Found::in_text(TEXT);
        assert_eq!(text(&found.keys), ["\"a\"", "\"b\"", "\"c\"", "\"d\""]);
        assert_eq!(text(&found.numbers), ["1", "-2.5e3"]);
        let values = text(&found.values);
        assert_eq!(values[..5], ["1", "-2.5e3", "[1,-2.5e3]", r#""x\"y""#, r#"{"c":"x\"y"}"#]);
        assert_eq!(values.last().unwrap().as_bytes(), TEXT);
    }

    #[test]
    fn a_changed_number_leaves_the_rest_alone() {
        let changed = Change::Number { which: 1, with: 18 }.apply(TEXT);
        assert_eq!(changed, br#"{"a":[1,255],"b":{"c":"x\"y"},"d":null}"#);
        assert_eq!(Change::Number { which: 0, with: 0 }.apply(b"[]"), b"[]");
    }
}
