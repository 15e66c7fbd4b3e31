//! What a terminal would take for commands, made visible.

use std::io::{self, Write};

/// Says on standard error what is worth knowing and no failure.
pub fn note(text: &str) {
    // Where nobody listens, nothing is lost that the work depends on.
    let _ = writeln!(io::stderr(), "rosto: {}", escaped(text));
}

/// One line of text without control characters and without those that turn its direction: `ESC[2J` in the name of a file
/// stays what it is.
pub fn escaped(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        match character.is_control() || turns_direction(character) {
            true => shown.extend(character.escape_default()),
            false => shown.push(character),
        }
    }
    shown
}

/// The same for text of several lines.
pub fn escaped_lines(text: &str) -> String {
    text.split('\n').map(escaped).collect::<Vec<_>>().join("\n")
}

/// Marks, embeddings, overrides and isolates of Unicode's bidirectional algorithm.
fn turns_direction(character: char) -> bool {
    matches!(character, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_stay_and_commands_show() {
        assert_eq!(escaped("foto de São João.jpg"), "foto de São João.jpg");
        assert_eq!(escaped("\u{1b}[2J\u{9b}1m\n\u{202e}gpj"), r"\u{1b}[2J\u{9b}1m\n\u{202e}gpj");
        assert_eq!(escaped_lines("one\ntwo\u{7}"), "one\ntwo\\u{7}");
    }
}
