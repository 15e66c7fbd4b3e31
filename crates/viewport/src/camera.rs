use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::dcamera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{DMat4, DVec2, DVec3, DVec4};
use rosto_mesh::Ray;

const VERTICAL_FIELD_OF_VIEW: f64 = 0.5;
/// Time constant of the glide towards where the camera is asked to be.
const GLIDE_S: f64 = 0.07;
const STEEPEST: f64 = FRAC_PI_2 - 1e-3;
const ZOOM_LIMITS: [f64; 2] = [0.35, 12.0];

/// A direction to look from that has a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NamedView {
    /// Straight at the face.
    Front,
    /// At the face's own left side, from +X.
    Left,
    /// From above, the face looking down the picture.
    Top,
    /// As at first: front, centred, at the first distance.
    Reset,
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
    glide: Glide,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Pose {
    target_m: DVec3,
    /// 0 looks at the face from +Z; positive from +X.
    azimuth: f64,
    /// Positive from above.
    elevation: f64,
    /// Above 1 is nearer than the distance that shows everything.
    zoom: f64,
}

impl Pose {
    fn home(centre_m: DVec3) -> Self {
        Self { target_m: centre_m, azimuth: 0.0, elevation: 0.0, zoom: 1.0 }
    }

    /// Unit vector from the target to the eye.
    fn back(&self) -> DVec3 {
        let (sin_azimuth, cos_azimuth) = self.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation.sin_cos();
        DVec3::new(sin_azimuth * cos_elevation, sin_elevation, cos_azimuth * cos_elevation)
    }

    fn is_near(&self, other: &Self, radius_m: f64) -> bool {
        self.target_m.distance(other.target_m) < 1e-5 * radius_m
            && (self.azimuth - other.azimuth).abs() < 1e-5
            && (self.elevation - other.elevation).abs() < 1e-5
            && (self.zoom - other.zoom).abs() < 1e-5 * other.zoom
    }

    fn towards(&self, goal: &Self, share: f64) -> Self {
        Self {
            target_m: self.target_m.lerp(goal.target_m, share),
            azimuth: self.azimuth + (goal.azimuth - self.azimuth) * share,
            elevation: self.elevation + (goal.elevation - self.elevation) * share,
            zoom: self.zoom * (goal.zoom / self.zoom).powf(share),
        }
    }
}

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

    /// Moves along the view plane so that what is at the target's depth follows the pointer.
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
        if self.now == self.goal {
            return false;
        }
        let share = match self.glide {
            Glide::Smooth => 1.0 - (-seconds.max(0.0) / GLIDE_S).exp(),
            Glide::Off => 1.0,
        };
        self.now = self.now.towards(&self.goal, share);
        if self.now.is_near(&self.goal, self.radius_m) {
            self.now = self.goal;
        }
        true
    }

    /// Where the eye is.
    pub fn eye_m(&self) -> DVec3 {
        self.now.target_m + self.now.back() * self.distance_m(&self.now)
    }

    /// Unit vector to the right in the picture.
    pub fn right(&self) -> DVec3 {
        DVec3::new(self.now.azimuth.cos(), 0.0, -self.now.azimuth.sin())
    }

    /// Unit vector up in the picture.
    pub fn up(&self) -> DVec3 {
        self.now.back().cross(self.right())
    }

    /// Unit vector from the picture to the viewer.
    pub fn back(&self) -> DVec3 {
        self.now.back()
    }

    /// WebGPU clip space (depth 0..1) from the model, for column vectors.
    pub fn clip_from_model(&self) -> DMat4 {
        let distance_m = self.distance_m(&self.now);
        let near_m = (distance_m - 4.0 * self.radius_m).max(0.02 * distance_m);
        let far_m = distance_m + 6.0 * self.radius_m;
        let aspect = self.size_px.x / self.size_px.y;
        perspective(VERTICAL_FIELD_OF_VIEW, aspect, near_m, far_m)
            * look_at_mat4(self.eye_m(), self.now.target_m, DVec3::Y)
    }

    /// Where a point appears, in px; none behind the eye.
    pub fn project(&self, point_m: DVec3) -> Option<DVec2> {
        let clip = self.clip_from_model() * DVec4::from((point_m, 1.0));
        let ndc = clip.truncate().truncate() / clip.w;
        (clip.w > 0.0).then(|| DVec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * self.size_px)
    }

    /// The ray from the eye through a place in the picture; its direction has length 1.
    pub fn ray(&self, place_px: DVec2) -> Ray {
        let ndc = place_px / self.size_px * 2.0 - DVec2::ONE;
        let half_height = (0.5 * VERTICAL_FIELD_OF_VIEW).tan();
        let half_width = half_height * self.size_px.x / self.size_px.y;
        let direction = self.right() * (ndc.x * half_width) - self.up() * (ndc.y * half_height) - self.back();
        Ray { origin: self.eye_m(), direction: direction.normalize() }
    }

    /// The offset in metres, within the view plane, that moves a point by so many px in the picture.
    pub fn view_plane_offset_m(&self, point_m: DVec3, motion_px: DVec2) -> DVec3 {
        let depth_m = (self.eye_m() - point_m).dot(self.back());
        (self.right() * motion_px.x - self.up() * motion_px.y) * self.m_per_px_at_distance(depth_m)
    }

    /// How many metres at distance 1 m from the eye's plane make one px.
    pub fn m_per_px_at_distance(&self, distance_m: f64) -> f64 {
        2.0 * distance_m * (0.5 * VERTICAL_FIELD_OF_VIEW).tan() / self.size_px.y
    }

    /// The distance that shows the whole sphere, in pictures of any shape, divided by the zoom.
    fn distance_m(&self, pose: &Pose) -> f64 {
        let half_height = (0.5 * VERTICAL_FIELD_OF_VIEW).tan();
        let narrower = half_height * (self.size_px.x / self.size_px.y).min(1.0);
        self.radius_m / narrower.atan().sin() / pose.zoom
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        let mut camera = Camera::default();
        camera.resize(800, 600);
        camera.frame(DVec3::new(0.0, 0.01, 0.02), 0.12);
        camera
    }

    #[test]
    fn the_centre_appears_in_the_middle_and_left_is_right() {
        let camera = camera();
        let middle = camera.project(DVec3::new(0.0, 0.01, 0.02)).unwrap();
        assert!(middle.distance(DVec2::new(400.0, 300.0)) < 1e-9, "{middle}");
        assert!(camera.project(DVec3::new(0.05, 0.01, 0.02)).unwrap().x > 400.0);
        assert!(camera.project(DVec3::new(0.0, 0.05, 0.02)).unwrap().y < 300.0);
        assert_eq!(camera.project(camera.eye_m() + camera.back()), None);
    }

    #[test]
    fn a_ray_through_a_projected_point_meets_it() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        camera.orbit(130.0, -70.0);
        camera.pan(12.0, 5.0);
        camera.zoom(1.7);
        camera.advance(0.0);
        let point = DVec3::new(0.03, -0.04, 0.05);
        let ray = camera.ray(camera.project(point).unwrap());
        let miss = (point - ray.origin).cross(ray.direction).length();
        assert!(miss < 1e-12, "{miss}");
    }

    #[test]
    fn a_point_moved_in_the_view_plane_follows_the_pointer() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        camera.orbit(90.0, 40.0);
        camera.advance(0.0);
        let point = DVec3::new(0.02, 0.03, 0.04);
        let motion = DVec2::new(25.0, -14.0);
        let moved = point + camera.view_plane_offset_m(point, motion);
        let seen = camera.project(moved).unwrap() - camera.project(point).unwrap();
        assert!(seen.distance(motion) < 1e-9, "{seen}");
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
    fn the_whole_sphere_is_seen_in_pictures_of_any_shape() {
        for (width, height) in [(1200, 500), (500, 1200), (700, 700)] {
            let mut camera = camera();
            camera.resize(width, height);
            let centre = DVec3::new(0.0, 0.01, 0.02);
            for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z] {
                let seen = camera.project(centre + side * 0.12).unwrap();
                assert!(seen.cmpge(DVec2::ZERO).all() && seen.cmple(camera.size_px()).all(), "{seen}");
            }
        }
    }

    #[test]
    fn no_input_drives_the_camera_out_of_reach() {
        let mut camera = camera();
        camera.set_glide(Glide::Off);
        for factor in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9, 1e9] {
            camera.zoom(factor);
            camera.orbit(1e6, 1e6);
            camera.pan(1e6, -1e6);
            camera.advance(1.0);
            assert!(camera.clip_from_model().is_finite());
        }
    }
}
