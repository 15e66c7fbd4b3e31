use rosto_stage::{Background, Dots, NamedView, PictureLight, ShadingMode, Srgb, Visibility};

use super::PER_CENT;
use super::build::{button, check, colour, group, slider, slot};
use super::widget::{ChoiceLook, GroupLook, Widget};
use crate::message::value::switched;
use crate::{Choice, Intent, LightSettings, Range, Session, Turntable};

/// Background when it is first made plain.
const GREY: [u8; 3] = [128; 3];

/// Whether the stage shows the photo or the 3D face.
pub(super) fn scene(session: &Session) -> Widget {
    session.setting("scene", Choice::Scene, ChoiceLook::Segments)
}

/// Appearance of the stage.
pub(super) fn section(session: &Session) -> Widget {
    let (view, settings) = (session.view(), session.stage().render_settings());
    let technical = &["normals", "response", "distortion"];
    group(
        "section.view",
        GroupLook::Plain,
        vec![
            session.setting_for("shading", Choice::Shading, ChoiceLook::ByThree, technical),
            session.setting("texture-source", Choice::TextureSource, ChoiceLook::Segments),
            check("view.wireframe", view.wireframe == Visibility::Shown, |on| Intent::Wireframe(switched(on))),
            check("view.dots", settings.dots == Dots::All, |on| Intent::Dots(switched(on))),
            check("view.turntable", view.turntable == Turntable::Turns, |on| Intent::Turntable(switched(on))),
            session.setting("lens", Choice::Lens, ChoiceLook::ByTwo),
            session.setting("triangulation", Choice::Triangulation, ChoiceLook::List),
            session.setting("density", Choice::Density, ChoiceLook::List).expert(),
            group("light", GroupLook::Fold, light(session)),
            group("background", GroupLook::Row, background(view.background)),
            group(
                "view.from",
                GroupLook::Row,
                vec![
                    button("view.front", Intent::GoTo(NamedView::Front)),
                    button("view.left", Intent::GoTo(NamedView::Left)),
                    button("view.top", Intent::GoTo(NamedView::Top)),
                ],
            ),
        ],
    )
    .on("view")
}

/// The lamp has no effect while the unlit photo is shown.
fn light(session: &Session) -> Vec<Widget> {
    let settings = session.stage().render_settings();
    let (is_photo, is_lit) = (settings.shading == ShadingMode::Picture, settings.picture_light == PictureLight::Lamp);
    let now = LightSettings::from(settings.light);
    let set =
        |change: fn(LightSettings, f64) -> LightSettings| move |value: f64| Intent::Light(change(now, value).into());
    let degrees = |end: f64| Range { min: -end, max: end, step: 1.0, neutral: 0.0 };
    let share = |max, neutral| Range { min: 0.0, max, step: 1.0, neutral };
    let lamp = vec![
        slot("light.sphere"),
        slider(
            "light.azimuth",
            degrees(180.0),
            "°",
            now.azimuth_deg,
            set(|now, azimuth_deg| LightSettings { azimuth_deg, ..now }),
        ),
        slider(
            "light.elevation",
            degrees(90.0),
            "°",
            now.elevation_deg,
            set(|now, elevation_deg| LightSettings { elevation_deg, ..now }),
        ),
        slider(
            "light.strength",
            share(200.0, 100.0),
            "%",
            PER_CENT * now.strength,
            set(|now, strength| LightSettings { strength: strength / PER_CENT, ..now }),
        ),
        slider(
            "light.ambient",
            share(100.0, 30.0),
            "%",
            PER_CENT * now.ambient,
            set(|now, ambient| LightSettings { ambient: ambient / PER_CENT, ..now }),
        ),
        colour("light.colour", now.colour, move |colour| Intent::Light(LightSettings { colour, ..now }.into())),
    ];
    vec![
        check("light.photo", is_lit, |on| Intent::PictureLight(switched(on))).hidden(!is_photo),
        group("light.lamp", GroupLook::Lines, lamp).enabled(!is_photo || is_lit),
    ]
}

fn background(background: Background) -> Vec<Widget> {
    let plain = match background {
        Background::Plain(Srgb(colour)) => Some(colour),
        Background::Ground | Background::Transparent => None,
    };
    let colour_now = plain.unwrap_or(GREY);
    let set = |plain: Option<[u8; 3]>| {
        Intent::Background(plain.map_or(Background::Ground, |colour| Background::Plain(Srgb(colour))))
    };
    vec![
        check("background.plain", plain.is_some(), move |on| set(on.then_some(colour_now))),
        colour("background.colour", colour_now, move |colour| set(Some(colour))),
    ]
}
