//! Choices and view as JSON text, so that a session that ends can be gone on with in another.
//!
//! Fields that are missing or not understood are refused as a whole: nobody's half of a preference is guessed. Those that
//! the first version did not have (`photo_light`, `anchors_marked`, `lens`, `scene`, `ring`, `skin`, `texture`) stand as usual where they are
//! missing.

use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Background, Dots, Lens, Light, PictureLight, Scene, ShadingMode, Srgb, Wireframe};
use rosto_studio::{ConstraintKind, DEFAULT_RING, Details, Mirror, Operator, RING_SHARES, Switch};
use serde_json::{Value, json};

use crate::error::SessionError;
use crate::{AnchorChoice, Choices, SelectionMode, Session, Skin, Turntable, View};

/// What the text tells.
pub(crate) struct Preferences {
    pub mode: SelectionMode,
    pub choices: Choices,
    pub view: View,
    pub light: Light,
    pub dots: Dots,
}

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
            "mode": self.mode().id(),
            "operator": choices.operator.id(),
            "hold": constraint,
            "anchors": choices.anchors.id(),
            "nearby": choices.is_nearby,
            "radius_mm": choices.radius_mm,
            "mirror": choices.mirror == Mirror::On,
            "turned": choices.details == Details::AsRigidAsPossible,
            "scene": view.scene.id(),
            "ring": view.ring,
            "paint": view.shading.id(),
            "skin": view.skin.id(),
            "texture": view.texture_size.id(),
            "lens": view.lens.id(),
            "wireframe": view.wireframe == Wireframe::Shown,
            "background": background,
            "turntable": view.turntable == Turntable::Turns,
            "triangulation": view.triangulation.id(),
            "density": view.density,
            "dots": settings.dots.id(),
            "photo_light": view.picture_light.id(),
            "anchors_marked": view.anchors == Switch::On,
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
    let word = |field: &'static str| value[field].as_str();
    let number = |field: &'static str| value[field].as_f64().ok_or(missing(field));
    let constraint = match &value["hold"] {
        Value::String(word) if word == "exact" => ConstraintKind::Hard,
        soft => ConstraintKind::Soft {
            weight: soft["soft"].as_f64().filter(|weight| *weight > 0.0).ok_or(missing("hold"))?,
        },
    };
    let choices = Choices {
        operator: word("operator").and_then(Operator::from_id).ok_or(missing("operator"))?,
        constraint,
        anchors: word("anchors").and_then(AnchorChoice::from_id).ok_or(missing("anchors"))?,
        is_nearby: false,
        radius_mm: number("radius_mm")?,
        mirror: if flag("mirror")? { Mirror::On } else { Mirror::Off },
        details: if flag("turned")? { Details::AsRigidAsPossible } else { Details::Kept },
    };
    let choices = Choices { is_nearby: flag("nearby")?, ..choices.reaching(choices.radius_mm)? };
    let density = value["density"].as_u64().filter(|density| *density <= crate::DENSEST_SHOWN.into());
    let view = View {
        scene: named_or_usual(&value["scene"], Scene::from_id).ok_or(missing("scene"))?,
        ring: ring(&value["ring"]).ok_or(missing("ring"))?,
        shading: word("paint").and_then(shading).ok_or(missing("paint"))?,
        skin: named_or_usual(&value["skin"], Skin::from_id).ok_or(missing("skin"))?,
        texture_size: named_or_usual(&value["texture"], TextureSize::from_id).ok_or(missing("texture"))?,
        lens: named_or_usual(&value["lens"], Lens::from_id).ok_or(missing("lens"))?,
        wireframe: if flag("wireframe")? { Wireframe::Shown } else { Wireframe::Hidden },
        background: background(&value["background"]).ok_or(missing("background"))?,
        turntable: if flag("turntable")? { Turntable::Turns } else { Turntable::Still },
        triangulation: word("triangulation").and_then(Triangulation::from_id).ok_or(missing("triangulation"))?,
        density: density.ok_or(missing("density"))? as u32,
        picture_light: named_or_usual(&value["photo_light"], PictureLight::from_id).ok_or(missing("photo_light"))?,
        anchors: anchors(&value["anchors_marked"]).ok_or(missing("anchors_marked"))?,
        motion: now.motion,
    };
    Ok(Preferences {
        mode: word("mode").and_then(SelectionMode::from_id).ok_or(missing("mode"))?,
        choices,
        view,
        light: light(&value).ok_or(missing("light"))?,
        dots: word("dots").and_then(Dots::from_id).ok_or(missing("dots"))?,
    })
}

/// What a name stands for; the usual where the text has none.
fn named_or_usual<T: Default>(value: &Value, from_id: fn(&str) -> Option<T>) -> Option<T> {
    if value.is_null() { Some(T::default()) } else { from_id(value.as_str()?) }
}

fn ring(value: &Value) -> Option<f64> {
    if value.is_null() { Some(DEFAULT_RING) } else { value.as_f64().filter(|ring| RING_SHARES.contains(ring)) }
}

fn anchors(value: &Value) -> Option<Switch> {
    if value.is_null() || !value.as_bool()? { Some(Switch::Off) } else { Some(Switch::On) }
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

fn shading(id: &str) -> Option<ShadingMode> {
    // Earlier texts call the picture by what it is of.
    ShadingMode::from_id(if id == "photo" { "picture" } else { id })
}
