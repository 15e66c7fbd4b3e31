use std::sync::Arc;

use glam::DVec3;
use rosto_laplacian::{LaplacianError, Response};

use super::Document;
use crate::expression_cache;
use crate::level::Level;
use crate::level_positions::{LevelPositions, Scratch};
use crate::prepared_edit::PreparedEdit;
use crate::shape::Shape;
use crate::{Command, Details, EditSpec, Entry, EntryStatus, Expression, InfluenceWeights, StudioError, Switch};

/// The offsets being previewed and the resulting positions.
#[derive(Clone)]
pub(super) struct Preview {
    offsets: Vec<DVec3>,
    /// Positions of the displayed mesh.
    positions: Vec<DVec3>,
    shape: Shape,
    /// Receives the next shape; copied to `shape` once it is complete.
    next: Shape,
    levels: LevelPositions,
    moved: Vec<DVec3>,
    scratch: Scratch,
    /// Weights of the previewed expressions.
    weights: Vec<(Expression, f64)>,
    kind: PreviewKind,
}

/// The kind of edit in progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum PreviewKind {
    None,
    /// The prepared edit.
    Prepared,
    Expressions,
}

impl Preview {
    pub(super) fn none(unedited: &Shape, levels: &[Level]) -> Self {
        let (shape, levels) = (unedited.clone(), unedited.positions(levels));
        Self {
            offsets: Vec::new(),
            positions: levels.densest().to_vec(),
            next: shape.clone(),
            shape,
            levels,
            moved: Vec::new(),
            scratch: Scratch::default(),
            weights: Vec::new(),
            kind: PreviewKind::None,
        }
    }

    /// Positions of the displayed mesh while an edit is in progress.
    pub(super) fn positions(&self) -> Option<&[DVec3]> {
        (self.kind != PreviewKind::None).then_some(&self.positions[..])
    }
}

/// Methods of the edit in progress.
impl Document {
    /// Prepares an edit: one solve. Cancels an edit in progress. The prepared edit survives commits, so the same
    /// vertices can be moved again without another solve.
    ///
    /// # Errors
    /// [`StudioError`] if the spec has no solution; the previously prepared edit is retained.
    pub fn prepare(&mut self, spec: EditSpec) -> Result<(), StudioError> {
        self.fault.check()?;
        if self.prepared.as_ref().is_none_or(|prepared| *prepared.spec() != spec) {
            let mut prepared = self.prepare_edit(spec)?;
            let influence = self.influence_of(&mut prepared)?;
            (self.prepared, self.influence) = (Some(prepared), Some(influence));
        }
        self.cancel();
        Ok(())
    }

    /// Releases the prepared edit and cancels an edit in progress.
    pub fn release(&mut self) {
        self.cancel();
        self.prepared = None;
        self.influence = None;
    }

    /// The spec of the prepared edit.
    pub fn spec(&self) -> Option<&EditSpec> {
        self.prepared.as_ref().map(PreparedEdit::spec)
    }

    /// The vertices that move by a given offset: the spec's handles, then the partners that the mirror adds.
    pub fn handles(&self) -> &[u32] {
        self.prepared.as_ref().map_or(&[], PreparedEdit::handles)
    }

    /// The vertices that the prepared edit keeps in place.
    pub fn anchors(&self) -> &[u32] {
        self.prepared.as_ref().map_or(&[], PreparedEdit::anchors)
    }

    /// Response of each vertex of the spec's level to each of [`Self::handles`], if details keep their direction.
    pub fn response(&self) -> Option<&Response> {
        self.prepared.as_ref().map(PreparedEdit::response)
    }

    /// Influence of the spec's handles on each displayed vertex when they move by one common offset and details keep
    /// their direction. If details rotate, it is the initial guess of the solver.
    pub fn influence(&self) -> Option<&InfluenceWeights> {
        self.influence.as_ref()
    }

    /// Distance of each displayed vertex from the handles along the surface at rest; 1 is the influence radius. `None`
    /// without a prepared edit or if it affects the whole mesh.
    pub fn influence_distances(&self) -> Option<Vec<f64>> {
        let prepared = self.prepared.as_ref()?;
        let steps = &self.levels[prepared.spec().level as usize..self.density as usize];
        Some(
            steps.iter().fold(prepared.influence_distances()?.to_vec(), |distances, level| {
                level.finer().interpolate(&distances)
            }),
        )
    }

    /// Moves the spec's handles by one offset each, relative to the last commit and in the document's unit. Unless
    /// details rotate, there is no solve and, after the first call, no allocation.
    ///
    /// # Errors
    /// [`StudioError::NothingPrepared`], [`StudioError::WrongOffsetCount`] or [`StudioError::OffsetNotFinite`], or
    /// [`StudioError::Laplacian`] if rotating details do not converge. The previous preview is retained.
    pub fn preview(&mut self, offsets: &[DVec3]) -> Result<(), StudioError> {
        self.fault.check()?;
        self.check_room(1)?;
        let prepared = self.prepared.as_ref().ok_or(StudioError::NothingPrepared)?;
        if prepared.is_stale() {
            self.prepared = Some(self.prepare_edit(prepared.spec().clone())?);
        }
        let prepared = self.prepared.as_mut().ok_or(StudioError::NothingPrepared)?;
        let (from, preview) = (self.replayed.last(), &mut self.preview);
        prepared.check(offsets)?;
        if let Some(influence) = uniform_influence(&self.influence, prepared, offsets, self.density) {
            influence.displace(self.committed.densest(), offsets[0], &mut preview.positions);
        } else {
            preview.next.copy_from(from);
            preview.next.displace(&self.levels, prepared, offsets, &mut preview.moved)?;
            preview.shape.copy_from(&preview.next);
            preview.shape.write_positions(&self.levels, &mut preview.levels, &mut preview.scratch);
            preview.positions.copy_from_slice(preview.levels.densest());
        }
        self.preview.offsets.clear();
        self.preview.offsets.extend_from_slice(offsets);
        self.preview.kind = PreviewKind::Prepared;
        Ok(())
    }

    /// Adds expressions, by weight, to the shape after the last commit. The prepared edit is retained and does not
    /// move. Solves only for expressions that have not been computed yet.
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`], [`StudioError::Weight`], or [`StudioError::Laplacian`] if the face has no
    /// solution. The previous preview is retained.
    pub fn preview_expressions(&mut self, weights: &[(Expression, f64)]) -> Result<(), StudioError> {
        self.fault.check()?;
        self.check_room(weights.len())?;
        for &(expression, weight) in weights {
            self.check_expression(weight)?;
            expression_cache::prepare(&mut self.levels, self.density, expression)?;
        }
        let preview = &mut self.preview;
        preview.positions.copy_from_slice(self.committed.densest());
        for &(expression, weight) in weights {
            let displacements =
                self.levels[self.density as usize].expression_cache().displacements(expression).unwrap_or_default();
            preview
                .positions
                .iter_mut()
                .zip(displacements)
                .for_each(|(position, displacement)| *position += weight * *displacement);
        }
        preview.weights.clear();
        preview.weights.extend_from_slice(weights);
        preview.kind = PreviewKind::Expressions;
        Ok(())
    }

    /// Adds the edit in progress to the history as one entry and discards undone changes. Expressions become one entry
    /// each, labelled with their ids, and one change. Does nothing without an edit in progress.
    pub fn commit(&mut self, label: &str) {
        if self.preview.kind == PreviewKind::Expressions {
            self.commit_expressions();
        } else if let (PreviewKind::Prepared, Some(prepared)) = (self.preview.kind, &mut self.prepared) {
            let (from, preview) = (self.replayed.last(), &mut self.preview);
            if uniform_influence(&self.influence, prepared, &preview.offsets, self.density).is_some() {
                preview.shape.copy_from(from);
                let moved = preview.shape.displace(&self.levels, prepared, &preview.offsets, &mut preview.moved);
                moved.expect("invariant: the preview has checked these offsets");
            }
            let command = prepared.command(self.preview.offsets.clone());
            self.history.push(Entry { label: label.to_owned(), command, switch: Switch::On });
            self.replayed.push(Arc::new(self.preview.shape.clone()), EntryStatus::InForce);
            self.settle();
        }
        self.end_preview();
    }

    fn commit_expressions(&mut self) {
        if self.preview.weights.is_empty() {
            return;
        }
        let mut entries = Vec::with_capacity(self.preview.weights.len());
        for &(expression, weight) in &self.preview.weights {
            let mut shape = Shape::clone(self.replayed.last());
            shape.express(&mut self.levels, expression, weight).expect("invariant: the preview has computed it");
            self.replayed.push(Arc::new(shape), EntryStatus::InForce);
            let command = Command::Express { expression, weight };
            entries.push(Entry { label: expression.id().to_owned(), command, switch: Switch::On });
        }
        self.history.push_all(entries);
        self.settle();
    }

    /// Computes the positions after the last entry.
    pub(super) fn settle(&mut self) {
        self.committed = Arc::new(self.replayed.last().positions(&self.levels));
    }

    /// Discards the edit in progress; the prepared edit is retained.
    pub fn cancel(&mut self) {
        self.preview.kind = PreviewKind::None;
    }

    /// Ends the edit in progress because the positions that the next one starts from have changed.
    pub(super) fn end_preview(&mut self) {
        self.cancel();
        if let Some(prepared) = &mut self.prepared {
            prepared.start_changed();
        }
    }

    fn prepare_edit(&mut self, spec: EditSpec) -> Result<PreparedEdit, StudioError> {
        self.check_spec(&spec)?;
        self.check_work_with(&spec)?;
        prepare_edit(&mut self.levels, self.density, self.replayed.last(), spec)
    }

    /// Computes [`Self::influence`] for a prepared edit.
    fn influence_of(&mut self, prepared: &mut PreparedEdit) -> Result<InfluenceWeights, StudioError> {
        let from = self.replayed.last();
        let mut first_guess = None;
        if prepared.spec().settings.details == Details::AsRigidAsPossible {
            let mut spec = prepared.spec().clone();
            spec.settings.details = Details::Kept;
            first_guess = Some(prepare_edit(&mut self.levels, self.density, from, spec)?);
        }
        let prepared = first_guess.as_mut().unwrap_or(prepared);
        let handles = prepared.spec().handles.len();
        let mut along = |axis: DVec3| {
            let mut shape = Shape::at_rest(&self.levels[..=self.density as usize]);
            shape.displace(&self.levels, prepared, &vec![axis; handles], &mut Vec::new())?;
            let positions = shape.positions(&self.levels);
            Ok::<_, StudioError>(positions.densest().iter().zip(self.rest()).map(|(to, at)| *to - *at).collect())
        };
        let (along_x, along_y): (Vec<DVec3>, Vec<DVec3>) = (along(DVec3::X)?, along(DVec3::Y)?);
        match along_x.iter().chain(&along_y).position(|displacement| !displacement.is_finite()) {
            Some(index) => Err(LaplacianError::NotFinite { vertex: (index % along_x.len()) as u32 }.into()),
            None => Ok(InfluenceWeights::from_displacements(&along_x, &along_y)),
        }
    }
}

pub(super) fn prepare_edit(
    levels: &mut [Level],
    density: u32,
    from: &Shape,
    spec: EditSpec,
) -> Result<PreparedEdit, StudioError> {
    let level = spec.level;
    if level > density {
        return Err(StudioError::TooCoarse { level, density });
    }
    let from = match spec.settings.details {
        Details::Kept => None,
        Details::AsRigidAsPossible => Some(from.positions_to(levels, level)),
    };
    let from = from.as_ref().map_or(&[][..], LevelPositions::densest);
    PreparedEdit::new(spec, &mut levels[level as usize], from)
}

/// Influence weights that replace the interpolation from level to level during a tick, if they apply: the handles share
/// one offset, the displayed mesh is denser than the spec's, and details keep their direction. They equal the
/// interpolation up to rounding; a commit interpolates, so that a replay gives the same bits.
fn uniform_influence<'a>(
    influence: &'a Option<InfluenceWeights>,
    prepared: &PreparedEdit,
    offsets: &[DVec3],
    density: u32,
) -> Option<&'a InfluenceWeights> {
    let as_one = offsets.iter().all(|offset| *offset == offsets[0]);
    let EditSpec { level, settings, .. } = prepared.spec();
    influence.as_ref().filter(|_| as_one && *level < density && settings.details == Details::Kept)
}
