use rosto_export::TextureSize;
use rosto_face::Triangulation;
use rosto_stage::{Background, Scene, Stage, Surface, Visibility};
use rosto_studio::{DEFAULT_FALLOFF_BAND, SMOOTH_DENSITY, Switch};

use crate::TextureSource;

/// Rotation speed of the empty state.
const IDLE_TURN_DEG_PER_S: f64 = 14.0;
/// Speed of auto-rotation.
const TURNTABLE_DEG_PER_S: f64 = 24.0;

/// View settings of an open face; they persist from one face to the next. Settings that are the same without a face are
/// in the [`Stage`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Whether the photo or the 3D face is displayed.
    pub scene: Scene,
    /// Falloff band around the face in its photo, as a share of the face's longer side.
    pub falloff_band: f64,
    /// Source of the texture.
    pub texture_source: TextureSource,
    /// Size of the texture.
    pub texture_size: TextureSize,
    /// Whether edges are shown.
    pub wireframe: Visibility,
    /// The background.
    pub background: Background,
    /// Whether the face rotates automatically.
    pub turntable: Turntable,
    /// Triangulation of the next face.
    pub triangulation: Triangulation,
    /// Density of the next face's mesh.
    pub density: u32,
    /// Whether anchors are marked.
    pub anchors: Switch,
    /// Whether the photo is seen behind the 3D face.
    pub backdrop: Visibility,
    /// Whether animations run.
    pub motion: Motion,
    /// Whether the printed body is displayed in place of the face.
    pub print: Visibility,
}

/// Auto-rotation of the face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Turntable {
    /// Off.
    #[default]
    Still,
    /// Slow rotation.
    Turns,
}

/// Animations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Motion {
    /// The camera glides, an opened face arrives with a movement, and the empty state rotates.
    #[default]
    Usual,
    /// Reduced motion: no animation.
    Reduced,
}

impl Default for View {
    /// A smooth face without holes, in the photo's colours.
    fn default() -> Self {
        Self {
            scene: Scene::default(),
            falloff_band: DEFAULT_FALLOFF_BAND,
            texture_source: TextureSource::default(),
            texture_size: TextureSize::default(),
            wireframe: Visibility::default(),
            background: Background::default(),
            turntable: Turntable::default(),
            triangulation: Triangulation::Canonical,
            density: SMOOTH_DENSITY,
            anchors: Switch::Off,
            backdrop: Visibility::Shown,
            motion: Motion::default(),
            print: Visibility::Hidden,
        }
    }
}

impl View {
    /// Applies the settings to the stage; the empty state has a separate appearance.
    pub(crate) fn show_on(&self, stage: &mut Stage, is_empty: bool) {
        stage.set_turntable(match (is_empty, self.motion, self.turntable) {
            (true, Motion::Usual, _) => IDLE_TURN_DEG_PER_S,
            (false, _, Turntable::Turns) => TURNTABLE_DEG_PER_S,
            _ => 0.0,
        });
        let settings = stage.render_settings_mut();
        settings.background = if is_empty { Background::Transparent } else { self.background };
        settings.surface = match (is_empty, self.print) {
            (true, _) => Surface::HiddenLine,
            (false, Visibility::Shown) => Surface::Coloured,
            (false, Visibility::Hidden) => Surface::Shaded,
        };
        settings.wireframe = if is_empty { Visibility::Shown } else { self.wireframe };
    }
}
