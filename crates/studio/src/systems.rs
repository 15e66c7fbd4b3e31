use glam::DVec3;
use rosto_laplacian::{LaplacianError, LaplacianSystem, Operator};
use rosto_mesh::Topology;

/// The factored systems of one mesh, each built when its operator is first asked for.
#[derive(Default)]
pub(crate) struct Systems {
    built: Vec<(Operator, LaplacianSystem)>,
}

impl Systems {
    pub(crate) fn get(
        &mut self,
        operator: Operator,
        topology: &Topology,
        rest: &[DVec3],
    ) -> Result<&LaplacianSystem, LaplacianError> {
        let found = self.built.iter().position(|(of, _)| *of == operator);
        let index = match found {
            Some(index) => index,
            None => {
                self.built.push((operator, LaplacianSystem::new(topology, rest, operator)?));
                self.built.len() - 1
            }
        };
        Ok(&self.built[index].1)
    }
}
