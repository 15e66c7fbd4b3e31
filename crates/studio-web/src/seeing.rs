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

/// Camera, light, paint and what is under the pointer. Places are device pixels from the canvas' top left. What is not a
/// number is `bad-number`, or passed over.
#[wasm_bindgen]
impl Studio {
    /// Turns the face as if the pointer held it.
    pub fn orbit(
        &mut self,
        #[wasm_bindgen(js_name = dxPx)] dx_px: f64,
        #[wasm_bindgen(js_name = dyPx)] dy_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Orbit(DVec2::new(dx_px, dy_px)))
    }

    /// Moves the face with the pointer.
    pub fn pan(
        &mut self,
        #[wasm_bindgen(js_name = dxPx)] dx_px: f64,
        #[wasm_bindgen(js_name = dyPx)] dy_px: f64,
    ) -> Result<ChangeName, JsValue> {
        self.act(Intent::Pan(DVec2::new(dx_px, dy_px)))
    }

    /// Shows the face larger by a factor above 1, smaller by one below.
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
        self.act(Intent::GoTo(FacadeError::unless(NamedView::from_id(name))?))
    }

    /// Lets the face turn by itself, or stand still.
    #[wasm_bindgen(js_name = setTurntable)]
    pub fn set_turntable(&mut self, turns: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Turntable(if turns { Turntable::Turns } else { Turntable::Still }))
    }

    /// Whether the page was asked to move less: no glide, no arrival, no turning empty state.
    #[wasm_bindgen(js_name = setReducedMotion)]
    pub fn set_reduced_motion(&mut self, reduced: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Motion(if reduced { Motion::Reduced } else { Motion::Usual }))
    }

    /// Draws the edges over the surface.
    #[wasm_bindgen(js_name = setWireframe)]
    pub fn set_wireframe(&mut self, shown: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Wireframe(if shown { Visibility::Shown } else { Visibility::Hidden }))
    }

    /// Shows a dot on every landmark, not only near the pointer.
    #[wasm_bindgen(js_name = setDots)]
    pub fn set_dots(&mut self, shown: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::Dots(if shown { Dots::All } else { Dots::NearPointer }))
    }

    /// The directional light, fixed to the viewer: azimuth 0 is from the viewer and positive from the right, elevation
    /// is positive from above, strength 1 is the usual one. `ambient` is the light from everywhere; 1 alone shows every
    /// colour as it is.
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

    /// Colour of the directional light, sRGB.
    #[wasm_bindgen(js_name = setLightColour)]
    pub fn set_light_colour(&mut self, red: u8, green: u8, blue: u8) -> Result<ChangeName, JsValue> {
        let light = self.session.stage().render_settings().light;
        self.act(Intent::Light(Light { colour: Srgb([red, green, blue]), ..light }))
    }

    /// Light or dark surroundings.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = setTheme)]
    pub fn set_theme(&mut self, theme: &str) -> Result<ChangeName, JsValue> {
        self.act(Intent::Theme(FacadeError::unless(Theme::from_id(theme))?))
    }

    /// Puts the theme's soft ground behind the face, with a shadow under it: the usual one.
    #[wasm_bindgen(js_name = setGround)]
    pub fn set_ground(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::Background(Background::Ground))
    }

    /// Puts one colour behind the face, sRGB.
    #[wasm_bindgen(js_name = setBackdrop)]
    pub fn set_backdrop(&mut self, red: u8, green: u8, blue: u8) -> Result<ChangeName, JsValue> {
        self.act(Intent::Background(Background::Plain(Srgb([red, green, blue]))))
    }

    /// 0 shows the face as edited, 1 as it was found.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setBefore)]
    pub fn set_before(&mut self, share: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::Before(share))
    }

    /// The face as it was found up to this share of the canvas' width, 0 to 1 from the left, and as edited beyond; undefined
    /// ends it.
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

    /// Marks what stays in place while what is selected moves, or not.
    #[wasm_bindgen(js_name = setAnchorsMarked)]
    pub fn set_anchors_marked(&mut self, marked: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::MarkAnchors(if marked { Switch::On } else { Switch::Off }))
    }

    /// Lets the light fall on the photo, too, or leaves it in the light that it was taken in.
    #[wasm_bindgen(js_name = setPhotoLit)]
    pub fn set_photo_lit(&mut self, lit: bool) -> Result<ChangeName, JsValue> {
        self.act(Intent::PictureLight(if lit { PictureLight::Lamp } else { PictureLight::Own }))
    }

    /// Tells where the pointer is: landmarks near it show as dots where they are what it selects, and what is under it is
    /// marked and returned.
    pub fn hover(
        &mut self,
        #[wasm_bindgen(js_name = xPx)] x_px: f64,
        #[wasm_bindgen(js_name = yPx)] y_px: f64,
    ) -> Result<Option<u32>, JsValue> {
        self.act(Intent::Hover(Some(DVec2::new(x_px, y_px))))?;
        Ok(self.session.hovered().vertex)
    }

    /// Marks a landmark that is pointed at elsewhere, such as on the photo; none when the pointer leaves.
    ///
    /// # Errors
    /// `bad-vertex`.
    #[wasm_bindgen(js_name = pointAt)]
    pub fn point_at(&mut self, landmark: Option<u32>) -> Result<ChangeName, JsValue> {
        self.act(Intent::PointAt(landmark))
    }

    /// Where a vertex appears, if a face is open.
    #[wasm_bindgen(js_name = screenPosition)]
    pub fn screen_position(&self, vertex: u32) -> Option<ScreenPoint> {
        let position_m = *self.session.face()?.document().positions().get(vertex as usize)?;
        let place = self.session.stage().camera().project(position_m)?;
        Some(ScreenPoint { x: place.x, y: place.y })
    }

    /// The box around the landmarks as they appear: left, top, right and bottom; empty without a face.
    #[wasm_bindgen(js_name = screenBox)]
    pub fn screen_box(&self) -> Vec<f64> {
        let Some(face) = self.session.face() else { return Vec::new() };
        let camera = self.session.stage().camera();
        let landmarks = face.document().positions().iter().take(LANDMARK_COUNT);
        let places = landmarks.filter_map(|&position_m| camera.project(position_m));
        let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (from, to) = places.fold(empty, |(from, to), place| (from.min(place), to.max(place)));
        vec![from.x, from.y, to.x, to.y]
    }
}
