//! Choices and view as JSON text, so that a session that ends can be gone on with in another.
//!
//! Fields that are missing or not understood are refused as a whole: nobody's half of a preference is guessed.

use rosto_face::Triangulation;
use rosto_stage::{Background, Dots, Light, ShadingMode, Srgb, Wireframe};
use rosto_studio::project::{operator_from_name, operator_name};
use rosto_studio::{ConstraintKind, Details, Mirror};
use serde_json::{Value, json};

use crate::error::SessionError;
use crate::{AnchorChoice, Choices, SelectionMode, Session, Turntable, View};

/// What the text tells.
pub(crate) struct Preferences {
    pub mode: SelectionMode,
    pub choices: Choices,
    pub view: View,
    pub light: Light,
    pub dots: Dots,
}

/// A value beside the word that stands for it.
type Words<T> = &'static [(T, &'static str)];

const MODES: Words<SelectionMode> =
    &[(SelectionMode::Landmark, "landmark"), (SelectionMode::Region, "region"), (SelectionMode::Point, "point")];
const ANCHORS: Words<AnchorChoice> =
    &[(AnchorChoice::Random, "random"), (AnchorChoice::Oval, "oval"), (AnchorChoice::PinsOnly, "pins")];
const PAINTS: Words<ShadingMode> = &[
    (ShadingMode::Photo, "photo"),
    (ShadingMode::Colours, "colours"),
    (ShadingMode::Clay, "clay"),
    (ShadingMode::Normals, "normals"),
    (ShadingMode::Response, "response"),
    (ShadingMode::Distortion, "distortion"),
];
const DOTS: Words<Dots> = &[(Dots::None, "none"), (Dots::NearPointer, "near"), (Dots::All, "all")];
const TRIANGULATIONS: Words<Triangulation> =
    &[(Triangulation::Canonical, "canonical"), (Triangulation::Tessellation, "tessellation")];

impl Session {
    /// Choices and view as text, for [`Intent::Prefer`](crate::Intent::Prefer).
    pub fn preferences(&self) -> String {
        let (choices, view, settings) = (self.choices(), self.view(), self.stage().render_settings());
        let constraint = match choices.constraint {
            ConstraintKind::Soft { weight } => json!({ "soft": weight }),
            ConstraintKind::Hard => json!("exact"),
        };
        let background = match view.background {
            Background::Plain(Srgb(colour)) => json!(colour),
            Background::Ground | Background::Transparent => json!("ground"),
        };
        let light = &settings.light;
        json!({
            "mode": word(MODES, self.mode()),
            "operator": operator_name(choices.operator),
            "hold": constraint,
            "anchors": word(ANCHORS, choices.anchors),
            "nearby": choices.is_nearby,
            "radius_mm": choices.radius_mm,
            "mirror": choices.mirror == Mirror::On,
            "turned": choices.details == Details::AsRigidAsPossible,
            "paint": word(PAINTS, view.shading),
            "wireframe": view.wireframe == Wireframe::Shown,
            "background": background,
            "turntable": view.turntable == Turntable::Turns,
            "triangulation": word(TRIANGULATIONS, view.triangulation),
            "density": view.density,
            "dots": word(DOTS, settings.dots),
            "light": [light.azimuth_deg, light.elevation_deg, light.strength, light.ambient],
            "light_colour": light.colour.0,
        })
        .to_string()
    }
}

/// Whether things move is the visitor's browser's to say: that stays as it is `now`.
pub(crate) fn read(text: &str, now: &View) -> Result<Preferences, SessionError> {
    let missing = |field| SessionError::Preferences { field };
    let value: Value = serde_json::from_str(text).map_err(|_| missing("JSON"))?;
    let flag = |field: &'static str| value[field].as_bool().ok_or(missing(field));
    let number = |field: &'static str| value[field].as_f64().ok_or(missing(field));
    let constraint = match &value["hold"] {
        Value::String(word) if word == "exact" => ConstraintKind::Hard,
        soft => ConstraintKind::Soft {
            weight: soft["soft"].as_f64().filter(|weight| *weight > 0.0).ok_or(missing("hold"))?,
        },
    };
    let choices = Choices {
        operator: value["operator"].as_str().and_then(operator_from_name).ok_or(missing("operator"))?,
        constraint,
        anchors: meant(ANCHORS, &value["anchors"]).ok_or(missing("anchors"))?,
        is_nearby: false,
        radius_mm: number("radius_mm")?,
        mirror: if flag("mirror")? { Mirror::On } else { Mirror::Off },
        details: if flag("turned")? { Details::AsRigidAsPossible } else { Details::Kept },
    };
    let choices = Choices { is_nearby: flag("nearby")?, ..choices.reaching(choices.radius_mm)? };
    let density = value["density"].as_u64().filter(|density| *density <= crate::DENSEST_SHOWN.into());
    let view = View {
        shading: meant(PAINTS, &value["paint"]).ok_or(missing("paint"))?,
        wireframe: if flag("wireframe")? { Wireframe::Shown } else { Wireframe::Hidden },
        background: background(&value["background"]).ok_or(missing("background"))?,
        turntable: if flag("turntable")? { Turntable::Turns } else { Turntable::Still },
        triangulation: meant(TRIANGULATIONS, &value["triangulation"]).ok_or(missing("triangulation"))?,
        density: density.ok_or(missing("density"))? as u32,
        motion: now.motion,
    };
    Ok(Preferences {
        mode: meant(MODES, &value["mode"]).ok_or(missing("mode"))?,
        choices,
        view,
        light: light(&value).ok_or(missing("light"))?,
        dots: meant(DOTS, &value["dots"]).ok_or(missing("dots"))?,
    })
}

fn background(value: &Value) -> Option<Background> {
    match value {
        Value::String(word) if word == "ground" => Some(Background::Ground),
        plain => colour(plain).map(Background::Plain),
    }
}

fn light(value: &Value) -> Option<Light> {
    let numbers: Option<Vec<f64>> = value["light"].as_array()?.iter().map(Value::as_f64).collect();
    let [azimuth_deg, elevation_deg, strength, ambient] = numbers?[..] else { return None };
    let light = Light { azimuth_deg, elevation_deg, strength, ambient, colour: colour(&value["light_colour"])? };
    crate::session::checked(light).ok()
}

fn colour(value: &Value) -> Option<Srgb> {
    let channels: Option<Vec<u8>> = value.as_array()?.iter().map(|channel| channel.as_u64()?.try_into().ok()).collect();
    Some(Srgb(channels?.try_into().ok()?))
}

fn word<T: Copy + PartialEq>(words: Words<T>, value: T) -> &'static str {
    words.iter().find(|(meant, _)| *meant == value).map_or("", |(_, word)| word)
}

fn meant<T: Copy>(words: Words<T>, value: &Value) -> Option<T> {
    let wanted = value.as_str()?;
    words.iter().find(|(_, word)| *word == wanted).map(|(meant, _)| *meant)
}
