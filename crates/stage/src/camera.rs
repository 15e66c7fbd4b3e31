mod camera_stream;
mod eye;
mod facing;
mod picture;
mod pose;
mod projection;
mod visible_area;

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec2, DVec3};

use crate::{Lens, PicturePlane, Pinhole};
pub use camera_stream::Sides;
pub(crate) use eye::Eye;
pub(crate) use facing::Facing;
use pose::Pose;
use visible_area::VisibleArea;

/// Time constant of the glide towards where the camera is asked to be.
const GLIDE_S: f64 = 0.07;
const ZOOM_LIMITS: [f64; 2] = [0.35, 12.0];

rosto_mesh::named! {
    /// A direction to look from that has a name.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum NamedView {
        /// Straight at the face.
        Front = "front",
        /// At the face's own left side, from +X.
        Left = "left",
        /// From above, the face looking down the picture.
        Top = "top",
        /// As at first: whole and centred, from the front or as its picture was taken.
        Reset = "reset",
    }
}

/// Whether the camera glides to where it is asked to be, or is there at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Glide {
    /// Damped: it comes to rest softly.
    #[default]
    Smooth,
    /// Without any motion of its own, for those who asked for less motion.
    Off,
}

/// A camera around the middle of what it frames, +Y up; right-handed, metres and radians.
///
/// How far its eye is from that middle is its [`Lens`]': zooming and panning cut another part out of the same picture, and
/// what is framed fills the same share of the view with each lens. Pixels are device pixels from the top left. The camera
/// is steered by goals, and [`Camera::advance`] takes it there.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    now: Pose,
    goal: Pose,
    /// How far it is turned around the upright axis besides.
    sway: f64,
    lens: Lens,
    pinhole: Option<Pinhole>,
    /// The picture that is framed in place of the mesh.
    framed: Option<PicturePlane>,
    centre_m: DVec3,
    size_px: DVec2,
    visible_area: VisibleArea,
    visible_area_goal: VisibleArea,
    glide: Glide,
    sides: Sides,
}

impl Default for Camera {
    /// Looks at a unit sphere around the origin in a picture of one pixel.
    fn default() -> Self {
        let (lens, radius_m) = (Lens::default(), 1.0);
        let eye = lens.eye(radius_m);
        let home = Pose { target_m: DVec3::ZERO, facing: Facing::default(), eye, radius_m, zoom: 1.0 };
        Self {
            now: home,
            goal: home,
            sway: 0.0,
            lens,
            pinhole: None,
            framed: None,
            centre_m: DVec3::ZERO,
            size_px: DVec2::ONE,
            visible_area: VisibleArea::ALL,
            visible_area_goal: VisibleArea::ALL,
            glide: Glide::default(),
            sides: Sides::default(),
        }
    }
}

impl Camera {
    /// Frames the sphere `centre_m`, `radius_m` from the front, or as its picture was taken, at once.
    pub fn frame(&mut self, centre_m: DVec3, radius_m: f64) {
        self.centre_m = centre_m;
        self.goal.radius_m = radius_m.max(f64::MIN_POSITIVE);
        self.goal = self.home();
        self.now = self.goal;
        self.sway = 0.0;
        self.visible_area = self.visible_area_goal;
    }

    /// Frames another radius around the same middle, from where it looks: it glides there.
    pub fn frame_again(&mut self, radius_m: f64) {
        self.goal.radius_m = radius_m.max(f64::MIN_POSITIVE);
        self.goal.eye = self.seen_from().0;
    }

    /// So many px at the picture's top, right, bottom and left have something lying over them: what is framed fits into
    /// the rest, and its middle is there. It glides there.
    pub fn set_viewport_insets(&mut self, insets_px: [f64; 4]) {
        self.keep_home(|camera| camera.visible_area_goal = VisibleArea::without(insets_px, camera.size_px));
    }

    /// Fits what is framed into what nothing lies over at once, without a glide.
    pub fn settle_clear(&mut self) {
        self.visible_area = self.visible_area_goal;
    }

    /// Has what is framed in the middle of the whole picture, as large as it is.
    pub fn centre(&mut self) {
        (self.visible_area.middle, self.visible_area_goal.middle) = (VisibleArea::ALL.middle, VisibleArea::ALL.middle);
    }

    /// Middle of what is framed, in metres.
    pub fn centre_m(&self) -> DVec3 {
        self.centre_m
    }

    /// Radius in metres of what is framed.
    pub fn radius_m(&self) -> f64 {
        self.goal.radius_m
    }

    /// Sets the picture's size in px; at least one pixel each way.
    pub fn resize(&mut self, width_px: u32, height_px: u32) {
        self.keep_home(|camera| camera.size_px = DVec2::new(f64::from(width_px.max(1)), f64::from(height_px.max(1))));
    }

    /// Size of the picture in px.
    pub fn size_px(&self) -> DVec2 {
        self.size_px
    }

    /// Chooses whether the camera glides.
    pub fn set_glide(&mut self, glide: Glide) {
        self.glide = glide;
    }

    /// Whether it glides.
    pub fn glides(&self) -> bool {
        self.glide == Glide::Smooth
    }

    /// From how far away it looks.
    pub fn lens(&self) -> Lens {
        self.lens
    }

    /// Looks from as far away as a lens says, and glides there: what is framed stays as large as it is. With
    /// [`Lens::AsTaken`] it goes to where the pinhole stood and frames all of it; with the others it stands upright.
    pub fn set_lens(&mut self, lens: Lens) {
        if self.lens != lens {
            self.lens = lens;
            self.take_up_lens();
        }
    }

    /// The camera that took the picture on the mesh, for [`Lens::AsTaken`]; with that one it glides there.
    pub fn set_pinhole(&mut self, pinhole: Option<Pinhole>) {
        if self.pinhole != pinhole {
            self.pinhole = pinhole;
            self.take_up_lens();
        }
    }

    fn take_up_lens(&mut self) {
        let (eye, facing) = self.seen_from();
        self.goal.eye = eye;
        match facing {
            Some(_) => self.look(NamedView::Reset),
            None => self.goal.facing.roll = 0.0,
        }
    }

    /// The lens' eye, and how it faces what is framed if it is a camera that stood somewhere.
    fn seen_from(&self) -> (Eye, Option<Facing>) {
        let taken = self.pinhole.filter(|_| self.lens == Lens::AsTaken || self.framed.is_some());
        match taken.and_then(|pinhole| pinhole.before(self.centre_m, self.goal.radius_m)) {
            Some((eye, facing)) => (eye, Some(facing)),
            None => (self.lens.eye(self.goal.radius_m), None),
        }
    }

    fn home(&self) -> Pose {
        let (eye, facing) = self.seen_from();
        let facing = facing.unwrap_or_default();
        let home = Pose { target_m: self.centre_m, facing, eye, radius_m: self.goal.radius_m, zoom: 1.0 };
        self.framed.map_or(home, |picture| self.framing(&picture, home))
    }

    /// Turns around the middle as if the pointer held the face: half a turn for a picture's height.
    pub fn orbit(&mut self, dx_px: f64, dy_px: f64) {
        let facing = &mut self.goal.facing;
        let motion_px = DVec2::new(self.sides.sign() * dx_px, dy_px);
        let radians = DVec2::from_angle(-facing.roll).rotate(motion_px) * (PI / self.size_px.y);
        facing.azimuth -= radians.x;
        facing.elevation = (facing.elevation + radians.y).clamp(-Facing::STEEPEST, Facing::STEEPEST);
    }

    /// Goes on around the upright axis by so much, and glides there.
    pub fn turn_towards(&mut self, radians: f64) {
        self.goal.facing.azimuth += radians;
    }

    /// Turns around the upright axis, at once and without glide.
    pub fn turn(&mut self, radians: f64) {
        self.goal.facing.azimuth += radians;
        self.now.facing.azimuth += radians;
    }

    /// Is turned around the upright axis by so much, besides wherever it goes.
    pub fn sway(&mut self, radians: f64) {
        self.sway = radians;
    }

    /// Glides back from that.
    pub fn end_sway(&mut self) {
        self.now.facing.azimuth += std::mem::take(&mut self.sway);
    }

    /// Moves along the view plane so that what is seen follows the pointer.
    pub fn pan(&mut self, dx_px: f64, dy_px: f64) {
        let axes = self.facing().axes();
        let offset_m =
            (axes.y_axis * dy_px - axes.x_axis * (self.sides.sign() * dx_px)) * self.m_per_px_at_target(&self.goal);
        let from_centre_m = (self.goal.target_m + offset_m - self.centre_m).clamp_length_max(self.furthest_m());
        self.goal.target_m = self.centre_m + from_centre_m;
    }

    /// Shows things larger by `factor`, smaller if it is below 1; nothing for a factor that is not positive.
    pub fn zoom(&mut self, factor: f64) {
        if factor > 0.0 && factor.is_finite() {
            let whole = if self.framed.is_some() { self.home().zoom } else { 1.0 };
            self.goal.zoom = (self.goal.zoom * factor).clamp(ZOOM_LIMITS[0] * whole, ZOOM_LIMITS[1] * whole);
        }
    }

    /// Goes to a named view by the shortest way round.
    pub fn look(&mut self, view: NamedView) {
        if view == NamedView::Reset {
            self.goal = self.home();
        }
        let facing = match view {
            NamedView::Reset => self.goal.facing,
            NamedView::Front => Facing::default(),
            NamedView::Left => Facing { azimuth: FRAC_PI_2, ..Facing::default() },
            NamedView::Top => Facing { elevation: Facing::STEEPEST, ..Facing::default() },
        };
        self.goal.facing = facing.nearest_to(&self.now.facing);
    }

    /// Moves on by `seconds`; true while the camera has not arrived.
    pub fn advance(&mut self, seconds: f64) -> bool {
        if self.now == self.goal && self.visible_area == self.visible_area_goal {
            return false;
        }
        let share = match self.glide {
            Glide::Smooth => 1.0 - (-seconds.max(0.0) / GLIDE_S).exp(),
            Glide::Off => 1.0,
        };
        self.now = self.now.towards(&self.goal, share);
        self.visible_area = self.visible_area.towards(self.visible_area_goal, share);
        if self.now.is_near(&self.goal) && self.visible_area.is_near(self.visible_area_goal) {
            (self.now, self.visible_area) = (self.goal, self.visible_area_goal);
        }
        true
    }
}
