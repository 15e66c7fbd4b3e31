//! Escapes control characters before text reaches a terminal.

use std::io::{self, Write};

/// Writes a message to standard error.
pub fn note(text: &str) {
    // Messages are optional: a failed write is ignored.
    let _ = writeln!(io::stderr(), "rosto: {}", escaped(text));
}

/// Escapes control characters and bidirectional controls, so that a file name with `ESC[2J` cannot control the
/// terminal. The result is one line.
pub fn escaped(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        match character.is_control() || changes_direction(character) {
            true => shown.extend(character.escape_default()),
            false => shown.push(character),
        }
    }
    shown
}

/// Like [`escaped`], but keeps line breaks.
pub fn escaped_lines(text: &str) -> String {
    text.split('\n').map(escaped).collect::<Vec<_>>().join("\n")
}

/// Marks, embeddings, overrides and isolates of the Unicode bidirectional algorithm.
fn changes_direction(character: char) -> bool {
    matches!(character, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_stay_and_control_characters_are_escaped() {
        assert_eq!(escaped("foto de São João.jpg"), "foto de São João.jpg");
        assert_eq!(escaped("\u{1b}[2J\u{9b}1m\n\u{202e}gpj"), r"\u{1b}[2J\u{9b}1m\n\u{202e}gpj");
        assert_eq!(escaped_lines("one\ntwo\u{7}"), "one\ntwo\\u{7}");
    }
}
