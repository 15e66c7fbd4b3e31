use super::Camera;
use crate::{PicturePlane, Pinhole};

/// Whether the picture is mirrored left to right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sides {
    /// Not mirrored.
    #[default]
    True,
    /// Mirrored on the screen only; model coordinates do not change.
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

/// Frames of a camera stream.
impl Camera {
    /// Whether the picture is mirrored.
    pub fn sides(&self) -> Sides {
        self.sides
    }

    /// Mirrors the picture, or not.
    pub fn set_sides(&mut self, sides: Sides) {
        // A mirrored picture is framed differently.
        self.carry_home(|camera| camera.sides = sides);
    }

    /// Replaces the picture by the next frame, taken by another pinhole, at the same position on the screen. A view of
    /// the mesh does not change.
    pub fn change_picture(&mut self, picture: PicturePlane, pinhole: Pinhole) {
        if self.framed.is_none() {
            self.pinhole = Some(pinhole);
            return;
        }
        self.carry_home(|camera| (camera.pinhole, camera.framed) = (Some(pinhole), Some(picture)));
    }

    /// Applies a change and carries the current view along with the framing.
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
