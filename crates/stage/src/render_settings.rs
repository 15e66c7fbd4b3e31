use crate::{Light, Srgb};

/// Share of the lamp's shading on a picture that has its own lighting.
const LAMP_ON_PICTURE: f64 = 0.15;

rosto_mesh::named! {
    /// Colouring of the surface.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum ShadingMode {
        /// The picture as texture; clay without a picture.
        #[default]
        Picture = "picture",
        /// Vertex colours, blended in linear light.
        Colours = "colours",
        /// Warm grey.
        Clay = "clay",
        /// Surface normal: x, y, z as red, green, blue.
        Normals = "normals",
        /// Clay with the response field as a ramp to the accent colour.
        Response = "response",
        /// Scalar per vertex, −1 to 1, from blue through neutral to red.
        Distortion = "distortion",
    }
}

/// Visibility of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Surface {
    /// Drawn in its shading mode.
    #[default]
    Shaded,
    /// Drawn in its vertex colours and without dots, in each shading mode.
    Coloured,
    /// Drawn only into the depth buffer, to hide the far side of a wireframe.
    HiddenLine,
}

/// Whether an element is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Visibility {
    /// Not drawn.
    #[default]
    Hidden,
    /// Drawn.
    Shown,
}

rosto_mesh::named! {
    /// Content of the stage.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Scene {
        /// The mesh.
        #[default]
        Solid = "solid",
        /// The picture taken of the mesh, warped with it; the mesh is invisible, but can still be picked.
        Picture = "picture",
    }
}

rosto_mesh::named! {
    /// Which vertices show as dots.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Dots {
        /// None.
        None = "none",
        /// Those near the pointer.
        #[default]
        NearPointer = "near",
        /// All.
        All = "all",
    }
}

rosto_mesh::named! {
    /// Colour scheme.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Theme {
        /// Dark marks on a light, warm background.
        #[default]
        Light = "light",
        /// Light marks on a dark background.
        Dark = "dark",
    }
}

/// Background of the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Background {
    /// The theme's gradient, with a soft shadow under the mesh.
    #[default]
    Ground,
    /// One colour, without a shadow.
    Plain(Srgb),
    /// Transparent.
    Transparent,
}

rosto_mesh::named! {
    /// Light on a surface that is textured with the picture.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum PictureLight {
        /// Mostly the light in the picture itself.
        #[default]
        Own = "own",
        /// The lamp, as on other surfaces.
        Lamp = "lamp",
    }
}

/// Render settings other than mesh, camera and marks.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RenderSettings {
    /// Colouring of the surface.
    pub shading: ShadingMode,
    /// Visibility of the surface.
    pub surface: Surface,
    /// Edges, one CSS pixel wide.
    pub wireframe: Visibility,
    /// Vertices that show as dots.
    pub dots: Dots,
    /// Number of vertices, from the first, that can show as dots; `None` for all.
    pub dotted: Option<u32>,
    /// Colour scheme.
    pub theme: Theme,
    /// Background.
    pub background: Background,
    /// Thin line where the plane of symmetry, x = 0, cuts the surface.
    pub mirror_plane: Visibility,
    /// Line on the surface at the edit's influence radius.
    pub rim: Visibility,
    /// Light on the picture.
    pub picture_light: PictureLight,
    /// Comparison slider: up to this share of the width, 0..1 from the left, the original shape is shown; beyond it,
    /// the current one.
    pub wipe: Option<f64>,
    /// The light.
    pub light: Light,
    /// Blend between the current shape (0) and the original one (1).
    pub before: f64,
    /// Strength of the response field's glow over any colouring, 0..1.
    pub glow: f64,
}

impl RenderSettings {
    /// Colouring of the drawn surface.
    pub(crate) fn drawn_shading(&self) -> ShadingMode {
        if self.surface == Surface::Coloured { ShadingMode::Colours } else { self.shading }
    }

    /// Light on the surface. A picture keeps its own lighting plus a trace of the lamp, so that its shape is visible
    /// when it turns.
    pub(crate) fn surface_light(&self) -> Light {
        match (self.drawn_shading(), self.picture_light) {
            (ShadingMode::Picture, PictureLight::Own) => self.light.faded_to_flat(1.0 - LAMP_ON_PICTURE),
            _ => self.light,
        }
    }
}

/// Colours of a theme; same values as in `web/css/base.css`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Palette {
    /// Background at the upper edge.
    pub ground_top: Srgb,
    /// Background at the lower edge.
    pub ground_bottom: Srgb,
    /// Edges and dots.
    pub ink: Srgb,
    /// Opacity of edges, 0..1.
    pub ink_alpha: f32,
    /// Outline of marks, for contrast on any colour.
    pub halo: Srgb,
    /// Selection and response.
    pub accent: Srgb,
    /// Opacity of the shadow under the mesh, 0..1.
    pub shadow_alpha: f32,
}

impl Theme {
    /// Colours of the theme.
    pub fn palette(self) -> Palette {
        match self {
            Self::Light => Palette {
                ground_top: Srgb([0xf5, 0xf3, 0xef]),
                ground_bottom: Srgb([0xe7, 0xe3, 0xdb]),
                ink: Srgb([0x2a, 0x26, 0x22]),
                ink_alpha: 0.36,
                halo: Srgb([0xff, 0xff, 0xff]),
                accent: Srgb([0xb8, 0x49, 0x2f]),
                shadow_alpha: 0.30,
            },
            Self::Dark => Palette {
                ground_top: Srgb([0x1c, 0x1d, 0x20]),
                ground_bottom: Srgb([0x11, 0x12, 0x14]),
                ink: Srgb([0xf1, 0xec, 0xe4]),
                ink_alpha: 0.30,
                halo: Srgb([0x14, 0x14, 0x16]),
                accent: Srgb([0xe0, 0x7a, 0x5f]),
                shadow_alpha: 0.55,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_keeps_its_colours_under_any_lamp() {
        let dark = Light { strength: 0.0, ambient: 0.0, ..Light::default() };
        for light in [Light::default(), dark, Light { azimuth_deg: 120.0, strength: 2.0, ..Light::default() }] {
            let own = RenderSettings { light, ..RenderSettings::default() };
            let darkest = own.surface_light().ambient;
            assert!(darkest >= 1.0 - LAMP_ON_PICTURE, "{darkest}");
            for settings in [
                RenderSettings { picture_light: PictureLight::Lamp, ..own },
                RenderSettings { shading: ShadingMode::Clay, ..own },
            ] {
                assert_eq!(settings.surface_light(), light);
            }
            let coloured = RenderSettings { surface: Surface::Coloured, ..own };
            assert_eq!((coloured.drawn_shading(), coloured.surface_light()), (ShadingMode::Colours, light));
        }
    }
}
