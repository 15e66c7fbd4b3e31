use glam::DVec2;

use super::pose::Pose;
use super::{Camera, NamedView, Sides};
use crate::PicturePlane;

/// Minimum share of the visible area that the mesh fills, even if the picture is cropped: a head with its shoulders.
const MIN_SHARE: f64 = 0.6;

/// Framing of the picture taken of the mesh.
impl Camera {
    /// Frames a picture in the pinhole's pose, or the mesh in its initial view, and glides there.
    pub fn frame_picture(&mut self, picture: Option<PicturePlane>) {
        if self.framed != picture {
            self.framed = picture;
            self.look(NamedView::Reset);
        }
    }

    /// Frames the mesh alone at once, from the current direction.
    pub fn leave_picture(&mut self) {
        if self.framed.take().is_some() {
            self.goal = Pose { facing: self.now.facing, eye: self.now.eye, ..self.home() };
            self.now = self.goal;
        }
    }

    /// How far the mesh is turned out of the pinhole's pose, which its picture shows: 0..1. 1 without a picture.
    pub fn turned_out(&self) -> f64 {
        let taken = self.framed.and_then(|_| self.lens_pose().1);
        taken.map_or(1.0, |taken| taken.turned_share(&self.now.facing))
    }

    /// Sets the view between the pinhole's (`share` 0) and the goal (1), without a glide.
    pub fn lift(&mut self, picture: PicturePlane, share: f64) {
        let framed = self.framed.replace(picture);
        let taken = self.home();
        self.framed = framed;
        self.now = taken.towards(&Pose { facing: self.goal.facing.nearest_to(&taken.facing), ..self.goal }, share);
    }

    /// Frames the whole picture or, if the mesh is small in it, a part of the picture around the mesh.
    pub(super) fn framing(&self, picture: &PicturePlane, home: Pose) -> Pose {
        let axes = home.facing.axes();
        let picture_centre_m = (axes.transpose() * (picture.centre_m() - self.centre_m)).truncate();
        let (lateral_m, half_m) = home.eye.silhouette_m(home.radius_m);
        let (room_px, half_picture_m) = (self.visible_area_goal.size * self.size_px, 0.5 * picture.size_m());
        // The live preview does not follow the mesh.
        let min_share = if self.sides == Sides::Swapped { 0.0 } else { MIN_SHARE };
        let px_per_m = (0.5 * room_px / half_m).min_element();
        let zoom = ((0.5 * room_px / half_picture_m).min_element() / px_per_m).max(min_share);
        // Centre on the mesh as far as the picture still fills the visible area.
        let spare_m = (half_picture_m - 0.5 * room_px / (px_per_m * zoom)).max(DVec2::ZERO);
        let seen_m = lateral_m.clamp(picture_centre_m - spare_m, picture_centre_m + spare_m);
        Pose { target_m: self.centre_m + axes * (seen_m - lateral_m).extend(0.0), zoom, ..home }
    }

    /// Maximum distance of the target from the centre.
    pub(super) fn max_distance_m(&self) -> f64 {
        let picture_m = self
            .framed
            .map_or(0.0, |picture| picture.centre_m().distance(self.centre_m) + 0.5 * picture.size_m().length());
        picture_m.max(2.0 * self.radius_m())
    }

    /// Applies a change of the visible area; a camera in its home view stays in it.
    pub(super) fn keep_home(&mut self, change: impl FnOnce(&mut Self)) {
        let is_home = self.framed.is_some() && self.goal.is_near(&self.home());
        change(self);
        if is_home {
            self.goal = self.home();
        }
    }
}
