use glam::DVec3;
use nalgebra_sparse::{CooMatrix, CsrMatrix};
use rosto_mesh::Topology;

use crate::factor::Factor;
use crate::gauge_fixed::gauge_fixed;
use crate::weights::{barycentric_areas, unit_scale};
use crate::{LaplacianError, Operator, check_positions};

/// Lower bound on a vertex's mass in the heat matrix, as a share of a mean edge's square.
const MIN_STORAGE: f64 = 1e-6;

/// Geodesic distances by the heat method (Crane, Weischedel and Wardetzky 2013): two factorisations per mesh, two
/// solves per set of sources.
///
/// Heat diffuses from the sources for the time it takes to cross an edge. The distance is the function whose gradient
/// is closest to the normalised negative gradient of the heat. The result is smooth and approximate: a few per cent off
/// where triangles are coarse or uneven, and bounded below by the straight-line distance. Paths cross triangles and do
/// not only follow edges.
pub struct Geodesics {
    triangles: Vec<[u32; 3]>,
    /// Scaled to about unit size by `scale`, so that squares do not overflow.
    positions: Vec<DVec3>,
    scale: f64,
    component: Vec<u32>,
    heat: Factor,
    poisson: Factor,
}

impl Geodesics {
    /// Factors the heat and Poisson systems of a mesh; `positions` in any unit.
    ///
    /// # Errors
    /// The errors of [`Operator::matrix`] for invalid positions, and [`LaplacianError::BadlyScaled`] if a factorisation
    /// fails.
    pub fn new(topology: &Topology, positions: &[DVec3]) -> Result<Self, LaplacianError> {
        check_positions(topology, positions)?;
        let laplacian = Operator::Cotangent.matrix(topology, positions)?;
        let component = topology.components();
        let scale = unit_scale(positions);
        let positions: Vec<DVec3> = positions.iter().map(|&position| position * scale).collect();
        Ok(Self {
            triangles: topology.triangles().to_vec(),
            heat: Factor::new(&heat_matrix(topology, &positions, &laplacian))?,
            positions,
            scale,
            poisson: Factor::new(&gauge_fixed(&laplacian, &component))?,
            component,
        })
    }

    /// Returns the distance from each vertex to the nearest of `sources`, in the positions' unit; infinite if the
    /// surface does not connect them.
    ///
    /// # Errors
    /// [`LaplacianError::NoSuchVertex`] for a source outside the mesh.
    pub fn distances(&self, sources: &[u32]) -> Result<Vec<f64>, LaplacianError> {
        let n = self.positions.len();
        if let Some(&vertex) = sources.iter().find(|&&vertex| vertex as usize >= n) {
            return Err(LaplacianError::NoSuchVertex { vertex, vertex_count: n });
        }
        let mut heat = vec![0.0; n];
        sources.iter().for_each(|&source| heat[source as usize] = 1.0);
        self.heat.solve(&mut heat);
        // Obtuse triangles can produce slightly negative heat.
        heat.iter_mut().for_each(|heat| *heat = heat.max(0.0));
        let mut distance = self.divergence_of_descent(&heat);
        self.poisson.solve(&mut distance);
        self.shift_to_sources(sources, &mut distance);
        self.clamp_to_euclidean(sources, &mut distance);
        Ok(distance)
    }

    /// The negated integrated divergence of the unit field down the gradient of `heat`: the right-hand side of `L φ`.
    fn divergence_of_descent(&self, heat: &[f64]) -> Vec<f64> {
        let mut divergence = vec![0.0; heat.len()];
        for &corners in &self.triangles {
            let at = corners.map(|corner| self.positions[corner as usize]);
            let opposite = [at[2] - at[1], at[0] - at[2], at[1] - at[0]];
            let normal = opposite[0].cross(opposite[1]).normalize_or_zero();
            // Heat is tiny far from the sources and only its direction counts, so scale it first to avoid cancellation.
            let hottest = corners.iter().map(|&corner| heat[corner as usize]).fold(f64::MIN_POSITIVE, f64::max);
            let share = corners.map(|corner| heat[corner as usize] / hottest);
            let uphill: DVec3 = (0..3).map(|k| share[k] * normal.cross(opposite[k])).sum();
            let uphill = uphill.normalize_or_zero();
            for k in 0..3 {
                // ∫⟨∇φₖ, ∇φ⟩ for the hat function of corner k, whose gradient is normal × opposite / 2A.
                divergence[corners[k] as usize] += 0.5 * normal.cross(opposite[k]).dot(-uphill);
            }
        }
        divergence
    }

    /// Shifts each component so that its nearest source is at 0; components without a source become infinite.
    fn shift_to_sources(&self, sources: &[u32], distance: &mut [f64]) {
        let mut nearest = vec![f64::INFINITY; distance.len()];
        for &source in sources {
            let own = &mut nearest[self.component[source as usize] as usize];
            *own = own.min(distance[source as usize]);
        }
        for (value, &component) in distance.iter_mut().zip(&self.component) {
            let zero = nearest[component as usize];
            *value = if zero.is_finite() { (*value - zero).max(0.0) / self.scale } else { f64::INFINITY };
        }
        sources.iter().for_each(|&source| distance[source as usize] = 0.0);
    }

    /// Raises distances to the straight-line distance, which the approximation can undercut on coarse triangles.
    fn clamp_to_euclidean(&self, sources: &[u32], distance: &mut [f64]) {
        for (value, position) in distance.iter_mut().zip(&self.positions) {
            let squared = |&source: &u32| self.positions[source as usize].distance_squared(*position);
            let straight = sources.iter().map(squared).fold(f64::INFINITY, f64::min).sqrt() / self.scale;
            if straight.is_finite() {
                *value = value.max(straight);
            }
        }
    }
}

/// `M/h² + L`: an implicit step of the heat equation over the time `h²`, with the mean edge length `h`.
fn heat_matrix(topology: &Topology, positions: &[DVec3], laplacian: &CsrMatrix<f64>) -> CsrMatrix<f64> {
    let lengths = topology.edges().iter().map(|&[a, b]| positions[a as usize].distance(positions[b as usize]));
    let step = lengths.sum::<f64>() / topology.edges().len().max(1) as f64;
    let in_steps: Vec<DVec3> = positions.iter().map(|&position| position / step).collect();
    let storage = barycentric_areas(topology, &in_steps);
    let mut entries = CooMatrix::new(laplacian.nrows(), laplacian.ncols());
    for (vertex, stored) in storage.into_iter().enumerate() {
        entries.push(vertex, vertex, stored.max(MIN_STORAGE));
    }
    CsrMatrix::from(&entries) + laplacian
}
