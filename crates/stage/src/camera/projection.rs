use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use rosto_mesh::Ray;

use super::facing::Facing;
use super::pose::Pose;
use super::{Camera, Sides, VisibleArea};

/// Depth range in front of and behind the centre, in radii.
const RADII_BEFORE: f64 = 4.0;
const RADII_BEHIND: f64 = 6.0;
/// Minimum distance of the near plane from the eye, as a share of the eye's distance.
const MIN_NEAR: f64 = 0.02;

/// Projection and its inverse.
impl Camera {
    /// Unit vector to the right in the picture.
    pub fn right(&self) -> DVec3 {
        self.facing().axes().x_axis * self.sides.sign()
    }

    /// Unit vector up in the picture.
    pub fn up(&self) -> DVec3 {
        self.facing().axes().y_axis
    }

    /// Unit vector from the picture to the viewer.
    pub fn back(&self) -> DVec3 {
        self.facing().axes().z_axis
    }

    /// The eye as a homogeneous point: position times nearness, and nearness in 1/m, which is 0 for parallel
    /// projection.
    pub fn eye(&self) -> DVec4 {
        let eye = self.now.eye;
        let to_eye = self.facing().axes() * eye.lateral.extend(1.0);
        (to_eye + self.centre_m * eye.nearness_per_m).extend(eye.nearness_per_m)
    }

    /// Unit vector from a point to the eye.
    pub fn to_eye(&self, point_m: DVec3) -> DVec3 {
        let eye = self.eye();
        (eye.truncate() - point_m * eye.w).normalize_or(self.back())
    }

    /// WebGPU clip space (depth 0..1) from the model, for column vectors; w is 1 at the depth of the centre.
    pub fn clip_from_model(&self) -> DMat4 {
        let (eye, [near_m, far_m]) = (self.now.eye, self.depths_m());
        let scale = 2.0 * self.px_per_m(&self.now, self.visible_area) / self.size_px;
        let shift = (self.visible_area.centre * 2.0 - DVec2::ONE) * DVec2::new(1.0, -1.0)
            - self.plane_centre_m(&self.now) * scale;
        let to_depth = eye.relative_distance(far_m) / (far_m - near_m);
        let by_depth = -(eye.lateral * scale + shift * eye.nearness_per_m);
        let clip_from_view = DMat4::from_cols(
            DVec4::new(scale.x, 0.0, 0.0, 0.0),
            DVec4::new(0.0, scale.y, 0.0, 0.0),
            DVec4::new(by_depth.x, by_depth.y, to_depth, -eye.nearness_per_m),
            DVec4::new(shift.x, shift.y, -to_depth * near_m, 1.0),
        );
        let view_from_model = DMat4::from_mat3(self.view_from_model()) * DMat4::from_translation(-self.centre_m);
        self.clip_from_sides() * clip_from_view * view_from_model
    }

    /// Projects a point to px; `None` behind the eye.
    pub fn project(&self, point_m: DVec3) -> Option<DVec2> {
        let clip = self.clip_from_model() * DVec4::from((point_m, 1.0));
        let ndc = clip.truncate().truncate() / clip.w;
        (clip.w > 0.0).then(|| DVec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * self.size_px)
    }

    /// Ray through a position in the picture, starting at the near plane, with a unit direction.
    pub fn ray(&self, position_px: DVec2) -> Ray {
        let position_px = match self.sides {
            Sides::True => position_px,
            Sides::Swapped => {
                DVec2::new(2.0 * self.visible_area.centre.x * self.size_px.x - position_px.x, position_px.y)
            }
        };
        let from_centre_m =
            (position_px - self.visible_area.centre * self.size_px) / self.px_per_m(&self.now, self.visible_area);
        let plane_m = self.plane_centre_m(&self.now) + from_centre_m * DVec2::new(1.0, -1.0);
        let (eye, [near_m, _], axes) = (self.now.eye, self.depths_m(), self.facing().axes());
        Ray {
            origin: self.centre_m + axes * eye.at_depth_m(plane_m, near_m),
            direction: (axes * eye.through(plane_m)).normalize(),
        }
    }

    /// Offset in metres in the view plane that moves a point by `motion_px` on the screen.
    pub fn view_plane_offset_m(&self, point_m: DVec3, motion_px: DVec2) -> DVec3 {
        (self.right() * motion_px.x - self.up() * motion_px.y) * self.m_per_px_at(point_m)
    }

    /// Metres per px in the view plane at a point's depth.
    pub fn m_per_px_at(&self, point_m: DVec3) -> f64 {
        self.now.eye.relative_distance(self.view_m(point_m).z) * self.m_per_px()
    }

    /// Metres per px at the centre's depth.
    pub fn m_per_px(&self) -> f64 {
        self.px_per_m(&self.now, self.visible_area).recip()
    }

    /// Metres per px of a goal at its target's depth.
    pub(super) fn m_per_px_at_target(&self, goal: &Pose) -> f64 {
        goal.eye.relative_distance(self.view_m(goal.target_m).z) / self.px_per_m(goal, self.visible_area)
    }

    /// Current direction.
    pub(super) fn facing(&self) -> Facing {
        self.now.facing
    }

    /// Mirrors about the centre of the visible area.
    fn clip_from_sides(&self) -> DMat4 {
        match self.sides {
            Sides::True => DMat4::IDENTITY,
            Sides::Swapped => {
                let mut swapped = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
                swapped.w_axis.x = 2.0 * (2.0 * self.visible_area.centre.x - 1.0);
                swapped
            }
        }
    }

    fn view_from_model(&self) -> DMat3 {
        self.facing().axes().transpose()
    }

    fn view_m(&self, point_m: DVec3) -> DVec3 {
        self.view_from_model() * (point_m - self.centre_m)
    }

    /// Position on the plane at the centre of the visible area.
    fn plane_centre_m(&self, pose: &Pose) -> DVec2 {
        pose.eye.on_plane_m(self.view_m(pose.target_m)) + pose.eye.silhouette_m(pose.radius_m).0
    }

    /// Scale that fits the sphere into the visible area, times the zoom.
    fn px_per_m(&self, pose: &Pose, visible_area: VisibleArea) -> f64 {
        let (_, half_m) = pose.eye.silhouette_m(pose.radius_m);
        (0.5 * visible_area.size * self.size_px / half_m).min_element() * pose.zoom
    }

    /// Near and far depths, towards the viewer.
    fn depths_m(&self) -> [f64; 2] {
        let radius_m = self.now.radius_m.max(self.goal.radius_m);
        let nearest_m = (1.0 - MIN_NEAR) / self.now.eye.nearness_per_m;
        [nearest_m.min(RADII_BEFORE * radius_m), -RADII_BEHIND * radius_m]
    }
}
