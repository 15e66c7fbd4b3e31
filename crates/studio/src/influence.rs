use glam::DVec3;

use crate::mirror::reflected;

/// How the displayed mesh follows handles that move by one offset: vertex v moves by `a_v Δ + b_v Δ̄`, where Δ is the
/// offset and Δ̄ its mirror image.
///
/// Dimensionless. An edit is linear in Δ with and without the mirror, at any density, unless details rotate.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InfluenceWeights {
    /// `a`, one for each displayed vertex.
    pub direct: Vec<f64>,
    /// `b`; empty without the mirror.
    pub mirrored: Vec<f64>,
}

impl InfluenceWeights {
    /// Computes the weights from the displacements by a unit offset along x and along y.
    pub(crate) fn from_displacements(along_x: &[DVec3], along_y: &[DVec3]) -> Self {
        let half = |sign: f64| along_y.iter().zip(along_x).map(|(y, x)| 0.5 * (y.y + sign * x.x)).collect();
        let mirrored: Vec<f64> = half(-1.0);
        let takes_part = mirrored.iter().any(|share| share.abs() > 1e-9);
        Self { direct: half(1.0), mirrored: if takes_part { mirrored } else { Vec::new() } }
    }

    /// Writes `from` plus the displacement for `offset` to `out`. Does not allocate.
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
