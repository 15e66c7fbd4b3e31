use glam::DVec2;
use rosto_session::{Changed, Mirror};
use rosto_stage::Scene;
use rosto_viewport::{MeshInput, SheetInput};
use wasm_bindgen::prelude::*;
use web_sys::ImageBitmap;

use crate::Studio;
use crate::error::{FacadeError, Result};
use crate::shown::Film;

/// The mirror.
#[wasm_bindgen]
impl Studio {
    /// Shows the next frame of the camera with the open face's edits: its landmarks as `openFace` takes them, or nothing where no
    /// face is in it. The first frame begins the mirror.
    ///
    /// # Errors
    /// `no-face`, `bad-face` or `device-lost`.
    #[wasm_bindgen(js_name = mirrorFrame)]
    pub fn mirror_frame(&mut self, frame: &ImageBitmap, landmarks: Option<Vec<f32>>) -> Result<(), JsValue> {
        let size_px = [frame.width(), frame.height()];
        let landmarks = landmarks.as_deref().map(|landmarks| landmarks.as_chunks::<3>().0);
        let film = self.film_for(size_px)?;
        self.session.mirror_frame(landmarks, size_px).map_err(FacadeError::from)?;
        self.film = film.or(self.film.take());
        self.take_frame(frame)?;
        self.show_film()?;
        self.session.stage_mut().ask_for_a_frame();
        Ok(())
    }

    /// Whether the last frame had a face in it; undefined while there is no mirror.
    #[wasm_bindgen(getter, js_name = mirrorSees)]
    pub fn mirror_sees(&self) -> Option<bool> {
        self.session.mirror().map(Mirror::is_seen)
    }

    /// Ends the mirror: the photo is there again.
    #[wasm_bindgen(js_name = endMirror)]
    pub fn end_mirror(&mut self) {
        self.session.end_mirror();
        self.film = None;
        self.show_soon(Changed::Mesh);
    }
}

impl Studio {
    /// Room for a frame of that size; none where there is.
    fn film_for(&self, size_px: [u32; 2]) -> Result<Option<Film>> {
        if self.film.as_ref().is_some_and(|film| film.size_px == size_px) {
            return Ok(None);
        }
        let on_gpu = self.viewport.reserve_film(size_px[0], size_px[1])?;
        Ok(Some(Film { on_gpu, size_px, version: None, is_on_mesh: false }))
    }

    fn take_frame(&mut self, frame: &ImageBitmap) -> Result<()> {
        // Without a face in the frame, the mesh keeps the last one that had one, unless the film itself is seen.
        let is_seen = self.session.mirror().is_some_and(Mirror::is_seen);
        if is_seen || self.session.stage().scene() == Scene::Picture {
            self.write_frame(frame)?;
        }
        Ok(())
    }

    #[cfg(target_arch = "wasm32")]
    fn write_frame(&self, frame: &ImageBitmap) -> Result<()> {
        let Some(film) = &self.film else { return Ok(()) };
        Ok(self.viewport.write_frame(&film.on_gpu, frame)?)
    }

    /// Only a browser has bitmaps; elsewhere this crate is built for its tests alone.
    #[cfg(not(target_arch = "wasm32"))]
    fn write_frame(&self, _: &ImageBitmap) -> Result<()> {
        Ok(())
    }

    /// What changes while the film runs: the edits follow at once, and do not wait for the next frame.
    pub(crate) fn show_in_mirror(&mut self, changed: Changed) -> Result<()> {
        if self.session.mirror().is_none() {
            self.film = None;
            return self.show(changed);
        }
        // The panel still has the photo.
        self.note_for_photo(changed);
        if changed >= Changed::Mesh || self.pieces.is_some() {
            self.show_mesh()?;
            if let Some(film) = &mut self.film {
                film.is_on_mesh = false;
            }
        }
        if changed >= Changed::Tick {
            self.session.follow_in_mirror()?;
            self.show_film()?;
        }
        if changed >= Changed::Document
            && let Some(face) = self.session.face()
        {
            // What the mesh follows is brought with each frame, not by fields.
            let reach = face.document().reach();
            self.viewport.set_fields([None, None], reach.as_deref())?;
        }
        self.session.stage_mut().ask_for_a_frame();
        Ok(())
    }

    fn show_film(&mut self) -> Result<()> {
        let (Some(film), Some(mirror), Some(face)) = (&mut self.film, self.session.mirror(), self.session.face())
        else {
            return Ok(());
        };
        let (patch, version) = mirror.patch();
        if film.version != Some(version) {
            film.version = Some(version);
            let [width, height] = film.size_px.map(f64::from);
            let picture = &film.on_gpu;
            let size_px = DVec2::new(width, height);
            let input = SheetInput { size_px, from_px: &patch.from_px, triangles: &patch.triangles, picture };
            self.viewport.show_sheet(Some(&input));
        }
        self.viewport.carry_sheet(&patch.from_px, &patch.to_px)?;
        if mirror.edited_m().len() != face.document().rest().len() {
            // No face was seen since this mesh is there.
            return Ok(());
        }
        if !std::mem::replace(&mut film.is_on_mesh, true) {
            self.viewport.show(&MeshInput {
                topology: face.document().topology(),
                positions_m: mirror.edited_m(),
                colours_srgb: &face.colours_srgb(&face.uvs()),
                uvs: mirror.uvs(),
                picture: Some(&film.on_gpu),
            })?;
            self.viewport.set_fields([None, None], face.document().reach().as_deref())?;
        }
        self.viewport.set_positions(mirror.edited_m())?;
        self.viewport.set_uvs(mirror.uvs())?;
        Ok(self.viewport.set_before(mirror.seen_m())?)
    }
}
