use rosto_export::{BaseColour, GlbOptions, Material, obj, ply, stl};
use rosto_session::{EditsAs, Units};
use rosto_stage::Background;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::{ExportEditsName, ExportPaintName, ExportShadingName, MeshFormatName, UnitsName};
use crate::state::Snapshot;

/// What leaves the page.
#[wasm_bindgen]
impl Studio {
    /// The mesh as JSON, as the command line writes it.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = meshJson)]
    pub fn mesh_json(&self, units: UnitsName) -> Result<String, JsValue> {
        let units = match units {
            UnitsName::Image => Units::Image,
            UnitsName::Millimetres => Units::Millimetres,
            _ => return Err(FacadeError::bad_choice().into()),
        };
        Ok(self.session.mesh_json(units).map_err(FacadeError::from)?)
    }

    /// The face as a binary glTF file, at the density that is shown, with what opens it again in the scene's extras.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `cannot-export`.
    #[wasm_bindgen(js_name = exportGlb)]
    pub fn export_glb(
        &mut self,
        paint: ExportPaintName,
        shading: ExportShadingName,
        edits: ExportEditsName,
    ) -> Result<Vec<u8>, JsValue> {
        let paint = match paint {
            ExportPaintName::Texture => BaseColour::Texture,
            ExportPaintName::VertexColours => BaseColour::VertexColours,
            _ => return Err(FacadeError::bad_choice().into()),
        };
        let shading = match shading {
            ExportShadingName::Lit => Material::Lit,
            ExportShadingName::Unlit => Material::Unlit,
            _ => return Err(FacadeError::bad_choice().into()),
        };
        let edits = match edits {
            ExportEditsName::Shape => EditsAs::Shape,
            ExportEditsName::MorphTargets => EditsAs::MorphTargets,
            _ => return Err(FacadeError::bad_choice().into()),
        };
        Ok(self
            .session
            .glb(GlbOptions { base_colour: paint, material: shading, ..GlbOptions::default() }, edits)
            .map_err(FacadeError::from)?)
    }

    /// The face, at the density that is shown, as a file of another kind.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `cannot-export`.
    #[wasm_bindgen(js_name = exportMesh)]
    pub fn export_mesh(&self, format: MeshFormatName) -> Result<Vec<u8>, JsValue> {
        let bytes = self.session.with_model(|model| match format {
            MeshFormatName::Obj => Ok(Some(obj(&model)?.into_bytes())),
            MeshFormatName::Ply => Ok(Some(ply(&model)?)),
            MeshFormatName::Stl => Ok(Some(stl(&model)?)),
            _ => Ok(None),
        });
        Ok(bytes.map_err(FacadeError::from)?.ok_or_else(FacadeError::bad_choice)?)
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
        let background = if transparent { Background::Transparent } else { self.session.view().background };
        let picture = self.viewport.snapshot(self.session.stage(), [width_px, height_px], background);
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
