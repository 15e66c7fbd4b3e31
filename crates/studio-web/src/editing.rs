use glam::{DVec2, DVec3};
use rosto_face::{LANDMARK_COUNT, Triangulation};
use rosto_studio::{Details, Document, Hold, Mirror, Operator, StudioError, Switch};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::choices::{AnchorChoice, Choices};
use crate::drag::{Drag, Pace};
use crate::modes::{AnchorsName, AxisName, DetailsName, HoldName, OperatorName, TriangulationName};
use crate::session::Session;
use crate::state::StudioState;
use crate::studio::MAX_DENSITY;
use crate::trouble::{Outcome, Trouble};

/// Moving what is in hand, how the face follows, and the history.
#[wasm_bindgen]
impl Studio {
    /// The vertices that stay while the landmark in hand moves.
    pub fn anchors(&self) -> Vec<u32> {
        self.session.as_ref().map_or(Vec::new(), |session| session.document.anchors().to_vec())
    }

    /// Holds exactly these vertices, until another landmark is selected.
    ///
    /// # Errors
    /// `no-face`, `bad-vertex`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = setAnchors)]
    pub fn set_anchors(&mut self, anchors: &[u32]) -> Result<(), JsValue> {
        let anchors = AnchorChoice::Explicit(anchors.to_vec());
        self.change(|session, choices| {
            choices.anchors = anchors;
            session.hold(choices)
        })
    }

    /// Which vertices stay beside those pinned by hand.
    ///
    /// # Errors
    /// `bad-choice`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = setAnchorChoice)]
    pub fn set_anchor_choice(&mut self, choice: AnchorsName) -> Result<(), JsValue> {
        self.choices.anchors = match choice {
            AnchorsName::Random => AnchorChoice::Random,
            AnchorsName::Oval => AnchorChoice::Oval,
            AnchorsName::Pinned => AnchorChoice::PinsOnly,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.hold_again()
    }

    /// How the surface's details are described.
    ///
    /// # Errors
    /// `bad-choice` or `cannot-solve`.
    #[wasm_bindgen(js_name = setOperator)]
    pub fn set_operator(&mut self, operator: OperatorName) -> Result<(), JsValue> {
        self.choices.operator = match operator {
            OperatorName::UniformSymmetric => Operator::UniformSymmetric,
            OperatorName::Uniform => Operator::Uniform,
            OperatorName::Degree => Operator::Degree,
            OperatorName::InverseLength => Operator::InverseLength,
            OperatorName::Cotangent => Operator::Cotangent,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.hold_again()
    }

    /// How firmly landmarks and anchors are held.
    ///
    /// # Errors
    /// `bad-choice` or `cannot-solve`.
    #[wasm_bindgen(js_name = setHold)]
    pub fn set_hold(&mut self, hold: HoldName) -> Result<(), JsValue> {
        self.choices.hold = match hold {
            HoldName::Soft => Hold::default(),
            HoldName::Exact => Hold::Exact,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.hold_again()
    }

    /// Whether details turn with the surface.
    ///
    /// # Errors
    /// `bad-choice` or `cannot-solve`.
    #[wasm_bindgen(js_name = setDetails)]
    pub fn set_details(&mut self, details: DetailsName) -> Result<(), JsValue> {
        self.choices.details = match details {
            DetailsName::Kept => Details::Kept,
            DetailsName::Turned => Details::Turned,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.hold_again()
    }

    /// How far along the surface an edit reaches; undefined is everywhere. A drag goes on.
    ///
    /// # Errors
    /// `bad-number` or `cannot-solve`.
    #[wasm_bindgen(js_name = setRadius)]
    pub fn set_radius(&mut self, #[wasm_bindgen(js_name = radiusMm)] radius_mm: Option<f64>) -> Result<(), JsValue> {
        if radius_mm.is_some_and(|radius_mm| !(radius_mm.is_finite() && radius_mm > 0.0)) {
            return Err(Trouble::bad_number("the radius").into());
        }
        self.choices.radius_mm = radius_mm;
        self.hold_again()
    }

    /// Whether the other side of the face follows.
    ///
    /// # Errors
    /// `cannot-solve`.
    #[wasm_bindgen(js_name = setMirror)]
    pub fn set_mirror(&mut self, mirrored: bool) -> Result<(), JsValue> {
        self.choices.mirror = if mirrored { Mirror::On } else { Mirror::Off };
        self.hold_again()
    }

    /// One tick of a slider: moves the landmark in hand by an offset from where it was at the last commit. No solve.
    ///
    /// # Errors
    /// `no-face`, `no-selection` or `bad-number`.
    pub fn preview(
        &mut self,
        #[wasm_bindgen(js_name = dxMm)] dx_mm: f64,
        #[wasm_bindgen(js_name = dyMm)] dy_mm: f64,
        #[wasm_bindgen(js_name = dzMm)] dz_mm: f64,
    ) -> Result<(), JsValue> {
        if self.session()?.slider().is_some() {
            self.commit()?;
        }
        self.session_mut()?.0.preview(DVec3::new(dx_mm, dy_mm, dz_mm))?;
        Ok(self.show_offset()?)
    }

    /// Starts to drag a vertex with all that is in hand together with it; if it is not in hand, it or its region is
    /// taken, unless it is a point that lies within the ring of the one in hand. An edit in progress is kept.
    ///
    /// # Errors
    /// `no-face`, `bad-vertex`, `bad-anchors` or `cannot-solve`.
    pub fn grab(
        &mut self,
        vertex: u32,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<(), JsValue> {
        self.commit()?;
        let vertex = self.point_beside(vertex, DVec2::new(x_px, y_px)).unwrap_or(vertex);
        if !self.holds(vertex) {
            self.take_at(vertex)?;
        }
        let start_m = self.session()?.document.committed()[vertex as usize];
        self.drag = Some(Drag::new(start_m, DVec2::new(x_px, y_px)));
        let stage = self.viewport.stage_mut();
        stage.set_pointer(None);
        stage.set_hovered(None);
        Ok(())
    }

    /// Drags what was grabbed to the pointer: in the view plane or along an axis; fine is ten times slower.
    ///
    /// # Errors
    /// `no-face` or `no-selection`.
    #[wasm_bindgen(js_name = dragTo)]
    pub fn drag_to(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
        axis: Option<AxisName>,
        fine: Option<bool>,
    ) -> Result<(), JsValue> {
        let axis = axis.map(AxisName::axis).transpose()?;
        let pace = if fine.unwrap_or(false) { Pace::Fine } else { Pace::Usual };
        let camera = self.viewport.stage().camera();
        let drag = self.drag.as_mut().ok_or_else(Trouble::no_selection)?;
        let offset_m = drag.offset_m(camera, DVec2::new(x_px, y_px), axis, pace);
        self.viewport.stage_mut().set_gizmo_axis(axis);
        self.session_mut()?.0.preview(offset_m * 1000.0)?;
        Ok(self.show_offset()?)
    }

    /// Keeps the edit in progress as one entry of the history; nothing moved is no entry.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn commit(&mut self) -> Result<(), JsValue> {
        self.drag = None;
        self.change_if_open(Session::commit)
    }

    /// Drops the edit in progress.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn cancel(&mut self) -> Result<(), JsValue> {
        self.drag = None;
        self.change_if_open(Session::cancel)
    }

    /// Takes the last change of the history back: an edit, an entry switched off or on, or a reset.
    ///
    /// # Errors
    /// `cannot-solve`.
    pub fn undo(&mut self) -> Result<(), JsValue> {
        self.change_if_open(|session, choices| session.change_history(choices, Document::undo))
    }

    /// Brings the last undone change back.
    ///
    /// # Errors
    /// `cannot-solve`.
    pub fn redo(&mut self) -> Result<(), JsValue> {
        self.change_if_open(|session, choices| session.change_history(choices, Document::redo))
    }

    /// Takes all entries away, as one change.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn reset(&mut self) -> Result<(), JsValue> {
        self.change_if_open(|session, choices| {
            session.change_history(choices, |document| {
                document.reset();
                Ok::<(), StudioError>(())
            })
        })
    }

    /// Switches every entry off that moved what is selected, as one change.
    ///
    /// # Errors
    /// `no-selection` or `cannot-solve`.
    #[wasm_bindgen(js_name = resetSelection)]
    pub fn reset_selection(&mut self) -> Result<(), JsValue> {
        self.change(|session, choices| {
            let subject = session.selection().ok_or_else(Trouble::no_selection)?.subject();
            session.change_history(choices, |document| document.switch_off(subject))
        })
    }

    /// Lets an entry of the history take part in the shape, or not.
    ///
    /// # Errors
    /// `no-face`, `bad-number` or `cannot-solve`.
    #[wasm_bindgen(js_name = setEntryEnabled)]
    pub fn set_entry_enabled(&mut self, index: u32, enabled: bool) -> Result<(), JsValue> {
        let switch = if enabled { Switch::On } else { Switch::Off };
        self.change(|session, choices| {
            session.change_history(choices, |document| document.switch(index as usize, switch))
        })
    }

    /// How the landmarks are joined; the edits are carried out again. Points that were pinned are free again.
    ///
    /// # Errors
    /// `bad-choice` or `cannot-solve`.
    #[wasm_bindgen(js_name = setTriangulation)]
    pub fn set_triangulation(&mut self, triangulation: TriangulationName) -> Result<(), JsValue> {
        let triangulation = match triangulation {
            TriangulationName::Tessellation => Triangulation::Tessellation,
            TriangulationName::Canonical => Triangulation::Canonical,
            _ => return Err(Trouble::bad_choice().into()),
        };
        if let Ok((session, choices)) = self.session_mut() {
            choices.pins.retain(|pin| (*pin as usize) < LANDMARK_COUNT);
            session.set_triangulation(triangulation, choices)?;
            self.show_mesh()?;
        }
        self.wishes.triangulation = triangulation;
        Ok(())
    }

    /// How often the mesh that is shown and exported is subdivided: 0 is the 468 landmarks, 3 the densest.
    ///
    /// # Errors
    /// `bad-choice` or `cannot-solve`.
    #[wasm_bindgen(js_name = setDensity)]
    pub fn set_density(&mut self, levels: u32) -> Result<(), JsValue> {
        if levels > MAX_DENSITY {
            return Err(Trouble::bad_choice().into());
        }
        let hand = self.hand;
        if let Ok((session, choices)) = self.session_mut() {
            session.set_density(levels, hand, choices)?;
            session.prepare(hand, choices)?;
            self.show_mesh()?;
        }
        self.wishes.density = levels;
        Ok(())
    }

    /// How things stand.
    pub fn state(&self) -> StudioState {
        self.session.as_ref().map(Session::state).unwrap_or_default()
    }
}

impl Studio {
    /// Changes the open face and shows it as it then is, whether the change succeeded or not.
    pub(crate) fn change(
        &mut self,
        change: impl FnOnce(&mut Session, &mut Choices) -> Outcome<()>,
    ) -> Result<(), JsValue> {
        let (session, choices) = self.session_mut()?;
        let outcome = change(session, choices);
        self.show_shape()?;
        Ok(outcome?)
    }

    fn change_if_open(&mut self, change: impl FnOnce(&mut Session, &Choices) -> Outcome<()>) -> Result<(), JsValue> {
        if self.session.is_none() { Ok(()) } else { self.change(|session, choices| change(session, choices)) }
    }

    /// Holds what is selected under the choices as they now are. An edit in progress goes on.
    pub(crate) fn hold_again(&mut self) -> Result<(), JsValue> {
        self.change_if_open(Session::hold_on)
    }
}
