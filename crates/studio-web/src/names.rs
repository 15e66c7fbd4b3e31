use rosto_face::{Region, landmark_name};
use rosto_session::{RADIUS_MM, SLIDER_MM, landmark_label};
use rosto_studio::FaceSlider;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::LanguageName;
use crate::state::{NamedRegion, NamedSlider, StudioEntry, StudioRange};

/// What things are called, and what numbers go through.
#[wasm_bindgen]
impl Studio {
    /// What a landmark is called, with or without an open face.
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = landmarkName)]
    pub fn landmark_name(&self, vertex: u32, language: LanguageName) -> Result<String, JsValue> {
        let vertex = rosto_session::known_landmark(vertex).map_err(FacadeError::from)?;
        Ok(landmark_name(vertex, language.language()?))
    }

    /// What a landmark is called on the page, with its number, such as "nose tip · 1".
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = landmarkLabel)]
    pub fn landmark_label(&self, vertex: u32, language: LanguageName) -> Result<String, JsValue> {
        let vertex = rosto_session::known_landmark(vertex).map_err(FacadeError::from)?;
        Ok(landmark_label(vertex, language.language()?))
    }

    /// The name of what is selected; undefined where nothing is.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = selectionName)]
    pub fn selection_name(&self, language: LanguageName) -> Result<Option<String>, JsValue> {
        Ok(self.session.selection_name(language.language()?))
    }

    /// What a drag that starts at a vertex moves: what is selected, if the vertex is part of it, or what is selected there.
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = nameAt)]
    pub fn name_at(&self, vertex: u32, language: LanguageName) -> Result<String, JsValue> {
        Ok(self.session.name_at(vertex, language.language()?).map_err(FacadeError::from)?)
    }

    /// The vertex that is meant by a number, or the landmark that is meant by its name, in any case of its letters;
    /// undefined where there is none that could be selected.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = vertexCalled)]
    pub fn vertex_called(&self, text: &str, language: LanguageName) -> Result<Option<u32>, JsValue> {
        Ok(self.session.vertex_called(text, language.language()?))
    }

    /// The latest entries of the history, oldest first: as many as asked for. `free()` each.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = latestEntries)]
    pub fn latest_entries(&self, most: u32, language: LanguageName) -> Result<Vec<StudioEntry>, JsValue> {
        let language = language.language()?;
        let Some(face) = self.session.face() else { return Ok(Vec::new()) };
        let rows = face.rows();
        let latest = &rows[rows.len().saturating_sub(most as usize)..];
        let entry = |row| StudioEntry::of(row, face.label(row.target, language));
        Ok(latest.iter().map(entry).collect())
    }

    /// Every region that can be moved as one, from the forehead down.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn regions(&self, language: LanguageName) -> Result<Vec<NamedRegion>, JsValue> {
        let language = language.language()?;
        let named =
            |region: Region| NamedRegion { id: region.id().to_owned(), label: region.name(language).to_owned() };
        Ok(Region::ALL.map(named).to_vec())
    }

    /// Every ready-made slider, in the order of the state's values.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = faceSliders)]
    pub fn face_sliders(&self, language: LanguageName) -> Result<Vec<NamedSlider>, JsValue> {
        let language = language.language()?;
        let named = |slider: FaceSlider| NamedSlider {
            id: slider.id().to_owned(),
            label: slider.name(language).to_owned(),
            range_mm: slider.range_m() * 1000.0,
        };
        Ok(FaceSlider::ALL.map(named).to_vec())
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
