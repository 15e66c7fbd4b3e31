use js_sys::Function;
use rosto_landmarks::Stage;
use wasm_bindgen::JsValue;

/// What is about to be done.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Step {
    Decoding,
    Finding(Stage),
    Finishing,
}

/// Tells the page how far the work has come.
pub(crate) struct Progress<'a> {
    report: &'a Function,
}

impl<'a> Progress<'a> {
    pub(crate) fn new(report: &'a Function) -> Self {
        Self { report }
    }

    /// What the page does with the news, even throwing, is no concern of the work.
    pub(crate) fn tell(&self, step: Step) {
        let (stage, fraction) = stage_and_fraction(step);
        let _ = self.report.call2(&JsValue::NULL, &stage.into(), &fraction.into());
    }
}

/// The page's name of the stage, and how much of the whole is done by then. Decoding is most of it with large photos.
fn stage_and_fraction(step: Step) -> (&'static str, f64) {
    const DECODED: f64 = 0.6;
    const DETECTED: f64 = 0.7;
    const MESHED: f64 = 0.9;
    match step {
        Step::Decoding => ("decode", 0.0),
        Step::Finding(Stage::Meshing { face, of }) => {
            ("landmarks", DETECTED + (MESHED - DETECTED) * face as f64 / of as f64)
        }
        Step::Finding(_) => ("detect", DECODED),
        Step::Finishing => ("landmarks", MESHED),
    }
}
