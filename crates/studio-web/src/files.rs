use rosto_export::{GlbOptions, JsonMesh, Model, Morph, Paint, Shading, Source, glb, mesh_json, obj, ply, stl};
use rosto_viewport::Background;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::modes::{ExportEditsName, ExportPaintName, ExportShadingName, MeshFormatName, UnitsName};
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

    /// The face as a binary glTF file, at the density that is shown, with what opens it again in the scene's extras.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `cannot-export`.
    #[wasm_bindgen(js_name = exportGlb)]
    pub fn export_glb(
        &self,
        paint: ExportPaintName,
        shading: ExportShadingName,
        edits: ExportEditsName,
    ) -> Result<Vec<u8>, JsValue> {
        let paint = match paint {
            ExportPaintName::Texture => Paint::Texture,
            ExportPaintName::VertexColours => Paint::VertexColours,
            _ => return Err(Trouble::bad_choice().into()),
        };
        let shading = match shading {
            ExportShadingName::Lit => Shading::Lit,
            ExportShadingName::Unlit => Shading::Unlit,
            _ => return Err(Trouble::bad_choice().into()),
        };
        let options = GlbOptions { paint, shading, ..GlbOptions::default() };
        match edits {
            ExportEditsName::Shape => Ok(self.glb(options)?),
            ExportEditsName::MorphTargets => Ok(self.glb_with_morph_targets(options)?),
            _ => Err(Trouble::bad_choice().into()),
        }
    }

    /// The face, at the density that is shown, as a file of another kind.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `cannot-export`.
    #[wasm_bindgen(js_name = exportMesh)]
    pub fn export_mesh(&self, format: MeshFormatName) -> Result<Vec<u8>, JsValue> {
        let bytes = self.with_model(|model| match format {
            MeshFormatName::Obj => Ok(obj(&model)?.into_bytes()),
            MeshFormatName::Ply => Ok(ply(&model)?),
            MeshFormatName::Stl => Ok(stl(&model)?),
            _ => Err(Trouble::bad_choice()),
        });
        Ok(bytes?)
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
        let background = if transparent { Background::Transparent } else { self.wishes.background };
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
    /// The edited face.
    fn glb(&self, options: GlbOptions<'_>) -> Outcome<Vec<u8>> {
        let edits = self.session()?.edits_json();
        let source = Some(self.source(&edits)?);
        self.with_model(|model| Ok(glb(&model, &GlbOptions { source, ..options })?))
    }

    /// The unedited face, with each edit beside it.
    fn glb_with_morph_targets(&self, options: GlbOptions<'_>) -> Outcome<Vec<u8>> {
        let session = self.session()?;
        let document = &session.document;
        let edits = session.edits_json();
        let source = Some(self.source(&edits)?);
        let layers = document.displacements();
        let named = document.history().entries().iter().zip(&layers);
        let morphs: Vec<Morph<'_>> =
            named.map(|(entry, layer)| Morph { name: &entry.label, displacements_m: layer, weight: 1.0 }).collect();
        self.with_model(|model| {
            let options = GlbOptions { source, morphs: &morphs, ..options };
            Ok(glb(&model.at(document.rest()), &options)?)
        })
    }

    /// What opens a file again.
    fn source<'a>(&'a self, edits: &'a str) -> Outcome<Source<'a>> {
        let session = self.session()?;
        let document = &session.document;
        let history = (!document.history().entries().is_empty()).then_some(edits);
        let (triangulation, density) = (session.triangulation(), document.density());
        Ok(Source { face: &session.face, triangulation, density, history })
    }

    /// Does something with the mesh that is shown.
    fn with_model<T>(&self, act: impl FnOnce(Model<'_>) -> Outcome<T>) -> Outcome<T> {
        let session = self.session()?;
        let uvs = session.uvs();
        act(Model {
            topology: session.document.topology(),
            positions_m: session.document.positions(),
            colours_srgb: &session.colours_srgb(&uvs),
            uvs: &uvs,
            picture: session.face.picture(),
        })
    }
}
