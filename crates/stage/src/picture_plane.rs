use glam::{DVec2, DVec3};
use rosto_mesh::Ray;

/// Position of a pinhole's picture in the model: on the plane through the framed centre perpendicular to the optical
/// axis, at the scale that matches the view.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PicturePlane {
    /// Top left corner of the picture, in metres.
    pub origin_m: DVec3,
    /// Offset of one px to the right, in metres.
    pub right_m: DVec3,
    /// Offset of one px down, in metres.
    pub down_m: DVec3,
    /// Width and height in px.
    pub size_px: DVec2,
}

impl PicturePlane {
    /// Model position of a point of the picture, given in px.
    pub fn at(&self, position_px: DVec2) -> DVec3 {
        self.origin_m + self.right_m * position_px.x + self.down_m * position_px.y
    }

    /// Intersection with a ray, in px of the picture, which may lie outside it; `None` for parallel rays.
    pub fn px_under(&self, ray: &Ray) -> Option<DVec2> {
        let normal = self.right_m.cross(self.down_m);
        let along = (self.origin_m - ray.origin).dot(normal) / ray.direction.dot(normal);
        let from_corner = ray.origin + ray.direction * along - self.origin_m;
        let share = |axis: DVec3| from_corner.dot(axis) / axis.length_squared();
        let position_px = DVec2::new(share(self.right_m), share(self.down_m));
        position_px.is_finite().then_some(position_px)
    }

    pub(crate) fn centre_m(&self) -> DVec3 {
        self.at(0.5 * self.size_px)
    }

    /// Width and height in metres.
    pub(crate) fn size_m(&self) -> DVec2 {
        DVec2::new(self.right_m.length(), self.down_m.length()) * self.size_px
    }
}
