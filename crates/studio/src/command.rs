use glam::DVec3;
use rosto_face::Region;
use rosto_laplacian::{ConstraintKind, Operator};

use crate::Expression;

/// A change to the mesh, as stored in the history.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Moves handles; the other vertices follow through their δ-coordinates.
    Move {
        /// The handles and the edit's settings.
        spec: EditSpec,
        /// Offset of each handle, in the document's unit; same order as `spec.handles`.
        offsets: Vec<DVec3>,
    },
    /// Moves both sides of the face towards symmetry.
    Symmetrise {
        /// 0 changes nothing; 1 makes the sides mirror images.
        share: f64,
    },
    /// Adds an expression. The displacement depends only on the face at rest, so the weights of several such commands
    /// add up.
    Express {
        /// The expression.
        expression: Expression,
        /// −1..=1: 1 is the full expression; −1 cancels a weight of 1.
        weight: f64,
    },
}

impl Command {
    /// Moves a vertex of the mesh at a subdivision level, with the default settings.
    pub fn move_vertex(level: u32, vertex: u32, offset: DVec3) -> Self {
        let spec = EditSpec { level, handles: vec![vertex], settings: Settings::default() };
        Self::Move { spec, offsets: vec![offset] }
    }

    /// Moves the landmarks of a region, with the default settings.
    pub fn move_region(region: Region, offset: DVec3) -> Self {
        let spec = EditSpec { level: 0, handles: region.vertices(), settings: Settings::default() };
        Self::Move { offsets: vec![offset; spec.handles.len()], spec }
    }
}

/// Vertices that an edit moves together, and how the rest of the mesh follows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EditSpec {
    /// Subdivision level of the mesh that the handles belong to; 0 is the cage. The edit is interpolated to denser
    /// meshes.
    pub level: u32,
    /// The moved vertices, without repeats.
    pub handles: Vec<u32>,
    /// How the other vertices follow.
    pub settings: Settings,
}

/// How the mesh follows its handles. The default is the paper's edit, with the face's oval as anchors.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    /// The discrete Laplacian of the mesh at rest.
    pub operator: Operator,
    /// How firmly handles and anchors are held: soft with a weight, or hard.
    pub constraint: ConstraintKind,
    /// The vertices that stay in place.
    pub anchors: Anchors,
    /// The region that the edit affects.
    pub influence: RegionOfInfluence,
    /// Whether the edit is mirrored to the other side of the face.
    pub mirror: Mirror,
    /// Whether details rotate with the surface.
    pub details: Details,
}

/// Vertices that stay in place while handles move.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Anchors {
    /// The rule that selects anchors.
    pub kind: AnchorKind,
    /// Anchors set one by one, in addition to those of the rule.
    pub pins: Vec<u32>,
}

impl Anchors {
    /// Anchors at exactly these vertices.
    pub fn explicit(pins: Vec<u32>) -> Self {
        Self { kind: AnchorKind::PinsOnly, pins }
    }

    /// The paper's anchors: two random vertices that are not handles. The same seed gives the same vertices.
    pub fn random(seed: u64) -> Self {
        Self { kind: AnchorKind::Random { seed }, pins: Vec::new() }
    }
}

/// A rule that selects anchors. The rule skips handles.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum AnchorKind {
    /// No rule: pins only.
    PinsOnly,
    /// Two random vertices.
    Random {
        /// Seed of the selection.
        seed: u64,
    },
    /// The face's oval, or the longest boundary if the mesh is not a face.
    #[default]
    Oval,
    /// Vertices farther from the handles than `radius`.
    Outside {
        /// Distance along the surface at rest, in the document's unit.
        radius: f64,
    },
}

/// The region that an edit affects.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum RegionOfInfluence {
    /// The whole mesh.
    #[default]
    Whole,
    /// Smooth falloff from the handles; vertices farther than `radius` do not move.
    Within {
        /// Distance along the surface at rest, in the document's unit.
        radius: f64,
    },
}

rosto_mesh::named! {
    /// Whether details rotate with the surface around them.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Details {
        /// They keep their direction: δ-coordinates as in the paper.
        #[default]
        Kept = "kept",
        /// They rotate: as rigid as possible. Each offset is solved iteratively, so a tick costs several solves.
        AsRigidAsPossible = "turned",
    }
}

rosto_mesh::named! {
    /// Whether an edit is mirrored to the other side of the face.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Mirror {
        /// The sides are independent.
        #[default]
        Off = "off",
        /// Partners move by the mirrored offset, and vertices on the midline stay in its plane. The change is mirrored,
        /// not the shape, so natural asymmetry is preserved.
        On = "on",
    }
}
