use glam::DVec2;
use rosto_face::LANDMARK_COUNT;
use rosto_mesh::vertex_normals;
use rosto_viewport::{Background, Dots, Glide, NamedView, Paint, Pointer, Srgb, Theme, Wireframe};
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::modes::{AxisName, PaintName, PointerName, ThemeName, ViewName};
use crate::state::ScreenPoint;
use crate::studio::Motion;
use crate::trouble::Trouble;

/// Camera, light, paint and what is under the pointer. Places are device pixels from the canvas' top left.
#[wasm_bindgen]
impl Studio {
    /// Turns the face as if the pointer held it.
    pub fn orbit(&mut self, #[wasm_bindgen(js_name = dxPx)] dx_px: f64, #[wasm_bindgen(js_name = dyPx)] dy_px: f64) {
        if (dx_px + dy_px).is_finite() {
            self.viewport.stage_mut().camera_mut().orbit(dx_px, dy_px);
        }
    }

    /// Moves the face with the pointer.
    pub fn pan(&mut self, #[wasm_bindgen(js_name = dxPx)] dx_px: f64, #[wasm_bindgen(js_name = dyPx)] dy_px: f64) {
        if (dx_px + dy_px).is_finite() {
            self.viewport.stage_mut().camera_mut().pan(dx_px, dy_px);
        }
    }

    /// Comes closer by a factor above 1, goes away by one below.
    pub fn zoom(&mut self, factor: f64) {
        self.viewport.stage_mut().camera_mut().zoom(factor);
    }

    /// Goes to a named view.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn view(&mut self, name: ViewName) -> Result<(), JsValue> {
        let view = match name {
            ViewName::Front => NamedView::Front,
            ViewName::Left => NamedView::Left,
            ViewName::Top => NamedView::Top,
            ViewName::Reset => NamedView::Reset,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.viewport.stage_mut().camera_mut().look(view);
        Ok(())
    }

    /// Turns the face by itself, in degrees a second; 0 stops.
    #[wasm_bindgen(js_name = setTurntable)]
    pub fn set_turntable(&mut self, #[wasm_bindgen(js_name = degreesPerSecond)] degrees_per_second: f64) {
        self.wishes.turntable_deg_per_s = if degrees_per_second.is_finite() { degrees_per_second } else { 0.0 };
        self.show_wishes();
    }

    /// Whether the page was asked to move less: no glide, no arrival, no turning empty state.
    #[wasm_bindgen(js_name = setReducedMotion)]
    pub fn set_reduced_motion(&mut self, reduced: bool) {
        self.wishes.motion = if reduced { Motion::Reduced } else { Motion::Usual };
        self.viewport.stage_mut().camera_mut().set_glide(if reduced { Glide::Off } else { Glide::Smooth });
        self.show_wishes();
    }

    /// How the surface is coloured.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = setPaint)]
    pub fn set_paint(&mut self, paint: PaintName) -> Result<(), JsValue> {
        self.wishes.paint = match paint {
            PaintName::Photo => Paint::Photo,
            PaintName::Colours => Paint::Colours,
            PaintName::Clay => Paint::Clay,
            PaintName::Normals => Paint::Normals,
            PaintName::Response => Paint::Response,
            PaintName::Distortion => Paint::Scalar,
            _ => return Err(Trouble::bad_choice().into()),
        };
        self.show_wishes();
        Ok(self.show_offset()?)
    }

    /// Draws the edges over the surface.
    #[wasm_bindgen(js_name = setWireframe)]
    pub fn set_wireframe(&mut self, shown: bool) {
        self.wishes.wireframe = if shown { Wireframe::Shown } else { Wireframe::Hidden };
        self.show_wishes();
    }

    /// The directional light, fixed to the viewer: azimuth 0 is from the viewer and positive from the right, elevation
    /// is positive from above, strength 1 is the usual one.
    #[wasm_bindgen(js_name = setLight)]
    pub fn set_light(
        &mut self,
        #[wasm_bindgen(js_name = azimuthDeg)] azimuth_deg: f64,
        #[wasm_bindgen(js_name = elevationDeg)] elevation_deg: f64,
        strength: f64,
    ) {
        if (azimuth_deg + elevation_deg + strength).is_finite() {
            let light = &mut self.viewport.stage_mut().look_mut().light;
            (light.azimuth_deg, light.elevation_deg, light.strength) = (azimuth_deg, elevation_deg, strength.max(0.0));
        }
    }

    /// Colour of the directional light, sRGB.
    #[wasm_bindgen(js_name = setLightColour)]
    pub fn set_light_colour(&mut self, red: u8, green: u8, blue: u8) {
        self.viewport.stage_mut().look_mut().light.colour = Srgb([red, green, blue]);
    }

    /// Strength of the light from everywhere; 1 alone shows every colour as it is.
    #[wasm_bindgen(js_name = setAmbient)]
    pub fn set_ambient(&mut self, strength: f64) {
        if strength.is_finite() {
            self.viewport.stage_mut().look_mut().light.ambient = strength.max(0.0);
        }
    }

    /// Light or dark surroundings.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = setTheme)]
    pub fn set_theme(&mut self, theme: ThemeName) -> Result<(), JsValue> {
        self.viewport.stage_mut().look_mut().theme = match theme {
            ThemeName::Light => Theme::Light,
            ThemeName::Dark => Theme::Dark,
            _ => return Err(Trouble::bad_choice().into()),
        };
        Ok(())
    }

    /// Puts the theme's soft ground behind the face, with a shadow under it: the usual one.
    #[wasm_bindgen(js_name = setGround)]
    pub fn set_ground(&mut self) {
        self.wishes.background = Background::Ground;
        self.show_wishes();
    }

    /// Puts one colour behind the face, sRGB.
    #[wasm_bindgen(js_name = setBackdrop)]
    pub fn set_backdrop(&mut self, red: u8, green: u8, blue: u8) {
        self.wishes.background = Background::Plain(Srgb([red, green, blue]));
        self.show_wishes();
    }

    /// 0 shows the face as edited, 1 as it was found.
    #[wasm_bindgen(js_name = setBefore)]
    pub fn set_before(&mut self, share: f64) {
        if share.is_finite() {
            self.viewport.stage_mut().look_mut().before = share.clamp(0.0, 1.0);
        }
    }

    /// The landmark nearest to where the pointer meets the face or, where any point can be taken in hand, the vertex.
    pub fn pick(
        &self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Option<u32> {
        self.vertex_at(DVec2::new(x_px, y_px))
    }

    /// Tells where the pointer is: landmarks near it show as dots where they are what it takes, and what is under it is
    /// marked and returned.
    pub fn hover(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Option<u32> {
        let place_px = DVec2::new(x_px, y_px);
        let vertex = self.vertex_at(place_px);
        let takes_landmarks = self.takes_landmarks();
        let axis = self.axis_at(place_px, Pointer::Fine);
        self.point_at(vertex);
        let stage = self.viewport.stage_mut();
        stage.set_pointer(vertex.filter(|_| takes_landmarks).map(|_| place_px));
        stage.set_hovered(vertex);
        stage.set_gizmo_axis(axis);
        vertex
    }

    /// Marks a landmark that is pointed at elsewhere, such as on the photo; none when the pointer leaves.
    ///
    /// # Errors
    /// `bad-vertex`.
    #[wasm_bindgen(js_name = hoverVertex)]
    pub fn hover_vertex(&mut self, vertex: Option<u32>) -> Result<(), JsValue> {
        if let Some(vertex) = vertex.filter(|&vertex| vertex as usize >= LANDMARK_COUNT) {
            return Err(Trouble::bad_vertex(vertex, LANDMARK_COUNT).into());
        }
        let has_face = self.session.is_some();
        self.point_at(vertex);
        let stage = self.viewport.stage_mut();
        stage.set_pointer(None);
        stage.set_hovered(vertex.filter(|_| has_face));
        stage.set_gizmo_axis(None);
        Ok(())
    }

    /// Shows a dot on every landmark, not only near the pointer.
    #[wasm_bindgen(js_name = setDots)]
    pub fn set_dots(&mut self, shown: bool) {
        self.viewport.stage_mut().look_mut().dots = if shown { Dots::All } else { Dots::NearPointer };
    }

    /// The axis of the gizmo that the pointer is on.
    #[wasm_bindgen(js_name = pickAxis)]
    pub fn pick_axis(
        &self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
        pointer: PointerName,
    ) -> Option<AxisName> {
        self.axis_at(DVec2::new(x_px, y_px), pointer.into()).map(AxisName::from)
    }

    /// Where a vertex appears, if a face is open.
    #[wasm_bindgen(js_name = screenPosition)]
    pub fn screen_position(&self, vertex: u32) -> Option<ScreenPoint> {
        let position_m = *self.session.as_ref()?.document.positions().get(vertex as usize)?;
        let place = self.viewport.stage().camera().project(position_m)?;
        Some(ScreenPoint { x: place.x, y: place.y })
    }

    /// For each landmark x, y, and 1 if the face's surface there faces the viewer, else 0. Empty without a face.
    #[wasm_bindgen(js_name = screenPositions)]
    pub fn screen_positions(&self) -> Vec<f32> {
        let Some(session) = &self.session else { return Vec::new() };
        let camera = self.viewport.stage().camera();
        let positions_m = session.document.positions();
        let normals = vertex_normals(session.document.topology(), positions_m);
        let landmarks = positions_m.iter().zip(&normals).take(LANDMARK_COUNT);
        landmarks
            .flat_map(|(position_m, normal)| {
                let place = camera.project(*position_m).unwrap_or(DVec2::NAN);
                let facing = normal.dot(camera.eye_m() - *position_m) > 0.0;
                [place.x as f32, place.y as f32, f32::from(u8::from(facing))]
            })
            .collect()
    }
}

impl Studio {
    fn axis_at(&self, place_px: DVec2, pointer: Pointer) -> Option<rosto_viewport::Axis> {
        self.viewport.pick_axis(place_px, self.session.as_ref()?.document.positions(), pointer)
    }
}
