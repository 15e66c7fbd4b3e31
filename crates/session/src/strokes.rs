//! Strokes that protect parts of a photo, and their JSON text.

use glam::DVec2;
use rosto_face::DISTANCES_M;
use rosto_warp::Dab;
use serde_json::{Value, json};

use crate::SessionError;

/// Maximum number of dabs.
const MAX_DABS: usize = 20_000;

/// Minimum distance between dabs, as a share of their radius.
const MIN_SPACING: f64 = 0.3;

/// Brush strokes; each is undone as a whole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Strokes {
    done: Vec<Vec<Dab>>,
    undone: Vec<Vec<Dab>>,
}

impl Strokes {
    /// The dabs, in painting order.
    pub fn dabs(&self) -> impl Iterator<Item = &Dab> {
        self.done.iter().flatten()
    }

    /// Number of strokes.
    pub fn count(&self) -> usize {
        self.done.len()
    }

    /// Whether there is an undone stroke to redo.
    pub fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    pub(crate) fn begin(&mut self, dab: Dab) {
        self.undone.clear();
        self.done.push(vec![dab]);
    }

    /// Continues the last stroke with evenly spaced dabs.
    pub(crate) fn extend(&mut self, to_px: DVec2) {
        let is_full = self.dabs().count() >= MAX_DABS;
        let Some(stroke) = self.done.last_mut().filter(|_| !is_full) else { return };
        let Some(&last) = stroke.last() else { return };
        let delta_px = to_px - last.centre_px;
        let steps = (delta_px.length() / (MIN_SPACING * last.radius_px)).floor().min(100.0) as u32;
        stroke.extend((1..=steps).map(|step| {
            let centre_px = last.centre_px + delta_px * (f64::from(step) / f64::from(steps));
            Dab { centre_px, ..last }
        }));
    }

    pub(crate) fn undo(&mut self) {
        self.undone.extend(self.done.pop());
    }

    pub(crate) fn redo(&mut self) {
        self.done.extend(self.undone.pop());
    }

    /// Removes all strokes; redo restores them one by one.
    pub(crate) fn clear(&mut self) {
        self.undone.extend(self.done.drain(..).rev());
    }

    /// View distance and strokes as JSON text, for [`Work::photo`](crate::Work::photo).
    pub(crate) fn to_json(&self, seen_from_m: Option<f64>) -> String {
        let dab = |dab: &Dab| json!([dab.centre_px.x, dab.centre_px.y, dab.radius_px]);
        let protected: Vec<Value> = self.done.iter().map(|stroke| stroke.iter().map(dab).collect()).collect();
        json!({ "seen_from_m": seen_from_m, "kept_px": protected }).to_string()
    }
}

/// Reads the text written by [`Strokes::to_json`].
pub(crate) fn read(text: &str) -> Result<(Option<f64>, Strokes), SessionError> {
    let invalid = |field| SessionError::PhotoEdit { field };
    let value: Value = serde_json::from_str(text).map_err(|_| invalid("JSON"))?;
    let seen_from_m = match &value["seen_from_m"] {
        Value::Null => None,
        number => Some(number.as_f64().filter(|m| DISTANCES_M.contains(m)).ok_or(invalid("seen_from_m"))?),
    };
    let strokes = value["kept_px"].as_array().ok_or(invalid("kept_px"))?.iter().map(stroke);
    let done: Vec<Vec<Dab>> = strokes.collect::<Option<_>>().ok_or(invalid("kept_px"))?;
    if done.iter().map(Vec::len).sum::<usize>() > MAX_DABS {
        return Err(invalid("kept_px"));
    }
    Ok((seen_from_m, Strokes { done, undone: Vec::new() }))
}

fn stroke(value: &Value) -> Option<Vec<Dab>> {
    let dabs = value.as_array()?.iter().map(|dab| {
        let numbers: Option<Vec<f64>> = dab.as_array()?.iter().map(Value::as_f64).collect();
        let [x, y, radius_px] = numbers?[..] else { return None };
        (radius_px > 0.0).then_some(Dab { centre_px: DVec2::new(x, y), radius_px })
    });
    dabs.collect()
}
