use rosto_export::{ExportOption, Format};
use rosto_face::{LANDMARK_COUNT, MAX_PHOTOS, landmark_id};
use rosto_studio::SMOOTH_DENSITY;
use serde::Serialize;
use tsify::Tsify;

use crate::edit_options::RADIUS_MM;
use crate::panel::{KEYS, Key};
use crate::range::Range;

/// Ids and ranges, which do not change. The page has the words.
#[derive(Debug, Clone, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Catalogue {
    /// Ids of the landmarks, in order, such as "left-mouth-corner" or "left-cheek-427".
    pub landmarks: Vec<String>,
    /// Range of the influence radius, in mm.
    pub radius: Range,
    /// Maximum number of photos of one face.
    pub max_photos: usize,
    /// Ids of the file formats, in display order.
    pub formats: Vec<&'static str>,
    /// Ids of those for 3D printing.
    pub printed_formats: Vec<&'static str>,
    /// Default density of the mesh.
    pub default_density: u32,
    /// The keys.
    pub keys: [Key; KEYS.len()],
}

impl Default for Catalogue {
    fn default() -> Self {
        let ids = |formats: &mut dyn Iterator<Item = Format>| formats.map(Format::id).collect();
        Self {
            landmarks: (0..LANDMARK_COUNT as u32).map(landmark_id).collect(),
            radius: RADIUS_MM,
            max_photos: MAX_PHOTOS,
            formats: ids(&mut Format::ALL.into_iter()),
            printed_formats: ids(&mut Format::ALL.into_iter().filter(|format| format.supports(ExportOption::Solid))),
            default_density: SMOOTH_DENSITY,
            keys: KEYS,
        }
    }
}
