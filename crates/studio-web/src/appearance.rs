use glam::DVec2;
use rosto_face::LANDMARK_COUNT;
use rosto_session::{Intent, Motion, Turntable};
use rosto_stage::{Background, Dots, Light, NamedView, PictureLight, Srgb, Theme, Visibility};
use rosto_studio::Switch;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::FacadeError;
use crate::modes::ChangeName;
use crate::state::ScreenPoint;

/// Camera, light, appearance and hovering. Positions are in device pixels from the top left of the canvas. NaN is
/// refused with `bad-number` or ignored.
#[wasm_bindgen]
impl Studio {
    /// Orbits the view by a pointer movement.
    pub fn orbit(
        &mut self,
        #[wasm_bindgen(js_name = dxPx)] dx_px: f64,
        #[wasm_bindgen(js_name = dyPx)] dy_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Orbit(DVec2::new(dx_px, dy_px)))
    }

    /// Pans the view by a pointer movement.
    pub fn pan(
        &mut self,
        #[wasm_bindgen(js_name = dxPx)] dx_px: f64,
        #[wasm_bindgen(js_name = dyPx)] dy_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Pan(DVec2::new(dx_px, dy_px)))
    }

    /// Zooms by a factor; above 1 enlarges.
    ///
    /// # Errors
    /// `bad-number`.
    pub fn zoom(&mut self, factor: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Zoom(factor))
    }

    /// Goes to a named view.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn view(&mut self, name: &str) -> Result<ChangeName, JsValue> {
        self.act(Intent::GoTo(FacadeError::require(NamedView::from_id(name))?))
    }

    /// Turns auto-rotation on or off.
    #[wasm_bindgen(js_name = setTurntable)]
    pub fn set_turntable(&mut self, turns: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Turntable(if turns { Turntable::Turns } else { Turntable::Still }))
    }

    /// Sets reduced motion: no gliding camera, no arrival movement, no rotating empty state.
    #[wasm_bindgen(js_name = setReducedMotion)]
    pub fn set_reduced_motion(&mut self, reduced: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Motion(if reduced { Motion::Reduced } else { Motion::Usual }))
    }

    /// Shows or hides the edges.
    #[wasm_bindgen(js_name = setWireframe)]
    pub fn set_wireframe(&mut self, shown: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Wireframe(if shown { Visibility::Shown } else { Visibility::Hidden }))
    }

    /// Shows dots on all landmarks, or only near the pointer.
    #[wasm_bindgen(js_name = setDots)]
    pub fn set_dots(&mut self, shown: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Dots(if shown { Dots::All } else { Dots::NearPointer }))
    }

    /// Sets the directional light, which is fixed to the viewer. Azimuth 0 is the viewer's direction and positive to
    /// the right, elevation is positive upwards, and strength 1 is the default. `ambient` is the strength of the
    /// ambient light; 1 without directional light shows the original colours.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setLight)]
    pub fn set_light(
        &mut self,
        #[wasm_bindgen(js_name = azimuthDeg)] azimuth_deg: f64,
        #[wasm_bindgen(js_name = elevationDeg)] elevation_deg: f64,
        strength: f64,
        ambient: f64,
    ) -> Result<ChangeName, JsValue> {
        let colour = self.session.stage().render_settings().light.colour;
        self.act(Intent::Light(Light { azimuth_deg, elevation_deg, strength, colour, ambient }))
    }

    /// Sets the colour of the directional light, sRGB.
    #[wasm_bindgen(js_name = setLightColour)]
    pub fn set_light_colour(&mut self, red: u8, green: u8, blue: u8) -> Result<ChangeName, JsValue> {
        let light = self.session.stage().render_settings().light;
        self.act(Intent::Light(Light { colour: Srgb([red, green, blue]), ..light }))
    }

    /// Sets the light or dark theme.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = setTheme)]
    pub fn set_theme(&mut self, theme: &str) -> Result<ChangeName, JsValue> {
        self.act(Intent::Theme(FacadeError::require(Theme::from_id(theme))?))
    }

    /// Sets the theme's background, with a shadow below the face (the default).
    #[wasm_bindgen(js_name = setGround)]
    pub fn set_ground(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Background(Background::Ground))
    }

    /// Sets a uniform background colour, sRGB.
    #[wasm_bindgen(js_name = setBackdrop)]
    pub fn set_backdrop(&mut self, red: u8, green: u8, blue: u8) -> Result<ChangeName, JsValue> {
        self.act(Intent::Background(Background::Plain(Srgb([red, green, blue]))))
    }

    /// Blends the edited face (0) with the original (1).
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setBefore)]
    pub fn set_before(&mut self, share: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Before(share))
    }

    /// Shows the original face left of this share of the canvas' width, 0..1, and the edited one right of it; undefined
    /// ends the comparison.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setWipe)]
    pub fn set_wipe(&mut self, share: Option<f64>) -> Result<ChangeName, JsValue> {
        self.act(Intent::Wipe(share))
    }

    /// Sets the widths in px covered by other elements at the edges of the canvas; the face is framed in the rest.
    #[wasm_bindgen(js_name = setViewportInsets)]
    pub fn set_viewport_insets(
        &mut self,
        #[wasm_bindgen(js_name = topPx)] top_px: f64,
        #[wasm_bindgen(js_name = rightPx)] right_px: f64,
        #[wasm_bindgen(js_name = bottomPx)] bottom_px: f64,
        #[wasm_bindgen(js_name = leftPx)] left_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::ViewportInsets([top_px, right_px, bottom_px, left_px]))
    }

    /// Shows or hides markers at the anchors.
    #[wasm_bindgen(js_name = setAnchorsMarked)]
    pub fn set_anchors_marked(&mut self, marked: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::MarkAnchors(if marked { Switch::On } else { Switch::Off }))
    }

    /// Sets whether the light also affects the photo, which contains its own lighting.
    #[wasm_bindgen(js_name = setPhotoLit)]
    pub fn set_photo_lit(&mut self, lit: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::PictureLight(if lit { PictureLight::Lamp } else { PictureLight::Own }))
    }

    /// Handles a pointer movement without a press. Highlights and returns the vertex under the pointer; shows nearby
    /// landmarks as dots if landmarks are selectable.
    pub fn hover(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<Option<u32>, JsValue> {
        self.act(Intent::Hover(Some(DVec2::new(x_px, y_px))))?;
        Ok(self.session.hovered().vertex)
    }

    /// Highlights a landmark that is hovered elsewhere, such as on the photo; undefined when the pointer leaves.
    ///
    /// # Errors
    /// `bad-vertex`.
    #[wasm_bindgen(js_name = pointAt)]
    pub fn point_at(&mut self, landmark: Option<u32>) -> Result<ChangeName, JsValue> {
        self.act(Intent::PointAt(landmark))
    }

    /// Position of a vertex on the canvas; undefined without a face.
    #[wasm_bindgen(js_name = screenPosition)]
    pub fn screen_position(&self, vertex: u32) -> Option<ScreenPoint> {
        let position_m = *self.session.face()?.document().positions().get(vertex as usize)?;
        let position = self.session.stage().camera().project(position_m)?;
        Some(ScreenPoint { x: position.x, y: position.y })
    }

    /// Bounding box of the landmarks on the canvas: left, top, right, bottom; empty without a face.
    #[wasm_bindgen(js_name = screenBox)]
    pub fn screen_box(&self) -> Vec<f64> {
        let Some(face) = self.session.face() else { return Vec::new() };
        let camera = self.session.stage().camera();
        let landmarks = face.document().positions().iter().take(LANDMARK_COUNT);
        let positions = landmarks.filter_map(|&position_m| camera.project(position_m));
        let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (from, to) = positions.fold(empty, |(from, to), position| (from.min(position), to.max(position)));
        vec![from.x, from.y, to.x, to.y]
    }
}
