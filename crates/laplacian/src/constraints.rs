use rosto_mesh::Topology;

use crate::{Falloff, LaplacianError};

/// Whether handles and anchors are soft (penalty) or hard (equality) constraints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ConstraintKind {
    /// Adds `weight·‖x'ᵢ − target‖²` to the energy; the paper uses a weight of 1.
    Soft {
        /// Positive and finite. A greater weight brings vertices closer to their targets.
        weight: f64,
    },
    /// Handles reach their targets exactly; anchors do not move.
    Hard,
}

impl Default for ConstraintKind {
    fn default() -> Self {
        Self::Soft { weight: 1.0 }
    }
}

impl ConstraintKind {
    /// `1/weight`: 0 for a hard constraint.
    pub(crate) fn compliance(self) -> f64 {
        match self {
            Self::Soft { weight } => weight.recip(),
            Self::Hard => 0.0,
        }
    }
}

/// Handles, anchors, the kind of constraint, and the region of influence.
///
/// A component with a handle needs an anchor. A component without a handle does not move.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Constraints<'a> {
    /// Vertices that an offset moves; distinct.
    pub handles: &'a [u32],
    /// Vertices that stay; distinct, and none of them a handle.
    pub anchors: &'a [u32],
    /// The kind of constraint, for handles and anchors.
    pub kind: ConstraintKind,
    /// Weights that limit the edit to a region; `None` for the whole mesh.
    pub falloff: Option<&'a Falloff>,
}

impl Constraints<'_> {
    /// Checks for contradictions. `component` maps each vertex to its component.
    pub(crate) fn check(&self, component: &[u32]) -> Result<(), LaplacianError> {
        self.check_vertices(component.len())?;
        self.check_kind()?;
        self.check_falloff(component.len())?;
        let anchored = |handle: &&u32| {
            self.anchors.iter().any(|&anchor| component[anchor as usize] == component[**handle as usize])
        };
        match self.handles.iter().find(|handle| !anchored(handle)) {
            Some(&handle) => Err(LaplacianError::Unanchored { handle }),
            None => Ok(()),
        }
    }

    fn check_vertices(&self, vertex_count: usize) -> Result<(), LaplacianError> {
        if self.handles.is_empty() {
            return Err(LaplacianError::NoHandle);
        }
        let is_handle = mask(self.handles, vertex_count)?;
        mask(self.anchors, vertex_count)?;
        match self.anchors.iter().find(|&&anchor| is_handle[anchor as usize]) {
            Some(&vertex) => Err(LaplacianError::PinnedHandle { vertex }),
            None => Ok(()),
        }
    }

    fn check_kind(&self) -> Result<(), LaplacianError> {
        match self.kind {
            ConstraintKind::Soft { weight } if !(weight > 0.0 && weight.is_finite()) => {
                Err(LaplacianError::Weight { weight })
            }
            _ => Ok(()),
        }
    }

    fn check_falloff(&self, vertex_count: usize) -> Result<(), LaplacianError> {
        let Some(falloff) = self.falloff.map(Falloff::weights) else { return Ok(()) };
        if falloff.len() != vertex_count {
            return Err(LaplacianError::LengthMismatch { expected: vertex_count, found: falloff.len() });
        }
        match self.handles.iter().find(|&&handle| falloff[handle as usize] == 0.0) {
            Some(&handle) => Err(LaplacianError::OutsideRegion { handle }),
            None => Ok(()),
        }
    }
}

/// A mask of the listed vertices. Rejects vertices outside the mesh and duplicates.
pub(crate) fn mask(vertices: &[u32], vertex_count: usize) -> Result<Vec<bool>, LaplacianError> {
    let mut is_marked = vec![false; vertex_count];
    for &vertex in vertices {
        let known = is_marked.get_mut(vertex as usize).ok_or(LaplacianError::NoSuchVertex { vertex, vertex_count })?;
        if std::mem::replace(known, true) {
            return Err(LaplacianError::Repeated { vertex });
        }
    }
    Ok(is_marked)
}

/// Rejects an empty mesh, and positions of the wrong length or with non-finite values.
pub(crate) fn check_positions(topology: &Topology, positions: &[glam::DVec3]) -> Result<(), LaplacianError> {
    if topology.vertex_count() == 0 {
        return Err(LaplacianError::Empty);
    }
    if positions.len() != topology.vertex_count() {
        return Err(LaplacianError::LengthMismatch { expected: topology.vertex_count(), found: positions.len() });
    }
    match positions.iter().position(|position| !position.is_finite()) {
        Some(vertex) => Err(LaplacianError::NotFinite { vertex: vertex as u32 }),
        None => Ok(()),
    }
}
