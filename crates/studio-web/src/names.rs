use rosto_face::{LANDMARK_COUNT, Language, Region, landmark_name};
use rosto_studio::FaceSlider;
use wasm_bindgen::prelude::*;

use crate::Studio;
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

    /// The name of what is in hand; undefined where there is nothing.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = selectionName)]
    pub fn selection_name(&self, language: LanguageName) -> Result<Option<String>, JsValue> {
        let language = language.language()?;
        let Some(session) = &self.session else { return Ok(None) };
        Ok(session.selection().map(|selection| session.label(selection.subject(), language)))
    }

    /// What a drag that starts at a vertex moves: what is in hand, if the vertex is part of it, or what is taken there.
    ///
    /// # Errors
    /// `bad-vertex` or `bad-choice`.
    #[wasm_bindgen(js_name = nameAt)]
    pub fn name_at(&self, vertex: u32, language: LanguageName) -> Result<String, JsValue> {
        let language = language.language()?;
        let Some(session) = &self.session else { return Ok(landmark_label(known(vertex)?, language)) };
        let selection = session.at_or_held(session.known(vertex, self.hand)?, self.hand);
        Ok(session.label(selection.subject(), language))
    }

    /// The vertex that is meant by a number, or the landmark that is meant by its name, in any case of its letters;
    /// undefined where there is none that could be taken in hand.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = vertexCalled)]
    pub fn vertex_called(&self, text: &str, language: LanguageName) -> Result<Option<u32>, JsValue> {
        let language = language.language()?;
        if let Ok(vertex) = text.trim().parse::<u32>() {
            let count = self.session.as_ref().map_or(LANDMARK_COUNT, |session| session.within_reach(self.hand));
            return Ok(Some(vertex).filter(|&vertex| (vertex as usize) < count));
        }
        let wanted = text.trim().to_lowercase();
        let ways = |landmark: u32| [landmark_name(landmark, language), landmark_label(landmark, language)];
        Ok((0..LANDMARK_COUNT as u32).find(|&landmark| ways(landmark).iter().any(|way| way.to_lowercase() == wanted)))
    }

    /// What an entry of the history works on.
    ///
    /// # Errors
    /// `no-face`, `bad-number` or `bad-choice`.
    #[wasm_bindgen(js_name = entryName)]
    pub fn entry_name(&self, index: u32, language: LanguageName) -> Result<String, JsValue> {
        let session = self.session()?;
        Ok(session.label(session.subject_of(index as usize)?, language.language()?))
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
