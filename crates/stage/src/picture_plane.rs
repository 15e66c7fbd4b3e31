use glam::{DVec2, DVec3};
use rosto_mesh::Ray;

/// Where the picture that a pinhole took lies in the model: on the plane through the middle of what is framed that its axis
/// meets at right angles, as large as it is seen there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PicturePlane {
    /// The picture's top left corner, in metres.
    pub origin_m: DVec3,
    /// One px to the right.
    pub right_m: DVec3,
    /// One px down.
    pub down_m: DVec3,
    /// Width and height in px.
    pub size_px: DVec2,
}

impl PicturePlane {
    /// Where a place in the picture, in its px, lies in the model.
    pub fn at(&self, place_px: DVec2) -> DVec3 {
        self.origin_m + self.right_m * place_px.x + self.down_m * place_px.y
    }

    /// The place in the picture, in its px or beside it, that a ray meets; none for one along it.
    pub fn px_under(&self, ray: &Ray) -> Option<DVec2> {
        let normal = self.right_m.cross(self.down_m);
        let along = (self.origin_m - ray.origin).dot(normal) / ray.direction.dot(normal);
        let from_corner = ray.origin + ray.direction * along - self.origin_m;
        let share = |axis: DVec3| from_corner.dot(axis) / axis.length_squared();
        let place_px = DVec2::new(share(self.right_m), share(self.down_m));
        place_px.is_finite().then_some(place_px)
    }

    pub(crate) fn middle_m(&self) -> DVec3 {
        self.at(0.5 * self.size_px)
    }

    /// How wide and high it lies there, in metres.
    pub(crate) fn size_m(&self) -> DVec2 {
        DVec2::new(self.right_m.length(), self.down_m.length()) * self.size_px
    }
}
