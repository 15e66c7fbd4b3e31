use pyo3::prelude::*;
use pyo3::types::PyString;
use rosto::{
    AnchorKind, Details, ExportOption, FileOptions, MeshRequest, Mirror, Operator, PhotoLens, RegionOfInfluence,
    Settings, Triangulation, Units, anchor_rule, card_px, constraint,
};

use crate::edits::{M_PER_MM, chosen};
use crate::error::refused;

const CM_PER_M: f64 = 100.0;

/// Names and values of options. Values are `bool`, `int`, `float`, `str`, or a list of these.
pub type Named<'py> = Vec<(String, Bound<'py, PyAny>)>;

/// Options of a mesh and of its files.
pub struct Options {
    /// The request without photos and edits.
    pub request: MeshRequest,
    pub settings: Settings,
    pub lens: Option<PhotoLens>,
    /// Corners of a card in px.
    pub card_px: Option<[[f64; 2]; 4]>,
    pub file: OptionsOfFile,
    seed: u64,
}

/// Options of a file.
#[derive(Default, Clone)]
pub struct OptionsOfFile {
    pub values: FileOptions,
    /// The options that were given.
    pub given: Vec<ExportOption>,
}

impl Options {
    pub fn new(named: Named<'_>) -> PyResult<Self> {
        let mut settings = Settings::default();
        settings.anchors.kind = AnchorKind::Random { seed: 0 };
        let (request, file) = (MeshRequest::of(Vec::new()), OptionsOfFile::default());
        let mut options = Self { request, settings, lens: None, card_px: None, file, seed: 0 };
        named.iter().try_for_each(|(name, value)| options.set(name, value))?;
        if let AnchorKind::Random { seed } = &mut options.settings.anchors.kind {
            *seed = options.seed;
        }
        Ok(options)
    }

    fn set(&mut self, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let settings = &mut self.settings;
        match name {
            "topology" => {
                self.request.triangulation = chosen("topology", &text(value)?, Triangulation::ALL, Triangulation::id)?;
            }
            "density" => self.request.density = whole(name, value)?.try_into().unwrap_or(u32::MAX),
            "distance" => self.lens = Some(PhotoLens::Distance(number(name, value)? / CM_PER_M)),
            "focal_35mm" => self.lens = Some(PhotoLens::Given(number(name, value)?)),
            "card_px" => self.card_px = Some(card_px(&text(value)?).map_err(refused)?),
            "operator" => settings.operator = chosen("operator", &text(value)?, Operator::ALL, Operator::id)?,
            "constraint" => settings.constraint = constraint(&text(value)?).map_err(refused)?,
            "anchors" => {
                settings.anchors.kind = match anchor_rule(&text(value)?).map_err(refused)? {
                    AnchorKind::Outside { radius } => AnchorKind::Outside { radius: radius * M_PER_MM },
                    kind => kind,
                }
            }
            "seed" => self.seed = whole(name, value)?,
            "pin" => settings.anchors.pins = vertices(name, value)?,
            "radius" => {
                settings.influence = match number(name, value)? {
                    radius if radius > 0.0 => RegionOfInfluence::Within { radius: radius * M_PER_MM },
                    radius => return Err(refused(format!("radius: {radius} is not positive"))),
                }
            }
            "mirror" => settings.mirror = if flag(name, value)? { Mirror::On } else { Mirror::Off },
            "turn_details" => {
                settings.details = if flag(name, value)? { Details::AsRigidAsPossible } else { Details::Kept };
            }
            _ => return self.file.set(name, value),
        }
        Ok(())
    }
}

impl OptionsOfFile {
    /// These options and further ones.
    pub fn with(&self, named: Named<'_>) -> PyResult<Self> {
        let mut options = self.clone();
        named.iter().try_for_each(|(name, value)| options.set(name, value))?;
        Ok(options)
    }

    fn set(&mut self, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let of_flag = |is_on| if is_on { "morph-targets" } else { "shape" }.to_owned();
        let (option, text) = match name {
            "morph_targets" => (ExportOption::Edits, of_flag(flag(name, value)?)),
            "expressions" => (ExportOption::Expressions, of_flag(flag(name, value)?)),
            _ => (ExportOption::from_id(&name.replace('_', "-")).ok_or_else(|| unknown(name))?, text(value)?),
        };
        self.values.set(option, &text).map_err(refused)?;
        if self.values.units == Units::Image {
            return Err(refused("units: image coordinates are only on the command line; use \"mm\""));
        }
        self.given.push(option);
        Ok(())
    }
}

fn unknown(name: &str) -> PyErr {
    refused(format!("{name}: there is no such option here; `rosto mesh --help` lists them, with - for _"))
}

/// A text, or a number as text.
fn text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    match value.cast::<PyString>() {
        Ok(text) => Ok(text.to_str()?.to_owned()),
        Err(_) => Ok(value.extract::<f64>().map_err(refused)?.to_string()),
    }
}

fn number(name: &str, value: &Bound<'_, PyAny>) -> PyResult<f64> {
    value.extract().map_err(|_| refused(format!("{name}: {value} is not a number")))
}

fn whole(name: &str, value: &Bound<'_, PyAny>) -> PyResult<u64> {
    let fraction = || value.extract::<f64>().ok().filter(|number| *number >= 0.0 && number.fract() == 0.0);
    let found = value.extract::<u64>().ok().or_else(|| fraction().map(|number| number as u64));
    found.ok_or_else(|| refused(format!("{name}: {value} is not a whole number")))
}

fn vertices(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<u32>> {
    let each = |value: &Bound<'_, PyAny>| Ok(u32::try_from(whole(name, value)?).unwrap_or(u32::MAX));
    match value.try_iter() {
        Ok(values) => values.map(|value| each(&value?)).collect(),
        Err(_) => Ok(vec![each(value)?]),
    }
}

fn flag(name: &str, value: &Bound<'_, PyAny>) -> PyResult<bool> {
    value.extract().map_err(|_| refused(format!("{name}: {value} is not True or False")))
}
