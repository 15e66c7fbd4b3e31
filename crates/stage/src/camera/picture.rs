use super::pose::Pose;
use super::{Camera, NamedView};
use crate::PicturePlane;

/// Framing the picture that was taken of the mesh, rather than the mesh.
impl Camera {
    /// Goes to where the pinhole stood and frames the picture that it took; glides there.
    pub fn frame_picture(&mut self, picture: PicturePlane) {
        if self.framed != Some(picture) {
            self.framed = Some(picture);
            self.look(NamedView::Reset);
        }
    }

    /// Frames the mesh again, through its own lens: from where it looks, or, `home`, as at first.
    pub fn leave_picture(&mut self, home: bool) {
        if self.framed.take().is_none() {
            return;
        }
        let facing = self.goal.facing;
        self.look(NamedView::Reset);
        if !home && self.seen_from().1.is_none() {
            self.goal.facing.azimuth = facing.azimuth;
            self.goal.facing.elevation = facing.elevation;
        }
    }

    /// Is at once as the pinhole took the picture, and on its way from there by a share: 0 is there, 1 where it goes.
    pub fn lift(&mut self, picture: PicturePlane, share: f64) {
        let framed = self.framed.replace(picture);
        let taken = self.home();
        self.framed = framed;
        self.now = taken.towards(&Pose { facing: self.goal.facing.nearest_to(&taken.facing), ..self.goal }, share);
    }

    /// What the picture's plane, through the middle of what is framed, shows of it in the middle of what nothing lies over.
    pub(super) fn framing(&self, picture: &PicturePlane, home: Pose) -> Pose {
        let axes = home.facing.axes();
        let middle_m = (axes.transpose() * (picture.middle_m() - self.centre_m)).truncate();
        let (aside_m, half_m) = home.eye.silhouette_m(home.radius_m);
        let target_m = self.centre_m + axes * (middle_m - aside_m).extend(0.0);
        let room = self.clear_goal.size * self.size_px;
        let whole = (room / half_m).min_element();
        let zoom = (room / (0.5 * picture.size_m())).min_element() / whole;
        Pose { target_m, zoom, ..home }
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
