use std::sync::Arc;

use glam::DVec3;
use rosto_laplacian::{Constraints, Falloff, Response, RigidEdit, RigidOptions, RigidSystem, random_anchors};

use crate::level::Level;
use crate::mirror::reflected;
use crate::{AnchorKind, Anchors, Command, Details, EditSpec, Mirror, RegionOfInfluence, StudioError};

/// Upper bound on distances, in influence radii.
const FAR: f64 = 1e3;

/// An edit with its anchors chosen, mirror partners added and responses solved.
#[derive(Clone)]
pub(crate) struct PreparedEdit {
    spec: EditSpec,
    /// The spec's handles first, then the partners that the mirror adds.
    handles: Vec<u32>,
    anchors: Vec<u32>,
    /// Index of each handle's partner among the handles; its own index without the mirror.
    partner_indices: Vec<usize>,
    response: Response,
    /// For an edit with a limited region: the distance of each vertex from the handles; 1 is the influence radius.
    influence_distances: Option<Vec<f64>>,
    /// For rotating details: the solver over the positions that the edit starts from.
    rigid: Option<Arc<RigidEdit>>,
    /// One for each handle; overwritten by each displacement.
    offsets: Vec<DVec3>,
    stale: bool,
}

impl PreparedEdit {
    /// Solves for the responses; `from` are the positions that an edit that turns details starts from.
    pub(crate) fn new(spec: EditSpec, level: &mut Level, from: &[DVec3]) -> Result<Self, StudioError> {
        let handles = with_partners(&spec, &spec.handles, level)?;
        let (falloff, influence_distances) = falloff(&spec, &handles, level)?.unzip();
        let anchors = anchors(&spec, &handles, level)?;
        let constraint = spec.settings.constraint;
        let constraints =
            Constraints { handles: &handles, anchors: &anchors, kind: constraint, falloff: falloff.as_ref() };
        let response = level.respond(spec.settings.operator, &constraints)?;
        let rigid = match spec.settings.details {
            Details::Kept => None,
            Details::AsRigidAsPossible => {
                let system = RigidSystem::new(level.topology(), from, spec.settings.operator)?;
                Some(Arc::new(system.constrain(&constraints)?))
            }
        };
        let partner_indices = partner_indices(&spec, &handles, level)?;
        let offsets = vec![DVec3::ZERO; handles.len()];
        Ok(Self {
            spec,
            handles,
            anchors,
            partner_indices,
            response,
            influence_distances,
            rigid,
            offsets,
            stale: false,
        })
    }

    /// Whether details rotate, so that the edit depends on the positions that it starts from.
    pub(crate) fn turns_details(&self) -> bool {
        self.rigid.is_some()
    }

    /// Memory size of the responses, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let distances = self.influence_distances.as_ref().map_or(0, Vec::len);
        self.response.bytes() + distances * size_of::<f64>()
    }

    pub(crate) fn spec(&self) -> &EditSpec {
        &self.spec
    }

    /// The spec's handles and their partners.
    pub(crate) fn handles(&self) -> &[u32] {
        &self.handles
    }

    pub(crate) fn anchors(&self) -> &[u32] {
        &self.anchors
    }

    pub(crate) fn response(&self) -> &Response {
        &self.response
    }

    /// Distance of each vertex of the spec's level from the handles; 1 is the influence radius. `None` for an edit of
    /// the whole mesh.
    pub(crate) fn influence_distances(&self) -> Option<&[f64]> {
        self.influence_distances.as_deref()
    }

    /// Marks the edit as stale, if it depends on the positions that it starts from.
    pub(crate) fn start_changed(&mut self) {
        self.stale = self.rigid.is_some();
    }

    /// Whether the edit must be prepared again before it can move.
    pub(crate) fn is_stale(&self) -> bool {
        self.stale
    }

    /// Writes `from`, displaced by one offset for each of the spec's handles, to `out`. Unless details rotate, there is
    /// no solve and no allocation.
    pub(crate) fn displace(
        &mut self,
        level: &Level,
        from: &[DVec3],
        offsets: &[DVec3],
        out: &mut [DVec3],
    ) -> Result<(), StudioError> {
        self.check(offsets)?;
        self.offsets.fill(DVec3::ZERO);
        self.offsets[..offsets.len()].copy_from_slice(offsets);
        if self.spec.settings.mirror == Mirror::On {
            self.mirror_offsets(offsets.len());
        }
        self.response.displace(from, &self.offsets, out);
        if let Some(rigid) = &self.rigid {
            rigid.settle(&self.offsets, &RigidOptions::default(), out)?;
        }
        if self.spec.settings.mirror == Mirror::On {
            level.mirror()?.symmetrise_displacement(from, out);
        }
        Ok(())
    }

    pub(crate) fn command(&self, offsets: Vec<DVec3>) -> Command {
        Command::Move { spec: self.spec.clone(), offsets }
    }

    /// Gives added partners the mirrored offset. If both partners are handles of the spec, both take the symmetric
    /// mean; a handle on the midline then loses its sideways component.
    fn mirror_offsets(&mut self, given: usize) {
        for index in 0..given {
            let partner = self.partner_indices[index];
            if partner >= given {
                self.offsets[partner] = reflected(self.offsets[index]);
            } else if partner >= index {
                let mean = (self.offsets[index] + reflected(self.offsets[partner])) / 2.0;
                self.offsets[index] = mean;
                self.offsets[partner] = reflected(mean);
            }
        }
    }

    /// Rejects offsets that do not fit the spec.
    pub(crate) fn check(&self, offsets: &[DVec3]) -> Result<(), StudioError> {
        let (expected, found) = (self.spec.handles.len(), offsets.len());
        if expected != found {
            return Err(StudioError::WrongOffsetCount { expected, found });
        }
        match offsets.iter().position(|offset| !offset.is_finite()) {
            Some(index) => Err(StudioError::OffsetNotFinite { handle: self.spec.handles[index] }),
            None => Ok(()),
        }
    }
}

/// The vertices, with their partners if the spec is mirrored. Unknown vertices are left for the solver to reject.
fn with_partners(spec: &EditSpec, vertices: &[u32], level: &Level) -> Result<Vec<u32>, StudioError> {
    let exist = vertices.iter().all(|&vertex| (vertex as usize) < level.rest().len());
    match spec.settings.mirror {
        Mirror::On if exist => Ok(level.mirror()?.closure(vertices)),
        _ => Ok(vertices.to_vec()),
    }
}

fn partner_indices(spec: &EditSpec, handles: &[u32], level: &Level) -> Result<Vec<usize>, StudioError> {
    if spec.settings.mirror == Mirror::Off {
        return Ok((0..handles.len()).collect());
    }
    let table = level.mirror()?;
    let index = |vertex: &u32| handles.iter().position(|handle| *handle == table.partner(*vertex));
    Ok(handles.iter().map(|handle| index(handle).expect("invariant: handles are closed under the mirror")).collect())
}

/// Falloff of the edit, and the distance of each vertex, where 1 is the influence radius. With the mirror, the distance
/// is the smaller of both partners'.
fn falloff(spec: &EditSpec, handles: &[u32], level: &mut Level) -> Result<Option<(Falloff, Vec<f64>)>, StudioError> {
    let RegionOfInfluence::Within { radius } = spec.settings.influence else { return Ok(None) };
    let distances = level.distances(handles)?;
    let falloff = Falloff::within(radius, &distances)?;
    // Bounded, so that unreachable vertices stay finite when denser meshes are interpolated.
    let mut influence_distances: Vec<f64> =
        distances.into_iter().map(|distance| (distance / radius).min(FAR)).collect();
    if spec.settings.mirror == Mirror::On {
        level.mirror()?.nearer_of_both(&mut influence_distances);
    }
    Ok(Some((falloff, influence_distances)))
}

/// The anchors of the settings: the pins, and the vertices that the rule selects except handles.
fn anchors(spec: &EditSpec, handles: &[u32], level: &mut Level) -> Result<Vec<u32>, StudioError> {
    let Anchors { kind, pins } = &spec.settings.anchors;
    let vertex_count = level.rest().len();
    let by_rule = match *kind {
        AnchorKind::PinsOnly => Vec::new(),
        AnchorKind::Oval => level.oval().to_vec(),
        AnchorKind::Random { seed } => random(vertex_count, handles, seed)?,
        AnchorKind::Outside { radius } => {
            let distances = level.distances(handles)?;
            (0..vertex_count as u32).filter(|&vertex| distances[vertex as usize] > radius).collect()
        }
    };
    let mut taken = vec![false; vertex_count];
    handles
        .iter()
        .filter(|&&handle| (handle as usize) < vertex_count)
        .for_each(|&handle| taken[handle as usize] = true);
    let mut anchors = with_partners(spec, pins, level)?;
    anchors.iter().filter(|&&pin| (pin as usize) < vertex_count).for_each(|&pin| taken[pin as usize] = true);
    for anchor in with_partners(spec, &by_rule, level)? {
        if !std::mem::replace(&mut taken[anchor as usize], true) {
            anchors.push(anchor);
        }
    }
    Ok(anchors)
}

fn random(vertex_count: usize, handles: &[u32], seed: u64) -> Result<Vec<u32>, StudioError> {
    let free = (0..vertex_count as u32).filter(|vertex| !handles.contains(vertex)).count();
    match free {
        0 | 1 => Err(StudioError::NoFreeAnchors { free }),
        _ => Ok(random_anchors(vertex_count, handles, seed).to_vec()),
    }
}
