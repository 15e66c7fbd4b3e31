use glam::DVec3;
use rosto_face::SplitFace;

use crate::{Command, Document, Entry, EntryStatus, Expression, StudioError};

/// A face in pieces for animation in other programs: the displayed mesh, split at eyes and mouth, without expressions,
/// and the displacement by each expression.
pub struct Rig {
    split_face: SplitFace,
    base_m: Vec<DVec3>,
    layers: Vec<Layer>,
}

/// A displacement of the vertices of a [`Rig`]: an edit or an expression.
pub struct Layer {
    /// The edit's label or the expression's id.
    pub name: String,
    /// Displacement of each vertex at weight 1, in metres.
    pub displacements_m: Vec<DVec3>,
    /// Current weight.
    pub weight: f64,
}

/// How a [`Rig`] represents edits other than expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditsInRig {
    /// As part of the face at rest.
    AtRest,
    /// As one layer each, on the unedited face.
    Layers,
}

impl Rig {
    /// Creates the rig of a document's committed state. Solves for the expressions that have not been computed yet.
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`] if the mesh is not a face in the model's frame.
    pub fn new(document: &mut Document, edits: EditsInRig) -> Result<Self, StudioError> {
        let weights = document.weights();
        let expressions = document.expressions()?.into_iter().zip(Expression::ALL).zip(weights);
        let split_face = document.split_face();
        let mut base_m = document.without_expressions();
        let mut layers = Vec::new();
        if edits == EditsInRig::Layers {
            base_m.copy_from_slice(document.rest());
            layers = edit_layers(document, &split_face, |command| !matches!(command, Command::Express { .. }));
        }
        layers.extend(expressions.map(|((displacements, expression), weight)| Layer {
            name: expression.id().to_owned(),
            displacements_m: split_face.displacements(&displacements),
            weight,
        }));
        Ok(Self { base_m: split_face.positions_m(&base_m), split_face, layers })
    }

    /// Creates a rig without expressions: the displayed mesh at its current positions, in metres. The pieces behind
    /// lids and lips are placed as for the face without expressions. With layers, the base is the unedited face.
    pub fn still(document: &mut Document, edits: EditsInRig) -> Self {
        let split_face = document.split_face();
        if edits == EditsInRig::Layers {
            let layers = edit_layers(document, &split_face, |_| true);
            return Self { base_m: split_face.positions_m(document.rest()), split_face, layers };
        }
        let skin_m = document.positions();
        let mut base_m = split_face.positions_m(&document.relaxed(skin_m));
        base_m[..skin_m.len()].copy_from_slice(skin_m);
        Self { base_m, split_face, layers: Vec::new() }
    }

    /// Darkens the inside of the mouth ([`SplitFace::darkened`]).
    #[must_use]
    pub fn darkened(self, colours_srgb: &[[u8; 3]]) -> Self {
        Self { split_face: self.split_face.darkened(colours_srgb), ..self }
    }

    /// The mesh in its pieces.
    pub fn split_face(&self) -> &SplitFace {
        &self.split_face
    }

    /// Positions of the vertices in metres, without layers.
    pub fn base_m(&self) -> &[DVec3] {
        &self.base_m
    }

    /// The layers: edits first, then expressions.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }
}

/// Displacement by each entry whose command `counts` accepts.
fn edit_layers(document: &mut Document, split_face: &SplitFace, counts: impl Fn(&Command) -> bool) -> Vec<Layer> {
    let displacements = document.displacements();
    let edits = document.history().entries().iter().zip(displacements).filter(|(entry, _)| counts(&entry.command));
    let layer = |(entry, displacements): (&Entry, Vec<DVec3>)| Layer {
        name: entry.label.clone(),
        displacements_m: split_face.displacements(&displacements),
        weight: 1.0,
    };
    edits.map(layer).collect()
}

impl Document {
    /// Weight of each expression: the sum over entries in force, in the order of [`Expression::ALL`].
    pub fn weights(&self) -> [f64; Expression::ALL.len()] {
        let mut weights = [0.0; Expression::ALL.len()];
        for (index, entry) in self.history().entries().iter().enumerate() {
            if let (Command::Express { expression, weight }, Some(EntryStatus::InForce)) =
                (&entry.command, self.status(index))
            {
                weights[*expression as usize] += weight;
            }
        }
        weights
    }

    /// Committed positions of the displayed mesh, minus the displacements by expressions.
    pub fn without_expressions(&self) -> Vec<DVec3> {
        self.relaxed(self.committed())
    }

    /// Positions of the displayed mesh, minus the displacements by expressions.
    fn relaxed(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let mut positions = positions.to_vec();
        for (expression, weight) in Expression::ALL.into_iter().zip(self.weights()).filter(|(_, weight)| *weight != 0.0)
        {
            let displacements = self.expression_displacements(expression);
            positions
                .iter_mut()
                .zip(displacements)
                .for_each(|(position, displacement)| *position -= weight * *displacement);
        }
        positions
    }
}
