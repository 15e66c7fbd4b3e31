use glam::DVec3;

use crate::mirror::reflected;

/// How the mesh that is shown follows handles that move as one: vertex v moves by `a_v Δ + b_v Δ̄`, where Δ is the offset
/// that each handle is given and Δ̄ its mirror image.
///
/// Dimensionless. Whatever the mirror and the density do to an edit, it stays linear in Δ, unless details turn.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InfluenceWeights {
    /// `a`, one for each vertex shown.
    pub direct: Vec<f64>,
    /// `b`; empty unless the mirror takes part.
    pub mirrored: Vec<f64>,
}

impl InfluenceWeights {
    /// From what an offset of one unit along x, and one along y, displace the mesh by.
    pub(crate) fn from_displacements(along_x: &[DVec3], along_y: &[DVec3]) -> Self {
        let half = |sign: f64| along_y.iter().zip(along_x).map(|(y, x)| 0.5 * (y.y + sign * x.x)).collect();
        let mirrored: Vec<f64> = half(-1.0);
        let takes_part = mirrored.iter().any(|share| share.abs() > 1e-9);
        Self { direct: half(1.0), mirrored: if takes_part { mirrored } else { Vec::new() } }
    }

    /// Writes `from`, moved by the handles' offset, to `out`. No allocation.
    pub(crate) fn displace(&self, from: &[DVec3], offset: DVec3, out: &mut [DVec3]) {
        for ((to, at), share) in out.iter_mut().zip(from).zip(&self.direct) {
            *to = *at + *share * offset;
        }
        let image = reflected(offset);
        for (to, share) in out.iter_mut().zip(&self.mirrored) {
            *to += *share * image;
        }
    }
}
