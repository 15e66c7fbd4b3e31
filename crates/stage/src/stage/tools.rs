use super::Stage;

/// Time at rest after which the tools fade, and duration of the fade.
const REST_MS: f64 = 1000.0;
const FADE_MS: f64 = 200.0;

/// Marks and gizmo at the selection, which fade when the user is at rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum Tools {
    /// The user is at rest.
    #[default]
    Hidden,
    /// The user holds or moves something.
    Held,
    /// Time of the last use, set by the next frame, and opacity.
    Used { since_ms: Option<f64>, opacity: f64 },
}

/// Marks and gizmo at the selection.
impl Stage {
    /// Shows marks and gizmo until one second after this; with `is_held`, without an end.
    pub fn use_tools(&mut self, is_held: bool) {
        self.tools = if is_held { Tools::Held } else { Tools::Used { since_ms: None, opacity: 1.0 } };
        self.changed = true;
    }

    /// Opacity of marks and gizmo, 0..1. Squares and pins do not fade.
    pub fn tools_opacity(&self) -> f64 {
        match self.tools {
            Tools::Hidden => 0.0,
            Tools::Held => 1.0,
            Tools::Used { opacity, .. } => opacity,
        }
    }

    /// Advances the fade; returns whether the opacity has changed, and whether it will.
    pub(super) fn advance_tools(&mut self, time_ms: f64) -> (bool, bool) {
        let Tools::Used { since_ms, opacity: before } = self.tools else { return (false, false) };
        let since_ms = since_ms.unwrap_or(time_ms);
        let fading_ms = (time_ms - since_ms - REST_MS).max(0.0);
        let fade_ms = if self.camera.glides() { FADE_MS } else { f64::MIN_POSITIVE };
        let opacity = (1.0 - fading_ms / fade_ms).max(0.0);
        self.tools = if opacity > 0.0 { Tools::Used { since_ms: Some(since_ms), opacity } } else { Tools::Hidden };
        (opacity != before, opacity > 0.0)
    }
}
