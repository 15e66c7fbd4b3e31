use rosto::{EditsAs, ExpressionsAs, FileOptions};
use rosto_export::{BaseColour, ExportOption, Eyes, Format, Material};
use rosto_mesh::Named;

use super::build::{check, choice, group, help, page_button, slot, text};
use super::formats::{formats, formats_help};
use super::name::word;
use super::widget::{ChoiceLook, Control, GroupLook, Tone, Widget};
use super::{Phrase, print};
use crate::files::{File, Outcome};
use crate::{Choice, Intent, Session};

/// Files and pictures of the face.
pub(super) fn section(session: &Session) -> Widget {
    let others = [print::fold(session), making(session), photo(session), other_formats(session)]
        .into_iter()
        .chain(pictures(session));
    let widgets = glb(session).into_iter().chain(others).collect();
    group("section.export", GroupLook::Plain, widgets).on("export")
}

/// The GLB: its options, name, size and verdict.
fn glb(session: &Session) -> Vec<Widget> {
    let now = session.files.options;
    let actions = vec![
        page_button("check-glb", "export.check"),
        page_button("share-glb", "export.share").hidden(!session.files.abilities.shares_models),
    ];
    let shape_or_targets = [ExpressionsAs::Shape, ExpressionsAs::MorphTargets];
    vec![
        option("base-colour", now, |options| &mut options.base_colour),
        session.setting("texture-size", Choice::TextureSize, ChoiceLook::List),
        session.setting("export.density", Choice::Density, ChoiceLook::List).labelled("density".into()).expert(),
        switch("export.unlit", now, |options| &mut options.material, [Material::Lit, Material::Unlit]),
        switch("export.morphs", now, |options| &mut options.edits, [EditsAs::Shape, EditsAs::MorphTargets]),
        switch("export.expressions", now, |options| &mut options.expressions, shape_or_targets),
        switch("export.eyes", now, |options| &mut options.eyes, [Eyes::Skin, Eyes::Pieces]),
        facts(session),
        group("export.glb", GroupLook::Row, actions),
        verdict(session),
        slot("export.ar"),
        help("export.scale"),
    ]
}

/// The place of an option.
type Field<T> = fn(&mut FileOptions) -> &mut T;

fn set<T>(mut options: FileOptions, field: Field<T>, value: T) -> Intent {
    *field(&mut options) = value;
    Intent::FileOptions(options)
}

/// A choice between the values of an option.
fn option<T: Named + 'static>(id: &'static str, mut now: FileOptions, field: Field<T>) -> Widget {
    let options = T::ALL.iter().map(|value| value.id().to_owned()).collect();
    let chosen = Some(field(&mut now).id().to_owned());
    let control = Control::Choice { name: id, options, expert: &[], chosen, look: ChoiceLook::Segments };
    choice(id, control, move |id| Some(set(now, field, T::from_id(&id)?)))
}

/// A switch between two values of an option.
fn switch<T>(id: &'static str, mut now: FileOptions, field: Field<T>, [off, on]: [T; 2]) -> Widget
where
    T: Copy + PartialEq + 'static,
{
    let is_on = *field(&mut now) == on;
    check(id, is_on, move |is_on| set(now, field, if is_on { on } else { off })).expert()
}

/// Name, size and content of the GLB.
fn facts(session: &Session) -> Widget {
    let size = match session.files.file {
        File::Made { bytes, .. } => size(bytes),
        _ => Phrase::verbatim(""),
    };
    let name = Phrase::verbatim(session.file_name(Format::Glb.id()));
    let [points, triangles] =
        session.face().map(|face| face.mesh_counts(session.files.options.has_pieces(Format::Glb))).unwrap_or_default();
    let holds = Phrase::word("export.holds").with("format", "GLB".to_owned()).with("points", points);
    let holds = holds.with("triangles", triangles).with("paint", paint(session));
    group(
        "export.facts",
        GroupLook::Stack,
        vec![
            Widget::new("export.file", Control::Facts { rows: vec![(name, size)] }),
            text("export.holds", Some(holds), Tone::Help),
        ],
    )
}

fn size(bytes: f64) -> Phrase {
    match bytes < 1e6 {
        true => Phrase::word("amount.kb").number("n", bytes / 1e3, 0),
        false => Phrase::word("amount.mb").number("n", bytes / 1e6, 1),
    }
}

/// The texture or vertex colours of the file.
fn paint(session: &Session) -> Phrase {
    let base_colour = session.files.options.base_colour;
    let key = word("export.paint", base_colour.id());
    match base_colour {
        BaseColour::Whole => {
            let side = session.files.texture_side_px.map_or_else(String::new, |side| side.to_string());
            key.with("side", side)
        }
        BaseColour::Photo => key.with("most", session.view().texture_size.id().to_owned()),
        BaseColour::VertexColours => key,
    }
}

fn verdict(session: &Session) -> Widget {
    let name = session.file_name(Format::Glb.id());
    let (key, tone, bytes, counts) = match session.files.file {
        File::Making { is_validated: true } => ("verdict.checking", Tone::Status, None, None),
        File::Made { bytes, verdict: Some(Outcome::Unchecked) } => {
            ("verdict.unchecked", Tone::Status, Some(bytes), None)
        }
        File::Made { bytes, verdict: Some(Outcome::Validated { errors, warnings, remarks }) } => {
            let (key, tone) =
                if errors == 0 { ("verdict.valid", Tone::Success) } else { ("verdict.invalid", Tone::Error) };
            (key, tone, Some(bytes), Some([("errors", errors), ("warnings", warnings), ("remarks", remarks)]))
        }
        _ => return text("verdict", None, Tone::Status),
    };
    let mut phrase = Phrase::word(key).with("file", name);
    if let Some(bytes) = bytes {
        phrase = phrase.with("size", size(bytes));
    }
    let counts = counts.into_iter().flatten();
    text("verdict", Some(counts.fold(phrase, |phrase, (name, count)| phrase.number(name, count.into(), 0))), tone)
}

/// The file that is being made, which can be cancelled.
fn making(session: &Session) -> Widget {
    let name = session.files.making.as_ref();
    let text_of = |name: &String| Phrase::word("export.making.file").with("file", name.clone());
    let widgets = vec![
        text("export.making.file", name.map(text_of), Tone::Busy),
        page_button("cancel-file", "cancel").hidden(name.is_none()),
    ];
    group("export.making", GroupLook::Row, widgets).hidden(name.is_none())
}

fn photo(session: &Session) -> Widget {
    let photo = session.files.photo;
    let about = match photo.saved_px {
        _ if photo.is_writing => Phrase::word("export.photo.wait"),
        Some([width, height]) => {
            Phrase::word("export.photo.small").with("width", width.to_string()).with("height", height.to_string())
        }
        None => Phrase::word("export.photo.help"),
    };
    group(
        "export.photo",
        GroupLook::Titled,
        vec![
            page_button("download-photo-png", "export.photo.png"),
            text("export.photo.help", Some(about), Tone::Status),
        ],
    )
}

/// Formats without separate options, and JSON.
fn other_formats(session: &Session) -> Widget {
    let is_plain = |format: Format| {
        let own = [ExportOption::Material, ExportOption::Units, ExportOption::Solid];
        !own.into_iter().any(|option| format.supports(option))
    };
    group(
        "export.others",
        GroupLook::Titled,
        vec![
            formats("export.formats", is_plain),
            formats_help("export.formats.help", is_plain),
            option("export.units", session.files.options, |options| &mut options.units).expert(),
            page_button("download-json", "export.json").expert(),
        ],
    )
}

/// Pictures of the view.
fn pictures(session: &Session) -> [Widget; 2] {
    let abilities = session.files.abilities;
    [
        check("export.transparent", session.is_transparent(), Intent::Transparent),
        page_button("copy-picture", "export.copy").hidden(!abilities.copies_pictures),
    ]
}
