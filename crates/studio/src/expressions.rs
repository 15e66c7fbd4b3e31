//! Expressions of the face, under the names that animation tools use.

mod handles;
mod lids;
mod table;

use glam::DVec3;
use rosto_face::{LANDMARK_COUNT, Triangulation, canonical_positions_m, without_fillings};
use rosto_laplacian::{Continuation, LaplacianError, Operator};
use rosto_mesh::Topology;

use crate::StudioError;
use handles::Prescribed;

rosto_mesh::named! {
    /// A blend shape, under Apple's name
    /// ([ARKit](https://developer.apple.com/documentation/arkit/arfaceanchor/blendshapelocation)). Left and right are
    /// the subject's.
    ///
    /// Of ARKit's 52 blend shapes, it omits those that need eyeballs or a tongue: `tongueOut`, and `eyeLookUp`,
    /// `eyeLookDown`, `eyeLookIn` and `eyeLookOut` of both eyes.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum Expression {
        /// Both lids of the left eye meet.
        EyeBlinkLeft = "eyeBlinkLeft",
        /// Both lids of the right eye meet.
        EyeBlinkRight = "eyeBlinkRight",
        /// The left eye narrows, mostly by its lower lid.
        EyeSquintLeft = "eyeSquintLeft",
        /// The right eye narrows, mostly by its lower lid.
        EyeSquintRight = "eyeSquintRight",
        /// The left eye opens wide.
        EyeWideLeft = "eyeWideLeft",
        /// The right eye opens wide.
        EyeWideRight = "eyeWideRight",
        /// The lower jaw moves forward.
        JawForward = "jawForward",
        /// The lower jaw moves to the left.
        JawLeft = "jawLeft",
        /// The lower jaw moves to the right.
        JawRight = "jawRight",
        /// The lower jaw rotates down with the lower lip.
        JawOpen = "jawOpen",
        /// Closes the lips while [`Self::JawOpen`] is 1; intended only for use with it.
        MouthClose = "mouthClose",
        /// The lips open into a funnel.
        MouthFunnel = "mouthFunnel",
        /// The closed lips contract and move forward.
        MouthPucker = "mouthPucker",
        /// Both lips move to the left.
        MouthLeft = "mouthLeft",
        /// Both lips move to the right.
        MouthRight = "mouthRight",
        /// The left corner of the mouth moves up and out, with the cheek.
        MouthSmileLeft = "mouthSmileLeft",
        /// The right corner of the mouth moves up and out, with the cheek.
        MouthSmileRight = "mouthSmileRight",
        /// The left corner of the mouth moves down.
        MouthFrownLeft = "mouthFrownLeft",
        /// The right corner of the mouth moves down.
        MouthFrownRight = "mouthFrownRight",
        /// The left corner of the mouth moves back.
        MouthDimpleLeft = "mouthDimpleLeft",
        /// The right corner of the mouth moves back.
        MouthDimpleRight = "mouthDimpleRight",
        /// The left corner of the mouth moves out.
        MouthStretchLeft = "mouthStretchLeft",
        /// The right corner of the mouth moves out.
        MouthStretchRight = "mouthStretchRight",
        /// The lower lip rolls into the mouth.
        MouthRollLower = "mouthRollLower",
        /// The upper lip rolls into the mouth.
        MouthRollUpper = "mouthRollUpper",
        /// The chin pushes the lower lip up and out.
        MouthShrugLower = "mouthShrugLower",
        /// The upper lip moves up and out.
        MouthShrugUpper = "mouthShrugUpper",
        /// The left halves of the lips press together.
        MouthPressLeft = "mouthPressLeft",
        /// The right halves of the lips press together.
        MouthPressRight = "mouthPressRight",
        /// The left half of the lower lip moves down.
        MouthLowerDownLeft = "mouthLowerDownLeft",
        /// The right half of the lower lip moves down.
        MouthLowerDownRight = "mouthLowerDownRight",
        /// The left half of the upper lip moves up.
        MouthUpperUpLeft = "mouthUpperUpLeft",
        /// The right half of the upper lip moves up.
        MouthUpperUpRight = "mouthUpperUpRight",
        /// The left brow moves down, mostly at its inner end.
        BrowDownLeft = "browDownLeft",
        /// The right brow moves down, mostly at its inner end.
        BrowDownRight = "browDownRight",
        /// The inner ends of both brows move up.
        BrowInnerUp = "browInnerUp",
        /// The outer part of the left brow moves up.
        BrowOuterUpLeft = "browOuterUpLeft",
        /// The outer part of the right brow moves up.
        BrowOuterUpRight = "browOuterUpRight",
        /// Both cheeks fill with air.
        CheekPuff = "cheekPuff",
        /// The left cheek rises towards the lower lid.
        CheekSquintLeft = "cheekSquintLeft",
        /// The right cheek rises towards the lower lid.
        CheekSquintRight = "cheekSquintRight",
        /// The left wing of the nose moves up.
        NoseSneerLeft = "noseSneerLeft",
        /// The right wing of the nose moves up.
        NoseSneerRight = "noseSneerRight",
    }
}

impl Expression {
    /// The mirror image of this expression; the expression itself if it is symmetric.
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

/// Displacements of one face's landmarks by expressions.
///
/// An expression is a Laplacian edit of the face at rest. Its table moves a few landmarks; the areas that it names
/// follow with a bi-Laplacian of the displacement of zero ([`Continuation`]), and the rest of the face stays. The solve
/// uses the skin without the triangles that fill eyes and mouth, so that a lower lip or lid moves without the upper
/// one. Displacements scale with the face's proportions.
pub struct Expressions {
    skin: Topology,
    rest_m: Vec<DVec3>,
    canonical_m: Vec<DVec3>,
    /// Each is solved on first use; in the order of [`Expression::ALL`].
    solved: Vec<Option<Vec<DVec3>>>,
}

impl Expressions {
    /// Creates the solver for a face at rest: 468 positions in metres, in the model's frame.
    ///
    /// # Errors
    /// [`StudioError::NoExpressions`] unless there are 468 positions; [`StudioError::Laplacian`] if one is not finite.
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

    /// Displacement of each landmark, in metres, by an expression at weight 1. Solved on first use; linear in the
    /// weight.
    ///
    /// # Errors
    /// [`StudioError::Laplacian`] if the face has no solution.
    pub fn displacement(&mut self, expression: Expression) -> Result<&[DVec3], StudioError> {
        let index = expression as usize;
        if self.solved[index].is_none() {
            self.solved[index] = Some(self.solve(expression)?);
        }
        Ok(self.solved[index].as_deref().expect("invariant: just solved"))
    }

    fn solve(&self, expression: Expression) -> Result<Vec<DVec3>, StudioError> {
        let Prescribed { landmarks, displacements_m } = Prescribed::of(expression, &self.rest_m, &self.canonical_m);
        let mut solver = Continuation::new(&self.skin, &self.rest_m, Operator::CotangentMass, &landmarks)?;
        let mut displacement = vec![DVec3::ZERO; LANDMARK_COUNT];
        let mut along = vec![0.0; LANDMARK_COUNT];
        for axis in 0..3 {
            let values: Vec<f64> = displacements_m.iter().map(|vector| vector[axis]).collect();
            solver.continued(&values, &mut along);
            displacement.iter_mut().zip(&along).for_each(|(vector, share)| vector[axis] = *share);
        }
        match displacement.iter().position(|vector| !vector.is_finite()) {
            Some(vertex) => Err(LaplacianError::NotFinite { vertex: vertex as u32 }.into()),
            None => Ok(displacement),
        }
    }
}

/// The canonical triangles without those that fill eyes and mouth; symmetric.
fn skin() -> Topology {
    let whole = Triangulation::Canonical.triangles();
    let triangles = without_fillings(&whole, &whole);
    Topology::new(LANDMARK_COUNT, triangles).expect("invariant: a part of the published table is a mesh")
}
