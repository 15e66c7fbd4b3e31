use rosto_face::{LANDMARK_COUNT, Region, landmark_id};
use rosto_session::{OpenFace, RADIUS_MM, SLIDER_MM};
use rosto_studio::{EditTarget, Expression, FaceSlider};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::state::{StudioEntry, StudioRange, StudioSlider, StudioTarget};

/// What things are, by their ids, and what numbers go through. The page has the words.
#[wasm_bindgen]
impl Studio {
    /// The ids of all landmarks, such as "left-mouth-corner" or "left-cheek-425", in their order.
    #[wasm_bindgen(getter, js_name = landmarkIds)]
    pub fn landmark_ids(&self) -> Vec<String> {
        (0..LANDMARK_COUNT as u32).map(landmark_id).collect()
    }

    /// What is selected; undefined where nothing is. `free()` it.
    #[wasm_bindgen(getter, js_name = selectedTarget)]
    pub fn selected_target(&self) -> Option<StudioTarget> {
        self.session.selected_target().map(|target| self.target(target))
    }

    /// What a drag that starts at a vertex moves: what is selected, if the vertex is part of it, or what is selected there.
    /// `free()` it.
    ///
    /// # Errors
    /// `bad-vertex`.
    #[wasm_bindgen(js_name = targetAt)]
    pub fn target_at(&self, vertex: u32) -> Result<StudioTarget, JsValue> {
        Ok(self.target(self.session.target_at(vertex).map_err(FacadeError::from)?))
    }

    /// The latest entries of the history, oldest first: as many as asked for. `free()` each, and its target.
    #[wasm_bindgen(js_name = latestEntries)]
    pub fn latest_entries(&self, most: u32) -> Vec<StudioEntry> {
        let rows = self.session.face().map_or(&[][..], OpenFace::rows);
        let latest = &rows[rows.len().saturating_sub(most as usize)..];
        latest.iter().map(|row| StudioEntry::of(row, self.target(row.target))).collect()
    }

    /// The ids of every region that can be moved as one, from the forehead down.
    #[wasm_bindgen(getter, js_name = regionIds)]
    pub fn region_ids(&self) -> Vec<String> {
        Region::ALL.map(|region| region.id().to_owned()).to_vec()
    }

    /// Every ready-made slider, in the order of the tick's values.
    #[wasm_bindgen(getter, js_name = faceSliders)]
    pub fn face_sliders(&self) -> Vec<StudioSlider> {
        let slider =
            |slider: FaceSlider| StudioSlider { id: slider.id().to_owned(), range_mm: slider.range_m() * 1000.0 };
        FaceSlider::ALL.map(slider).to_vec()
    }

    /// The ids of all expressions, ARKit's names, in the order of the tick's weights.
    #[wasm_bindgen(getter, js_name = expressionIds)]
    pub fn expression_ids(&self) -> Vec<String> {
        Expression::ALL.map(|expression| expression.id().to_owned()).to_vec()
    }

    /// What the sliders of what is selected go through, in mm.
    #[wasm_bindgen(getter, js_name = offsetRange)]
    pub fn offset_range(&self) -> StudioRange {
        SLIDER_MM.into()
    }

    /// What the radius goes through, in mm.
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
