use rosto_face::Region;
use rosto_laplacian::LaplacianError;
use rosto_studio::{Mirror, StudioError};

use super::Phrase;
use super::build::{button, check, choice, group, help, slider, slot, text};
use super::widget::{ChoiceLook, Control, GroupLook, Tone, Widget};
use crate::edit_options::{RADIUS_MM, SLIDER_MM};
use crate::message::value::switched;
use crate::{Choice, Intent, OpenFace, Selection, SelectionMode, Session};

/// Selecting a part of the face and moving it.
pub(super) fn section(session: &Session) -> Widget {
    let mode = session.mode();
    group(
        "section.landmark",
        GroupLook::Section,
        vec![
            session.setting("selection", Choice::SelectionMode, ChoiceLook::Segments),
            region(session).hidden(mode != SelectionMode::Region),
            slot("landmark.search").hidden(mode == SelectionMode::Region),
            session
                .setting("point.density", Choice::Density, ChoiceLook::List)
                .labelled("density".into())
                .hidden(mode != SelectionMode::Point)
                .expert(),
            group("landmark.offset", GroupLook::Lines, offsets(session)).enabled(can_move(session)),
            explanation(session),
            depth(session),
            session.setting("preset", Choice::Preset, ChoiceLook::Segments).expert(),
            group("landmark.more", GroupLook::Fold, options(session)),
        ],
    )
    .on("shape")
    .open()
}

fn options(session: &Session) -> Vec<Widget> {
    vec![
        mirror(session),
        help("edit.mirror.none").hidden(can_mirror(session)),
        check("edit.nearby", session.edit_options().is_nearby, |on| Intent::Nearby(switched(on))),
        radius(session),
        pin(session),
    ]
}

fn region(session: &Session) -> Widget {
    let chosen = match session.face().and_then(OpenFace::selection) {
        Some(Selection::Region(region)) => Some(region.id().to_owned()),
        _ => None,
    };
    let options = Region::ALL.iter().map(|region| region.id().to_owned()).collect();
    let look = ChoiceLook::List;
    choice("region", Control::Choice { name: "region", options, expert: &[], chosen, look }, |id| {
        Some(Intent::Select(Some(Selection::Region(Region::from_id(&id)?))))
    })
}

fn explanation(session: &Session) -> Widget {
    let face = session.face();
    if let Some(refusal) = face.and_then(OpenFace::refusal) {
        let is_unanchored = matches!(refusal, StudioError::Laplacian(LaplacianError::Unanchored { .. }));
        let key = if is_unanchored { "refusal.unanchored" } else { "refusal.other" };
        return text("landmark.help", Some(Phrase::word(key)), Tone::Error);
    }
    let lies_in_plane = face.is_some_and(|face| face.lies_in_plane(session.edit_options()));
    text("landmark.help", lies_in_plane.then(|| Phrase::word("landmark.in-plane")), Tone::Help)
}

fn can_move(session: &Session) -> bool {
    session.face().is_some_and(|face| face.selection().is_some() && face.refusal().is_none())
}

fn offsets(session: &Session) -> Vec<Widget> {
    let offset_mm = session.face().map(OpenFace::offset_mm).unwrap_or_default();
    let axis = |id, axis: usize| {
        let set = move |to_mm| {
            let mut moved_mm = offset_mm;
            moved_mm[axis] = to_mm;
            Intent::Offset(moved_mm)
        };
        slider(id, SLIDER_MM, "mm", offset_mm[axis], set).along(["x", "y", "z"][axis])
    };
    vec![axis("landmark.x", 0), axis("landmark.y", 1), axis("landmark.z", 2)]
}

/// Shown while the edit points along the view and is hardly visible.
fn depth(session: &Session) -> Widget {
    let along = text("depth.along", Some(Phrase::word("depth.along")), Tone::Status);
    group("depth", GroupLook::Row, vec![along, button("depth.show", Intent::ShowDepth)])
        .hidden(!session.is_along_view())
}

fn can_mirror(session: &Session) -> bool {
    session.face().is_none_or(OpenFace::can_mirror)
}

fn mirror(session: &Session) -> Widget {
    let is_on = session.edit_options().mirror == Mirror::On;
    check("edit.mirror", is_on, |on| Intent::Mirror(switched(on))).enabled(can_mirror(session))
}

fn radius(session: &Session) -> Widget {
    let options = session.edit_options();
    slider("edit.radius", RADIUS_MM, "mm", options.radius_mm, Intent::Radius).hidden(!options.is_nearby)
}

fn pin(session: &Session) -> Widget {
    let face = session.face();
    let pin = check("edit.pin", face.is_some_and(OpenFace::is_pinned), |on| Intent::Pin(switched(on))).expert();
    pin.noted("edit.pin.how").enabled(face.is_some_and(|face| face.selection().is_some()))
}

/// Speech after a commit of an offset.
pub(crate) fn moved(session: &Session, face: &OpenFace) -> Option<Phrase> {
    let name = session.name_of(face.selection()?.target());
    let offset_mm = face.offset_mm();
    let moved = Phrase::word("landmark.moved").with("name", name);
    Some(moved.number("x", offset_mm.x, 1).number("y", offset_mm.y, 1).number("z", offset_mm.z, 1))
}

/// Vertices that stay in place while the selection moves.
pub(super) fn anchors(session: &Session) -> Widget {
    const NAMED: usize = 6;
    let face = session.face().filter(|face| face.selection().is_some());
    let anchors = face.map_or(&[][..], |face| face.document().anchors());
    let phrase = match anchors.len() {
        0 => None,
        count if count > NAMED => Some(Phrase::word("landmark.anchors.many").with("n", count)),
        _ => {
            let numbers: Vec<String> = anchors.iter().map(u32::to_string).collect();
            Some(Phrase::word("landmark.anchors").with("list", numbers.join(", ")))
        }
    };
    text("landmark.anchors", phrase, Tone::Help)
}
