use glam::DVec3;
use rosto_face::mirror_of;

use crate::FaceSlider;

/// Amount of each ready-made slider, in metres, that comes closest to a displacement of the face.
pub type SliderAmounts = [f64; FaceSlider::ALL.len()];

/// The handles of each slider on both sides, with their weights.
///
/// The amount of slider `s` in displacements `d` is the least-squares fit `Σ d_h·u_h / Σ |u_h|²` to its directions `u`.
/// It is linear, and zero for displacements that are the opposite of their mirror image.
#[derive(Debug, Clone)]
pub(crate) struct SliderMeasures(Vec<Vec<(usize, DVec3)>>);

impl Default for SliderMeasures {
    fn default() -> Self {
        Self(FaceSlider::ALL.into_iter().map(weights).collect())
    }
}

fn weights(slider: FaceSlider) -> Vec<(usize, DVec3)> {
    let handles = slider.spec().handles;
    let directions = slider.offsets_m(1.0);
    let sides = |(handle, direction): (u32, DVec3)| {
        let mirrored = DVec3::new(-direction.x, direction.y, direction.z);
        [(handle, direction), (mirror_of(handle), mirrored)]
    };
    let both: Vec<(u32, DVec3)> = handles.into_iter().zip(directions).flat_map(sides).collect();
    let norm = both.iter().map(|(_, direction)| direction.length_squared()).sum::<f64>();
    both.into_iter().map(|(handle, direction)| (handle as usize, direction / norm)).collect()
}

impl SliderMeasures {
    /// The amounts in the displacements of the landmarks.
    pub fn of(&self, displacement_m: impl Fn(usize) -> DVec3) -> SliderAmounts {
        let amount = |handles: &Vec<(usize, DVec3)>| {
            handles.iter().map(|(handle, weight)| displacement_m(*handle).dot(*weight)).sum::<f64>()
        };
        std::array::from_fn(|slider| amount(&self.0[slider]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_slider_measures_its_own_amount_and_none_of_an_asymmetric_displacement() {
        let measures = SliderMeasures::default();
        for slider in FaceSlider::ALL {
            let handles = slider.spec().handles;
            let offsets = slider.offsets_m(0.003);
            let moved = |landmark: usize| {
                let at = |vertex: usize| handles.iter().position(|&handle| handle as usize == vertex);
                let image = at(mirror_of(landmark as u32) as usize);
                match (at(landmark), image) {
                    (Some(index), _) => offsets[index],
                    (None, Some(index)) => offsets[index] * DVec3::new(-1.0, 1.0, 1.0),
                    (None, None) => DVec3::ZERO,
                }
            };
            let amount = measures.of(moved)[slider as usize];
            assert!((amount - 0.003).abs() < 1e-12, "{}: {amount}", slider.id());
            let skewed = measures.of(|_| DVec3::X)[slider as usize];
            assert!(skewed.abs() < 1e-12, "{}: {skewed}", slider.id());
        }
    }
}
