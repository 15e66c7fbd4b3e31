use glam::DVec2;
use rosto_face::DISTANCES_M;
use rosto_warp::Dab;
use serde_json::{Value, json};

use crate::Error;

/// Maximum number of dabs that protect a photo.
pub const MAX_DABS: usize = 20_000;

/// Edits of a photo alone: the distance from which it is shown, and the strokes that protect parts of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PhotoEdit {
    /// Distance in metres; `None` is the original one.
    pub seen_from_m: Option<f64>,
    /// Strokes, each as dabs in px of the upright photo.
    pub strokes: Vec<Vec<Dab>>,
}

impl PhotoEdit {
    /// The edits as text, for [`SavedEdits::photo_edit`](crate::SavedEdits::photo_edit).
    pub fn to_json(&self) -> String {
        let dab = |dab: &Dab| json!([dab.centre_px.x, dab.centre_px.y, dab.radius_px]);
        let protected: Vec<Value> = self.strokes.iter().map(|stroke| stroke.iter().map(dab).collect()).collect();
        json!({ "seen_from_m": self.seen_from_m, "protected_px": protected }).to_string()
    }

    /// Reads the result of [`Self::to_json`].
    ///
    /// # Errors
    /// [`Error::PhotoEdit`] for a missing or invalid field, [`Error::TooManyDabs`] for more than [`MAX_DABS`].
    pub fn from_json(text: &str) -> Result<Self, Error> {
        let invalid = |field| Error::PhotoEdit { field };
        let value: Value = serde_json::from_str(text).map_err(|_| invalid("JSON"))?;
        let seen_from_m = match &value["seen_from_m"] {
            Value::Null => None,
            number => Some(number.as_f64().filter(|m| DISTANCES_M.contains(m)).ok_or(invalid("seen_from_m"))?),
        };
        let strokes = value["protected_px"].as_array().and_then(|strokes| strokes.iter().map(stroke).collect());
        let strokes: Vec<Vec<Dab>> = strokes.ok_or(invalid("protected_px"))?;
        match strokes.iter().map(|stroke| stroke.len().max(1)).sum::<usize>() {
            found if found > MAX_DABS => Err(Error::TooManyDabs { found, max: MAX_DABS }),
            _ => Ok(Self { seen_from_m, strokes }),
        }
    }
}

fn stroke(value: &Value) -> Option<Vec<Dab>> {
    let dabs = value.as_array()?.iter().map(|dab| {
        let numbers: Option<Vec<f64>> = dab.as_array()?.iter().map(Value::as_f64).collect();
        let [x, y, radius_px] = numbers?[..] else { return None };
        (radius_px > 0.0).then_some(Dab { centre_px: DVec2::new(x, y), radius_px })
    });
    dabs.collect()
}
