use glam::DVec3;
use rosto_face::Parted;

use crate::{Command, Document, Entry, EntryStatus, Expression, StudioError};

/// A face in pieces: the mesh that is shown, parted at eyes and mouth. So that others can move it, where it is without
/// expressions, and what each of them displaces it by.
pub struct Rig {
    parted: Parted,
    base_m: Vec<DVec3>,
    layers: Vec<Layer>,
}

/// What moves the vertices of a [`Rig`]: an edit or an expression.
pub struct Layer {
    /// The label of the edit, or the expression's id.
    pub name: String,
    /// Displacement of each vertex at weight 1, in metres.
    pub displacements_m: Vec<DVec3>,
    /// How much of it the face shows.
    pub weight: f64,
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
        let mut layers = Vec::new();
        if edits == EditsInRig::Layers {
            base_m.copy_from_slice(document.rest());
            layers = edit_layers(document, &parted, |command| !matches!(command, Command::Express { .. }));
        }
        layers.extend(expressions.map(|((ways, expression), weight)| Layer {
            name: expression.id().to_owned(),
            displacements_m: parted.ways(&ways),
            weight,
        }));
        Ok(Self { base_m: parted.positions_m(&base_m), parted, layers })
    }

    /// The mesh that is shown at positions in metres, in its pieces: they lie behind lids and lips as these are without expressions.
    /// No expression can be moved in it. With layers it is the unedited face.
    pub fn still(document: &mut Document, edits: EditsInRig) -> Self {
        let parted = document.parted();
        if edits == EditsInRig::Layers {
            let layers = edit_layers(document, &parted, |_| true);
            return Self { base_m: parted.positions_m(document.rest()), parted, layers };
        }
        let skin_m = document.positions();
        let mut base_m = parted.positions_m(&document.relaxed(skin_m));
        base_m[..skin_m.len()].copy_from_slice(skin_m);
        Self { base_m, parted, layers: Vec::new() }
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

    /// The edits that are layers, and then the expressions.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }
}

/// What each entry that counts displaced the mesh by.
fn edit_layers(document: &mut Document, parted: &Parted, counts: impl Fn(&Command) -> bool) -> Vec<Layer> {
    let displacements = document.displacements();
    let edits = document.history().entries().iter().zip(displacements).filter(|(entry, _)| counts(&entry.command));
    let layer = |(entry, ways): (&Entry, Vec<DVec3>)| Layer {
        name: entry.label.clone(),
        displacements_m: parted.ways(&ways),
        weight: 1.0,
    };
    edits.map(layer).collect()
}

impl Document {
    /// How much of each expression the face shows: the sum of its entries in force, in the order of [`Expression::ALL`].
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
