use super::Camera;
use crate::{PicturePlane, Pinhole};

/// On which side of the picture things are seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sides {
    /// Where they are.
    #[default]
    True,
    /// On the other one, as in a mirror. Only what is seen is swapped: everything keeps its place in the model.
    Swapped,
}

impl Sides {
    pub(super) fn sign(self) -> f64 {
        match self {
            Self::True => 1.0,
            Self::Swapped => -1.0,
        }
    }
}

/// Pictures that come one after the other, of a mesh that moves.
impl Camera {
    /// On which side things are seen.
    pub fn sides(&self) -> Sides {
        self.sides
    }

    /// Swaps the sides of what is seen, or not.
    pub fn set_sides(&mut self, sides: Sides) {
        // A mirror frames its picture in another way.
        self.carry_home(|camera| camera.sides = sides);
    }

    /// Another picture takes the place of the one before, which another pinhole took: on the screen it is where that one was, at
    /// once. Who looks at the mesh goes on looking at it as before.
    pub fn change_picture(&mut self, picture: PicturePlane, pinhole: Pinhole) {
        if self.framed.is_none() {
            self.pinhole = Some(pinhole);
            return;
        }
        self.carry_home(|camera| (camera.pinhole, camera.framed) = (Some(pinhole), Some(picture)));
    }

    /// What changes how the picture is framed takes along at once who looks at it.
    fn carry_home(&mut self, change: impl FnOnce(&mut Self)) {
        let before = self.framed.is_some().then(|| self.home());
        change(self);
        if let Some(before) = before {
            let after = self.home();
            self.now = self.now.carried(&before, &after);
            self.goal = self.goal.carried(&before, &after);
        }
    }
}
