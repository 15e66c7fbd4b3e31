use glam::DVec3;

use crate::{ConstraintKind, Constraints};

/// How every vertex follows each handle; built once for a set of constraints, then applied for any offsets.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    handles: Vec<u32>,
    /// One field after the other.
    fields: Vec<f64>,
}

impl Response {
    pub(crate) fn new(constraints: &Constraints<'_>, mut fields: Vec<f64>) -> Self {
        if let Some(falloff) = constraints.falloff {
            let weights = falloff.weights();
            for (field, &handle) in fields.chunks_exact_mut(weights.len()).zip(constraints.handles) {
                // A hard constrained handle still arrives where the region is already fading.
                let whole = if constraints.kind == ConstraintKind::Hard { weights[handle as usize] } else { 1.0 };
                field.iter_mut().zip(weights).for_each(|(value, share)| *value *= share / whole);
            }
        }
        Self { handles: constraints.handles.to_vec(), fields }
    }

    /// The handles, in the order of the constraints.
    pub fn handles(&self) -> &[u32] {
        &self.handles
    }

    /// The response field `g` of the `index`-th handle: for each vertex, the share of that handle's offset that it takes.
    /// Dimensionless.
    ///
    /// # Panics
    /// If there is no such handle.
    pub fn field(&self, index: usize) -> &[f64] {
        let n = self.fields.len() / self.handles.len();
        &self.fields[index * n..(index + 1) * n]
    }

    /// Writes `X' = X + Σ g Δᵀ` to `out`: `rest` moved by one offset for each handle, all in one unit.
    ///
    /// This is what a slider does on every tick: no solve, no allocation.
    ///
    /// # Panics
    /// If there is not one offset for each handle, or not one place in `rest` and `out` for each vertex.
    pub fn displace(&self, rest: &[DVec3], offsets: &[DVec3], out: &mut [DVec3]) {
        let n = self.fields.len() / self.handles.len();
        assert_eq!(offsets.len(), self.handles.len(), "one offset for each handle");
        assert!(rest.len() == n && out.len() == n, "one position for each vertex");
        out.copy_from_slice(rest);
        for (field, &offset) in self.fields.chunks_exact(n).zip(offsets) {
            for (position, &share) in out.iter_mut().zip(field) {
                *position += share * offset;
            }
        }
    }
}
