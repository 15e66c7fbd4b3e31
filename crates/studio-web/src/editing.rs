use glam::{DVec2, DVec3};
use rosto_face::{LANDMARK_COUNT, Triangulation};
use rosto_studio::{Hold, Mirror, Operator, Switch};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::choices::AnchorChoice;
use crate::drag::{Drag, Pace};
use crate::modes::{AnchorsName, AxisName, HoldName, OperatorName, TriangulationName};
use crate::session::Session;
use crate::state::StudioState;
use crate::studio::MAX_DENSITY;
use crate::trouble::{Outcome, Trouble};

/// Seeds for random anchors stay exact as JavaScript's and JSON's numbers.
const SEEDS: f64 = 9_007_199_254_740_992.0;

/// Choosing and moving landmarks.
#[wasm_bindgen]
impl Studio {
    /// Takes a landmark in hand, or lets go of it. Random anchors are drawn anew.
    ///
    /// # Errors
    /// `no-face`, `bad-vertex`, `bad-anchors` or `cannot-solve`.
    pub fn select(&mut self, vertex: Option<u32>) -> Result<(), JsValue> {
        self.drag = None;
        let seed = (js_sys::Math::random() * SEEDS) as u64;
        self.change(|session, choices| session.select(vertex, choices, seed))
    }

    /// The landmark in hand.
    #[wasm_bindgen(getter)]
    pub fn selected(&self) -> Option<u32> {
        self.session.as_ref()?.selected()
    }

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

    /// The vertices pinned by hand.
    pub fn pins(&self) -> Vec<u32> {
        self.choices.pins.clone()
    }

    /// Pins a landmark, so that it stays while others move, or unpins it.
    ///
    /// # Errors
    /// `bad-vertex`, `bad-anchors` or `cannot-solve`.
    #[wasm_bindgen(js_name = setPinned)]
    pub fn set_pinned(&mut self, vertex: u32, pinned: bool) -> Result<(), JsValue> {
        if vertex as usize >= LANDMARK_COUNT {
            return Err(Trouble::bad_vertex(vertex, LANDMARK_COUNT).into());
        }
        self.choices.pins.retain(|&pin| pin != vertex);
        if pinned {
            self.choices.pins.push(vertex);
        }
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
        self.session_mut()?.0.preview(DVec3::new(dx_mm, dy_mm, dz_mm))?;
        Ok(self.show_offset()?)
    }

    /// Starts to drag the landmark in hand.
    ///
    /// # Errors
    /// `no-face` or `no-selection`.
    pub fn grab(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<(), JsValue> {
        let session = self.session()?;
        let vertex = session.selected().ok_or_else(Trouble::no_selection)?;
        let start_m = session.document.committed()[vertex as usize];
        self.drag = Some(Drag::new(start_m, DVec2::new(x_px, y_px)));
        let stage = self.viewport.stage_mut();
        stage.set_pointer(None);
        stage.set_hovered(None);
        Ok(())
    }

    /// Drags the grabbed landmark to the pointer: in the view plane or along an axis; fine is ten times slower.
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
        self.change_if_open(|session| {
            session.commit();
            Ok(())
        })
    }

    /// Drops the edit in progress.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn cancel(&mut self) -> Result<(), JsValue> {
        self.drag = None;
        self.change_if_open(|session| {
            session.cancel();
            Ok(())
        })
    }

    /// Takes the last entry back.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn undo(&mut self) -> Result<(), JsValue> {
        self.change_if_open(|session| {
            session.undo();
            Ok(())
        })
    }

    /// Brings the last undone entry back.
    ///
    /// # Errors
    /// `cannot-solve`.
    pub fn redo(&mut self) -> Result<(), JsValue> {
        self.change_if_open(Session::redo)
    }

    /// Takes all entries back; redo brings them again.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn reset(&mut self) -> Result<(), JsValue> {
        self.change_if_open(|session| {
            session.reset();
            Ok(())
        })
    }

    /// Lets an entry of the history take part in the shape, or not.
    ///
    /// # Errors
    /// `no-face` or `bad-number`.
    #[wasm_bindgen(js_name = setEntryEnabled)]
    pub fn set_entry_enabled(&mut self, index: u32, enabled: bool) -> Result<(), JsValue> {
        let switch = if enabled { Switch::On } else { Switch::Off };
        self.change(|session, _| session.switch(index, switch))
    }

    /// How the landmarks are joined; the edits are carried out again.
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
        if let Ok((session, choices)) = self.session_mut() {
            session.set_density(levels, choices)?;
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
    fn change(
        &mut self,
        change: impl FnOnce(&mut Session, &mut crate::choices::Choices) -> Outcome<()>,
    ) -> Result<(), JsValue> {
        let (session, choices) = self.session_mut()?;
        let outcome = change(session, choices);
        self.show_shape()?;
        Ok(outcome?)
    }

    fn change_if_open(&mut self, change: impl FnOnce(&mut Session) -> Outcome<()>) -> Result<(), JsValue> {
        if self.session.is_none() { Ok(()) } else { self.change(|session, _| change(session)) }
    }

    /// Holds what is selected under the choices as they now are. An edit in progress goes on.
    fn hold_again(&mut self) -> Result<(), JsValue> {
        if self.session.is_none() {
            return Ok(());
        }
        self.change(|session, choices| {
            let moving_mm = session.is_moving().then(|| session.offset_m() * 1000.0);
            session.hold(choices)?;
            moving_mm.map_or(Ok(()), |offset_mm| session.preview(offset_mm))
        })
    }
}
