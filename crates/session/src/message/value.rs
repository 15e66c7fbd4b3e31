//! The form in which values of the domain travel.

use glam::{DVec2, DVec3};
use rosto_face::{PhotoLens, Region};
use rosto_mesh::Named;
use rosto_stage::{Background, Dots, Light, PictureLight, Pointer, Srgb, Visibility};
use rosto_studio::{ConstraintKind, Mirror, Switch};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use tsify::Tsify;

use crate::Selection;

/// A value that the user has entered.
#[derive(Debug, Clone, PartialEq, Deserialize, Tsify)]
#[serde(untagged)]
pub enum Value {
    /// State of a switch.
    Flag(bool),
    /// A number.
    Number(f64),
    /// Id of a choice.
    Text(String),
    /// An sRGB colour.
    Colour([u8; 3]),
}
use crate::drag::Pace;
use crate::saved::MAX_SHOWN_DENSITY;
use crate::view::{Motion, Turntable};

/// The available constraints; the soft one has the paper's weight.
pub(crate) const CONSTRAINTS: [(&str, ConstraintKind); 2] =
    [("exact", ConstraintKind::Hard), ("soft", ConstraintKind::Soft { weight: 1.0 })];

/// A setting with two values, which travels as a boolean.
pub(crate) trait Flag {
    /// The value of `true`.
    const ON: Self;
    /// The value of `false`.
    const OFF: Self;
}

macro_rules! flags {
    ($($name:ident { $off:ident, $on:ident })+) => {
        $(impl Flag for $name {
            const OFF: Self = Self::$off;
            const ON: Self = Self::$on;
        })+
    };
}

/// The value of a setting with two values.
pub(crate) fn switched<T: Flag>(on: bool) -> T {
    if on { T::ON } else { T::OFF }
}

flags! {
    Dots { NearPointer, All }
    Mirror { Off, On }
    Motion { Usual, Reduced }
    Pace { Usual, Fine }
    PictureLight { Own, Lamp }
    Pointer { Fine, Coarse }
    Switch { Off, On }
    Turntable { Still, Turns }
    Visibility { Hidden, Shown }
}

/// The light.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct LightSettings {
    /// Degrees to the viewer's right; 0 is the viewer's direction.
    pub azimuth_deg: f64,
    /// Degrees above the horizon.
    pub elevation_deg: f64,
    /// Strength of the directional light; 1 is the default.
    pub strength: f64,
    /// Strength of the ambient light; 1 without directional light shows the original colours.
    pub ambient: f64,
    /// Colour of the directional light, sRGB.
    pub colour: [u8; 3],
}

impl From<Light> for LightSettings {
    fn from(light: Light) -> Self {
        let Light { azimuth_deg, elevation_deg, strength, ambient, colour: Srgb(colour) } = light;
        Self { azimuth_deg, elevation_deg, strength, ambient, colour }
    }
}

impl From<LightSettings> for Light {
    fn from(light: LightSettings) -> Self {
        let LightSettings { azimuth_deg, elevation_deg, strength, ambient, colour } = light;
        Self { azimuth_deg, elevation_deg, strength, ambient, colour: Srgb(colour) }
    }
}

/// The page's form of a [`Selection`].
#[derive(Deserialize, Tsify)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Selected {
    /// A landmark, by its number.
    Landmark(u32),
    /// A region, by its id.
    Region(
        #[serde(deserialize_with = "id")]
        #[tsify(type = "string")]
        Region,
    ),
    /// A vertex of a denser mesh.
    Point {
        /// Subdivision level, from 1.
        level: u32,
        /// The vertex.
        vertex: u32,
    },
}

pub(crate) fn id<'de, T: Named, D: Deserializer<'de>>(from: D) -> Result<T, D::Error> {
    named(&String::deserialize(from)?)
}

pub(crate) fn maybe_id<'de, T: Named, D: Deserializer<'de>>(from: D) -> Result<Option<T>, D::Error> {
    Option::<String>::deserialize(from)?.map(|id| named(&id)).transpose()
}

fn named<T: Named, E: Error>(id: &str) -> Result<T, E> {
    T::from_id(id).ok_or_else(|| E::custom(format_args!("unknown id {id:?}")))
}

pub(crate) fn flag<'de, T: Flag, D: Deserializer<'de>>(from: D) -> Result<T, D::Error> {
    Ok(switched(bool::deserialize(from)?))
}

pub(crate) fn point<'de, D: Deserializer<'de>>(from: D) -> Result<DVec2, D::Error> {
    <[f64; 2]>::deserialize(from).map(DVec2::from)
}

pub(crate) fn maybe_point<'de, D: Deserializer<'de>>(from: D) -> Result<Option<DVec2>, D::Error> {
    Ok(Option::<[f64; 2]>::deserialize(from)?.map(DVec2::from))
}

pub(crate) fn vector<'de, D: Deserializer<'de>>(from: D) -> Result<DVec3, D::Error> {
    <[f64; 3]>::deserialize(from).map(DVec3::from)
}

pub(crate) fn lens<'de, D: Deserializer<'de>>(from: D) -> Result<PhotoLens, D::Error> {
    String::deserialize(from)?.parse().map_err(D::Error::custom)
}

pub(crate) fn constraint<'de, D: Deserializer<'de>>(from: D) -> Result<ConstraintKind, D::Error> {
    let id = String::deserialize(from)?;
    let found = CONSTRAINTS.into_iter().find(|(one, _)| *one == id).map(|(_, constraint)| constraint);
    found.ok_or_else(|| D::Error::custom(format_args!("unknown id {id:?}")))
}

/// The id of a density is its number as text.
pub(crate) fn density<'de, D: Deserializer<'de>>(from: D) -> Result<u32, D::Error> {
    let id = String::deserialize(from)?;
    let density = id.parse().ok().filter(|density| *density <= MAX_SHOWN_DENSITY);
    density.ok_or_else(|| D::Error::custom(format_args!("unknown id {id:?}")))
}

pub(crate) fn light<'de, D: Deserializer<'de>>(from: D) -> Result<Light, D::Error> {
    Ok(LightSettings::deserialize(from)?.into())
}

/// A uniform colour, or none for the theme's background.
pub(crate) fn background<'de, D: Deserializer<'de>>(from: D) -> Result<Background, D::Error> {
    let colour = Option::<[u8; 3]>::deserialize(from)?;
    Ok(colour.map_or(Background::Ground, |colour| Background::Plain(Srgb(colour))))
}

pub(crate) fn selection<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Selection>, D::Error> {
    Ok(Option::<Selected>::deserialize(from)?.map(|selected| match selected {
        Selected::Landmark(vertex) => Selection::Landmark(vertex),
        Selected::Region(region) => Selection::Region(region),
        Selected::Point { level, vertex } => Selection::Point { level, vertex },
    }))
}
