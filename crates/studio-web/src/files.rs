use rosto_export::{BaseColour, Choosable, Format, Material};
use rosto_session::{EditsAs, FileOptions, Units};
use rosto_stage::Background;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::error::FacadeError;
use crate::state::Snapshot;

/// What leaves the page.
#[wasm_bindgen]
impl Studio {
    /// The formats about which there is nothing to choose, by their ids.
    #[wasm_bindgen(getter, js_name = plainFormats)]
    pub fn plain_formats(&self) -> Vec<String> {
        let plain = Format::ALL.into_iter().filter(|format| format.choosable() == Choosable::Nothing);
        plain.map(|format| format.id().to_owned()).collect()
    }

    /// The media type of a format's files.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = mediaType)]
    pub fn media_type(&self, format: &str) -> Result<String, JsValue> {
        Ok(FacadeError::unless(Format::from_id(format))?.media_type().to_owned())
    }

    /// The face as a file, at the density that is shown; a glTF with what opens it again in the scene's extras. Each format
    /// takes what it has a place for: the base colour ("texture" or "colours"), the material ("lit" or "unlit"), how it
    /// carries the edits ("shape" or "morph-targets"), the unit of JSON's positions ("mm" or "image").
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `cannot-export`.
    #[wasm_bindgen(js_name = exportFile)]
    pub fn export_file(
        &mut self,
        format: &str,
        #[wasm_bindgen(js_name = baseColour)] base_colour: &str,
        material: &str,
        edits: &str,
        units: &str,
    ) -> Result<Vec<u8>, JsValue> {
        let options = FileOptions {
            base_colour: FacadeError::unless(BaseColour::from_id(base_colour))?,
            material: FacadeError::unless(Material::from_id(material))?,
            edits: FacadeError::unless(EditsAs::from_id(edits))?,
            units: FacadeError::unless(Units::from_id(units))?,
        };
        let format = FacadeError::unless(Format::from_id(format))?;
        Ok(self.session.file(format, &options).map_err(FacadeError::from)?)
    }

    /// A picture of the face in any size, as it is seen but for marks and tools; transparent where there is no face, if asked so.
    ///
    /// # Errors
    /// `device-lost` at once, `not-drawn` later.
    #[wasm_bindgen(unchecked_return_type = "Promise<Snapshot>")]
    pub fn snapshot(
        &mut self,
        #[wasm_bindgen(js_name = widthPx)] width_px: u32,
        #[wasm_bindgen(js_name = heightPx)] height_px: u32,
        transparent: bool,
    ) -> Result<js_sys::Promise, JsValue> {
        let background = if transparent { Background::Transparent } else { self.session.view().background };
        let picture = self.viewport.snapshot(&self.session.stage().without_tools(), [width_px, height_px], background);
        self.session.stage_mut().ask_for_a_frame();
        let picture = picture.map_err(FacadeError::from)?;
        Ok(future_to_promise(async move { Ok(Snapshot::from(picture.await.map_err(FacadeError::from)?).into()) }))
    }

    /// The project file: landmarks, edits, and the photo as the PNG that is given.
    ///
    /// # Errors
    /// `no-face` or `cannot-export`.
    #[wasm_bindgen(js_name = projectFile)]
    pub fn project_file(&self, png: &[u8]) -> Result<Vec<u8>, JsValue> {
        Ok(self.session.project(png).map_err(FacadeError::from)?)
    }

    /// The edits as versioned JSON.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = editsJson)]
    pub fn edits_json(&self) -> Result<String, JsValue> {
        Ok(self.face()?.history_json())
    }
}
