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

/// How the face follows.
#[wasm_bindgen]
impl Studio {
    /// The ids of what there is to choose from, in the order that a panel shows them in. What can be chosen is
    /// "selection", "preset", "operator", "constraint", "details", "anchors", "shading", "lens", "triangulation" and
    /// "density".
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn choices(&self, choice: &str) -> Result<Vec<String>, JsValue> {
        Ok(FacadeError::unless(Choice::from_id(choice))?.values())
    }

    /// Chooses one of those by its id.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn choose(&mut self, choice: &str, id: &str) -> Result<ChangeName, JsValue> {
        let choice = FacadeError::unless(Choice::from_id(choice))?;
        self.act(FacadeError::unless(choice.intent(id))?)
    }

    /// Whether the other side of the face follows.
    #[wasm_bindgen(js_name = setMirror)]
    pub fn set_mirror(&mut self, mirrored: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Mirror(if mirrored { Mirror::On } else { Mirror::Off }))
    }

    /// Whether an edit reaches no further than the radius.
    #[wasm_bindgen(js_name = setNearby)]
    pub fn set_nearby(&mut self, nearby: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Nearby(switch(nearby)))
    }

    /// How far along the surface an edit reaches. A drag goes on.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setRadius)]
    pub fn set_radius(&mut self, #[wasm_bindgen(js_name = radiusMm)] radius_mm: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Radius(radius_mm))
    }

    /// Makes that so many times as far, within its limits.
    ///
    /// # Errors
    /// `bad-number`.
    pub fn widen(&mut self, factor: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Widen(factor))
    }
}

/// Moving what is selected, and the whole face.
#[wasm_bindgen]
impl Studio {
    /// One tick of the sliders: moves what is selected by an offset from where it was at the last commit. No solve.
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

    /// One tick of a ready-made slider: `toMm` is where it is to stand, its earlier entries counted. The first tick takes
    /// it in hand (one solve); `commit` and `cancel` end it, after which what is selected is held again.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `bad-number`.
    pub fn slide(&mut self, slider: &str, #[wasm_bindgen(js_name = toMm)] to_mm: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Slide(FacadeError::unless(FaceSlider::from_id(slider))?, to_mm))
    }

    /// One tick of an expression: `to` is how much of it the face is to show, 0..1, its earlier entries counted; with the mirror,
    /// its partner of the other side shows as much. `commit` and `cancel` end it.
    ///
    /// # Errors
    /// `no-face`, `bad-choice` or `bad-number`.
    pub fn express(&mut self, expression: &str, to: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Express(FacadeError::unless(Expression::from_id(expression))?, to))
    }

    /// Switches every expression off, as one change.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = resetExpressions)]
    pub fn reset_expressions(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::ResetExpressions)
    }

    /// Keeps the edit in progress as one entry of the history; nothing moved is no entry.
    pub fn commit(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Commit)
    }

    /// Drops the edit in progress. A drag is over, even if the pointer stays pressed.
    pub fn cancel(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Cancel)
    }

    /// Brings the two sides of the face closer to each other: 100 per cent leaves mirror images.
    ///
    /// # Errors
    /// `no-face` or `bad-number`.
    pub fn symmetrise(&mut self, #[wasm_bindgen(js_name = perCent)] per_cent: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Symmetrise(per_cent / 100.0))
    }

    /// The pointer is pressed. True if it has grabbed something, which `drag` moves; if not, it turns the face.
    pub fn press(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
        pointer: PointerName,
    ) -> Result<bool, JsValue> {
        self.act(Intent::Press(DVec2::new(x_px, y_px), pointer.into()))?;
        Ok(self.session.has_grabbed())
    }

    /// The pressed pointer goes on, and what it has grabbed follows: in the view plane or along an axis; fine is ten
    /// times slower.
    pub fn drag(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
        fine: bool,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Drag(DVec2::new(x_px, y_px), if fine { Pace::Fine } else { Pace::Usual }))
    }

    /// What is dragged follows along one axis only; the same axis again frees it.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = dragAlong)]
    pub fn drag_along(&mut self, axis: &str) -> Result<ChangeName, JsValue> {
        self.act(Intent::Along(FacadeError::unless(Axis::from_id(axis))?))
    }

    /// The pointer is let go: what was dragged is kept.
    pub fn release(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Release)
    }

    /// Whether something is being dragged.
    #[wasm_bindgen(getter)]
    pub fn dragging(&self) -> bool {
        self.session.is_dragging()
    }
}

/// The history, and how things stand.
#[wasm_bindgen]
impl Studio {
    /// Takes the last change of the history back: an edit, an entry switched off or on, or a reset. An edit in progress is
    /// kept first, and is what is taken back.
    pub fn undo(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Undo)
    }

    /// Brings the last undone change back.
    pub fn redo(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Redo)
    }

    /// Takes all entries away, as one change.
    pub fn reset(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Reset)
    }

    /// Switches every entry off that moved what is selected, as one change.
    ///
    /// # Errors
    /// `no-face` or `no-selection`.
    #[wasm_bindgen(js_name = resetSelection)]
    pub fn reset_selection(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::ResetSelected)
    }

    /// Lets an entry of the history take part in the shape, or not.
    ///
    /// # Errors
    /// `no-face` or `bad-number`.
    #[wasm_bindgen(js_name = setEntryEnabled)]
    pub fn set_entry_enabled(&mut self, index: u32, enabled: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Switch(index as usize, switch(enabled)))
    }

    /// How things stand; to be read after each change of the document. `free()` it.
    pub fn state(&self) -> StudioState {
        StudioState::of(&self.session)
    }

    /// How far the edit in progress has gone; to be read after each tick. `free()` it.
    pub fn tick(&self) -> StudioTick {
        StudioTick::of(self.session.tick())
    }
}
