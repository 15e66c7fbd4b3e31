use glam::dcamera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{DMat4, DVec2, DVec3, DVec4};
use rosto_mesh::Ray;

use super::Camera;
use super::pose::Pose;

const VERTICAL_FIELD_OF_VIEW: f64 = 0.5;

/// Between the model and the picture.
impl Camera {
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
        let off_middle = (self.clear.middle * 2.0 - DVec2::ONE) * DVec2::new(1.0, -1.0);
        DMat4::from_translation(off_middle.extend(0.0))
            * perspective(VERTICAL_FIELD_OF_VIEW, aspect, near_m, far_m)
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
        let ndc = (place_px / self.size_px - self.clear.middle) * 2.0;
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

    /// The distance that shows the whole sphere where nothing lies over the picture, whatever its shape, divided by the zoom.
    pub(super) fn distance_m(&self, pose: &Pose) -> f64 {
        let clear_px = self.clear.size * self.size_px;
        let narrower = (0.5 * VERTICAL_FIELD_OF_VIEW).tan() * clear_px.min_element() / self.size_px.y;
        self.radius_m / narrower.atan().sin() / pose.zoom
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::camera;
    use super::*;
    use crate::Glide;

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
}
