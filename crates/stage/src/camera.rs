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

/// Time constant of the glide, in seconds.
const GLIDE_S: f64 = 0.07;
const ZOOM_LIMITS: [f64; 2] = [0.35, 12.0];

rosto_mesh::named! {
    /// A named viewing direction.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum NamedView {
        /// From the front.
        Front = "front",
        /// From the face's own left side, +X.
        Left = "left",
        /// From behind.
        Back = "back",
        /// From above, with the face pointing down in the picture.
        Top = "top",
        /// The initial view: everything centred, from the front or as the picture was taken.
        Reset = "reset",
    }
}

/// Whether the camera moves smoothly or jumps to its goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Glide {
    /// Damped motion.
    #[default]
    Smooth,
    /// Immediate, for users who prefer reduced motion.
    Off,
}

/// Orbit camera around the centre of the framed sphere; +Y up, right-handed, metres and radians.
///
/// The [`Lens`] sets the distance of the eye from the centre. Zooming and panning crop and shift the same picture, and
/// the framed sphere fills the same share of the view with each lens. Pixels are device pixels from the top left.
/// Methods set a goal; [`Camera::advance`] moves the camera towards it.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    now: Pose,
    goal: Pose,
    lens: Lens,
    pinhole: Option<Pinhole>,
    /// Picture that is framed instead of the mesh.
    framed: Option<PicturePlane>,
    centre_m: DVec3,
    size_px: DVec2,
    visible_area: VisibleArea,
    visible_area_goal: VisibleArea,
    glide: Glide,
    sides: Sides,
}

impl Default for Camera {
    /// A unit sphere at the origin, in a picture of one pixel.
    fn default() -> Self {
        let (lens, radius_m) = (Lens::default(), 1.0);
        let eye = lens.eye(radius_m);
        let home = Pose { target_m: DVec3::ZERO, facing: Facing::default(), eye, radius_m, zoom: 1.0 };
        Self {
            now: home,
            goal: home,
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
    /// Frames a sphere at once, from the front or as its picture was taken.
    pub fn frame(&mut self, centre_m: DVec3, radius_m: f64) {
        self.centre_m = centre_m;
        self.goal.radius_m = radius_m.max(f64::MIN_POSITIVE);
        self.goal = self.home();
        self.now = self.goal;
        self.visible_area = self.visible_area_goal;
    }

    /// Sets the widths in px of the picture's margins that are covered (top, right, bottom, left). The camera glides
    /// until the framed sphere is centred and fits in the rest.
    pub fn set_viewport_insets(&mut self, insets_px: [f64; 4]) {
        self.keep_home(|camera| camera.visible_area_goal = VisibleArea::without(insets_px, camera.size_px));
    }

    /// Applies the viewport insets without a glide.
    pub fn settle_visible_area(&mut self) {
        self.visible_area = self.visible_area_goal;
    }

    /// Centres the framed sphere in the whole picture, without resizing it.
    pub fn centre(&mut self) {
        (self.visible_area.centre, self.visible_area_goal.centre) = (VisibleArea::ALL.centre, VisibleArea::ALL.centre);
    }

    /// Centre of the framed sphere in metres.
    pub fn centre_m(&self) -> DVec3 {
        self.centre_m
    }

    /// Radius of the framed sphere in metres.
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

    /// Chooses smooth or immediate motion.
    pub fn set_glide(&mut self, glide: Glide) {
        self.glide = glide;
    }

    /// Whether motion is smooth.
    pub fn glides(&self) -> bool {
        self.glide == Glide::Smooth
    }

    /// The current lens.
    pub fn lens(&self) -> Lens {
        self.lens
    }

    /// Sets the lens and glides to its distance; the framed sphere keeps its size. [`Lens::AsTaken`] goes to the
    /// pinhole's pose and frames everything; the others remove any roll. In front of a picture, the others change only a
    /// view that is turned out of the pinhole's.
    pub fn set_lens(&mut self, lens: Lens) {
        if self.lens == lens {
            return;
        }
        self.lens = lens;
        if self.framed.is_some() && lens != Lens::AsTaken {
            self.goal.eye = self.eye_towards(&self.goal.facing);
        } else {
            self.apply_lens();
        }
    }

    /// Sets the pose for [`Lens::AsTaken`], the camera that took the picture on the mesh; glides there if that lens is
    /// active.
    pub fn set_pinhole(&mut self, pinhole: Option<Pinhole>) {
        if self.pinhole != pinhole {
            self.pinhole = pinhole;
            self.apply_lens();
        }
    }

    fn apply_lens(&mut self) {
        match self.lens_pose().1 {
            Some(_) => self.look(NamedView::Reset),
            None => self.goal.facing.roll = 0.0,
        }
        self.goal.eye = self.eye_towards(&self.goal.facing);
    }

    /// The lens' eye and, for a pinhole, its orientation.
    fn lens_pose(&self) -> (Eye, Option<Facing>) {
        let taken = self.pinhole.filter(|_| self.lens == Lens::AsTaken || self.framed.is_some());
        match taken.and_then(|pinhole| pinhole.before(self.centre_m, self.goal.radius_m)) {
            Some((eye, facing)) => (eye, Some(facing)),
            None => (self.lens.eye(self.goal.radius_m), None),
        }
    }

    fn home(&self) -> Pose {
        let (eye, facing) = self.lens_pose();
        let facing = facing.unwrap_or_default();
        let home = Pose { target_m: self.centre_m, facing, eye, radius_m: self.goal.radius_m, zoom: 1.0 };
        self.framed.map_or(home, |picture| self.framing(&picture, home))
    }

    /// Orbits as if the pointer dragged the face: half a turn per picture height.
    pub fn orbit(&mut self, dx_px: f64, dy_px: f64) {
        let facing = self.goal.facing;
        let motion_px = DVec2::new(self.sides.sign() * dx_px, dy_px);
        let radians = DVec2::from_angle(-facing.roll).rotate(motion_px) * (PI / self.size_px.y);
        let elevation = (facing.elevation + radians.y).clamp(-Facing::MAX_ELEVATION, Facing::MAX_ELEVATION);
        self.face_towards(Facing { azimuth: facing.azimuth - radians.x, elevation, ..facing });
    }

    /// Turns around the upright axis with a glide.
    pub fn turn_towards(&mut self, radians: f64) {
        self.face_towards(self.goal.facing.turned(radians));
    }

    /// Turns around the upright axis without a glide.
    pub fn turn(&mut self, radians: f64) {
        self.face_towards(self.goal.facing.turned(radians));
        self.now = self.turned(self.now, self.now.facing.turned(radians));
    }

    /// Moves in the view plane so that the picture follows the pointer.
    pub fn pan(&mut self, dx_px: f64, dy_px: f64) {
        let axes = self.facing().axes();
        let offset_m =
            (axes.y_axis * dy_px - axes.x_axis * (self.sides.sign() * dx_px)) * self.m_per_px_at_target(&self.goal);
        let from_centre_m = (self.goal.target_m + offset_m - self.centre_m).clamp_length_max(self.max_distance_m());
        self.goal.target_m = self.centre_m + from_centre_m;
    }

    /// Magnifies by `factor`; ignores factors that are not positive and finite.
    pub fn zoom(&mut self, factor: f64) {
        if factor > 0.0 && factor.is_finite() {
            let full = if self.framed.is_some() { self.home().zoom } else { 1.0 };
            self.goal.zoom = (self.goal.zoom * factor).clamp(ZOOM_LIMITS[0] * full, ZOOM_LIMITS[1] * full);
        }
    }

    /// Magnifies by `factor` about a position on the canvas, which stays in place.
    pub fn zoom_at(&mut self, factor: f64, at_px: DVec2) {
        let before = self.goal.zoom;
        self.zoom(factor);
        let from_centre_px = at_px - self.visible_area_goal.centre * self.size_px;
        let by_px = from_centre_px * (1.0 - self.goal.zoom / before);
        self.pan(by_px.x, by_px.y);
    }

    /// Turns to a named view the short way round.
    pub fn look(&mut self, view: NamedView) {
        if view == NamedView::Reset {
            self.goal = self.home();
        }
        let facing = match view {
            NamedView::Reset => self.goal.facing,
            NamedView::Front => Facing::default(),
            NamedView::Left => Facing { azimuth: FRAC_PI_2, ..Facing::default() },
            NamedView::Back => Facing { azimuth: PI, ..Facing::default() },
            NamedView::Top => Facing { elevation: Facing::MAX_ELEVATION, ..Facing::default() },
        };
        self.face_towards(facing.nearest_to(&self.now.facing));
    }

    /// Turns the goal to a direction.
    fn face_towards(&mut self, facing: Facing) {
        self.goal = self.turned(self.goal, facing);
    }

    /// A pose turned to a direction. In front of a picture, the mesh turns in its place, and the lens changes from the
    /// pinhole's to the chosen one.
    fn turned(&self, pose: Pose, facing: Facing) -> Pose {
        if self.framed.is_none() {
            return Pose { facing, ..pose };
        }
        let from_centre_m = pose.facing.axes().transpose() * (pose.target_m - self.centre_m);
        let target_m = self.centre_m + facing.axes() * from_centre_m;
        Pose { facing, target_m, eye: self.eye_towards(&facing), ..pose }
    }

    /// The eye for a direction.
    fn eye_towards(&self, facing: &Facing) -> Eye {
        let (eye, taken) = self.lens_pose();
        match taken.filter(|_| self.lens != Lens::AsTaken) {
            Some(taken) => eye.towards(&self.lens.eye(self.goal.radius_m), taken.turned_share(facing)),
            None => eye,
        }
    }

    /// Advances the motion by `seconds`; returns whether the camera was moving.
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
