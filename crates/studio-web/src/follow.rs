use glam::DVec3;
use rosto_studio::{Document, StudioError};

/// How the shown mesh follows the held landmark and its mirror image: vertex v moves by `a_v Δ + b_v Δ̄`, where Δ̄ is Δ
/// with its x turned round.
///
/// A preview is linear in Δ, whatever the mirror and the density do to it, so two previews tell both fields.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct FollowFields {
    pub a: Vec<f64>,
    /// Empty unless the mirror takes part.
    pub b: Vec<f64>,
}

impl FollowFields {
    /// Asks the document, whose edit in progress is cancelled. Empty where nothing is held.
    pub fn of(document: &mut Document) -> Result<Self, StudioError> {
        if document.grip().is_none() {
            return Ok(Self::default());
        }
        let along_x: Vec<f64> = displacements(document, DVec3::X)?.iter().map(|moved| moved.x).collect();
        let along_y: Vec<f64> = displacements(document, DVec3::Y)?.iter().map(|moved| moved.y).collect();
        document.cancel();
        let half = |sign: f64| along_y.iter().zip(&along_x).map(|(y, x)| 0.5 * (y + sign * x)).collect();
        let b: Vec<f64> = half(-1.0);
        let is_mirrored = b.iter().any(|share| share.abs() > 1e-9);
        Ok(Self { a: half(1.0), b: if is_mirrored { b } else { Vec::new() } })
    }

    /// The two fields as the viewport takes them.
    pub fn fields(&self) -> [Option<&[f64]>; 2] {
        [&self.a, &self.b].map(|field| (!field.is_empty()).then_some(field.as_slice()))
    }
}

/// The offsets that belong to the two fields.
pub(crate) fn offsets(offset: DVec3) -> [DVec3; 2] {
    [offset, DVec3::new(-offset.x, offset.y, offset.z)]
}

fn displacements(document: &mut Document, offset: DVec3) -> Result<Vec<DVec3>, StudioError> {
    document.preview(&[offset])?;
    Ok(document.positions().iter().zip(document.committed()).map(|(now, before)| *now - *before).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rosto_face::{Triangulation, canonical_positions_m};
    use rosto_studio::{Anchors, Frame, Grip, Hold, Mirror, Operator, Rest, Settings};

    fn document(triangulation: Triangulation) -> Document {
        let mut positions = canonical_positions_m();
        // No face is symmetric.
        positions.iter_mut().enumerate().for_each(|(vertex, position)| {
            *position += 1e-3 * DVec3::new((vertex as f64).sin(), (2.1 * vertex as f64).cos(), 0.0);
        });
        Document::new(Rest::new(triangulation.topology(), positions, Frame::Model)).unwrap()
    }

    #[test]
    fn the_fields_predict_every_preview() {
        let mut document = document(Triangulation::Canonical);
        for (density, vertex, mirror, operator) in [
            (0, 61, Mirror::Off, Operator::UniformSymmetric),
            (0, 61, Mirror::On, Operator::Cotangent),
            (0, 1, Mirror::On, Operator::Cotangent),
            (1, 291, Mirror::On, Operator::InverseLength),
        ] {
            document.set_density(density).unwrap();
            let settings =
                Settings { operator, mirror, hold: Hold::Exact, anchors: Anchors::default(), ..Settings::default() };
            document.hold(Grip { handles: vec![vertex], settings, ..Grip::default() }).unwrap();
            let follow = FollowFields::of(&mut document).unwrap();
            let offset = DVec3::new(0.004, -0.003, 0.007);
            document.preview(&[offset]).unwrap();
            let [to_a, to_b] = offsets(offset);
            for (v, (now, before)) in document.positions().iter().zip(document.committed()).enumerate() {
                let b = follow.b.get(v).copied().unwrap_or(0.0);
                let predicted = *before + to_a * follow.a[v] + to_b * b;
                assert!(now.distance(predicted) < 1e-12, "vertex {v}, {vertex}, {mirror:?}");
            }
            document.cancel();
        }
    }
}
