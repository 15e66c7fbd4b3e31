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

/// What is chosen about files, as it is until somebody chooses otherwise. `free()` it after use.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct FileChoices(FileOptions);

#[wasm_bindgen]
impl FileChoices {
    /// What is usual.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Chooses one thing by ids: "base-colour" ("whole", "photo", "colours"),
    /// "material" ("lit", "unlit"), "edits" and "expressions" ("shape", "morph-targets"), "eyes" ("skin", "pieces"),
    /// "units" ("mm", "image"), "solid" ("thickness:MM", "flat:MM", "surface").
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn choose(&mut self, what: &str, id: &str) -> Result<(), JsValue> {
        let Self(options) = self;
        match what {
            "base-colour" => options.base_colour = FacadeError::unless(BaseColour::from_id(id))?,
            "material" => options.material = FacadeError::unless(Material::from_id(id))?,
            "edits" => options.edits = FacadeError::unless(EditsAs::from_id(id))?,
            "expressions" => options.expressions = FacadeError::unless(ExpressionsAs::from_id(id))?,
            "eyes" => options.eyes = FacadeError::unless(Eyes::from_id(id))?,
            "units" => options.units = FacadeError::unless(Units::from_id(id))?,
            "solid" => options.solid = FacadeError::unless(id.parse().ok())?,
            _ => FacadeError::unless(None)?,
        }
        Ok(())
    }
}

readable! {
    /// What a printed body measures.
    pub struct PrintedBody {
        /// What it encloses, in cm³.
        volume_cm3 as volumeCm3: f64,
        /// The sides of the box around it, in mm: x, y, z.
        size_mm as sizeMm: Vec<f64>,
        /// How thick its wall is where it is thinnest, in mm.
        thinnest_mm as thinnestMm: f64,
        /// How far sharp folds that left no room for the wall were rounded off, in mm; 0 where none did.
        moved_mm as movedMm: f64,
        /// What it weighs in g if it is filled with PLA.
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

/// How often a mesh is subdivided unless somebody chooses otherwise.
#[wasm_bindgen(js_name = usualDensity)]
pub fn usual_density() -> u32 {
    SMOOTH_DENSITY
}

/// What the wall or the back of a printed body may measure in mm: the least and the most.
#[wasm_bindgen(js_name = solidRangeMm)]
pub fn solid_range_mm() -> Vec<f64> {
    SOLID_MM.to_vec()
}

/// What leaves the page.
#[wasm_bindgen]
impl Studio {
    /// The formats that are for printing, by their ids.
    #[wasm_bindgen(getter, js_name = printedFormats)]
    pub fn printed_formats(&self) -> Vec<String> {
        rosto_session::printed_formats().map(|format| format.id().to_owned()).collect()
    }

    /// The formats that have no choices of their own, by their ids: a button does for each.
    #[wasm_bindgen(getter, js_name = plainFormats)]
    pub fn plain_formats(&self) -> Vec<String> {
        rosto_session::plain_formats().map(|format| format.id().to_owned()).collect()
    }

    /// Whether a format has a place for what paints the face.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = isPainted)]
    pub fn is_painted(&self, format: &str) -> Result<bool, JsValue> {
        Ok(FacadeError::unless(Format::from_id(format))?.supports(ExportOption::BaseColour))
    }

    /// The media type of a format's files.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = mediaType)]
    pub fn media_type(&self, format: &str) -> Result<String, JsValue> {
        Ok(FacadeError::unless(Format::from_id(format))?.media_type().to_owned())
    }

    /// How the name of a format's file ends: as the format is called, or "zip" where there are several files.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = fileEnding)]
    pub fn file_ending(&self, format: &str, choices: &FileChoices) -> Result<String, JsValue> {
        let format = FacadeError::unless(Format::from_id(format))?;
        Ok(format.bundle_extension(choices.0.base_colour).to_owned())
    }

    /// The face as a file, at the density that is shown; a glTF with what opens it again in the scene's extras. Each format
    /// takes of the choices what it has a place for. Where there are several files it is a zip archive of them all.
    ///
    /// # Errors
    /// `no-face`, `bad-choice`, `too-thick`, `no-body`, `surface-alone` or `cannot-export`.
    #[wasm_bindgen(js_name = exportFile)]
    pub fn export_file(&mut self, format: &str, choices: &FileChoices) -> Result<Vec<u8>, JsValue> {
        let format = FacadeError::unless(Format::from_id(format))?;
        Ok(self.session.bundled_file(format, &choices.0).map_err(FacadeError::from)?)
    }

    /// How many points and triangles the mesh in a file has, before it is saved.
    ///
    /// # Errors
    /// `no-face` or `bad-choice`.
    #[wasm_bindgen(js_name = meshCounts)]
    pub fn mesh_counts(&self, format: &str, choices: &FileChoices) -> Result<Vec<u32>, JsValue> {
        let format = FacadeError::unless(Format::from_id(format))?;
        let counts = self.session.mesh_counts(format, &choices.0).map_err(FacadeError::from)?;
        Ok(counts.map(|count| count as u32).to_vec())
    }

    /// What the body for printing measures, before it is saved; undefined of the surface alone.
    ///
    /// # Errors
    /// `no-face`, `too-thick` or `no-body`.
    #[wasm_bindgen(js_name = solidFacts)]
    pub fn solid_facts(&self, choices: &FileChoices) -> Result<Option<PrintedBody>, JsValue> {
        Ok(self.session.solid_facts(choices.0.solid).map_err(FacadeError::from)?.map(PrintedBody::from))
    }

    /// A picture of the face in any size, as it is seen but for marks and tools; transparent where there is no face, if asked so.
    ///
    /// # Errors
    /// `device-lost` at once; `no-memory` or `not-drawn` later.
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
