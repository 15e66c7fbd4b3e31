use glam::{DVec2, DVec3};
use rosto_session::{Choice, Intent, Pace};
use rosto_stage::Axis;
use rosto_studio::{Expression, FaceSlider, Mirror, Switch};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::{ChangeName, PointerName};
use crate::state::{StudioState, StudioTick};

fn switch(is_on: bool) -> Switch {
    if is_on { Switch::On } else { Switch::Off }
}

/// Edit settings.
#[wasm_bindgen]
impl Studio {
    /// Ids of a setting's values, in the order in which a panel shows them. The settings are "selection", "preset",
    /// "operator", "constraint", "details", "anchors", "scene", "shading", "texture-source", "texture-size", "lens",
    /// "triangulation" and "density".
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn choices(&self, choice: &str) -> Result<Vec<String>, JsValue> {
        Ok(FacadeError::require(Choice::from_id(choice))?.values())
    }

    /// Sets a setting to the value with this id.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn choose(&mut self, choice: &str, id: &str) -> Result<ChangeName, JsValue> {
        let choice = FacadeError::require(Choice::from_id(choice))?;
        self.act(FacadeError::require(choice.intent(id))?)
    }

    /// Sets whether edits are mirrored to the other side of the face.
    #[wasm_bindgen(js_name = setMirror)]
    pub fn set_mirror(&mut self, mirrored: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Mirror(if mirrored { Mirror::On } else { Mirror::Off }))
    }

    /// Sets whether edits are limited to the influence radius.
    #[wasm_bindgen(js_name = setNearby)]
    pub fn set_nearby(&mut self, nearby: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Nearby(switch(nearby)))
    }

    /// Sets the influence radius along the surface. A drag continues.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setRadius)]
    pub fn set_radius(&mut self, #[wasm_bindgen(js_name = radiusMm)] radius_mm: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Radius(radius_mm))
    }

    /// Scales the influence radius by a factor, within its range.
    ///
    /// # Errors
    /// `bad-number`.
    pub fn widen(&mut self, factor: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Widen(factor))
    }
}

/// Edits of the selection and of the whole face.
#[wasm_bindgen]
impl Studio {
    /// Tick of the offset sliders: moves the selection by an offset relative to the last commit. No solve.
    ///
    /// # Errors
    /// `bad-number`.
    pub fn preview(
        &mut self,
        #[wasm_bindgen(js_name = dxMm)] dx_mm: f64,
        #[wasm_bindgen(js_name = dyMm)] dy_mm: f64,
        #[wasm_bindgen(js_name = dzMm)] dz_mm: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Preview(DVec3::new(dx_mm, dy_mm, dz_mm)))
    }

    /// Tick of a ready-made slider; `toMm` is its value, including earlier entries. The first tick needs one solve.
    /// `commit` or `cancel` ends the edit and prepares the selection again.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `bad-number`.
    pub fn slide(&mut self, slider: &str, #[wasm_bindgen(js_name = toMm)] to_mm: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Slide(FacadeError::require(FaceSlider::from_id(slider))?, to_mm))
    }

    /// Tick of an expression; `to` is its weight, 0..1, including earlier entries. With the mirror, its partner on the
    /// other side gets the same weight. `commit` or `cancel` ends the edit.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `bad-number`.
    pub fn express(&mut self, expression: &str, to: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Express(FacadeError::require(Expression::from_id(expression))?, to))
    }

    /// Switches off each expression, as one change.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = resetExpressions)]
    pub fn reset_expressions(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::ResetExpressions)
    }

    /// Commits the edit in progress as one entry of the history; no entry if nothing moved.
    pub fn commit(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Commit)
    }

    /// Discards the edit in progress. Ends a drag even if the pointer stays pressed.
    pub fn cancel(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Cancel)
    }

    /// Moves both sides of the face towards symmetry; at 100 per cent they are mirror images.
    ///
    /// # Errors
    /// `no-face` or `bad-number`.
    pub fn symmetrise(&mut self, #[wasm_bindgen(js_name = perCent)] per_cent: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Symmetrise(per_cent / 100.0))
    }

    /// Handles a pointer press. Returns whether it grabbed something for `drag` to move; if not, the pointer orbits the
    /// view.
    pub fn press(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
        pointer: PointerName,
    ) -> Result<bool, JsValue> {
        self.act(Intent::Press(DVec2::new(x_px, y_px), pointer.into()))?;
        Ok(self.session.has_grabbed())
    }

    /// Handles a movement of the pressed pointer: the grabbed vertex follows in the view plane or along an axis. `fine`
    /// moves it ten times slower.
    pub fn drag(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
        fine: bool,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Drag(DVec2::new(x_px, y_px), if fine { Pace::Fine } else { Pace::Usual }))
    }

    /// Constrains the drag to one axis; the same axis again removes the constraint.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = dragAlong)]
    pub fn drag_along(&mut self, axis: &str) -> Result<ChangeName, JsValue> {
        self.act(Intent::Along(FacadeError::require(Axis::from_id(axis))?))
    }

    /// Handles a pointer release; commits the drag.
    pub fn release(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Release)
    }

    /// Whether the selection is being dragged.
    #[wasm_bindgen(getter)]
    pub fn dragging(&self) -> bool {
        self.session.is_dragging()
    }
}

/// History and state.
#[wasm_bindgen]
impl Studio {
    /// Undoes the last change of the history: an edit, an entry switched on or off, or a reset. An edit in progress is
    /// committed first and then undone.
    pub fn undo(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Undo)
    }

    /// Redoes the last undone change.
    pub fn redo(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Redo)
    }

    /// Removes all entries, as one change.
    pub fn reset(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Reset)
    }

    /// Switches off each entry that moved the selection, as one change.
    ///
    /// # Errors
    /// `no-face` or `no-selection`.
    #[wasm_bindgen(js_name = resetSelection)]
    pub fn reset_selection(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::ResetSelected)
    }

    /// Switches an entry of the history on or off.
    ///
    /// # Errors
    /// `no-face` or `bad-number`.
    #[wasm_bindgen(js_name = setEntryEnabled)]
    pub fn set_entry_enabled(&mut self, index: u32, enabled: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Switch(index as usize, switch(enabled)))
    }

    /// Returns the state; read it after each change of the document. `free()` it after use.
    pub fn state(&self) -> StudioState {
        StudioState::of(&self.session)
    }

    /// Returns the progress of the edit; read it after each tick. `free()` it after use.
    pub fn tick(&self) -> StudioTick {
        StudioTick::of(self.session.tick())
    }
}
