use std::sync::Arc;

use glam::{DMat3, DVec3};
use rosto_mesh::Topology;

use crate::gauge_fixed::{ConstrainedForm, GaugeFixedForm};
use crate::rotation::best_rotation;
use crate::{ConstraintKind, Constraints, Falloff, LaplacianError, Operator};

/// As-rigid-as-possible edits (Sorkine and Alexa 2007, in the formulation of Chao et al. 2010), which rotate details
/// with the surface.
///
/// Built once per mesh, from rest positions `X` and the edge weights of an operator; triangle `t` contributes `c_tk` to
/// the weight of its side `k`. Positions `X'` and one rotation `Rᵢ` per vertex minimise
/// ```text
/// E = Σ_t Σ_k c_tk · ⅓ Σ_{i∈t} ‖side'_tk − Rᵢ side_tk‖² + Σ_constrained w‖x'ᵢ − targetᵢ‖²
/// ```
/// by alternation. For fixed positions, the rotations are independent small problems. For fixed rotations, the
/// positions solve `L x' = Σ c_tk R̄_t side_tk`, with the mean rotation `R̄_t` of a triangle's corners and the same
/// factorisation in each iteration. Neither step increases `E`, and `E ≥ 0` even for obtuse triangles.
pub struct RigidSystem {
    rest: Arc<Rest>,
}

struct Rest {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// `c_tk`, for the side opposite corner `k`.
    shares: Vec<[f64; 3]>,
    form: GaugeFixedForm,
}

/// A side of a triangle: start vertex, end vertex, and share of the edge's weight.
type Side = (usize, usize, f64);

/// An as-rigid-as-possible edit for fixed handles and anchors.
pub struct RigidEdit {
    rest: Arc<Rest>,
    constrained: ConstrainedForm,
    handles: usize,
    falloff: Option<Falloff>,
}

/// Stopping criteria of the iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidOptions {
    /// Maximum number of iterations.
    pub max_iterations: usize,
    /// Stops when an iteration reduces the energy by at most this fraction.
    pub tolerance: f64,
}

impl Default for RigidOptions {
    fn default() -> Self {
        Self { max_iterations: 10, tolerance: 1e-4 }
    }
}

impl RigidSystem {
    /// Factors `L` for the symmetric form of `operator`. `positions` in any unit.
    ///
    /// # Errors
    /// The errors of [`LaplacianSystem::new`](crate::LaplacianSystem::new).
    pub fn new(topology: &Topology, positions: &[DVec3], operator: Operator) -> Result<Self, LaplacianError> {
        let symmetric = operator.symmetric();
        let laplacian = symmetric.matrix(topology, positions)?;
        let rest = Rest {
            positions: positions.to_vec(),
            triangles: topology.triangles().to_vec(),
            shares: symmetric.triangle_shares(topology, positions),
            form: GaugeFixedForm::new(topology, &laplacian)?,
        };
        Ok(Self { rest: Arc::new(rest) })
    }

    /// Does the work that depends only on the constraints.
    ///
    /// # Errors
    /// The errors of [`LaplacianSystem::respond`](crate::LaplacianSystem::respond).
    pub fn constrain(&self, constraints: &Constraints<'_>) -> Result<RigidEdit, LaplacianError> {
        let constrained = self.rest.form.constrain(constraints)?;
        let (handles, falloff) = (constraints.handles.len(), constraints.falloff.cloned());
        Ok(RigidEdit { rest: Arc::clone(&self.rest), constrained, handles, falloff })
    }
}

impl RigidEdit {
    /// Iterates from `positions` towards the minimum for one offset per handle. Returns the energy at the start and
    /// after each iteration.
    ///
    /// The initial positions may be the rest positions, a δ-coordinate edit, or the result of the previous tick of a
    /// drag. A falloff scales the resulting displacement.
    ///
    /// # Errors
    /// [`LaplacianError::BadlyScaled`] if a solve gives non-finite values.
    ///
    /// # Panics
    /// If the number of offsets differs from that of the handles, or the number of positions from that of the vertices.
    pub fn settle(
        &self,
        offsets: &[DVec3],
        options: &RigidOptions,
        positions: &mut [DVec3],
    ) -> Result<Vec<f64>, LaplacianError> {
        assert_eq!(offsets.len(), self.handles, "one offset for each handle");
        assert_eq!(positions.len(), self.rest.positions.len(), "one position for each vertex");
        let mut targets = vec![DVec3::ZERO; self.constrained.constrained.len()];
        targets[..offsets.len()].copy_from_slice(offsets);
        self.start(&targets, positions);
        let mut rotations = self.rest.rotations(positions);
        let mut energies = vec![self.energy(&rotations, &targets, positions)];
        while energies.len() <= options.max_iterations {
            self.move_to(&rotations, &targets, positions)?;
            rotations = self.rest.rotations(positions);
            energies.push(self.energy(&rotations, &targets, positions));
            if let [.., before, after] = energies[..]
                && before - after <= options.tolerance * before
            {
                break;
            }
        }
        self.fade(&targets, positions);
        Ok(energies)
    }

    /// Moves hard constrained vertices to their targets, so that the first energy is that of an admissible shape.
    fn start(&self, targets: &[DVec3], positions: &mut [DVec3]) {
        if self.constrained.kind == ConstraintKind::Hard {
            for (&vertex, &target) in self.constrained.constrained.iter().zip(targets) {
                positions[vertex as usize] = self.rest.positions[vertex as usize] + target;
            }
        }
    }

    /// The energy `E` for the given rotations and positions.
    fn energy(&self, rotations: &[DMat3], targets: &[DVec3], positions: &[DVec3]) -> f64 {
        let rest = &self.rest.positions;
        let bent = |(corners, sides): ([usize; 3], [Side; 3])| {
            let side_bent = |(from, to, share): Side| {
                let (before, after) = (rest[to] - rest[from], positions[to] - positions[from]);
                share * corners.map(|corner| (after - rotations[corner] * before).length_squared()).iter().sum::<f64>()
            };
            sides.map(side_bent).iter().sum::<f64>() / 3.0
        };
        let missed = |(&vertex, &target): (&u32, &DVec3)| {
            (positions[vertex as usize] - self.rest.positions[vertex as usize] - target).length_squared()
        };
        let holding = match self.constrained.kind {
            ConstraintKind::Soft { weight } => {
                weight * self.constrained.constrained.iter().zip(targets).map(missed).sum::<f64>()
            }
            ConstraintKind::Hard => 0.0,
        };
        self.rest.triangles().map(bent).sum::<f64>() + holding
    }

    /// Sets the optimal positions for fixed rotations. Solves for the displacement `d = x' − x`, whose load
    /// `Σ c_tk (R̄_t − 1) side_tk` vanishes without rotation.
    fn move_to(&self, rotations: &[DMat3], targets: &[DVec3], positions: &mut [DVec3]) -> Result<(), LaplacianError> {
        let rest = &self.rest.positions;
        let mut load = vec![DVec3::ZERO; rest.len()];
        for (corners, sides) in self.rest.triangles() {
            let [a, b, c] = corners.map(|corner| rotations[corner]);
            let turn = (a + b + c) * (1.0 / 3.0) - DMat3::IDENTITY;
            for (from, to, share) in sides {
                let pull = share * (turn * (rest[to] - rest[from]));
                load[to] += pull;
                load[from] -= pull;
            }
        }
        positions.copy_from_slice(rest);
        let mut moved = vec![0.0; rest.len()];
        for axis in 0..3 {
            let load: Vec<f64> = load.iter().map(|load| load[axis]).collect();
            let targets: Vec<f64> = targets.iter().map(|target| target[axis]).collect();
            self.constrained.minimise(&self.rest.form, Some(&load), &targets, &mut moved)?;
            positions.iter_mut().zip(&moved).for_each(|(position, moved)| position[axis] += moved);
        }
        Ok(())
    }

    fn fade(&self, targets: &[DVec3], positions: &mut [DVec3]) {
        let Some(falloff) = &self.falloff else { return };
        for ((position, &rest), &share) in positions.iter_mut().zip(&self.rest.positions).zip(falloff.weights()) {
            *position = rest + share * (*position - rest);
        }
        self.start(targets, positions);
    }
}

impl Rest {
    /// The corners and sides of each triangle.
    fn triangles(&self) -> impl Iterator<Item = ([usize; 3], [Side; 3])> {
        self.triangles.iter().zip(&self.shares).map(|(corners, shares)| {
            let [a, b, c] = corners.map(|corner| corner as usize);
            ([a, b, c], [(b, c, shares[0]), (c, a, shares[1]), (a, b, shares[2])])
        })
    }

    /// For each vertex, the best rotation from the sides of its triangles at rest to those of `positions`.
    fn rotations(&self, positions: &[DVec3]) -> Vec<DMat3> {
        let mut covariances = vec![DMat3::ZERO; positions.len()];
        for (corners, sides) in self.triangles() {
            let covariance = sides.into_iter().fold(DMat3::ZERO, |sum, (from, to, share)| {
                let (before, after) = (self.positions[to] - self.positions[from], positions[to] - positions[from]);
                sum + DMat3::from_cols(after * before.x, after * before.y, after * before.z) * share
            });
            corners.iter().for_each(|&corner| covariances[corner] += covariance);
        }
        covariances.iter().map(best_rotation).collect()
    }
}
