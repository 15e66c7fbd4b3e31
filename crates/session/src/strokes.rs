//! What of a photo is kept as it is, painted with a brush, and as JSON text.

use glam::DVec2;
use rosto_face::DISTANCES_M;
use rosto_warp::Dab;
use serde_json::{Value, json};

use crate::{OpenFace, SessionError};

/// Nobody paints more dabs than this.
const MOST_DABS: usize = 20_000;

/// Dabs nearer to each other than this share of their radius are one.
const LEAST_APART: f64 = 0.3;

/// Strokes of a brush, each taken back as a whole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Strokes {
    done: Vec<Vec<Dab>>,
    undone: Vec<Vec<Dab>>,
}

impl Strokes {
    /// All dabs, in the order in which they were painted.
    pub fn dabs(&self) -> impl Iterator<Item = &Dab> {
        self.done.iter().flatten()
    }

    /// How many strokes there are.
    pub fn count(&self) -> usize {
        self.done.len()
    }

    /// Whether one can be brought back.
    pub fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    pub(crate) fn begin(&mut self, dab: Dab) {
        self.undone.clear();
        self.done.push(vec![dab]);
    }

    /// Goes on with the last stroke: a dab wherever the brush has gone on by a third of its radius.
    pub(crate) fn go_on(&mut self, to_px: DVec2) {
        let is_full = self.dabs().count() >= MOST_DABS;
        let Some(stroke) = self.done.last_mut().filter(|_| !is_full) else { return };
        let Some(&last) = stroke.last() else { return };
        let way_px = to_px - last.centre_px;
        let steps = (way_px.length() / (LEAST_APART * last.radius_px)).floor().min(100.0) as u32;
        stroke.extend((1..=steps).map(|step| {
            let centre_px = last.centre_px + way_px * (f64::from(step) / f64::from(steps));
            Dab { centre_px, ..last }
        }));
    }

    pub(crate) fn undo(&mut self) {
        self.undone.extend(self.done.pop());
    }

    pub(crate) fn redo(&mut self) {
        self.done.extend(self.undone.pop());
    }

    /// Takes all away; redo brings them back, one by one.
    pub(crate) fn clear(&mut self) {
        self.undone.extend(self.done.drain(..).rev());
    }
}

impl OpenFace {
    /// The same for a file; none where nothing was done to the photo alone.
    pub(crate) fn in_photo_json(&self) -> Option<String> {
        let photo = self.photo();
        (photo.seen_from_m().is_some() || photo.strokes().count() > 0).then(|| self.photo_json())
    }

    /// Data of the photo alone, as JSON text for [`Work::photo`](crate::Work::photo): from where it is seen, and what of it
    /// is kept.
    pub fn photo_json(&self) -> String {
        let dab = |dab: &Dab| json!([dab.centre_px.x, dab.centre_px.y, dab.radius_px]);
        let strokes = self.photo().strokes();
        let kept: Vec<Value> = strokes.done.iter().map(|stroke| stroke.iter().map(dab).collect()).collect();
        json!({ "seen_from_m": self.photo().seen_from_m(), "kept_px": kept }).to_string()
    }
}

/// What [`OpenFace::photo_json`] wrote.
pub(crate) fn read(text: &str) -> Result<(Option<f64>, Strokes), SessionError> {
    let bad = |field| SessionError::InPhoto { field };
    let value: Value = serde_json::from_str(text).map_err(|_| bad("JSON"))?;
    let seen_from_m = match &value["seen_from_m"] {
        Value::Null => None,
        number => Some(number.as_f64().filter(|m| DISTANCES_M.contains(m)).ok_or(bad("seen_from_m"))?),
    };
    let strokes = value["kept_px"].as_array().ok_or(bad("kept_px"))?.iter().map(stroke);
    let done: Vec<Vec<Dab>> = strokes.collect::<Option<_>>().ok_or(bad("kept_px"))?;
    if done.iter().map(Vec::len).sum::<usize>() > MOST_DABS {
        return Err(bad("kept_px"));
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
