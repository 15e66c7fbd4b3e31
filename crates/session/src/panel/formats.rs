use rosto_export::Format;

use super::build::{group, page_button, text};
use super::widget::{GroupLook, Tone, Widget};
use super::{Part, Phrase};

/// A download button for each listed format.
pub(super) fn formats(id: &'static str, is_listed: fn(Format) -> bool) -> Widget {
    let button = |format: Format| {
        let name = Phrase::verbatim(format.id().to_ascii_uppercase());
        page_button(format!("download-{}", format.id()), name)
    };
    group(id, GroupLook::Row, Format::ALL.into_iter().filter(|&format| is_listed(format)).map(button).collect())
}

/// Contents of the formats, one sentence each.
pub(super) fn formats_help(id: &'static str, is_listed: fn(Format) -> bool) -> Widget {
    let texts = Format::ALL.into_iter().filter(|&format| is_listed(format));
    let texts: Vec<Phrase> = texts.map(|format| Phrase::word(format!("format.{}.help", format.id()))).collect();
    let joined = texts.into_iter().reduce(|before, next| {
        Phrase::word("sentences").with("before", Part::Phrase(before)).with("next", Part::Phrase(next))
    });
    text(id, joined, Tone::Help)
}
