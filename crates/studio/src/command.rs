use glam::DVec3;
use rosto_laplacian::{ConstraintKind, Operator};

use crate::Expression;

/// One change to the mesh, as the history keeps it.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Moves handles; the rest follows by δ-coordinates.
    Move {
        /// Which vertices are moved, and how the rest follows.
        spec: EditSpec,
        /// One offset for each handle of the spec, in the document's unit.
        offsets: Vec<DVec3>,
    },
    /// Brings the two sides of the face closer to each other.
    Symmetrise {
        /// 0 changes nothing; 1 leaves both sides mirror images.
        share: f64,
    },
    /// Adds to how far the face shows an expression. What it moves depends on the face at rest alone, so that the weights of
    /// several such commands add up.
    Express {
        /// Which one.
        expression: Expression,
        /// −1..=1: 1 is all of it, and −1 takes that back.
        weight: f64,
    },
}

/// Vertices taken hold of together, and how the rest of the mesh is to follow them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EditSpec {
    /// How often the mesh that the handles belong to was subdivided: 0 is the cage itself. What is moved there is carried
    /// over to the denser meshes.
    pub level: u32,
    /// The vertices that are moved, each once.
    pub handles: Vec<u32>,
    /// How the rest follows.
    pub settings: Settings,
}

/// How the mesh follows its handles. The default is the paper's edit, with the face's oval for anchors.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    /// The Laplacian, over the mesh at rest.
    pub operator: Operator,
    /// How firmly handles and anchors are held.
    pub constraint: ConstraintKind,
    /// What stays in place.
    pub anchors: Anchors,
    /// How far the edit reaches.
    pub influence: RegionOfInfluence,
    /// Whether the other side of the face takes part.
    pub mirror: Mirror,
    /// Whether details turn with the surface.
    pub details: Details,
}

/// What stays in place while handles move.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Anchors {
    /// Anchors that a rule names.
    pub kind: AnchorKind,
    /// Anchors named one by one, beside those of the rule.
    pub pins: Vec<u32>,
}

impl Anchors {
    /// Exactly these vertices.
    pub fn explicit(pins: Vec<u32>) -> Self {
        Self { kind: AnchorKind::PinsOnly, pins }
    }

    /// The paper's: two random vertices that are not handles; the same for the same seed.
    pub fn random(seed: u64) -> Self {
        Self { kind: AnchorKind::Random { seed }, pins: Vec::new() }
    }
}

/// A rule that names anchors. A handle is never an anchor by rule.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum AnchorKind {
    /// No rule: only what is pinned.
    PinsOnly,
    /// Two random vertices.
    Random {
        /// The same seed gives the same two.
        seed: u64,
    },
    /// The face's oval, or the mesh's longest boundary if it is no face.
    #[default]
    Oval,
    /// Everything further from the handles than this.
    Outside {
        /// Along the surface at rest, in the document's unit.
        radius: f64,
    },
}

/// How far an edit reaches.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum RegionOfInfluence {
    /// Over the whole mesh.
    #[default]
    Whole,
    /// Fading out smoothly; nothing further from the handles than this moves.
    Within {
        /// Along the surface at rest, in the document's unit.
        radius: f64,
    },
}

rosto_mesh::named! {
    /// Whether details turn with the surface around them.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Details {
        /// They keep their direction: δ-coordinates as in the paper.
        #[default]
        Kept = "kept",
        /// They turn: as rigid as possible. Solved anew for every offset, so that a tick costs several solves.
        AsRigidAsPossible = "turned",
    }
}

rosto_mesh::named! {
    /// Whether the other side of the face takes part in an edit.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Mirror {
        /// Each side is on its own.
        #[default]
        Off = "off",
        /// Partners move by the mirrored offset, and vertices of the midline stay in its plane. It is the change that is
        /// mirrored and not the shape, so that natural asymmetry survives.
        On = "on",
    }
}
