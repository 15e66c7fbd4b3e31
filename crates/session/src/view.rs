use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Background, Lens, PictureLight, Scene, ShadingMode, Stage, Surface, Visibility};
use rosto_studio::{DEFAULT_FALLOFF_BAND, SMOOTH_DENSITY, Switch};

use crate::TextureSource;

/// How fast the empty state turns.
const IDLE_TURN_DEG_PER_S: f64 = 14.0;
/// How fast the face turns by itself, if asked to.
const TURNTABLE_DEG_PER_S: f64 = 24.0;

/// What was asked for that only a face shows, kept from one face to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Whether the photo is on the stage, or the face in the round.
    pub scene: Scene,
    /// How far around the face its photo gives way, as a share of the face's longer side.
    pub falloff_band: f64,
    /// How the surface is coloured.
    pub shading: ShadingMode,
    /// Which picture is laid on it.
    pub texture_source: TextureSource,
    /// How large its texture is.
    pub texture_size: TextureSize,
    /// From how far away it is seen.
    pub lens: Lens,
    /// Whether edges are drawn.
    pub wireframe: Visibility,
    /// What lies behind.
    pub background: Background,
    /// Whether the face turns by itself.
    pub turntable: Turntable,
    /// How the landmarks of the next face are joined.
    pub triangulation: Triangulation,
    /// How often the next face's mesh is subdivided.
    pub density: u32,
    /// What lights the photo.
    pub picture_light: PictureLight,
    /// Whether what stays in place is marked.
    pub anchors: Switch,
    /// Whether things move by themselves.
    pub motion: Motion,
}

/// Whether the face turns by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Turntable {
    /// It stands still.
    #[default]
    Still,
    /// It turns slowly.
    Turns,
}

/// Whether things move by themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Motion {
    /// The camera glides, a face arrives, the empty state turns.
    #[default]
    Usual,
    /// Nothing moves that was not moved.
    Reduced,
}

impl Default for View {
    /// The face smooth and filled in, as a hand expects it, in the photo's colours.
    fn default() -> Self {
        Self {
            scene: Scene::default(),
            falloff_band: DEFAULT_FALLOFF_BAND,
            shading: ShadingMode::default(),
            texture_source: TextureSource::default(),
            texture_size: TextureSize::default(),
            lens: Lens::default(),
            wireframe: Visibility::default(),
            background: Background::default(),
            turntable: Turntable::default(),
            triangulation: Triangulation::Canonical,
            density: SMOOTH_DENSITY,
            picture_light: PictureLight::default(),
            anchors: Switch::Off,
            motion: Motion::default(),
        }
    }
}

impl View {
    /// Makes the stage follow; the empty state has a look of its own.
    pub(crate) fn show_on(&self, stage: &mut Stage, is_empty: bool) {
        stage.set_turntable(match (is_empty, self.motion, self.turntable) {
            (true, Motion::Usual, _) => IDLE_TURN_DEG_PER_S,
            (false, _, Turntable::Turns) => TURNTABLE_DEG_PER_S,
            _ => 0.0,
        });
        stage.camera_mut().set_lens(self.lens);
        let settings = stage.render_settings_mut();
        settings.background = if is_empty { Background::Transparent } else { self.background };
        settings.shading = self.shading;
        settings.picture_light = self.picture_light;
        settings.surface = if is_empty { Surface::HiddenLine } else { Surface::Shaded };
        settings.wireframe = if is_empty { Visibility::Shown } else { self.wireframe };
    }
}
