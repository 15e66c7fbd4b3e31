use rosto_stage::Scene;

use super::Phrase;
use super::build::{group, page_button, slot, text};
use super::widget::{GroupLook, Tone, Widget};
use crate::{OpenFace, Session};

/// The main button saves what the stage shows; the other one opens the menu.
pub(super) fn buttons(session: &Session) -> Widget {
    let label = if shows_photo(session) { "save.photo" } else { "export.glb" };
    let note = Some(Phrase::word("save.unedited")).filter(|_| !is_edited(session));
    group(
        "save",
        GroupLook::Row,
        vec![
            text("save.note", note, Tone::Help),
            page_button("save.share", "save.share").hidden(!session.files.abilities.shares_pictures),
            page_button("save.main", label),
            page_button("save.more", "save.more"),
        ],
    )
}

/// Everything that can be saved.
pub(super) fn menu(_: &Session) -> Widget {
    group(
        "save.menu",
        GroupLook::Stack,
        vec![
            page_button("download-photo-jpeg", "save.menu.photo"),
            page_button("download-pair", "save.menu.pair"),
            page_button("download-picture", "save.menu.picture"),
            slot("export.clip"),
            page_button("download-glb", "save.menu.glb"),
            page_button("open-print", "save.menu.print"),
            page_button("save-project", "save.menu.project"),
        ],
    )
}

fn shows_photo(session: &Session) -> bool {
    session.face().is_some() && session.view().scene == Scene::Picture
}

/// Whether the face or its photo differs from the one that was opened.
fn is_edited(session: &Session) -> bool {
    let is_edited =
        |face: &OpenFace| !face.document().history().entries().is_empty() || face.photo().seen_from_m().is_some();
    session.face().is_some_and(is_edited)
}
