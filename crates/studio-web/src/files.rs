use rosto_export::{GlbOptions, JsonMesh, Model, Paint, Source, glb, mesh_json};
use rosto_viewport::Background;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::modes::{ExportPaintName, UnitsName};
use crate::state::Snapshot;
use crate::trouble::{Outcome, Trouble};

/// What leaves the page and comes back.
#[wasm_bindgen]
impl Studio {
    /// The mesh as JSON, as the command line writes it.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = meshJson)]
    pub fn mesh_json(&self, units: UnitsName) -> Result<String, JsValue> {
        let session = self.session()?;
        let (units, positions) = match units {
            UnitsName::Image => ("image", session.positions_image()),
            UnitsName::Millimetres => ("mm", session.positions_mm()),
            _ => return Err(Trouble::bad_choice().into()),
        };
        Ok(mesh_json(&JsonMesh {
            units,
            positions: &positions,
            colours_srgb: &session.colours_srgb(&session.uvs()),
            triangles: session.document.topology().triangles(),
        }))
    }

    /// The face as a binary glTF file, with its edits in the scene's extras.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `cannot-export`.
    #[wasm_bindgen(js_name = exportGlb)]
    pub fn export_glb(&self, paint: ExportPaintName) -> Result<Vec<u8>, JsValue> {
        let paint = match paint {
            ExportPaintName::Texture => Paint::Texture,
            ExportPaintName::VertexColours => Paint::VertexColours,
            _ => return Err(Trouble::bad_choice().into()),
        };
        Ok(self.glb(paint)?)
    }

    /// A picture of the view in any size; transparent where there is no face, if asked so.
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
        let background = if transparent { Background::Transparent } else { Background::Ground };
        let picture = self.viewport.snapshot([width_px, height_px], background).map_err(Trouble::from)?;
        Ok(future_to_promise(async move { Ok(Snapshot::from(picture.await.map_err(Trouble::from)?).into()) }))
    }

    /// The edits as versioned JSON.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = editsJson)]
    pub fn edits_json(&self) -> Result<String, JsValue> {
        Ok(self.session()?.edits_json())
    }

    /// Puts edits from such a text in place of those there are.
    ///
    /// # Errors
    /// `no-face`, `bad-project`, `bad-vertex` or `cannot-solve`; the edits stay as they were.
    #[wasm_bindgen(js_name = openEdits)]
    pub fn open_edits(&mut self, json: &str) -> Result<(), JsValue> {
        let (session, choices) = self.session_mut()?;
        session.open_edits(json, choices)?;
        Ok(self.show_shape()?)
    }
}

impl Studio {
    fn glb(&self, paint: Paint) -> Outcome<Vec<u8>> {
        let session = self.session()?;
        let document = &session.document;
        let uvs = session.uvs();
        let model = Model {
            topology: document.topology(),
            positions_m: document.positions(),
            colours_srgb: &session.colours_srgb(&uvs),
            uvs: &uvs,
            picture: session.face.picture(),
        };
        let edits = session.edits_json();
        let history = (!document.history().entries().is_empty()).then_some(edits.as_str());
        let source = Some(Source {
            face: &session.face,
            triangulation: session.triangulation(),
            density: document.density(),
            history,
        });
        Ok(glb(&model, &GlbOptions { paint, source, ..GlbOptions::default() })?)
    }
}
