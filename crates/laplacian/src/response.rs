use glam::DVec3;

use crate::{ConstraintKind, Constraints};

/// Displacement of every vertex per unit offset of each handle. Computed once per set of constraints, for any offsets.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    handles: Vec<u32>,
    /// One field per handle, concatenated.
    fields: Vec<f64>,
}

impl Response {
    pub(crate) fn new(constraints: &Constraints<'_>, mut fields: Vec<f64>) -> Self {
        if let Some(falloff) = constraints.falloff {
            let weights = falloff.weights();
            for (field, &handle) in fields.chunks_exact_mut(weights.len()).zip(constraints.handles) {
                // Without the division, a falloff below 1 at a hard handle would keep it from its target.
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

    /// The response field `g` of the handle at `index`: for each vertex, its share of the handle's offset.
    /// Dimensionless.
    ///
    /// # Panics
    /// If `index` is out of range.
    pub fn field(&self, index: usize) -> &[f64] {
        let n = self.fields.len() / self.handles.len();
        &self.fields[index * n..(index + 1) * n]
    }

    /// Memory size of the fields, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(self.fields.as_slice())
    }

    /// Writes `X' = X + Σ g Δᵀ` to `out`: `rest` displaced by one offset per handle, all in one unit.
    ///
    /// Runs on each tick of a slider, without a solve or an allocation.
    ///
    /// # Panics
    /// If the number of offsets differs from that of the handles, or the length of `rest` or `out` from that of the
    /// vertices.
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
