use bytemuck::{Pod, Zeroable};
use glam::DVec2;

use super::Stage;
use crate::{Dots, Sides};

/// Uniform buffer that the shaders read, one per frame.
///
/// The viewport's `shaders/frame.wgsl` has the same fields in the same order; a test there compares the sizes.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct FrameUniforms {
    clip_from_model: [f32; 16],
    eye: [f32; 4],
    light_direction: [f32; 3],
    light_strength: f32,
    light_colour: [f32; 3],
    ambient: f32,
    offset_a_m: [f32; 3],
    before: f32,
    offset_b_m: [f32; 3],
    glow: f32,
    right: [f32; 3],
    m_per_px: f32,
    up: [f32; 3],
    shading: u32,
    ground_m: [f32; 3],
    radius_m: f32,
    viewport_px: [f32; 2],
    pointer_px: [f32; 2],
    ink: [f32; 4],
    halo: [f32; 4],
    accent: [f32; 4],
    ground_top: [f32; 4],
    ground_bottom: [f32; 4],
    dots: u32,
    hovered: u32,
    gizmo_vertex: u32,
    gizmo_axis: u32,
    rim: f32,
    mirror_plane: f32,
    pixel_ratio: f32,
    picture: f32,
    picture_origin_m: [f32; 3],
    picture_width_px: f32,
    picture_right_m: [f32; 3],
    picture_height_px: f32,
    picture_down_m: [f32; 3],
    swapped: f32,
    tools: f32,
    unused: [f32; 3],
}

/// Value for "no vertex" in shaders.
const NO_VERTEX: u32 = u32::MAX;

impl Stage {
    /// Uniforms of this frame.
    pub fn uniforms(&self) -> FrameUniforms {
        self.uniforms_at(self.settings.before)
    }

    /// Uniforms for the part that shows the original shape ([`RenderSettings::wipe`](crate::RenderSettings::wipe)).
    pub fn uniforms_before(&self) -> FrameUniforms {
        self.uniforms_at(1.0)
    }

    fn uniforms_at(&self, before: f64) -> FrameUniforms {
        let (camera, settings) = (&self.camera, &self.settings);
        let palette = settings.theme.palette();
        let light = &settings.surface_light();
        // During the arrival, the light changes from the picture's own to the lamp.
        let lamp = (1.0 - self.picture_share) as f32;
        let picture = self.picture.unwrap_or_default();
        FrameUniforms {
            clip_from_model: camera.clip_from_model().as_mat4().to_cols_array(),
            eye: camera.eye().as_vec4().to_array(),
            light_direction: light.direction(camera).as_vec3().to_array(),
            light_strength: lamp * light.brightness() as f32,
            light_colour: light.colour.to_linear(),
            ambient: 1.0 + lamp * (light.ambient as f32 - 1.0),
            offset_a_m: self.offsets_m[0].as_vec3().to_array(),
            before: before as f32,
            offset_b_m: self.offsets_m[1].as_vec3().to_array(),
            glow: settings.glow as f32,
            right: camera.right().as_vec3().to_array(),
            m_per_px: camera.m_per_px() as f32,
            up: camera.up().as_vec3().to_array(),
            shading: settings.drawn_shading() as u32,
            ground_m: self.ground_m.as_vec3().to_array(),
            radius_m: camera.radius_m() as f32,
            viewport_px: camera.size_px().as_vec2().to_array(),
            pointer_px: self.pointer_px.unwrap_or(DVec2::splat(-1e6)).as_vec2().to_array(),
            ink: palette.ink.with_alpha(palette.ink_alpha),
            halo: palette.halo.with_alpha(palette.shadow_alpha * (1.0 - self.backdrop_share()) as f32),
            accent: palette.accent.with_alpha(1.0),
            ground_top: palette.ground_top.with_alpha(1.0),
            ground_bottom: palette.ground_bottom.with_alpha(1.0),
            dots: u32::from(settings.dots == Dots::All),
            hovered: self.hovered.unwrap_or(NO_VERTEX),
            gizmo_vertex: self.gizmo.unwrap_or(NO_VERTEX),
            gizmo_axis: self.gizmo_axis.map_or(NO_VERTEX, |axis| axis as u32),
            rim: f32::from(settings.rim as u8),
            mirror_plane: f32::from(settings.mirror_plane as u8),
            pixel_ratio: self.pixel_ratio as f32,
            picture: self.picture_opacity() as f32,
            picture_origin_m: picture.origin_m.as_vec3().to_array(),
            picture_width_px: picture.size_px.x as f32,
            picture_right_m: picture.right_m.as_vec3().to_array(),
            picture_height_px: picture.size_px.y as f32,
            picture_down_m: picture.down_m.as_vec3().to_array(),
            swapped: f32::from(u8::from(camera.sides() == Sides::Swapped)),
            tools: self.tools_opacity() as f32,
            unused: [0.0; 3],
        }
    }
}
