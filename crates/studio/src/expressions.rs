//! Expressions of the face, by the names that animation tools know them by.

mod handles;
mod lids;
mod table;

use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, Triangulation, canonical_positions_m, without_fillings};
use rosto_laplacian::{Continuation, LaplacianError, Operator};
use rosto_mesh::Topology;

use crate::StudioError;
use handles::Authored;

rosto_mesh::named! {
    /// A blend shape by Apple's name ([ARKit](https://developer.apple.com/documentation/arkit/arfaceanchor/blendshapelocation)).
    /// Left and right are the subject's.
    ///
    /// Of ARKit's 52 those are here that a face without eyeballs, teeth and tongue can make: not `tongueOut`, nor
    /// `eyeLookUp`, `eyeLookDown`, `eyeLookIn` and `eyeLookOut` of either eye.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Expression {
        /// Both lids of the left eye meet.
        EyeBlinkLeft = "eyeBlinkLeft",
        /// Both lids of the right eye meet.
        EyeBlinkRight = "eyeBlinkRight",
        /// The left eye narrows, its lower lid above all.
        EyeSquintLeft = "eyeSquintLeft",
        /// The right eye narrows, its lower lid above all.
        EyeSquintRight = "eyeSquintRight",
        /// The left eye opens wide.
        EyeWideLeft = "eyeWideLeft",
        /// The right eye opens wide.
        EyeWideRight = "eyeWideRight",
        /// The lower jaw comes forward.
        JawForward = "jawForward",
        /// The lower jaw goes to the left.
        JawLeft = "jawLeft",
        /// The lower jaw goes to the right.
        JawRight = "jawRight",
        /// The lower jaw turns down and takes the lower lip along.
        JawOpen = "jawOpen",
        /// What closes the lips while [`Self::JawOpen`] is 1, and is meant for it alone.
        MouthClose = "mouthClose",
        /// The lips open into a funnel.
        MouthFunnel = "mouthFunnel",
        /// The closed lips draw together and come forward.
        MouthPucker = "mouthPucker",
        /// Both lips go to the left.
        MouthLeft = "mouthLeft",
        /// Both lips go to the right.
        MouthRight = "mouthRight",
        /// The mouth's left corner goes up and out, and the cheek with it.
        MouthSmileLeft = "mouthSmileLeft",
        /// The mouth's right corner goes up and out, and the cheek with it.
        MouthSmileRight = "mouthSmileRight",
        /// The mouth's left corner goes down.
        MouthFrownLeft = "mouthFrownLeft",
        /// The mouth's right corner goes down.
        MouthFrownRight = "mouthFrownRight",
        /// The mouth's left corner goes back.
        MouthDimpleLeft = "mouthDimpleLeft",
        /// The mouth's right corner goes back.
        MouthDimpleRight = "mouthDimpleRight",
        /// The mouth's left corner goes out.
        MouthStretchLeft = "mouthStretchLeft",
        /// The mouth's right corner goes out.
        MouthStretchRight = "mouthStretchRight",
        /// The lower lip rolls into the mouth.
        MouthRollLower = "mouthRollLower",
        /// The upper lip rolls into the mouth.
        MouthRollUpper = "mouthRollUpper",
        /// The chin pushes the lower lip up and out.
        MouthShrugLower = "mouthShrugLower",
        /// The upper lip goes up and out.
        MouthShrugUpper = "mouthShrugUpper",
        /// The left halves of the lips are pressed together.
        MouthPressLeft = "mouthPressLeft",
        /// The right halves of the lips are pressed together.
        MouthPressRight = "mouthPressRight",
        /// The left half of the lower lip goes down.
        MouthLowerDownLeft = "mouthLowerDownLeft",
        /// The right half of the lower lip goes down.
        MouthLowerDownRight = "mouthLowerDownRight",
        /// The left half of the upper lip goes up.
        MouthUpperUpLeft = "mouthUpperUpLeft",
        /// The right half of the upper lip goes up.
        MouthUpperUpRight = "mouthUpperUpRight",
        /// The left brow goes down, its inner end above all.
        BrowDownLeft = "browDownLeft",
        /// The right brow goes down, its inner end above all.
        BrowDownRight = "browDownRight",
        /// The inner ends of both brows go up.
        BrowInnerUp = "browInnerUp",
        /// The outer part of the left brow goes up.
        BrowOuterUpLeft = "browOuterUpLeft",
        /// The outer part of the right brow goes up.
        BrowOuterUpRight = "browOuterUpRight",
        /// Both cheeks are blown up.
        CheekPuff = "cheekPuff",
        /// The left cheek goes up to the lower lid.
        CheekSquintLeft = "cheekSquintLeft",
        /// The right cheek goes up to the lower lid.
        CheekSquintRight = "cheekSquintRight",
        /// The left wing of the nose goes up.
        NoseSneerLeft = "noseSneerLeft",
        /// The right wing of the nose goes up.
        NoseSneerRight = "noseSneerRight",
    }
}

impl Expression {
    /// The expression that this one becomes in the mirror: itself, if both sides take part alike.
    pub fn mirrored(self) -> Self {
        let id = self.id();
        let other = match (id.strip_suffix("Left"), id.strip_suffix("Right")) {
            (Some(stem), _) => [stem, "Right"].concat(),
            (_, Some(stem)) => [stem, "Left"].concat(),
            _ => return self,
        };
        Self::from_id(&other).expect("invariant: sides come in pairs")
    }
}

/// What each expression displaces the landmarks of one face by.
///
/// An expression is a Laplacian edit of the face at rest: a few landmarks are moved as its table says, the parts that it names
/// follow so that the bi-Laplacian of the displacement is zero ([`Continuation`]), and the rest stays. It is solved on the skin
/// alone, eyes and mouth cut open, so that a lower lip or lid moves without the upper one. Ways are measured in the face's
/// own measures.
pub struct Expressions {
    skin: Topology,
    rest_m: Vec<DVec3>,
    canonical_m: Vec<DVec3>,
    /// Each solved when it is first asked for, in the order of [`Expression::ALL`].
    solved: Vec<Option<Vec<DVec3>>>,
}

impl Expressions {
    /// For a face at rest: 468 positions in metres in the model's frame.
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`] if there are not 468; [`StudioError::Laplacian`] for one that is not finite.
    pub fn new(positions_m: &[DVec3]) -> Result<Self, StudioError> {
        if positions_m.len() != LANDMARK_COUNT {
            return Err(StudioError::NoExpressions { vertex_count: positions_m.len() });
        }
        if let Some(vertex) = positions_m.iter().position(|position| !position.is_finite()) {
            return Err(LaplacianError::NotFinite { vertex: vertex as u32 }.into());
        }
        let solved = Expression::ALL.map(|_| None).into();
        let canonical_m = canonical_positions_m();
        Ok(Self { skin: skin(), rest_m: positions_m.to_vec(), canonical_m, solved })
    }

    /// By how many metres an expression of weight 1 displaces each landmark. Solved the first time; linear in the weight.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] for a face that has no answer.
    pub fn displacement(&mut self, expression: Expression) -> Result<&[DVec3], StudioError> {
        let place = expression as usize;
        if self.solved[place].is_none() {
            self.solved[place] = Some(self.solve(expression)?);
        }
        Ok(self.solved[place].as_deref().expect("invariant: just solved"))
    }

    fn solve(&self, expression: Expression) -> Result<Vec<DVec3>, StudioError> {
        let Authored { known, displacements_m } = Authored::of(expression, &self.rest_m, &self.canonical_m);
        let mut solver = Continuation::new(&self.skin, &self.rest_m, Operator::CotangentMass, &known)?;
        let mut displacement = vec![DVec3::ZERO; LANDMARK_COUNT];
        let mut along = vec![0.0; LANDMARK_COUNT];
        for axis in 0..3 {
            let known: Vec<f64> = displacements_m.iter().map(|way| way[axis]).collect();
            solver.continued(&known, &mut along);
            displacement.iter_mut().zip(&along).for_each(|(way, share)| way[axis] = *share);
        }
        match displacement.iter().position(|way| !way.is_finite()) {
            Some(vertex) => Err(LaplacianError::NotFinite { vertex: vertex as u32 }.into()),
            None => Ok(displacement),
        }
    }
}

/// The canonical triangles without those that fill eyes and mouth: their own mirror image.
fn skin() -> Topology {
    let whole = Triangulation::Canonical.triangles();
    let triangles = without_fillings(&whole, &whole);
    Topology::new(LANDMARK_COUNT, triangles).expect("invariant: a part of the published table is a mesh")
}
