use rosto_session::{Applied, Catalogue, Changed, Intent, PanelDiff, State, Tick};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::{FacadeError, Result};
use crate::sent::sent;

/// The session's messages, as plain objects.
#[wasm_bindgen]
impl Studio {
    /// Applies an intent completely, or throws and changes nothing. Read `tick()` or `state()` again after a change of
    /// that extent.
    ///
    /// # Errors
    /// `bad-choice` for an unknown intent or id, `bad-number` for an invalid number, and the errors of the intent, such
    /// as `no-face`, `no-selection` or `bad-vertex`.
    pub fn apply(&mut self, intent: Ts<Intent>) -> Result<Ts<Applied>, JsValue> {
        let intent = Intent::from_js(intent).map_err(|error| FacadeError::of_message(&error))?;
        Ok(sent(&self.act(intent)?)?)
    }

    /// Returns the state that panels show.
    pub fn state(&self) -> Result<Ts<State>, JsValue> {
        Ok(sent(&self.session.state())?)
    }

    /// Returns the widgets of the panels that have changed since the last call; at first, all sections. `isTick`: only
    /// the edit in progress has changed.
    #[wasm_bindgen(js_name = panelDiff)]
    pub fn panel_diff(&mut self, #[wasm_bindgen(js_name = isTick)] is_tick: bool) -> Result<Ts<PanelDiff>, JsValue> {
        self.session.set_texture_side_px(self.texture_side_px());
        let changed = if is_tick { Changed::Tick } else { Changed::Document };
        Ok(sent(&self.session.panel_diff(&mut self.panel, changed))?)
    }

    /// Returns the values that the edit in progress moves.
    pub fn tick(&self) -> Result<Ts<Tick>, JsValue> {
        Ok(sent(&self.session.tick())?)
    }
}

/// Returns the ids and ranges, which do not change.
#[wasm_bindgen]
pub fn catalogue() -> Result<Ts<Catalogue>, JsValue> {
    Ok(sent(&Catalogue::default())?)
}

impl Studio {
    /// Single mutation entry point: applies an intent and shows its change.
    pub(crate) fn act(&mut self, intent: Intent) -> Result<Applied> {
        let closes = intent == Intent::Close;
        let applied = match intent {
            Intent::Resize([width_px, height_px], pixel_ratio) => {
                let size_px = self.viewport.fitting(width_px, height_px);
                let applied = self.session.answer(Intent::Resize(size_px, pixel_ratio))?;
                self.viewport.resize(size_px[0], size_px[1]);
                applied
            }
            other => self.session.answer(other)?,
        };
        if closes {
            self.pictures.open(Vec::new());
        }
        self.show_soon(applied.changed);
        Ok(applied)
    }
}
