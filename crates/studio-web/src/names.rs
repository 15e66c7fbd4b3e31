use rosto_face::{LANDMARK_COUNT, Region, landmark_id};
use rosto_session::{OpenFace, RADIUS_MM, SLIDER_MM};
use rosto_studio::{EditTarget, Expression, FaceSlider};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::state::{StudioEntry, StudioRange, StudioSlider, StudioTarget};

/// Ids and ranges for the panels; the page has the words.
#[wasm_bindgen]
impl Studio {
    /// Ids of the landmarks, in order, such as "left-mouth-corner" or "left-cheek-427".
    #[wasm_bindgen(getter, js_name = landmarkIds)]
    pub fn landmark_ids(&self) -> Vec<String> {
        (0..LANDMARK_COUNT as u32).map(landmark_id).collect()
    }

    /// Target of the selection; undefined without one. `free()` it after use.
    #[wasm_bindgen(getter, js_name = selectedTarget)]
    pub fn selected_target(&self) -> Option<StudioTarget> {
        self.session.selected_target().map(|target| self.target(target))
    }

    /// Target of a drag that starts at a vertex: the selection if it contains the vertex, else what a click there
    /// selects. `free()` it after use.
    ///
    /// # Errors
    /// `bad-vertex`.
    #[wasm_bindgen(js_name = targetAt)]
    pub fn target_at(&self, vertex: u32) -> Result<StudioTarget, JsValue> {
        Ok(self.target(self.session.target_at(vertex).map_err(FacadeError::from)?))
    }

    /// The latest `most` entries of the history, oldest first. `free()` each of them and its target after use.
    #[wasm_bindgen(js_name = latestEntries)]
    pub fn latest_entries(&self, most: u32) -> Vec<StudioEntry> {
        let rows = self.session.face().map_or(&[][..], OpenFace::rows);
        let latest = &rows[rows.len().saturating_sub(most as usize)..];
        latest.iter().map(|row| StudioEntry::of(row, self.target(row.target))).collect()
    }

    /// Ids of the regions, from the forehead down.
    #[wasm_bindgen(getter, js_name = regionIds)]
    pub fn region_ids(&self) -> Vec<String> {
        Region::ALL.map(|region| region.id().to_owned()).to_vec()
    }

    /// The ready-made sliders, in the order of the tick's values.
    #[wasm_bindgen(getter, js_name = faceSliders)]
    pub fn face_sliders(&self) -> Vec<StudioSlider> {
        let slider =
            |slider: FaceSlider| StudioSlider { id: slider.id().to_owned(), range_mm: slider.range_m() * 1000.0 };
        FaceSlider::ALL.map(slider).to_vec()
    }

    /// Ids of the expressions (ARKit's names), in the order of the tick's weights.
    #[wasm_bindgen(getter, js_name = expressionIds)]
    pub fn expression_ids(&self) -> Vec<String> {
        Expression::ALL.map(|expression| expression.id().to_owned()).to_vec()
    }

    /// Range of the selection's offset sliders, in mm.
    #[wasm_bindgen(getter, js_name = offsetRange)]
    pub fn offset_range(&self) -> StudioRange {
        SLIDER_MM.into()
    }

    /// Range of the influence radius, in mm.
    #[wasm_bindgen(getter, js_name = radiusRange)]
    pub fn radius_range(&self) -> StudioRange {
        RADIUS_MM.into()
    }
}

impl Studio {
    fn target(&self, target: EditTarget) -> StudioTarget {
        let part = self.session.face().and_then(|face| face.document().part_of(target));
        StudioTarget::of(target, part)
    }
}
