use rosto_face::{LANDMARK_COUNT, Language, Region, landmark_name};
use rosto_studio::FaceSlider;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::hand::{Selection, subject_label};
use crate::modes::LanguageName;
use crate::state::{NamedRegion, NamedSlider};
use crate::trouble::{Outcome, Trouble};

/// What things are called.
#[wasm_bindgen]
impl Studio {
    /// What a landmark is called, with or without an open face.
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = landmarkName)]
    pub fn landmark_name(&self, vertex: u32, language: LanguageName) -> Result<String, JsValue> {
        Ok(landmark_name(known(vertex)?, language.language()?))
    }

    /// What a landmark is called on the page, with its number, such as "nose tip · 1".
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = landmarkLabel)]
    pub fn landmark_label(&self, vertex: u32, language: LanguageName) -> Result<String, JsValue> {
        Ok(landmark_label(known(vertex)?, language.language()?))
    }

    /// What the landmark or region in hand is called; undefined where there is none.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = selectionName)]
    pub fn selection_name(&self, language: LanguageName) -> Result<Option<String>, JsValue> {
        let language = language.language()?;
        let selection = self.session.as_ref().and_then(|session| session.selection());
        Ok(selection.map(|selection| subject_label(selection.subject(), language)))
    }

    /// What a drag that starts at a landmark moves: what is in hand, if the landmark is part of it, or what is taken there.
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = nameAt)]
    pub fn name_at(&self, landmark: u32, language: LanguageName) -> Result<String, JsValue> {
        let landmark = known(landmark)?;
        let selection = self.session.as_ref().map(|session| session.at_or_held(landmark, self.hand));
        let subject = selection.unwrap_or(Selection::Landmark(landmark)).subject();
        Ok(subject_label(subject, language.language()?))
    }

    /// What an entry of the history works on.
    ///
    /// # Errors
    /// `no-face`, `bad-number` or `bad-choice`.
    #[wasm_bindgen(js_name = entryName)]
    pub fn entry_name(&self, index: u32, language: LanguageName) -> Result<String, JsValue> {
        let subject = self.session()?.subject_of(index as usize)?;
        Ok(subject_label(subject, language.language()?))
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
}

/// The name with the number, once.
pub(crate) fn landmark_label(landmark: u32, language: Language) -> String {
    let name = landmark_name(landmark, language);
    // Landmarks without a name of their own bring their number along.
    let bare = name.strip_suffix(&format!(" {landmark}")).unwrap_or(&name);
    format!("{bare} · {landmark}")
}

fn known(vertex: u32) -> Outcome<u32> {
    if vertex as usize >= LANDMARK_COUNT {
        return Err(Trouble::bad_vertex(vertex, LANDMARK_COUNT));
    }
    Ok(vertex)
}
