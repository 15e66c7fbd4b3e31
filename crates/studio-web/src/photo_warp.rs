use glam::DVec2;
use rosto_session::{Changed, OpenFace};
use rosto_viewport::PhotoLayerInput;
use rosto_warp::WarpMesh;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::Result;
use crate::picture::OpenPicture;

/// The face in its photo.
#[wasm_bindgen]
impl Studio {
    /// Centres and radii of the protected dabs, in device pixels of the canvas, as x, y, radius triples.
    #[wasm_bindgen(js_name = protectedOnCanvas)]
    pub fn protected_on_canvas(&self) -> Vec<f32> {
        self.session.protected_on_canvas().into_iter().flatten().map(|px| px as f32).collect()
    }

    /// Whether `followPhoto` must be called. On the stage the photo follows automatically, except for updates that need
    /// a factorisation, which run in a separate task.
    #[wasm_bindgen(getter, js_name = photoIsDue)]
    pub fn photo_is_due(&self) -> bool {
        self.photo_shown.is_due || self.needs_factorisation()
    }

    /// Updates the photo to the current edits and shows it.
    ///
    /// # Errors
    /// `device-lost`.
    #[wasm_bindgen(js_name = followPhoto)]
    pub fn follow_photo(&mut self) -> Result<(), JsValue> {
        self.update_photo()?;
        self.session.stage_mut().request_frame();
        Ok(())
    }

    /// Greatest distance, in px of the photo, by which the photo lags behind the edits to avoid folds.
    #[wasm_bindgen(getter, js_name = photoLimitedPx)]
    pub fn photo_limited_px(&self) -> f64 {
        self.session.face().map_or(0.0, |face| face.photo().limited_px())
    }

    /// Positions of the landmarks, and of the irises if found, in the edited photo, as x, y pairs in shares of its
    /// size; undefined without a face.
    #[wasm_bindgen(js_name = photoLandmarks)]
    pub fn photo_landmarks(&self) -> Option<Vec<f32>> {
        let positions = self.session.face()?.landmarks_in_edited_photo();
        Some(positions.into_iter().flat_map(|position| position.as_vec2().to_array()).collect())
    }
}

impl Studio {
    /// Shows the original photo of a newly opened face.
    pub(crate) fn show_photo_as_taken(&mut self) {
        self.photo_shown.version = None;
        let still = WarpMesh::default();
        let face_and_picture = self.session.face().zip(self.pictures.lead(&self.session));
        self.viewport
            .show_photo_layer(face_and_picture.map(|(face, picture)| photo_layer(face, picture, &still)).as_ref());
    }

    /// Marks the photo as due for an update, which happens at most once per frame.
    pub(crate) fn mark_photo_due(&mut self, changed: Changed) {
        self.photo_shown.is_due |= changed >= Changed::Tick && self.session.face().is_some();
    }

    /// Updates the displayed photo before a frame, unless that needs a factorisation.
    pub(crate) fn show_photo(&mut self) -> Result<()> {
        let is_seen = self.session.stage().picture_share() > 0.0;
        if self.photo_shown.is_due && is_seen && !self.needs_factorisation() { self.update_photo() } else { Ok(()) }
    }

    fn needs_factorisation(&self) -> bool {
        self.session.face().is_some_and(|face| face.photo().needs_factorisation())
    }

    fn update_photo(&mut self) -> Result<()> {
        self.photo_shown.is_due = false;
        self.session.update_photo_warp();
        self.show_photo_layer()
    }

    fn show_photo_layer(&mut self) -> Result<()> {
        let (Some(face), Some(picture)) = (self.session.face(), self.pictures.lead(&self.session)) else {
            return Ok(());
        };
        // During the live preview, the camera stream takes the photo's place.
        let Some((warp_mesh, version)) = face.photo().warp_mesh().filter(|_| self.camera_stream.is_none()) else {
            return Ok(());
        };
        if self.photo_shown.version.replace(version) != Some(version) {
            self.viewport.show_photo_layer(Some(&photo_layer(face, picture, warp_mesh)));
        }
        Ok(self.viewport.move_photo_layer(&warp_mesh.to_px)?)
    }
}

fn photo_layer<'a>(face: &OpenFace, picture: &'a OpenPicture, warp_mesh: &'a WarpMesh) -> PhotoLayerInput<'a> {
    PhotoLayerInput {
        size_px: DVec2::from(face.model().photo_size_px().map(f64::from)),
        from_px: &warp_mesh.from_px,
        triangles: &warp_mesh.triangles,
        picture: &picture.on_gpu,
    }
}
