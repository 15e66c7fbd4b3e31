use glam::DVec2;

use super::pose::Pose;
use super::{Camera, Facing, NamedView, Sides};
use crate::PicturePlane;

/// What the picture is of fills at least this share of the room, though not all of the picture be seen then.
const LEAST_SHARE: f64 = 0.5;

/// Framing the picture that was taken of the mesh, rather than the mesh.
impl Camera {
    /// Goes to where the pinhole stood and frames the picture that it took; glides there.
    pub fn frame_picture(&mut self, picture: PicturePlane) {
        if self.framed != Some(picture) {
            self.framed = Some(picture);
            self.look(NamedView::Reset);
        }
    }

    /// Frames the mesh again as at first, through its own lens.
    pub fn leave_picture(&mut self) {
        if self.framed.take().is_some() {
            self.look(NamedView::Reset);
        }
    }

    /// Frames the mesh again through its own lens, from where it looks.
    pub fn turn_out_of_picture(&mut self) {
        let facing = self.goal.facing;
        self.leave_picture();
        if self.seen_from().1.is_none() {
            self.goal.facing = Facing { roll: 0.0, ..facing };
        }
    }

    /// Is at once as the pinhole took the picture, and on its way from there by a share: 0 is there, 1 where it goes.
    pub fn lift(&mut self, picture: PicturePlane, share: f64) {
        let framed = self.framed.replace(picture);
        let taken = self.home();
        self.framed = framed;
        self.now = taken.towards(&Pose { facing: self.goal.facing.nearest_to(&taken.facing), ..self.goal }, share);
    }

    /// All of the picture or, where what it is of is small in it, as much of it as the room holds around that.
    pub(super) fn framing(&self, picture: &PicturePlane, home: Pose) -> Pose {
        let axes = home.facing.axes();
        let middle_m = (axes.transpose() * (picture.middle_m() - self.centre_m)).truncate();
        let (aside_m, half_m) = home.eye.silhouette_m(home.radius_m);
        let (room_px, half_picture_m) = (self.visible_area_goal.size * self.size_px, 0.5 * picture.size_m());
        // A mirror stands still, wherever what is in it goes.
        let least_share = if self.sides == Sides::Swapped { 0.0 } else { LEAST_SHARE };
        let px_per_m = (0.5 * room_px / half_m).min_element();
        let zoom = ((0.5 * room_px / half_picture_m).min_element() / px_per_m).max(least_share);
        // As near to what it is of as the picture fills the room.
        let spare_m = (half_picture_m - 0.5 * room_px / (px_per_m * zoom)).max(DVec2::ZERO);
        let seen_m = aside_m.clamp(middle_m - spare_m, middle_m + spare_m);
        Pose { target_m: self.centre_m + axes * (seen_m - aside_m).extend(0.0), zoom, ..home }
    }

    /// How far from the middle it may look.
    pub(super) fn furthest_m(&self) -> f64 {
        let picture_m = self
            .framed
            .map_or(0.0, |picture| picture.middle_m().distance(self.centre_m) + 0.5 * picture.size_m().length());
        picture_m.max(2.0 * self.radius_m())
    }

    /// What changes the room there is keeps a camera at home that is there.
    pub(super) fn keep_home(&mut self, change: impl FnOnce(&mut Self)) {
        let is_home = self.framed.is_some() && self.goal == self.home();
        change(self);
        if is_home {
            self.goal = self.home();
        }
    }
}
