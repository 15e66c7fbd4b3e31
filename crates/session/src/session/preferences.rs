//! Settings and view as JSON text, so that another session can restore them.
//!
//! Text with a missing or invalid field is refused completely; there are no default values.

use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Background, Dots, Lens, Light, PictureLight, Scene, ShadingMode, Srgb, Visibility};
use rosto_studio::{ConstraintKind, Details, FALLOFF_BAND_SHARES, Mirror, Operator, Switch};
use serde_json::{Value, json};

use super::Session;
use super::appearance::checked;
use crate::error::SessionError;
use crate::{AnchorChoice, EditOptions, SelectionMode, TextureSource, Turntable, View};

/// The contents of the text.
pub(crate) struct Preferences {
    pub mode: SelectionMode,
    pub edit_options: EditOptions,
    pub view: View,
    pub light: Light,
    pub dots: Dots,
    pub shading: ShadingMode,
    pub picture_light: PictureLight,
    pub lens: Lens,
}

impl Session {
    /// Settings and view as text, for [`Intent::RestorePreferences`](crate::Intent::RestorePreferences).
    pub fn preferences(&self) -> String {
        let (edit_options, view, settings) = (self.edit_options(), self.view(), self.stage().render_settings());
        let constraint = match edit_options.constraint {
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
            "operator": edit_options.operator.id(),
            "constraint": constraint,
            "anchors": edit_options.anchors.id(),
            "nearby": edit_options.is_nearby,
            "radius_mm": edit_options.radius_mm,
            "mirror": edit_options.mirror == Mirror::On,
            "turned": edit_options.details == Details::AsRigidAsPossible,
            "scene": view.scene.id(),
            "falloff-band": view.falloff_band,
            "paint": settings.shading.id(),
            "texture-source": view.texture_source.id(),
            "texture": view.texture_size.id(),
            "lens": self.stage().camera().lens().id(),
            "wireframe": view.wireframe == Visibility::Shown,
            "background": background,
            "turntable": view.turntable == Turntable::Turns,
            "triangulation": view.triangulation.id(),
            "density": view.density,
            "dots": settings.dots.id(),
            "photo_light": settings.picture_light.id(),
            "anchors_marked": view.anchors == Switch::On,
            "light": [light.azimuth_deg, light.elevation_deg, light.strength, light.ambient],
            "light_colour": light.colour.0,
        })
        .to_string()
    }
}

/// Reads the preferences. Motion, backdrop and the display of the print are taken from `now`: they belong to the user's
/// system, the window and the panel.
pub(crate) fn read(text: &str, now: &View) -> Result<Preferences, SessionError> {
    let missing = |field| SessionError::Preferences { field };
    let value: Value = serde_json::from_str(text).map_err(|_| missing("JSON"))?;
    let flag = |field: &'static str| value[field].as_bool().ok_or(missing(field));
    let number = |field: &'static str| value[field].as_f64().ok_or(missing(field));
    let constraint = match &value["constraint"] {
        Value::String(word) if word == "exact" => ConstraintKind::Hard,
        soft => ConstraintKind::Soft {
            weight: soft["soft"].as_f64().filter(|weight| *weight > 0.0).ok_or(missing("constraint"))?,
        },
    };
    let edit_options = EditOptions {
        operator: named(&value, "operator", Operator::from_id)?,
        constraint,
        anchors: named(&value, "anchors", AnchorChoice::from_id)?,
        is_nearby: false,
        radius_mm: number("radius_mm")?,
        mirror: if flag("mirror")? { Mirror::On } else { Mirror::Off },
        details: if flag("turned")? { Details::AsRigidAsPossible } else { Details::Kept },
    };
    let edit_options = EditOptions { is_nearby: flag("nearby")?, ..edit_options.with_radius(edit_options.radius_mm)? };
    let density = value["density"].as_u64().filter(|density| *density <= crate::MAX_SHOWN_DENSITY.into());
    let view = View {
        scene: named(&value, "scene", Scene::from_id)?,
        falloff_band: Some(number("falloff-band")?)
            .filter(|falloff_band| FALLOFF_BAND_SHARES.contains(falloff_band))
            .ok_or(missing("falloff-band"))?,
        texture_source: named(&value, "texture-source", TextureSource::from_id)?,
        texture_size: named(&value, "texture", TextureSize::from_id)?,
        wireframe: if flag("wireframe")? { Visibility::Shown } else { Visibility::Hidden },
        background: background(&value["background"]).ok_or(missing("background"))?,
        turntable: if flag("turntable")? { Turntable::Turns } else { Turntable::Still },
        triangulation: named(&value, "triangulation", Triangulation::from_id)?,
        density: density.ok_or(missing("density"))? as u32,
        anchors: if flag("anchors_marked")? { Switch::On } else { Switch::Off },
        backdrop: now.backdrop,
        motion: now.motion,
        print: now.print,
    };
    Ok(Preferences {
        mode: named(&value, "mode", SelectionMode::from_id)?,
        edit_options,
        view,
        light: light(&value).ok_or(missing("light"))?,
        dots: named(&value, "dots", Dots::from_id)?,
        shading: named(&value, "paint", ShadingMode::from_id)?,
        picture_light: named(&value, "photo_light", PictureLight::from_id)?,
        lens: named(&value, "lens", Lens::from_id)?,
    })
}

fn named<T>(value: &Value, field: &'static str, from_id: fn(&str) -> Option<T>) -> Result<T, SessionError> {
    value[field].as_str().and_then(from_id).ok_or(SessionError::Preferences { field })
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
    checked(light).ok()
}

fn colour(value: &Value) -> Option<Srgb> {
    let channels: Option<Vec<u8>> = value.as_array()?.iter().map(|channel| channel.as_u64()?.try_into().ok()).collect();
    Some(Srgb(channels?.try_into().ok()?))
}
