use rosto_export::{BaseColour, ExportOption, Eyes, Format, Material, PLA_G_PER_CM3, SOLID_MM, SolidFacts, Units};
use rosto_session::{EditsAs, ExpressionsAs, FileOptions};
use rosto_stage::Background;
use rosto_studio::SMOOTH_DENSITY;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::Studio;
use crate::error::FacadeError;
use crate::readable::readable;
use crate::state::Snapshot;

/// Options of exported files. `free()` it after use.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct StudioFileOptions(FileOptions);

#[wasm_bindgen]
impl StudioFileOptions {
    /// Creates the default options.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets an option by ids: "base-colour" ("whole", "photo", "colours"), "material" ("lit", "unlit"), "edits" and
    /// "expressions" ("shape", "morph-targets"), "eyes" ("skin", "pieces"), "units" ("mm", "image"), "solid"
    /// ("thickness:MM", "flat:MM", "surface").
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn choose(&mut self, what: &str, id: &str) -> Result<(), JsValue> {
        let Self(options) = self;
        match what {
            "base-colour" => options.base_colour = FacadeError::require(BaseColour::from_id(id))?,
            "material" => options.material = FacadeError::require(Material::from_id(id))?,
            "edits" => options.edits = FacadeError::require(EditsAs::from_id(id))?,
            "expressions" => options.expressions = FacadeError::require(ExpressionsAs::from_id(id))?,
            "eyes" => options.eyes = FacadeError::require(Eyes::from_id(id))?,
            "units" => options.units = FacadeError::require(Units::from_id(id))?,
            "solid" => options.solid = FacadeError::require(id.parse().ok())?,
            _ => FacadeError::require(None)?,
        }
        Ok(())
    }
}

readable! {
    /// Measures of a body for printing.
    pub struct PrintedBody {
        /// Enclosed volume, in cm³.
        volume_cm3 as volumeCm3: f64,
        /// Sides of the bounding box, in mm: x, y, z.
        size_mm as sizeMm: Vec<f64>,
        /// Smallest wall thickness, in mm.
        thinnest_mm as thinnestMm: f64,
        /// Distance by which sharp folds were rounded to make room for the wall, in mm; 0 if none were.
        moved_mm as movedMm: f64,
        /// Mass in g if printed solid in PLA.
        pla_grams as plaGrams: f64,
    }
}

impl From<SolidFacts> for PrintedBody {
    fn from(facts: SolidFacts) -> Self {
        let SolidFacts { volume_cm3, size_mm, thinnest_mm, moved_mm } = facts;
        let pla_grams = facts.mass_g(PLA_G_PER_CM3);
        Self { volume_cm3, size_mm: size_mm.to_array().to_vec(), thinnest_mm, moved_mm, pla_grams }
    }
}

/// Default density.
#[wasm_bindgen(js_name = defaultDensity)]
pub fn default_density() -> u32 {
    SMOOTH_DENSITY
}

/// Range of the thickness of the wall or back of a printed body: minimum and maximum, in mm.
#[wasm_bindgen(js_name = solidRangeMm)]
pub fn solid_range_mm() -> Vec<f64> {
    SOLID_MM.to_vec()
}

/// File export.
#[wasm_bindgen]
impl Studio {
    /// Ids of the formats for 3D printing.
    #[wasm_bindgen(getter, js_name = printedFormats)]
    pub fn printed_formats(&self) -> Vec<String> {
        rosto_session::printed_formats().map(|format| format.id().to_owned()).collect()
    }

    /// Ids of the formats without format-specific options, each offered as a plain button.
    #[wasm_bindgen(getter, js_name = plainFormats)]
    pub fn plain_formats(&self) -> Vec<String> {
        rosto_session::plain_formats().map(|format| format.id().to_owned()).collect()
    }

    /// Whether a format supports a choice of the base colour.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = isPainted)]
    pub fn is_painted(&self, format: &str) -> Result<bool, JsValue> {
        Ok(FacadeError::require(Format::from_id(format))?.supports(ExportOption::BaseColour))
    }

    /// Media type of a format's files.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = mediaType)]
    pub fn media_type(&self, format: &str) -> Result<String, JsValue> {
        Ok(FacadeError::require(Format::from_id(format))?.media_type().to_owned())
    }

    /// Extension of a format's file: the format's own, or "zip" if there are companion files.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = fileEnding)]
    pub fn file_ending(&self, format: &str, options: &StudioFileOptions) -> Result<String, JsValue> {
        let format = FacadeError::require(Format::from_id(format))?;
        Ok(format.bundle_extension(options.0.base_colour).to_owned())
    }

    /// Exports the face at the displayed density. A glTF stores the project in the scene's extras. A format uses the
    /// options that it supports. Companion files are included by returning a zip archive.
    ///
    /// # Errors
    /// `no-face`, `bad-choice`, `too-thick`, `no-body`, `surface-alone` or `cannot-export`.
    #[wasm_bindgen(js_name = exportFile)]
    pub fn export_file(&mut self, format: &str, options: &StudioFileOptions) -> Result<Vec<u8>, JsValue> {
        let format = FacadeError::require(Format::from_id(format))?;
        Ok(self.session.bundled_file(format, &options.0).map_err(FacadeError::from)?)
    }

    /// Numbers of points and triangles that an exported mesh will have.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = meshCounts)]
    pub fn mesh_counts(&self, format: &str, options: &StudioFileOptions) -> Result<Vec<u32>, JsValue> {
        let format = FacadeError::require(Format::from_id(format))?;
        let counts = self.session.mesh_counts(format, &options.0).map_err(FacadeError::from)?;
        Ok(counts.map(|count| count as u32).to_vec())
    }

    /// Measures of the body for printing, before it is saved; undefined if only the surface is exported.
    ///
    /// # Errors
    /// `no-face`, `too-thick` or `no-body`.
    #[wasm_bindgen(js_name = solidFacts)]
    pub fn solid_facts(&self, options: &StudioFileOptions) -> Result<Option<PrintedBody>, JsValue> {
        Ok(self.session.solid_facts(options.0.solid).map_err(FacadeError::from)?.map(PrintedBody::from))
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
        Ok(future_to_promise(async move { Ok(Snapshot::from(picture.await.map_err(FacadeError::from)?).into()) }))
    }

    /// Writes the project file: landmarks, edits, and the photo as the given PNG.
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
