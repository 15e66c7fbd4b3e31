use glam::DVec3;
use rosto_studio::{Document, FaceSlider, StudioError};

/// How the shown mesh follows a ready-made slider: vertex v moves by `a_v Δ_a + b_v Δ_b`, where Δ_a and Δ_b are those of
/// [`slider_offsets`]; each tick sends no more than these two to the GPU.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SliderInfluence {
    pub a: Vec<f64>,
    pub b: Vec<f64>,
}

impl SliderInfluence {
    /// Asks the document, which holds the slider's spec. An edit in progress is cancelled.
    pub fn of(document: &mut Document, slider: FaceSlider) -> Result<Self, StudioError> {
        document.preview(&slider.offsets_m(1.0))?;
        let ways = document.positions().iter().zip(document.committed()).map(|(now, before)| *now - *before);
        let ways: Vec<DVec3> = ways.collect();
        document.cancel();
        let [a, b] = slider.axes().map(|axis| ways.iter().map(|way| way.dot(axis)).collect());
        Ok(Self { a, b })
    }
}

/// The offsets that belong to the two fields of a slider moved by an amount.
pub(crate) fn slider_offsets(slider: FaceSlider, amount: f64) -> [DVec3; 2] {
    slider.axes().map(|axis| axis * amount)
}

/// The offsets that belong to the two fields of handles that move as one.
pub(crate) fn offsets(offset: DVec3) -> [DVec3; 2] {
    [offset, DVec3::new(-offset.x, offset.y, offset.z)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_face::{Triangulation, canonical_positions_m};
    use rosto_studio::{CoordinateFrame, Rest};

    #[test]
    fn two_fields_are_enough_for_every_slider() {
        let mut positions = canonical_positions_m();
        // No face is symmetric.
        positions.iter_mut().enumerate().for_each(|(vertex, position)| {
            *position += 1e-3 * DVec3::new((vertex as f64).sin(), (2.1 * vertex as f64).cos(), 0.0);
        });
        for (triangulation, density) in [(Triangulation::Tessellation, 0), (Triangulation::Canonical, 1)] {
            let rest = Rest::new(triangulation.topology(), positions.clone(), CoordinateFrame::Model);
            let mut document = Document::new(rest).unwrap();
            document.set_density(density).unwrap();
            for slider in FaceSlider::ALL {
                document.prepare(slider.spec()).unwrap();
                let influence = SliderInfluence::of(&mut document, slider).unwrap();
                document.preview(&slider.offsets_m(0.003)).unwrap();
                let [to_a, to_b] = slider_offsets(slider, 0.003);
                for (v, (now, before)) in document.positions().iter().zip(document.committed()).enumerate() {
                    let predicted = *before + to_a * influence.a[v] + to_b * influence.b[v];
                    assert!(now.distance(predicted) < 1e-12, "vertex {v}: {}", slider.id());
                }
                document.cancel();
            }
        }
    }
}
