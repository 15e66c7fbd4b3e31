use glam::DVec3;
use rosto_face::MAX_DENSITY;

use super::Document;
use super::points::nearest;
use crate::level::{Level, Rest};
use crate::mirror::{MirrorTable, reflected};
use crate::{Command, EditSpec, Mirror, StudioError};

impl Document {
    /// Creates a document with the same landmarks and another triangulation or other positions. It continues this
    /// document's history, including undone changes. Edits of points of a denser mesh move to the nearest points of the
    /// new one.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] if the positions do not fit the mesh or are not finite. Entries that cannot be
    /// applied to the new mesh are skipped.
    pub fn over(&mut self, rest: Rest) -> Result<Self, StudioError> {
        self.fault.check()?;
        let mut document = Self::new(rest)?;
        document.fault = self.fault;
        let levels = self.history.commands().filter_map(|command| match command {
            Command::Move { spec, .. } => Some(spec.level),
            Command::Symmetrise { .. } | Command::Express { .. } => None,
        });
        let highest = levels.filter(|level| *level <= MAX_DENSITY).max().unwrap_or(0);
        if self.levels[0].topology() == document.levels[0].topology() {
            // Same vertices, other positions.
            document.history = self.history.clone();
            document.replay_from(0);
            return Ok(document);
        }
        self.subdivide_to(highest);
        document.subdivide_to(highest);
        let history = self.history.clone().with_commands(|command| {
            if let Command::Move { spec, offsets } = command
                && (1..=highest).contains(&spec.level)
            {
                let level = spec.level as usize;
                transfer(spec, offsets, &self.levels[level], &document.levels[level]);
            }
        });
        document.history = history;
        document.replay_from(0);
        Ok(document)
    }
}

fn transfer(spec: &mut EditSpec, offsets: &mut Vec<DVec3>, from: &Level, to: &Level) {
    if spec.settings.mirror == Mirror::On
        && to.mirror().is_err()
        && let Ok(table) = from.mirror()
    {
        spell_out_mirror(spec, offsets, table);
    }
    let nearest_vertex = |vertex: u32| match from.rest().get(vertex as usize) {
        Some(position) => nearest(to.rest(), *position).unwrap_or(vertex),
        None => vertex,
    };
    let handles: Vec<u32> = spec.handles.iter().map(|handle| nearest_vertex(*handle)).collect();
    (spec.handles, *offsets) = merged(&handles, offsets);
    let pins = &mut spec.settings.anchors.pins;
    pins.iter_mut().for_each(|pin| *pin = nearest_vertex(*pin));
    pins.sort_unstable();
    pins.dedup();
    pins.retain(|pin| !spec.handles.contains(pin));
}

/// Removes repeated handles: those that map to one vertex move it by the mean of their offsets.
fn merged(handles: &[u32], offsets: &[DVec3]) -> (Vec<u32>, Vec<DVec3>) {
    let mut merged: Vec<(u32, DVec3, f64)> = Vec::with_capacity(handles.len());
    for (handle, offset) in handles.iter().zip(offsets) {
        match merged.iter_mut().find(|(vertex, ..)| vertex == handle) {
            Some((_, sum, count)) => (*sum, *count) = (*sum + *offset, *count + 1.0),
            None => merged.push((*handle, *offset, 1.0)),
        }
    }
    merged.into_iter().map(|(handle, sum, count)| (handle, sum / count)).unzip()
}

/// Adds partners as explicit handles, for a mesh whose triangles are not symmetric.
fn spell_out_mirror(spec: &mut EditSpec, offsets: &mut Vec<DVec3>, table: &MirrorTable) {
    let given = spec.handles.len();
    spec.handles = table.closure(&spec.handles);
    for (handle, offset) in spec.handles.iter().zip(offsets.iter_mut()) {
        if table.partner(*handle) == *handle {
            offset.x = 0.0;
        }
    }
    let added = spec.handles[given..].iter().map(|handle| {
        let position = spec.handles[..given].iter().position(|given| table.partner(*given) == *handle);
        reflected(offsets[position.expect("invariant: a partner was added for one of the handles")])
    });
    let added: Vec<DVec3> = added.collect();
    offsets.extend(added);
    spec.settings.anchors.pins = table.closure(&spec.settings.anchors.pins);
    spec.settings.mirror = Mirror::Off;
}
