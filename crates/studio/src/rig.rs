use glam::DVec3;
use rosto_face::Parted;

use crate::{Command, Document, Expression, Standing, StudioError};

/// A face in pieces: the mesh that is shown, parted at eyes and mouth. So that others can move it, where it is without
/// expressions, and what each of them displaces it by.
pub struct Rig {
    parted: Parted,
    base_m: Vec<DVec3>,
    layers_m: Vec<(String, Vec<DVec3>)>,
    expressions: Vec<(Expression, Vec<DVec3>, f64)>,
}

/// What the edits that are no expressions are in a [`Rig`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EditsInRig {
    /// Part of the face at rest.
    AtRest,
    /// A layer each, beside the unedited face.
    Layers,
}

impl Rig {
    /// Of a document as it was committed. Needs a solve for each expression that was not asked for yet.
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`] for what is no face in the model's frame.
    pub fn new(document: &mut Document, edits: EditsInRig) -> Result<Self, StudioError> {
        let weights = document.weights();
        let expressions = document.expressions()?.into_iter().zip(Expression::ALL).zip(weights);
        let parted = document.parted();
        let mut base_m = document.without_expressions();
        let expressions: Vec<_> =
            expressions.map(|((ways, expression), weight)| (expression, parted.ways(&ways), weight)).collect();
        let layers = if edits == EditsInRig::Layers { layers(document) } else { Vec::new() };
        if edits == EditsInRig::Layers {
            base_m.copy_from_slice(document.rest());
        }
        let layers_m = layers.into_iter().map(|(label, ways)| (label, parted.ways(&ways))).collect();
        Ok(Self { base_m: parted.positions_m(&base_m), parted, layers_m, expressions })
    }

    /// The mesh that is shown at positions in metres, in its pieces: they lie behind lids and lips as these are without expressions.
    /// No expression can be moved in it. With layers it is the unedited face.
    pub fn still(document: &mut Document, edits: EditsInRig) -> Self {
        let parted = document.parted();
        let (skin_m, relaxed_m, layers) = match edits {
            EditsInRig::AtRest => (document.positions().to_vec(), document.relaxed(document.positions()), Vec::new()),
            EditsInRig::Layers => (document.rest().to_vec(), document.rest().to_vec(), document.displacements()),
        };
        let mut base_m = parted.positions_m(&relaxed_m);
        base_m[..skin_m.len()].copy_from_slice(&skin_m);
        let labels = document.history().entries().iter().map(|entry| entry.label.clone());
        let layers_m = labels.zip(layers).map(|(label, ways)| (label, parted.ways(&ways))).collect();
        Self { base_m, parted, layers_m, expressions: Vec::new() }
    }

    /// The same with a dark mouth ([`Parted::darkened`]).
    #[must_use]
    pub fn darkened(self, colours_srgb: &[[u8; 3]]) -> Self {
        Self { parted: self.parted.darkened(colours_srgb), ..self }
    }

    /// The mesh in its pieces.
    pub fn parted(&self) -> &Parted {
        &self.parted
    }

    /// Where its vertices are, in metres, before any layer and expression.
    pub fn base_m(&self) -> &[DVec3] {
        &self.base_m
    }

    /// The edits that are layers: what each is called, and what it displaces the vertices by, in metres. All count fully.
    pub fn layers_m(&self) -> &[(String, Vec<DVec3>)] {
        &self.layers_m
    }

    /// Each expression with what it displaces the vertices by at 1, in metres, and how much of it the face shows.
    pub fn expressions(&self) -> &[(Expression, Vec<DVec3>, f64)] {
        &self.expressions
    }
}

/// What each entry that is no expression displaced the mesh by.
fn layers(document: &mut Document) -> Vec<(String, Vec<DVec3>)> {
    let displacements = document.displacements();
    let edits = document.history().entries().iter().zip(displacements);
    let edits = edits.filter(|(entry, _)| !matches!(entry.command, Command::Express { .. }));
    edits.map(|(entry, ways)| (entry.label.clone(), ways)).collect()
}

/// What expressions are to a document.
impl Document {
    /// How much of each expression the face shows: the sum of its entries in force, in the order of [`Expression::ALL`].
    pub fn weights(&self) -> [f64; Expression::ALL.len()] {
        let mut weights = [0.0; Expression::ALL.len()];
        for (index, entry) in self.history().entries().iter().enumerate() {
            if let (Command::Express { expression, weight }, Some(Standing::InForce)) =
                (&entry.command, self.standing(index))
            {
                weights[*expression as usize] += weight;
            }
        }
        weights
    }

    /// The mesh that is shown as it was committed, but for what expressions displaced it by.
    pub fn without_expressions(&self) -> Vec<DVec3> {
        self.relaxed(self.committed())
    }

    /// Positions of the mesh that is shown, but for what expressions displaced them by.
    fn relaxed(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let mut positions = positions.to_vec();
        for (expression, weight) in Expression::ALL.into_iter().zip(self.weights()).filter(|(_, weight)| *weight != 0.0)
        {
            let ways = self.expressed(expression);
            positions.iter_mut().zip(ways).for_each(|(position, way)| *position -= weight * *way);
        }
        positions
    }
}
