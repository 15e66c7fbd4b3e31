use std::sync::Arc;

use glam::DVec3;
use rosto_laplacian::{LaplacianError, Response};

use super::Document;
use crate::expressed;
use crate::level::Level;
use crate::level_positions::{LevelPositions, Scratch};
use crate::prepared_edit::PreparedEdit;
use crate::{Command, Details, EditSpec, Entry, EntryStatus, Expression, InfluenceWeights, StudioError, Switch};

/// The spec's offsets and the positions they lead to, while vertices are being moved.
#[derive(Clone)]
pub(super) struct Preview {
    offsets: Vec<DVec3>,
    /// Of the mesh that is shown.
    positions: Vec<DVec3>,
    shape: LevelPositions,
    /// Takes the next shape, which takes the other's place once it is whole.
    next: LevelPositions,
    scratch: Scratch,
    /// How much of which expressions, where they are what is under way.
    weights: Vec<(Expression, f64)>,
    under_way: UnderWay,
}

/// What is being moved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum UnderWay {
    Nothing,
    /// What is held.
    Prepared,
    Expressions,
}

impl Preview {
    pub(super) fn none(unedited: &LevelPositions) -> Self {
        let (shape, positions) = (unedited.clone(), unedited.densest().to_vec());
        Self {
            offsets: Vec::new(),
            positions,
            next: shape.clone(),
            shape,
            scratch: Scratch::default(),
            weights: Vec::new(),
            under_way: UnderWay::Nothing,
        }
    }

    /// Those of the mesh that is shown, while vertices are being moved.
    pub(super) fn positions(&self) -> Option<&[DVec3]> {
        (self.under_way != UnderWay::Nothing).then_some(&self.positions[..])
    }
}

/// The edit in progress.
impl Document {
    /// Takes hold of vertices: one solve. An edit in progress is cancelled; the spec stays over commits, so that the
    /// same vertices can be moved again without another solve.
    ///
    /// # Errors
    /// [`StudioError`] if the spec has no answer; what was held stays held.
    pub fn prepare(&mut self, spec: EditSpec) -> Result<(), StudioError> {
        self.fault.check()?;
        if self.prepared.as_ref().is_none_or(|prepared| *prepared.spec() != spec) {
            let mut prepared = self.made_ready(spec)?;
            let influence = self.influence_of(&mut prepared)?;
            (self.prepared, self.influence) = (Some(prepared), Some(influence));
        }
        self.cancel();
        Ok(())
    }

    /// Lets go; an edit in progress is cancelled.
    pub fn release(&mut self) {
        self.cancel();
        self.prepared = None;
        self.influence = None;
    }

    /// The spec that is held.
    pub fn spec(&self) -> Option<&EditSpec> {
        self.prepared.as_ref().map(PreparedEdit::spec)
    }

    /// All vertices that move by their own offset: the spec's handles, then the partners that the mirror adds.
    pub fn handles(&self) -> &[u32] {
        self.prepared.as_ref().map_or(&[], PreparedEdit::handles)
    }

    /// The vertices that the spec keeps in place.
    pub fn anchors(&self) -> &[u32] {
        self.prepared.as_ref().map_or(&[], PreparedEdit::anchors)
    }

    /// How every vertex of the spec's level follows each of [`Self::handles`], if details keep their direction.
    pub fn response(&self) -> Option<&Response> {
        self.prepared.as_ref().map(PreparedEdit::response)
    }

    /// How every vertex shown follows the spec's handles when they move by one offset and details keep their direction.
    /// Where details turn, the first guess that they start from.
    pub fn influence(&self) -> Option<&InfluenceWeights> {
        self.influence.as_ref()
    }

    /// How far each vertex shown is from what is held, along the surface at rest: 1 where an edit ends. None while nothing
    /// is held, or what is held moves the whole mesh.
    pub fn influence_distances(&self) -> Option<Vec<f64>> {
        let prepared = self.prepared.as_ref()?;
        let steps = &self.levels[prepared.spec().level as usize..self.density as usize];
        Some(
            steps.iter().fold(prepared.influence_distances()?.to_vec(), |distances, level| {
                level.finer().interpolate(&distances)
            }),
        )
    }

    /// Moves what is held by one offset for each of the spec's handles, counted from the last commit, in the document's
    /// unit. Unless details turn: no solve and, after the first call, no allocation.
    ///
    /// # Errors
    /// [`StudioError::NothingPrepared`], [`StudioError::WrongOffsetCount`] or [`StudioError::OffsetNotFinite`], or
    /// [`StudioError::Laplacian`] for details that find no rest. What was moved before stays where it was.
    pub fn preview(&mut self, offsets: &[DVec3]) -> Result<(), StudioError> {
        self.fault.check()?;
        let prepared = self.prepared.as_ref().ok_or(StudioError::NothingPrepared)?;
        if prepared.is_stale() {
            self.prepared = Some(self.made_ready(prepared.spec().clone())?);
        }
        let prepared = self.prepared.as_mut().ok_or(StudioError::NothingPrepared)?;
        let (from, preview) = (self.replayed.last(), &mut self.preview);
        prepared.check(offsets)?;
        if let Some(influence) = carried(&self.influence, prepared, offsets, self.density) {
            influence.displace(from.densest(), offsets[0], &mut preview.positions);
        } else {
            preview.next.displace(&self.levels, from, prepared, offsets, &mut preview.scratch)?;
            std::mem::swap(&mut preview.shape, &mut preview.next);
            preview.positions.copy_from_slice(preview.shape.densest());
        }
        self.preview.offsets.clear();
        self.preview.offsets.extend_from_slice(offsets);
        self.preview.under_way = UnderWay::Prepared;
        Ok(())
    }

    /// Adds so much of each expression to the shape after the last commit; what is held stays held, and does not move. No solve
    /// but for the first time that one is asked for.
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`], [`StudioError::Weight`], or [`StudioError::Laplacian`] for a face that has no answer.
    /// What was moved before stays where it was.
    pub fn preview_expressions(&mut self, weights: &[(Expression, f64)]) -> Result<(), StudioError> {
        self.fault.check()?;
        for &(expression, weight) in weights {
            self.check_expression(weight)?;
            expressed::prepare(&mut self.levels, self.density, expression)?;
        }
        let (from, preview) = (self.replayed.last().densest(), &mut self.preview);
        preview.positions.copy_from_slice(from);
        for &(expression, weight) in weights {
            let ways = self.levels[self.density as usize].expressed().ways(expression).unwrap_or_default();
            preview.positions.iter_mut().zip(ways).for_each(|(position, way)| *position += weight * *way);
        }
        preview.weights.clear();
        preview.weights.extend_from_slice(weights);
        preview.under_way = UnderWay::Expressions;
        Ok(())
    }

    /// Makes the edit in progress one entry of the history; what was undone is forgotten. Expressions become an entry each, with
    /// their own labels, and one change. Without an edit in progress, nothing happens.
    pub fn commit(&mut self, label: &str) {
        if self.preview.under_way == UnderWay::Expressions {
            self.commit_expressions();
        } else if let (UnderWay::Prepared, Some(prepared)) = (self.preview.under_way, &mut self.prepared) {
            let (from, preview) = (self.replayed.last(), &mut self.preview);
            if carried(&self.influence, prepared, &preview.offsets, self.density).is_some() {
                let moved =
                    preview.shape.displace(&self.levels, from, prepared, &preview.offsets, &mut preview.scratch);
                moved.expect("invariant: the preview has checked these offsets");
            }
            let command = prepared.command(self.preview.offsets.clone());
            self.history.push(Entry { label: label.to_owned(), command, switch: Switch::On });
            self.replayed.push(Arc::new(self.preview.shape.clone()), EntryStatus::InForce);
        }
        self.settle_down();
    }

    fn commit_expressions(&mut self) {
        if self.preview.weights.is_empty() {
            return;
        }
        let mut entries = Vec::with_capacity(self.preview.weights.len());
        for &(expression, weight) in &self.preview.weights {
            let mut shape = LevelPositions::clone(self.replayed.last());
            shape.express(&self.levels, expression, weight);
            self.replayed.push(Arc::new(shape), EntryStatus::InForce);
            let command = Command::Express { expression, weight };
            entries.push(Entry { label: expression.id().to_owned(), command, switch: Switch::On });
        }
        self.history.push_all(entries);
    }

    /// Drops the edit in progress; the spec stays.
    pub fn cancel(&mut self) {
        self.preview.under_way = UnderWay::Nothing;
    }

    /// Ends the edit in progress after the start of the next one has changed.
    pub(super) fn settle_down(&mut self) {
        self.cancel();
        if let Some(prepared) = &mut self.prepared {
            prepared.start_changed();
        }
    }

    fn made_ready(&mut self, spec: EditSpec) -> Result<PreparedEdit, StudioError> {
        self.check_grip(&spec)?;
        made_ready(&mut self.levels, self.density, self.replayed.last(), spec)
    }

    /// What [`Self::influence`] says of a spec.
    fn influence_of(&mut self, prepared: &mut PreparedEdit) -> Result<InfluenceWeights, StudioError> {
        let from = self.replayed.last();
        let mut kept = None;
        if prepared.spec().settings.details == Details::AsRigidAsPossible {
            let mut spec = prepared.spec().clone();
            spec.settings.details = Details::Kept;
            kept = Some(made_ready(&mut self.levels, self.density, from, spec)?);
        }
        let prepared = kept.as_mut().unwrap_or(prepared);
        // Not the preview's own: an edit in progress stays as it is should this fail.
        let (mut shape, mut scratch) = (LevelPositions::clone(from), Scratch::default());
        let handles = prepared.spec().handles.len();
        let mut along = |axis: DVec3| {
            shape.displace(&self.levels, from, prepared, &vec![axis; handles], &mut scratch)?;
            Ok::<_, StudioError>(shape.densest().iter().zip(from.densest()).map(|(to, at)| *to - *at).collect())
        };
        let (along_x, along_y): (Vec<DVec3>, Vec<DVec3>) = (along(DVec3::X)?, along(DVec3::Y)?);
        match along_x.iter().chain(&along_y).position(|way| !way.is_finite()) {
            Some(place) => Err(LaplacianError::NotFinite { vertex: (place % along_x.len()) as u32 }.into()),
            None => Ok(InfluenceWeights::from_displacements(&along_x, &along_y)),
        }
    }
}

pub(super) fn made_ready(
    levels: &mut [Level],
    density: u32,
    from: &LevelPositions,
    spec: EditSpec,
) -> Result<PreparedEdit, StudioError> {
    let level = spec.level;
    if level > density {
        return Err(StudioError::TooCoarse { level, density });
    }
    PreparedEdit::new(spec, &mut levels[level as usize], from.at(level))
}

/// The short way from a spec to a denser mesh that is shown: what each tick would else carry over, level by level. Equal
/// to it but for rounding, so that a commit takes the long way, as a replay does.
fn carried<'a>(
    influence: &'a Option<InfluenceWeights>,
    prepared: &PreparedEdit,
    offsets: &[DVec3],
    density: u32,
) -> Option<&'a InfluenceWeights> {
    let as_one = offsets.iter().all(|offset| *offset == offsets[0]);
    let EditSpec { level, settings, .. } = prepared.spec();
    influence.as_ref().filter(|_| as_one && *level < density && settings.details == Details::Kept)
}
