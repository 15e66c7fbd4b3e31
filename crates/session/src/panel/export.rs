use rosto::{EditsAs, ExpressionsAs, FileOptions};
use rosto_export::{BaseColour, ExportOption, Eyes, Format, Material, SOLID_MM, Solid, Units};

use super::name::word;
use super::widget::{
    ChoiceLook, Control, GroupLook, Tone, Widget, check, choice, group, help, page_button, slider, slot, text,
};
use super::{Part, Phrase};
use crate::files::{File, Outcome};
use crate::{Choice, Intent, Range, Session};

/// Rounding below this is not visible, in mm.
const VISIBLE_MM: f64 = 0.05;

/// Files and pictures of the face.
pub(super) fn section(session: &Session) -> Widget {
    let now = session.files.options;
    let glb = vec![
        option("base-colour", now.base_colour, BaseColour::id, &BaseColour::ALL, move |base_colour| FileOptions {
            base_colour,
            ..now
        }),
        session.setting("texture-size", Choice::TextureSize, ChoiceLook::List),
        session.setting("export.density", Choice::Density, ChoiceLook::List).labelled("density".into()).expert(),
        switch("export.unlit", now.material == Material::Unlit, move |on| FileOptions {
            material: if on { Material::Unlit } else { Material::Lit },
            ..now
        }),
        switch("export.morphs", now.edits == EditsAs::MorphTargets, move |on| FileOptions {
            edits: if on { EditsAs::MorphTargets } else { EditsAs::Shape },
            ..now
        }),
        switch("export.expressions", now.expressions == ExpressionsAs::MorphTargets, move |on| FileOptions {
            expressions: if on { ExpressionsAs::MorphTargets } else { ExpressionsAs::Shape },
            ..now
        }),
        switch("export.eyes", now.eyes == Eyes::Pieces, move |on| FileOptions {
            eyes: if on { Eyes::Pieces } else { Eyes::Skin },
            ..now
        }),
        facts(session),
        group(
            "export.glb",
            GroupLook::Row,
            vec![
                page_button("check-glb", "export.check"),
                page_button("share-glb", "export.share").hidden(!session.files.abilities.shares_models),
            ],
        ),
        verdict(session),
        slot("export.ar"),
        help("export.scale"),
        print(session),
    ];
    let others = [photo(session), other_formats(session)].into_iter().chain(pictures(session));
    let project = [page_button("save-project", "work.save"), help("work.help")];
    group("section.export", GroupLook::Plain, glb.into_iter().chain(others).chain(project).collect()).on("export")
}

/// A choice between the values of a file option.
fn option<T: Copy + PartialEq + 'static>(
    id: &'static str,
    chosen: T,
    ids: fn(T) -> &'static str,
    all: &'static [T],
    set: impl Fn(T) -> FileOptions + 'static,
) -> Widget {
    let options = all.iter().map(|&value| ids(value).to_owned()).collect();
    let control = Control::Choice {
        name: id,
        options,
        expert: &[],
        chosen: Some(ids(chosen).to_owned()),
        look: ChoiceLook::Segments,
    };
    choice(id, control, move |id| {
        let value = all.iter().copied().find(|&value| ids(value) == id)?;
        Some(Intent::FileOptions(set(value)))
    })
}

/// A switch between two values of a file option.
fn switch(id: &'static str, is_on: bool, set: impl Fn(bool) -> FileOptions + 'static) -> Widget {
    check(id, is_on, move |is_on| Intent::FileOptions(set(is_on))).expert()
}

/// Name, size and content of the GLB.
fn facts(session: &Session) -> Widget {
    let size = match session.files.file {
        File::Made { bytes, .. } => size(bytes),
        _ => Phrase::word("amount.none"),
    };
    let name = Phrase::word("export.name").with("name", session.file_name(Format::Glb.id()));
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

/// Formats for 3D printing: the body and its measures.
fn print(session: &Session) -> Widget {
    let files = &session.files;
    let solid = files.options.solid;
    let [min, max] = SOLID_MM;
    let range = |neutral| Range { min, max, step: 0.1, neutral };
    let now = files.options;
    let set = move |solid| Intent::FileOptions(FileOptions { solid, ..now });
    let rows = files.body.facts.iter().flat_map(|body| {
        let [x, y, z] = body.size_mm;
        let size = Phrase::word("amount.size").number("x", x, 0).number("y", y, 0).number("z", z, 0);
        let rounded =
            (body.moved_mm >= VISIBLE_MM).then(|| (word("print", "rounded"), amount("amount.mm", body.moved_mm, 1)));
        let rows = [
            (word("print", "size"), size),
            (word("print", "volume"), amount("amount.cm3", body.volume_cm3, 1)),
            (word("print", "weight"), amount("amount.g", body.pla_grams, 0)),
            (word("print", "thinnest"), amount("amount.mm", body.thinnest_mm, 1)),
        ];
        rows.into_iter().chain(rounded)
    });
    let kinds = [
        ("thickness", Solid::Thickness { mm: files.thickness_mm }),
        ("flat", Solid::FlatBack { mm: files.back_mm }),
        ("surface", Solid::Surface),
    ];
    let chosen = kinds.iter().find(|(_, kind)| *kind == solid).map(|(id, _)| (*id).to_owned());
    let options = kinds.iter().map(|(id, _)| (*id).to_owned()).collect();
    let kind = choice(
        "solid",
        Control::Choice { name: "solid", options, expert: &[], chosen, look: ChoiceLook::Segments },
        move |id| {
            let solid = kinds.iter().find(|(kind, _)| *kind == id)?.1;
            Some(set(solid))
        },
    );
    group(
        "print",
        GroupLook::Fold,
        vec![
            kind,
            slider("solid.thickness.mm", range(2.0), "mm", files.thickness_mm, move |mm| set(Solid::Thickness { mm }))
                .hidden(!matches!(solid, Solid::Thickness { .. })),
            slider("solid.flat.mm", range(3.0), "mm", files.back_mm, move |mm| set(Solid::FlatBack { mm }))
                .hidden(!matches!(solid, Solid::FlatBack { .. })),
            Widget::new("print.facts", Control::Facts { rows: rows.collect() }).enabled(!files.body.is_stale),
            text("print.error", body_error(session), Tone::Error),
            formats("print.formats", |format| format.supports(ExportOption::Solid)),
            formats_help("print.help", |format| format.supports(ExportOption::Solid)),
        ],
    )
}

fn amount(key: &'static str, value: f64, decimals: u8) -> Phrase {
    Phrase::word(key).number("n", value, decimals)
}

/// Why the body cannot be made, with an allowed length if there is one.
fn body_error(session: &Session) -> Option<Phrase> {
    let error = session.files.body.error.as_ref()?;
    // Rounded down so that the suggested length works.
    let works_mm = (10.0 * error.max_mm.unwrap_or_default()).floor() / 10.0;
    if works_mm >= SOLID_MM[0] {
        return Some(Phrase::word("print.at-most").number("most", works_mm, 1));
    }
    let reason = word("error", &error.code);
    let hint = Phrase::word(format!("error.{}.hint", error.code));
    Some(Phrase::word("print.error").with("reason", reason).with("hint", hint))
}

fn formats(id: &'static str, is_listed: fn(Format) -> bool) -> Widget {
    let button = |format: Format| {
        let name = Phrase::word("format.name").with("name", format.id().to_uppercase());
        page_button(format!("download-{}", format.id()), name)
    };
    group(id, GroupLook::Row, Format::ALL.into_iter().filter(|&format| is_listed(format)).map(button).collect())
}

/// Contents of the formats, one sentence each.
fn formats_help(id: &'static str, is_listed: fn(Format) -> bool) -> Widget {
    let texts = Format::ALL.into_iter().filter(|&format| is_listed(format));
    let texts: Vec<Phrase> = texts.map(|format| Phrase::word(format!("format.{}.help", format.id()))).collect();
    let joined = texts.into_iter().reduce(|before, next| {
        Phrase::word("sentences").with("before", Part::Phrase(before)).with("next", Part::Phrase(next))
    });
    text(id, joined, Tone::Help)
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
    let buttons = vec![
        page_button("download-photo-jpeg", "export.photo.jpeg"),
        page_button("download-photo-png", "export.photo.png"),
    ];
    group(
        "export.photo",
        GroupLook::Titled,
        vec![
            group("export.photo.formats", GroupLook::Row, buttons),
            text("export.photo.help", Some(about), Tone::Status),
        ],
    )
}

/// Formats without separate options, and JSON.
fn other_formats(session: &Session) -> Widget {
    let now = session.files.options;
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
            option("export.units", now.units, Units::id, &Units::ALL, move |units| FileOptions { units, ..now })
                .expert(),
            page_button("download-json", "export.json").expert(),
        ],
    )
}

/// Pictures of the view.
fn pictures(session: &Session) -> [Widget; 4] {
    let abilities = session.files.abilities;
    [
        check("export.transparent", session.is_transparent(), Intent::Transparent),
        group(
            "export.pictures",
            GroupLook::Row,
            vec![
                page_button("download-picture", "export.picture"),
                page_button("copy-picture", "export.copy").hidden(!abilities.copies_pictures),
            ],
        ),
        group(
            "export.pairs",
            GroupLook::Row,
            vec![
                page_button("download-pair", "pair.save"),
                page_button("share-pair", "pair.share").hidden(!abilities.shares_pictures),
            ],
        ),
        slot("export.clip"),
    ]
}
