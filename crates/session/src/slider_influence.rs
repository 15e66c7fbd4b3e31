use glam::DVec3;
use rosto_studio::{Document, FaceSlider, StudioError};

/// How the displayed mesh follows a ready-made slider: vertex v moves by `a_v Δ_a + b_v Δ_b`, with the offsets of
/// [`slider_offsets`]. Each tick sends only these two to the GPU.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SliderInfluence {
    pub a: Vec<f64>,
    pub b: Vec<f64>,
}

impl SliderInfluence {
    /// Computes the fields of the prepared slider. Cancels an edit in progress.
    pub fn of(document: &mut Document, slider: FaceSlider) -> Result<Self, StudioError> {
        document.preview(&slider.offsets_m(1.0))?;
        let displacements = document.positions().iter().zip(document.committed()).map(|(now, before)| *now - *before);
        let displacements: Vec<DVec3> = displacements.collect();
        document.cancel();
        let [a, b] =
            slider.axes().map(|axis| displacements.iter().map(|displacement| displacement.dot(axis)).collect());
        Ok(Self { a, b })
    }
}

/// The offsets of the two fields of a slider at an amount.
pub(crate) fn slider_offsets(slider: FaceSlider, amount: f64) -> [DVec3; 2] {
    slider.axes().map(|axis| axis * amount)
}

/// The offsets of the two fields of handles with one common offset.
pub(crate) fn offsets(offset: DVec3) -> [DVec3; 2] {
    [offset, DVec3::new(-offset.x, offset.y, offset.z)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_face::{Triangulation, canonical_positions_m};
    use rosto_studio::{CoordinateFrame, Rest};

    #[test]
    fn two_fields_describe_each_slider() {
        let mut positions = canonical_positions_m();
        // Perturb the symmetric face.
        positions.iter_mut().enumerate().for_each(|(vertex, position)| {
            *position += 1e-3 * DVec3::new((vertex as f64).sin(), (2.1 * vertex as f64).cos(), 0.0);
        });
        for (triangulation, density) in [(Triangulation::Tessellation, 0), (Triangulation::Canonical, 1)] {
            let rest = Rest::of_landmarks(triangulation.topology(), positions.clone(), CoordinateFrame::Model);
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
