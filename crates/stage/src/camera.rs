mod pose;
mod projection;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec2, DVec3};

use pose::Pose;

/// Time constant of the glide towards where the camera is asked to be.
const GLIDE_S: f64 = 0.07;
const STEEPEST: f64 = FRAC_PI_2 - 1e-3;
const ZOOM_LIMITS: [f64; 2] = [0.35, 12.0];

rosto_named::named! {
    /// A direction to look from that has a name.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum NamedView {
        /// Straight at the face.
        Front = "front",
        /// At the face's own left side, from +X.
        Left = "left",
        /// From above, the face looking down the picture.
        Top = "top",
        /// As at first: front, centred, at the first distance.
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

/// A camera on a sphere around what it looks at, +Y up; right-handed, metres and radians.
///
/// Pixels are device pixels from the top left. The camera is steered by goals, and [`Camera::advance`] takes it there.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    now: Pose,
    goal: Pose,
    centre_m: DVec3,
    radius_m: f64,
    size_px: DVec2,
    clear: Clear,
    clear_goal: Clear,
    glide: Glide,
}

/// The part of the picture that nothing lies over, in shares of its size.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Clear {
    middle: DVec2,
    size: DVec2,
}

impl Clear {
    const ALL: Self = Self { middle: DVec2::splat(0.5), size: DVec2::ONE };

    fn towards(self, goal: Self, share: f64) -> Self {
        Self { middle: self.middle.lerp(goal.middle, share), size: self.size.lerp(goal.size, share) }
    }

    fn is_near(self, other: Self) -> bool {
        self.middle.distance(other.middle) + self.size.distance(other.size) < 1e-5
    }
}

/// However much lies over the picture, this share of it is taken for clear.
const LEAST_CLEAR: f64 = 0.2;

impl Default for Camera {
    /// Looks at a unit sphere around the origin in a picture of one pixel.
    fn default() -> Self {
        let home = Pose::home(DVec3::ZERO);
        Self {
            now: home,
            goal: home,
            centre_m: DVec3::ZERO,
            radius_m: 1.0,
            size_px: DVec2::ONE,
            clear: Clear::ALL,
            clear_goal: Clear::ALL,
            glide: Glide::default(),
        }
    }
}

impl Camera {
    /// Frames the sphere `centre_m`, `radius_m` from the front, at once.
    pub fn frame(&mut self, centre_m: DVec3, radius_m: f64) {
        self.centre_m = centre_m;
        self.radius_m = radius_m.max(f64::MIN_POSITIVE);
        self.now = Pose::home(centre_m);
        self.goal = self.now;
        self.clear = self.clear_goal;
    }

    /// Frames another radius around the same middle, from where it looks: it glides there.
    pub fn frame_again(&mut self, radius_m: f64) {
        let radius_m = radius_m.max(f64::MIN_POSITIVE);
        self.now.zoom *= radius_m / self.radius_m;
        self.radius_m = radius_m;
    }

    /// So many px at the picture's top, right, bottom and left have something lying over them: what is framed fits into
    /// the rest, and its middle is there. It glides there.
    pub fn set_covered(&mut self, [top, right, bottom, left]: [f64; 4]) {
        let share = |px: f64, of_px: f64| if px > 0.0 { (px / of_px).min(1.0) } else { 0.0 };
        let from = DVec2::new(share(left, self.size_px.x), share(top, self.size_px.y));
        let to = DVec2::ONE - DVec2::new(share(right, self.size_px.x), share(bottom, self.size_px.y));
        let size = (to - from).max(DVec2::splat(LEAST_CLEAR));
        let middle = (0.5 * (from + to)).clamp(0.5 * size, DVec2::ONE - 0.5 * size);
        self.clear_goal = Clear { middle, size };
    }

    /// Fits what is framed into what nothing lies over at once, without a glide.
    pub fn settle_clear(&mut self) {
        self.clear = self.clear_goal;
    }

    /// Has what is framed in the middle of the whole picture, as large as it is.
    pub fn centre(&mut self) {
        (self.clear.middle, self.clear_goal.middle) = (Clear::ALL.middle, Clear::ALL.middle);
    }

    /// Middle of what is framed, in metres.
    pub fn centre_m(&self) -> DVec3 {
        self.centre_m
    }

    /// Radius in metres of what is framed.
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Sets the picture's size in px; at least one pixel each way.
    pub fn resize(&mut self, width_px: u32, height_px: u32) {
        self.size_px = DVec2::new(f64::from(width_px.max(1)), f64::from(height_px.max(1)));
    }

    /// Size of the picture in px.
    pub fn size_px(&self) -> DVec2 {
        self.size_px
    }

    /// Chooses whether the camera glides.
    pub fn set_glide(&mut self, glide: Glide) {
        self.glide = glide;
    }

    /// Turns around the target as if the pointer held the face: half a turn for a picture's height.
    pub fn orbit(&mut self, dx_px: f64, dy_px: f64) {
        let radians_per_px = PI / self.size_px.y;
        self.goal.azimuth -= dx_px * radians_per_px;
        self.goal.elevation = (self.goal.elevation + dy_px * radians_per_px).clamp(-STEEPEST, STEEPEST);
    }

    /// Turns around the upright axis, at once and without glide.
    pub fn turn(&mut self, radians: f64) {
        self.goal.azimuth += radians;
        self.now.azimuth += radians;
    }

    /// Glides around the upright axis by so much the other way.
    pub fn turn_back(&mut self, radians: f64) {
        self.goal.azimuth -= radians;
    }

    /// Moves along the view plane so that what is at the subject's depth follows the pointer.
    pub fn pan(&mut self, dx_px: f64, dy_px: f64) {
        let m_per_px = self.m_per_px_at_distance(self.distance_m(&self.goal));
        let offset_m = (self.up() * dy_px - self.right() * dx_px) * m_per_px;
        let from_centre_m = (self.goal.target_m + offset_m - self.centre_m).clamp_length_max(2.0 * self.radius_m);
        self.goal.target_m = self.centre_m + from_centre_m;
    }

    /// Comes closer by `factor`, away if it is below 1; nothing for a factor that is not positive.
    pub fn zoom(&mut self, factor: f64) {
        if factor > 0.0 && factor.is_finite() {
            self.goal.zoom = (self.goal.zoom * factor).clamp(ZOOM_LIMITS[0], ZOOM_LIMITS[1]);
        }
    }

    /// Goes to a named view by the shortest way round.
    pub fn look(&mut self, view: NamedView) {
        let (azimuth, elevation) = match view {
            NamedView::Front | NamedView::Reset => (0.0, 0.0),
            NamedView::Left => (FRAC_PI_2, 0.0),
            NamedView::Top => (0.0, STEEPEST),
        };
        if view == NamedView::Reset {
            self.goal = Pose::home(self.centre_m);
        }
        let turns = ((self.now.azimuth - azimuth) / TAU).round();
        self.goal.azimuth = azimuth + turns * TAU;
        self.goal.elevation = elevation;
    }

    /// Moves on by `seconds`; true while the camera has not arrived.
    pub fn advance(&mut self, seconds: f64) -> bool {
        if self.now == self.goal && self.clear == self.clear_goal {
            return false;
        }
        let share = match self.glide {
            Glide::Smooth => 1.0 - (-seconds.max(0.0) / GLIDE_S).exp(),
            Glide::Off => 1.0,
        };
        self.now = self.now.towards(&self.goal, share);
        self.clear = self.clear.towards(self.clear_goal, share);
        if self.now.is_near(&self.goal, self.radius_m) && self.clear.is_near(self.clear_goal) {
            (self.now, self.clear) = (self.goal, self.clear_goal);
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn camera() -> Camera {
        let mut camera = Camera::default();
        camera.resize(800, 600);
        camera.frame(DVec3::new(0.0, 0.01, 0.02), 0.12);
        camera
    }

    #[test]
    fn panning_takes_the_target_along_with_the_pointer() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        camera.pan(30.0, -20.0);
        camera.advance(0.0);
        let middle = camera.project(DVec3::new(0.0, 0.01, 0.02)).unwrap();
        assert!(middle.distance(DVec2::new(430.0, 280.0)) < 1e-9, "{middle}");
    }

    #[test]
    fn dragging_to_the_right_turns_the_face_to_the_right() {
        let mut camera = camera();
        let nose = DVec3::new(0.0, 0.01, 0.12);
        camera.orbit(50.0, 0.0);
        while camera.advance(0.016) {}
        assert!(camera.project(nose).unwrap().x > 400.0);
    }

    #[test]
    fn the_glide_is_independent_of_the_frame_rate_and_ends() {
        let after = |frames: u32| {
            let mut camera = camera();
            camera.orbit(100.0, 30.0);
            (0..frames).for_each(|_| {
                camera.advance(0.1 / f64::from(frames));
            });
            camera.eye_m()
        };
        assert!(after(2).distance(after(24)) < 1e-9);
        let mut camera = camera();
        camera.look(NamedView::Left);
        let frames = std::iter::repeat_with(|| camera.advance(0.016)).take_while(|&moving| moving).count();
        assert!(frames < 120, "{frames}");
    }

    #[test]
    fn named_views_look_along_the_axes_and_take_the_short_way() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        camera.turn(3.0 * TAU + 0.4);
        camera.look(NamedView::Left);
        camera.advance(0.0);
        assert!(camera.back().distance(DVec3::X) < 1e-12);
        camera.look(NamedView::Top);
        camera.advance(0.0);
        assert!(camera.back().distance(DVec3::Y) < 2e-3);
        camera.look(NamedView::Reset);
        camera.advance(0.0);
        assert!(camera.back().distance(DVec3::Z) < 1e-12);
    }

    #[test]
    fn what_is_framed_fits_into_what_nothing_lies_over() {
        for covered_px in [[0.0; 4], [40.0, 0.0, 80.0, 0.0], [10.0, 300.0, 20.0, 0.0], [0.0, 0.0, 420.0, 500.0]] {
            let mut camera = camera();
            camera.set_covered(covered_px);
            while camera.advance(0.016) {}
            let [top, right, bottom, left] = covered_px;
            let (from, to) = (DVec2::new(left, top), DVec2::new(800.0 - right, 600.0 - bottom));
            let middle = camera.project(camera.centre_m()).unwrap();
            assert!(middle.distance(0.5 * (from + to)) < 1e-9, "{covered_px:?}: {middle}");
            for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z] {
                let seen = camera.project(camera.centre_m() + side * camera.radius_m()).unwrap();
                assert!(seen.cmpge(from - 1e-9).all() && seen.cmple(to + 1e-9).all(), "{covered_px:?}: {seen}");
                let ray = camera.ray(seen);
                let miss = (camera.centre_m() + side * camera.radius_m() - ray.origin).cross(ray.direction).length();
                assert!(miss < 1e-12, "{miss}");
            }
        }
    }

    #[test]
    fn what_has_grown_is_framed_again_without_a_jump() {
        let mut camera = camera();
        let (eye_m, clip) = (camera.eye_m(), camera.clip_from_model());
        camera.frame_again(0.18);
        assert!(camera.eye_m().distance(eye_m) < 1e-12 && camera.clip_from_model() != clip, "only the depth range");
        while camera.advance(0.016) {}
        assert!((camera.eye_m().distance(camera.centre_m()) / eye_m.distance(camera.centre_m()) - 1.5).abs() < 1e-9);
    }

    #[test]
    fn no_input_drives_the_camera_out_of_reach() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        for factor in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 1e9] {
            camera.zoom(factor);
            camera.orbit(1e6, 1e6);
            camera.pan(1e6, -1e6);
            camera.set_covered([factor, 1e9, -factor, f64::NAN]);
            camera.advance(1.0);
            assert!(camera.clip_from_model().is_finite());
        }
    }
}
