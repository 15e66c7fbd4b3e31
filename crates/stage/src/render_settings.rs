use crate::{Light, Srgb};

/// How much of the lamp a picture gets that has its own light.
const LAMP_ON_PICTURE: f64 = 0.15;

rosto_mesh::named! {
    /// How the surface is coloured.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum ShadingMode {
        /// The picture as texture; clay where there is none.
        #[default]
        Picture = "picture",
        /// The colour of each vertex, blended in linear light.
        Colours = "colours",
        /// A plain, warm grey.
        Clay = "clay",
        /// The direction the surface faces: x, y, z as red, green, blue.
        Normals = "normals",
        /// Clay with the response field as a ramp from nothing to the accent.
        Response = "response",
        /// The scalar of each vertex, −1 to 1, from blue over neutral to red.
        Distortion = "distortion",
    }
}

/// Whether the surface itself is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Surface {
    /// It is, by its shading mode.
    #[default]
    Shaded,
    /// Only in that it hides what lies behind it: a wireframe over it shows its near side.
    HiddenLine,
}

/// Whether something is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Visibility {
    /// Not drawn.
    #[default]
    Hidden,
    /// Drawn.
    Shown,
}

rosto_mesh::named! {
    /// What is on the stage.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Scene {
        /// The mesh in the round.
        #[default]
        Solid = "solid",
        /// The picture that was taken of it, which follows it; the mesh itself is felt, and not seen.
        Picture = "picture",
    }
}

rosto_mesh::named! {
    /// Which of the dotted vertices show as dots.
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
    /// Light or dark surroundings.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Theme {
        /// Dark marks on a light, warm ground.
        #[default]
        Light = "light",
        /// Light marks on a dark ground.
        Dark = "dark",
    }
}

/// What lies behind the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Background {
    /// The theme's gradient, and a soft shadow under the mesh.
    #[default]
    Ground,
    /// One colour, and no shadow.
    Plain(Srgb),
    /// Nothing.
    Transparent,
}

rosto_mesh::named! {
    /// What lights a surface that is painted with the picture.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum PictureLight {
        /// Nearly nothing beside the light that the picture was taken in.
        #[default]
        Own = "own",
        /// The lamp, as it lights everything else.
        Lamp = "lamp",
    }
}

/// Everything about how a mesh is shown that is not the mesh, the camera or the marks on it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RenderSettings {
    /// How the surface is coloured.
    pub shading: ShadingMode,
    /// Whether it is seen.
    pub surface: Surface,
    /// The edges, each one CSS pixel wide.
    pub wireframe: Visibility,
    /// Which vertices show as dots.
    pub dots: Dots,
    /// How many vertices, from the first, can show as dots; by default all.
    pub dotted: Option<u32>,
    /// Light or dark surroundings.
    pub theme: Theme,
    /// What lies behind.
    pub background: Background,
    /// The plane of symmetry: a hairline where the plane x = 0 cuts the surface.
    pub mirror_plane: Visibility,
    /// The end of an edit's reach: a line on the surface as far from what moves as the edit reaches.
    pub rim: Visibility,
    /// What lights the picture.
    pub picture_light: PictureLight,
    /// The shape before shows up to this share of the picture's width, 0..1 from the left, and the shape now beyond.
    pub wipe: Option<f64>,
    /// The light.
    pub light: Light,
    /// 0 shows the mesh as it is, 1 as it was before; between them, a blend.
    pub before: f64,
    /// How strongly the response field glows in the accent over any paint, 0..1.
    pub glow: f64,
}

impl RenderSettings {
    /// The light that falls on the surface: a picture has the light in it that it was taken in, and of the lamp just a trace,
    /// so that its shape shows when it turns.
    pub(crate) fn surface_light(&self) -> Light {
        match (self.shading, self.picture_light) {
            (ShadingMode::Picture, PictureLight::Own) => self.light.faded_to_flat(1.0 - LAMP_ON_PICTURE),
            _ => self.light,
        }
    }
}

/// The colours of a theme; `web/css/base.css` says the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Palette {
    /// The ground at the picture's upper edge.
    pub ground_top: Srgb,
    /// The ground at its lower edge.
    pub ground_bottom: Srgb,
    /// Edges and dots.
    pub ink: Srgb,
    /// How opaque edges are, 0..1.
    pub ink_alpha: f32,
    /// What surrounds a mark, so that it shows on any colour.
    pub halo: Srgb,
    /// What is selected, and what follows.
    pub accent: Srgb,
    /// How dark the shadow under the mesh is, 0..1.
    pub shadow_alpha: f32,
}

impl Theme {
    /// Its colours.
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
    fn a_picture_keeps_its_colours_whatever_the_lamp_does() {
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
        }
    }
}
