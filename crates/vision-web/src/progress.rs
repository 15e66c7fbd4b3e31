use js_sys::Function;
use rosto_landmarks::Stage;
use wasm_bindgen::JsValue;

/// Step that is about to start.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Step {
    Decoding,
    Finding(Stage),
    Finishing,
}

/// Reports progress to the page.
pub(crate) struct Progress<'a> {
    report: &'a Function,
}

impl<'a> Progress<'a> {
    pub(crate) fn new(report: &'a Function) -> Self {
        Self { report }
    }

    /// Errors of the callback are ignored.
    pub(crate) fn report(&self, step: Step) {
        let (stage, fraction) = stage_and_fraction_of_all(step);
        let _ = self.report.call2(&JsValue::NULL, &stage.into(), &fraction.into());
    }
}

/// Name of the stage for the page, and the overall fraction done, 0 to 1. Each stage counts as a third.
fn stage_and_fraction_of_all(step: Step) -> (&'static str, f64) {
    const MESHED: f64 = 0.8;
    let (stage, before, fraction) = match step {
        Step::Decoding => ("decode", 0.0, 0.0),
        Step::Finding(Stage::Detecting { share }) => ("detect", 1.0, share.into()),
        Step::Finding(Stage::Meshing { face, of }) => ("landmarks", 2.0, MESHED * face as f64 / of.max(1) as f64),
        Step::Finishing => ("landmarks", 2.0, MESHED),
    };
    (stage, (before + fraction) / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

    wasm_bindgen_test_configure!(run_in_browser);

    #[wasm_bindgen_test]
    fn progress_is_monotonic_in_steps_of_at_most_a_third() {
        for of in 0..5 {
            let detecting = [0.0, 0.5, 1.0].map(|share| Step::Finding(Stage::Detecting { share }));
            let meshing = (0..of).map(|face| Step::Finding(Stage::Meshing { face, of }));
            let mut steps = vec![Step::Decoding];
            steps.extend(detecting.into_iter().chain(meshing).chain([Step::Finishing]));
            let bars: Vec<f64> = steps.into_iter().map(|step| stage_and_fraction_of_all(step).1).collect();
            assert_eq!(bars[..2], [0.0, 1.0 / 3.0], "first two fractions");
            let last = if of == 0 { 4 } else { bars.len() };
            assert!(bars[..last].windows(2).all(|two| (0.0..0.334).contains(&(two[1] - two[0]))), "{bars:?}");
            assert!(bars.is_sorted() && bars.iter().all(|bar| (0.0..1.0).contains(bar)), "{bars:?}");
        }
    }
}
