use glam::DVec2;
use rosto_session::{Changed, LivePreview};
use rosto_stage::Scene;
use rosto_viewport::{MeshInput, PhotoLayerInput};
use wasm_bindgen::prelude::*;
use web_sys::ImageBitmap;

use crate::Studio;
use crate::error::{FacadeError, Result};
use crate::shown::CameraStream;

/// The live preview.
#[wasm_bindgen]
impl Studio {
    /// Shows the next frame of the camera with the open face's edits. `landmarks` are those of the worker's `follow`, or
    /// undefined if the frame contains no face. The first frame starts the live preview.
    ///
    /// # Errors
    /// `no-face`, `bad-face` or `device-lost`.
    #[wasm_bindgen(js_name = previewFrame)]
    pub fn preview_frame(&mut self, frame: &ImageBitmap, landmarks: Option<Vec<f32>>) -> Result<(), JsValue> {
        let size_px = [frame.width(), frame.height()];
        let landmarks = landmarks.as_deref().map(|landmarks| landmarks.as_chunks::<3>().0);
        let camera_stream = self.camera_stream_for(size_px)?;
        self.session.preview_frame(landmarks, size_px).map_err(FacadeError::from)?;
        self.camera_stream = camera_stream.or(self.camera_stream.take());
        self.take_frame(frame)?;
        self.show_camera_stream()?;
        self.session.stage_mut().request_frame();
        Ok(())
    }

    /// Ends the live preview and shows the photo again.
    #[wasm_bindgen(js_name = endLivePreview)]
    pub fn end_live_preview(&mut self) {
        self.session.end_live_preview();
        self.camera_stream = None;
        self.show_soon(Changed::Mesh);
    }
}

impl Studio {
    /// Reserves a texture for frames of this size; `None` if the current one fits.
    fn camera_stream_for(&self, size_px: [u32; 2]) -> Result<Option<CameraStream>> {
        if self.camera_stream.as_ref().is_some_and(|camera_stream| camera_stream.size_px == size_px) {
            return Ok(None);
        }
        let on_gpu = self.viewport.reserve_camera_stream(size_px[0], size_px[1])?;
        Ok(Some(CameraStream { on_gpu, size_px, version: None, is_on_mesh: false }))
    }

    fn take_frame(&mut self, frame: &ImageBitmap) -> Result<()> {
        // The mesh keeps the last frame with a face. A frame without a face is only uploaded if the picture is
        // displayed.
        let is_seen = self.session.live_preview().is_some_and(LivePreview::is_seen);
        if is_seen || self.session.stage().scene() == Scene::Picture {
            self.write_frame(frame)?;
        }
        Ok(())
    }

    #[cfg(target_arch = "wasm32")]
    fn write_frame(&self, frame: &ImageBitmap) -> Result<()> {
        let Some(camera_stream) = &self.camera_stream else { return Ok(()) };
        Ok(self.viewport.write_frame(&camera_stream.on_gpu, frame)?)
    }

    /// Bitmaps exist only in browsers; other targets build this crate for its tests.
    #[cfg(not(target_arch = "wasm32"))]
    fn write_frame(&self, _: &ImageBitmap) -> Result<()> {
        Ok(())
    }

    /// Shows a change during the live preview. Edits are applied to the current frame without waiting for the next one.
    pub(crate) fn show_live_preview(&mut self, changed: Changed) -> Result<()> {
        if self.session.live_preview().is_none() {
            self.camera_stream = None;
            return self.show(changed);
        }
        // The panel still shows the photo.
        self.mark_photo_due(changed);
        if changed >= Changed::Mesh || self.pieces.is_some() {
            self.show_mesh()?;
            if let Some(camera_stream) = &mut self.camera_stream {
                camera_stream.is_on_mesh = false;
            }
        }
        if changed >= Changed::Tick {
            self.session.follow_live_preview()?;
            self.show_camera_stream()?;
        }
        if changed >= Changed::Document
            && let Some(face) = self.session.face()
        {
            // The positions come with each frame instead of influence fields.
            let influence_distances = face.document().influence_distances();
            self.viewport.set_fields([None, None], influence_distances.as_deref())?;
        }
        self.session.stage_mut().request_frame();
        Ok(())
    }

    fn show_camera_stream(&mut self) -> Result<()> {
        let (Some(camera_stream), Some(live_preview), Some(face)) =
            (&mut self.camera_stream, self.session.live_preview(), self.session.face())
        else {
            return Ok(());
        };
        let (warp_mesh, version) = live_preview.warp_mesh();
        if camera_stream.version != Some(version) {
            camera_stream.version = Some(version);
            let [width, height] = camera_stream.size_px.map(f64::from);
            let picture = &camera_stream.on_gpu;
            let size_px = DVec2::new(width, height);
            let input =
                PhotoLayerInput { size_px, from_px: &warp_mesh.from_px, triangles: &warp_mesh.triangles, picture };
            self.viewport.show_photo_layer(Some(&input));
        }
        self.viewport.carry_photo_layer(&warp_mesh.from_px, &warp_mesh.to_px)?;
        if live_preview.edited_m().len() != face.document().rest().len() {
            // No frame with a face has arrived since the mesh changed.
            return Ok(());
        }
        if !std::mem::replace(&mut camera_stream.is_on_mesh, true) {
            self.viewport.show(&MeshInput {
                topology: face.document().topology(),
                positions_m: live_preview.edited_m(),
                colours_srgb: &face.colours_srgb(),
                uvs: live_preview.uvs(),
                picture: Some(&camera_stream.on_gpu),
            })?;
            self.viewport.set_fields([None, None], face.document().influence_distances().as_deref())?;
        }
        self.viewport.set_positions(live_preview.edited_m())?;
        self.viewport.set_uvs(live_preview.uvs())?;
        Ok(self.viewport.set_before(live_preview.seen_m())?)
    }
}
