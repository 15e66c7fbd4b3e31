use rosto_stage::Background;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::error::FacadeError;
use crate::sent::sent;
use crate::snapshot::Snapshot;

/// Facts for files, and pictures of the view.
#[wasm_bindgen]
impl Studio {
    /// Options of exported files, as the worker's `FileOptions` has them.
    #[wasm_bindgen(js_name = fileOptions, unchecked_return_type = "Record<string, string>")]
    pub fn file_options(&self) -> js_sys::Object {
        let entries = self.session.file_options().into_iter();
        let entries: js_sys::Array = entries.map(|(id, value)| js_sys::Array::of2(&id.into(), &value.into())).collect();
        js_sys::Object::from_entries(&entries).unwrap_or_default()
    }

    /// Name of an exported mesh, with the number of its points unless it has the default density.
    #[wasm_bindgen(js_name = fileName)]
    pub fn file_name(&self, extension: &str) -> String {
        self.session.file_name(extension)
    }

    /// Whether the panel asks for pictures with a transparent background.
    #[wasm_bindgen(getter, js_name = isTransparent)]
    pub fn is_transparent(&self) -> bool {
        self.session.is_transparent()
    }

    /// Renders a picture of the view in any size, without marks and tools, optionally with a transparent background.
    ///
    /// # Errors
    /// Throws `device-lost`; the promise rejects with `no-memory` or `not-drawn`.
    #[wasm_bindgen(unchecked_return_type = "Promise<Snapshot>")]
    pub fn snapshot(
        &mut self,
        #[wasm_bindgen(js_name = widthPx)] width_px: u32,
        #[wasm_bindgen(js_name = heightPx)] height_px: u32,
        transparent: bool,
    ) -> Result<js_sys::Promise, JsValue> {
        let background = if transparent { Background::Transparent } else { self.session.view().background };
        let picture = self.viewport.snapshot(&self.session.stage().without_tools(), [width_px, height_px], background);
        self.session.stage_mut().request_frame();
        let picture = picture.map_err(FacadeError::from)?;
        Ok(future_to_promise(async move {
            let snapshot = Snapshot::from(picture.await.map_err(FacadeError::from)?);
            Ok(sent(&snapshot)?.into())
        }))
    }
}
