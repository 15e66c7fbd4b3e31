use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use rosto_mesh::Ray;

use super::facing::Facing;
use super::pose::Pose;
use super::{Camera, Sides, VisibleArea};

/// What is drawn reaches from so many radii before the middle to so many behind it.
const RADII_BEFORE: f64 = 4.0;
const RADII_BEHIND: f64 = 6.0;
/// And no nearer to the eye than this share of its distance.
const NEAREST: f64 = 0.02;

/// Between the model and the picture.
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

    /// The eye as a homogeneous point: its place in metres by its nearness, and its nearness in 1/m. That is 0 for one
    /// infinitely far away, of which the direction is left.
    pub fn eye(&self) -> DVec4 {
        let eye = self.now.eye;
        let to_eye = self.facing().axes() * eye.aside.extend(1.0);
        (to_eye + self.centre_m * eye.nearness_per_m).extend(eye.nearness_per_m)
    }

    /// Unit vector from a point to the eye.
    pub fn to_eye(&self, point_m: DVec3) -> DVec3 {
        let eye = self.eye();
        (eye.truncate() - point_m * eye.w).normalize_or(self.back())
    }

    /// WebGPU clip space (depth 0..1) from the model, for column vectors; w is 1 at the depth of the middle.
    pub fn clip_from_model(&self) -> DMat4 {
        let (eye, [near_m, far_m]) = (self.now.eye, self.depths_m());
        let scale = 2.0 * self.px_per_m(&self.now, self.visible_area) / self.size_px;
        let shift =
            (self.visible_area.middle * 2.0 - DVec2::ONE) * DVec2::new(1.0, -1.0) - self.middle_m(&self.now) * scale;
        let to_depth = eye.remoteness(far_m) / (far_m - near_m);
        let by_depth = -(eye.aside * scale + shift * eye.nearness_per_m);
        let clip_from_view = DMat4::from_cols(
            DVec4::new(scale.x, 0.0, 0.0, 0.0),
            DVec4::new(0.0, scale.y, 0.0, 0.0),
            DVec4::new(by_depth.x, by_depth.y, to_depth, -eye.nearness_per_m),
            DVec4::new(shift.x, shift.y, -to_depth * near_m, 1.0),
        );
        let view_from_model = DMat4::from_mat3(self.view_from_model()) * DMat4::from_translation(-self.centre_m);
        self.clip_from_sides() * clip_from_view * view_from_model
    }

    /// Where a point appears, in px; none behind the eye.
    pub fn project(&self, point_m: DVec3) -> Option<DVec2> {
        let clip = self.clip_from_model() * DVec4::from((point_m, 1.0));
        let ndc = clip.truncate().truncate() / clip.w;
        (clip.w > 0.0).then(|| DVec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * self.size_px)
    }

    /// The ray through a place in the picture, from as near to the eye as anything is drawn; its direction has length 1.
    pub fn ray(&self, place_px: DVec2) -> Ray {
        let place_px = match self.sides {
            Sides::True => place_px,
            Sides::Swapped => DVec2::new(2.0 * self.visible_area.middle.x * self.size_px.x - place_px.x, place_px.y),
        };
        let from_middle_m =
            (place_px - self.visible_area.middle * self.size_px) / self.px_per_m(&self.now, self.visible_area);
        let plane_m = self.middle_m(&self.now) + from_middle_m * DVec2::new(1.0, -1.0);
        let (eye, [near_m, _], axes) = (self.now.eye, self.depths_m(), self.facing().axes());
        Ray {
            origin: self.centre_m + axes * eye.at_depth_m(plane_m, near_m),
            direction: (axes * eye.through(plane_m)).normalize(),
        }
    }

    /// The offset in metres, within the view plane, that moves a point by so many px in the picture.
    pub fn view_plane_offset_m(&self, point_m: DVec3, motion_px: DVec2) -> DVec3 {
        (self.right() * motion_px.x - self.up() * motion_px.y) * self.m_per_px_at(point_m)
    }

    /// How many metres within the view plane make one px, as deep as a point lies.
    pub fn m_per_px_at(&self, point_m: DVec3) -> f64 {
        self.now.eye.remoteness(self.view_m(point_m).z) * self.m_per_px()
    }

    /// The same as deep as the middle of what is framed.
    pub fn m_per_px(&self) -> f64 {
        self.px_per_m(&self.now, self.visible_area).recip()
    }

    /// The same for the goal as deep as its target lies.
    pub(super) fn m_per_px_at_target(&self, goal: &Pose) -> f64 {
        goal.eye.remoteness(self.view_m(goal.target_m).z) / self.px_per_m(goal, self.visible_area)
    }

    /// How it faces what it frames now.
    pub(super) fn facing(&self) -> Facing {
        let facing = self.now.facing;
        Facing { azimuth: facing.azimuth + self.sway, ..facing }
    }

    /// Sides are swapped about the middle of what nothing lies over.
    fn clip_from_sides(&self) -> DMat4 {
        match self.sides {
            Sides::True => DMat4::IDENTITY,
            Sides::Swapped => {
                let mut swapped = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
                swapped.w_axis.x = 2.0 * (2.0 * self.visible_area.middle.x - 1.0);
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

    /// What of the plane is seen in the middle of what nothing lies over.
    fn middle_m(&self, pose: &Pose) -> DVec2 {
        pose.eye.on_plane_m(self.view_m(pose.target_m)) + pose.eye.silhouette_m(pose.radius_m).0
    }

    /// The scale that fits the whole sphere into what nothing lies over, times the zoom.
    fn px_per_m(&self, pose: &Pose, visible_area: VisibleArea) -> f64 {
        let (_, half_m) = pose.eye.silhouette_m(pose.radius_m);
        (0.5 * visible_area.size * self.size_px / half_m).min_element() * pose.zoom
    }

    /// The depths between which things are drawn, towards the viewer: the nearest and the furthest.
    fn depths_m(&self) -> [f64; 2] {
        let radius_m = self.now.radius_m.max(self.goal.radius_m);
        let nearest_m = (1.0 - NEAREST) / self.now.eye.nearness_per_m;
        [nearest_m.min(RADII_BEFORE * radius_m), -RADII_BEHIND * radius_m]
    }
}
