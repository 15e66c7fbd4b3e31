use glam::DVec3;
use rosto_laplacian::{Constraints, Response, random_anchors};

use crate::document::Rest;
use crate::mirror::reflected;
use crate::systems::Systems;
use crate::{AnchorKind, Anchors, Command, Grip, Mirror, StudioError};

/// A grip made ready: anchors chosen, partners joined, response fields solved.
pub(crate) struct Held {
    grip: Grip,
    /// The grip's handles first, then the partners that the mirror adds.
    handles: Vec<u32>,
    anchors: Vec<u32>,
    /// For each handle, where its partner stands among the handles; itself where the mirror is off.
    partner_places: Vec<usize>,
    response: Response,
    /// One for each handle; filled anew by each displacement.
    offsets: Vec<DVec3>,
}

impl Held {
    /// Solves for the response fields.
    pub(crate) fn new(grip: Grip, rest: &Rest, systems: &mut Systems) -> Result<Self, StudioError> {
        let handles = match grip.settings.mirror {
            Mirror::Off => grip.handles.clone(),
            Mirror::On => closure(rest, &grip.handles)?,
        };
        let anchors = anchors(&grip, &handles, rest)?;
        let constraints = Constraints { handles: &handles, anchors: &anchors, hold: grip.settings.hold, region: None };
        let system = systems.get(grip.settings.operator, &rest.topology, &rest.positions)?;
        let response = system.respond(&constraints)?;
        let partner_places = partner_places(&grip, &handles, rest)?;
        let offsets = vec![DVec3::ZERO; handles.len()];
        Ok(Self { grip, handles, anchors, partner_places, response, offsets })
    }

    pub(crate) fn grip(&self) -> &Grip {
        &self.grip
    }

    /// The handles with their partners.
    pub(crate) fn handles(&self) -> &[u32] {
        &self.handles
    }

    pub(crate) fn anchors(&self) -> &[u32] {
        &self.anchors
    }

    pub(crate) fn response(&self) -> &Response {
        &self.response
    }

    /// Writes `from`, moved by one offset for each of the grip's handles, to `out`. No solve, no allocation.
    pub(crate) fn displace(
        &mut self,
        rest: &Rest,
        from: &[DVec3],
        offsets: &[DVec3],
        out: &mut [DVec3],
    ) -> Result<(), StudioError> {
        self.check(offsets)?;
        self.offsets.fill(DVec3::ZERO);
        self.offsets[..offsets.len()].copy_from_slice(offsets);
        if self.grip.settings.mirror == Mirror::On {
            self.mirror_offsets(offsets.len());
        }
        self.response.displace(from, &self.offsets, out);
        if let (Mirror::On, Some(table)) = (self.grip.settings.mirror, &rest.mirror) {
            table.symmetrise_displacement(from, out);
        }
        Ok(())
    }

    pub(crate) fn command(&self, offsets: Vec<DVec3>) -> Command {
        Command::Move { grip: self.grip.clone(), offsets }
    }

    /// Partners that were not taken hold of follow the mirrored offset; those that were meet in the middle, which takes
    /// the sideways part from a handle of the midline.
    fn mirror_offsets(&mut self, given: usize) {
        for place in 0..given {
            let partner = self.partner_places[place];
            if partner >= given {
                self.offsets[partner] = reflected(self.offsets[place]);
            } else if partner >= place {
                let mean = (self.offsets[place] + reflected(self.offsets[partner])) / 2.0;
                self.offsets[place] = mean;
                self.offsets[partner] = reflected(mean);
            }
        }
    }

    fn check(&self, offsets: &[DVec3]) -> Result<(), StudioError> {
        let (expected, found) = (self.grip.handles.len(), offsets.len());
        if expected != found {
            return Err(StudioError::WrongOffsetCount { expected, found });
        }
        match offsets.iter().position(|offset| !offset.is_finite()) {
            Some(index) => Err(StudioError::OffsetNotFinite { handle: self.grip.handles[index] }),
            None => Ok(()),
        }
    }
}

/// The vertices and their partners. A vertex that is not there is left for the solver to refuse.
fn closure(rest: &Rest, vertices: &[u32]) -> Result<Vec<u32>, StudioError> {
    let table = rest.mirror.as_ref().ok_or(StudioError::NoMirror)?;
    if vertices.iter().any(|&vertex| vertex as usize >= rest.positions.len()) {
        return Ok(vertices.to_vec());
    }
    Ok(table.closure(vertices))
}

fn partner_places(grip: &Grip, handles: &[u32], rest: &Rest) -> Result<Vec<usize>, StudioError> {
    if grip.settings.mirror == Mirror::Off {
        return Ok((0..handles.len()).collect());
    }
    let table = rest.mirror.as_ref().ok_or(StudioError::NoMirror)?;
    let place = |vertex: &u32| handles.iter().position(|handle| *handle == table.partner(*vertex));
    Ok(handles.iter().map(|handle| place(handle).expect("invariant: handles are closed under the mirror")).collect())
}

/// The anchors that the settings ask for: pins, and those of the rule that are no handles.
fn anchors(grip: &Grip, handles: &[u32], rest: &Rest) -> Result<Vec<u32>, StudioError> {
    let Anchors { kind, pins } = &grip.settings.anchors;
    let vertex_count = rest.positions.len();
    let by_rule = match *kind {
        AnchorKind::PinsOnly => Vec::new(),
        AnchorKind::Oval => rest.oval.clone(),
        AnchorKind::Random { seed } => {
            let free = (0..vertex_count as u32).filter(|vertex| !handles.contains(vertex)).count();
            if free < 2 {
                return Err(StudioError::NoFreeAnchors { free });
            }
            random_anchors(vertex_count, handles, seed).to_vec()
        }
    };
    let mirrored = |vertices: &[u32]| match grip.settings.mirror {
        Mirror::Off => Ok(vertices.to_vec()),
        Mirror::On => closure(rest, vertices),
    };
    let mut anchors = mirrored(pins)?;
    for anchor in mirrored(&by_rule)? {
        if !handles.contains(&anchor) && !anchors.contains(&anchor) {
            anchors.push(anchor);
        }
    }
    Ok(anchors)
}
