use std::collections::BTreeMap;

use rosto_export::SOLID_MM;
use rosto_face::{LANDMARK_COUNT, MAX_PHOTOS, Measure, Region, landmark_id};
use rosto_mesh::Named;
use rosto_studio::{Expression, FaceSlider, SMOOTH_DENSITY};
use serde::Serialize;
use tsify::Tsify;

use crate::edit_options::{RADIUS_MM, SLIDER_MM};
use crate::panel::range_mm;
use crate::range::Range;
use crate::{BRUSH_PX, Choice, FALLOFF_BAND, FormatFacts, formats};

/// Ids and ranges, which do not change. The page has the words.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(hashmap_as_object)]
pub struct Catalogue {
    /// Ids of the landmarks, in order, such as "left-mouth-corner" or "left-cheek-427".
    pub landmarks: Vec<String>,
    /// Ids of the regions, from the forehead down.
    pub regions: Vec<&'static str>,
    /// Ids of the expressions (ARKit's names).
    pub expressions: Vec<&'static str>,
    /// Ids of the measures, in display order.
    pub measures: Vec<&'static str>,
    /// The ready-made sliders, in mm.
    pub sliders: Vec<SliderRange>,
    /// Range of the selection's offset sliders, in mm.
    pub offset: Range,
    /// Range of the influence radius, in mm.
    pub radius: Range,
    /// Range of the falloff band, as a share of the face's longer side.
    pub falloff_band: Range,
    /// Range of the brush's radius, in CSS px.
    pub brush: Range,
    /// Ids of each setting's values, in display order.
    pub choices: BTreeMap<&'static str, Vec<String>>,
    /// Maximum number of photos of one face.
    pub max_photos: usize,
    /// The file formats, in display order.
    pub formats: Vec<FormatFacts>,
    /// Range of the thickness of the wall or back of a printed body: minimum and maximum, in mm.
    pub solid_mm: [f64; 2],
    /// Default density of the mesh.
    pub default_density: u32,
}

/// A ready-made slider.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SliderRange {
    /// Id, such as "nose-width".
    pub id: &'static str,
    /// Range, in mm.
    pub range: Range,
}

impl Default for Catalogue {
    fn default() -> Self {
        Self {
            landmarks: (0..LANDMARK_COUNT as u32).map(landmark_id).collect(),
            regions: ids::<Region>(),
            expressions: ids::<Expression>(),
            measures: ids::<Measure>(),
            sliders: FaceSlider::ALL.map(SliderRange::of).to_vec(),
            offset: SLIDER_MM,
            radius: RADIUS_MM,
            falloff_band: FALLOFF_BAND,
            brush: BRUSH_PX,
            choices: Choice::ALL.map(|choice| (choice.id(), choice.values())).into(),
            max_photos: MAX_PHOTOS,
            formats: formats(),
            solid_mm: SOLID_MM,
            default_density: SMOOTH_DENSITY,
        }
    }
}

impl SliderRange {
    fn of(slider: FaceSlider) -> Self {
        Self { id: slider.id(), range: range_mm(slider) }
    }
}

fn ids<T: Named>() -> Vec<&'static str> {
    T::ALL.iter().map(|one| one.id()).collect()
}
