use glam::DVec3;

use crate::{Camera, Srgb};

/// Brightness for `strength` 1. Together with the default ambient light, a surface that faces the viewer shows about
/// its own colour.
const BRIGHTNESS: f64 = 0.92;

/// Directional light fixed to the viewer, plus ambient light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Degrees to the viewer's right; 0 is the viewer's direction, −90 from the left.
    pub azimuth_deg: f64,
    /// Degrees above the horizon.
    pub elevation_deg: f64,
    /// Strength of the directional light; 1 is the default.
    pub strength: f64,
    /// Colour of the directional light.
    pub colour: Srgb,
    /// Ambient brightness; 1 alone shows surfaces in their own colour.
    pub ambient: f64,
}

impl Default for Light {
    /// White light from the upper left.
    fn default() -> Self {
        Self { azimuth_deg: -35.0, elevation_deg: 40.0, strength: 1.0, colour: Srgb::WHITE, ambient: 0.4 }
    }
}

impl Light {
    /// No shading: surfaces in their own colour.
    pub const FLAT: Self =
        Self { azimuth_deg: 0.0, elevation_deg: 0.0, strength: 0.0, colour: Srgb::WHITE, ambient: 1.0 };

    /// Interpolates towards [`Self::FLAT`] by a share, 0..1.
    pub(crate) fn faded_to_flat(self, share: f64) -> Self {
        let mix = |from: f64, to: f64| from + (to - from) * share;
        Self {
            strength: mix(self.strength, Self::FLAT.strength),
            ambient: mix(self.ambient, Self::FLAT.ambient),
            ..self
        }
    }

    /// Brightness of a surface that faces the directional light.
    pub fn brightness(&self) -> f64 {
        self.strength * BRIGHTNESS
    }

    /// Unit vector in the model's frame from the surface towards the light.
    pub fn direction(&self, camera: &Camera) -> DVec3 {
        let (sin_azimuth, cos_azimuth) = self.azimuth_deg.to_radians().sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation_deg.to_radians().sin_cos();
        camera.right() * (sin_azimuth * cos_elevation)
            + camera.up() * sin_elevation
            + camera.back() * (cos_azimuth * cos_elevation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NamedView;

    #[test]
    fn the_light_comes_from_the_upper_left_of_each_view() {
        let mut camera = Camera::default();
        camera.resize(640, 480);
        for view in [NamedView::Front, NamedView::Left, NamedView::Top] {
            camera.look(view);
            while camera.advance(0.05) {}
            let direction = Light::default().direction(&camera);
            assert!((direction.length() - 1.0).abs() < 1e-12);
            assert!(direction.dot(camera.right()) < -0.2 && direction.dot(camera.up()) > 0.2, "{view:?}");
            assert!(direction.dot(camera.back()) > 0.2);
        }
    }

    #[test]
    fn a_surface_facing_the_viewer_shows_about_its_own_colour() {
        let camera = Camera::default();
        let light = Light::default();
        let brightness = light.ambient + light.brightness() * light.direction(&camera).dot(camera.back());
        assert!((brightness - 1.0).abs() < 0.1, "{brightness}");
    }
}
