use std::collections::HashMap;

use glam::DVec3;

use crate::prepared_edit::PreparedEdit;
use crate::spec_key::SpecKey;
use crate::{Details, EditSpec, StudioError};

/// Memory limit of the responses, in bytes.
const BUDGET_BYTES: usize = 16 << 20;

/// The edits solved during a replay: entries with equal specs share one solve.
#[derive(Default)]
pub(super) struct Solved {
    edits: HashMap<SpecKey, PreparedEdit>,
    bytes: usize,
    scratch: Vec<DVec3>,
    /// Number of edits that were solved.
    #[cfg(test)]
    pub solves: usize,
}

impl Solved {
    /// The edit of a spec, solved by `solve` unless an earlier entry needed it, and a scratch buffer.
    pub fn edit(
        &mut self,
        spec: &EditSpec,
        solve: impl FnOnce() -> Result<PreparedEdit, StudioError>,
    ) -> Result<(&mut PreparedEdit, &mut Vec<DVec3>), StudioError> {
        let key = SpecKey::of(spec);
        // An edit that turns details depends on the shape that it starts from.
        if spec.settings.details == Details::AsRigidAsPossible {
            self.edits.remove(&key);
        }
        if !self.edits.contains_key(&key) {
            let edit = solve()?;
            #[cfg(test)]
            {
                self.solves += 1;
            }
            self.bytes += edit.bytes();
            if self.bytes > BUDGET_BYTES {
                self.edits.clear();
                self.bytes = edit.bytes();
            }
            self.edits.insert(key.clone(), edit);
        }
        let edit = self.edits.get_mut(&key).expect("invariant: inserted above");
        Ok((edit, &mut self.scratch))
    }
}
