use glam::DVec2;
use rosto::SavedFace;
use rosto_face::{Triangulation, canonical_positions_m};
use rosto_session::{Changed, Intent, OpenFace, Session, Widget};
use rosto_stage::ShadingMode;
use rosto_viewport::{MeshInput, PictureOnGpu, Viewport};
use tsify::Ts;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;
use web_sys::ImageBitmap;

use crate::error::{FacadeError, Result};
use crate::picture::{OpenPicture, Pictures};
use crate::pieces::Pieces;
use crate::renderer::Renderer;
use crate::sent::sent;
use crate::shown::{CameraStream, PhotoShown, ShownPrint};

/// Number of seeds that a JavaScript number represents exactly.
const SEEDS: f64 = 9_007_199_254_740_992.0;

/// A user's session and its viewport. [`Studio::act`] is the single mutation entry point of the session.
#[wasm_bindgen]
pub struct Studio {
    pub(crate) session: Session,
    pub(crate) viewport: Viewport,
    pub(crate) pictures: Pictures,
    pub(crate) photo_shown: PhotoShown,
    /// The camera stream, during the live preview.
    pub(crate) camera_stream: Option<CameraStream>,
    /// The pieces of the mesh on the GPU, while the face shows an expression.
    pub(crate) pieces: Option<Pieces>,
    /// The printed body, while it is displayed in place of the face.
    pub(crate) print: Option<ShownPrint>,
    /// The panels that the page shows.
    pub(crate) panel: Vec<Widget>,
    /// Change whose upload failed; the next frame tries again.
    pending_change: Changed,
}

#[wasm_bindgen]
impl Studio {
    /// Resolves when WebGPU reports that the GPU is lost. For WebGL2, listen to the canvas' event.
    #[wasm_bindgen(js_name = gpuLost, unchecked_return_type = "Promise<void>")]
    pub fn gpu_lost(&self) -> js_sys::Promise {
        let lost = self.viewport.lost();
        future_to_promise(async move {
            lost.await;
            Ok(JsValue::UNDEFINED)
        })
    }

    /// Continues on a new GPU after `device-lost`; the session is unaffected.
    ///
    /// # Errors
    /// `device-lost` if the new GPU is lost too.
    #[wasm_bindgen(js_name = useRenderer)]
    pub fn use_renderer(&mut self, renderer: Renderer) -> Result<(), JsValue> {
        let viewport = renderer.into_viewport();
        self.pictures.move_to(&viewport)?;
        self.viewport = viewport;
        let size = self.session.stage().camera().size_px().to_array().map(|side| side as u32);
        self.viewport.resize(size[0], size[1]);
        // The next frame creates another one.
        self.camera_stream = None;
        self.show_soon(Changed::Mesh);
        Ok(())
    }

    /// Adds a picture for a face to be opened or a photo to be added: upright, possibly scaled down. The studio closes
    /// the bitmap after the next face is opened, unless that face uses it.
    ///
    /// # Errors
    /// `bad-face` if the bitmap is closed or too large.
    #[wasm_bindgen(js_name = addPicture)]
    pub fn add_picture(&mut self, key: String, bitmap: ImageBitmap) -> Result<(), JsValue> {
        self.pictures.add(key, OpenPicture::new(bitmap, &self.viewport)?);
        Ok(())
    }

    /// Opens a face from the texts of `savedPhotos` and `savedEdits` or of the worker's `open`; without edits, it is a
    /// newly found face. `pictures` holds the key of an added picture for each photo. Everything is checked before
    /// anything is replaced.
    ///
    /// # Errors
    /// `bad-face`, `bad-history` or `other-version`.
    pub fn open(&mut self, photos: &str, edits: Option<String>, pictures: Vec<String>) -> Result<Ts<Changed>, JsValue> {
        let saved = SavedFace::from_json(photos, edits.as_deref()).map_err(FacadeError::of_saved)?;
        if pictures.len() != saved.photos.len() {
            return Err(FacadeError::no_picture().into());
        }
        pictures.iter().try_for_each(|key| self.pictures.require(key))?;
        let changed = self.session.apply(Intent::Open(Box::new(saved))).map_err(FacadeError::from)?;
        self.pictures.open(pictures);
        // In another task, as both parts take long.
        self.show_later();
        Ok(sent(&changed)?)
    }

    /// The open face's photos as text, in the order in which they were added. It changes with the photos and the lens.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = savedPhotos)]
    pub fn saved_photos(&self) -> Result<String, JsValue> {
        Ok(self.face()?.saved_photos())
    }

    /// The open face's edits, density and triangulation as text.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = savedEdits)]
    pub fn saved_edits(&self) -> Result<String, JsValue> {
        Ok(self.face()?.saved_edits())
    }

    /// Keys of the open face's pictures, in the order of its photos.
    pub fn pictures(&self) -> Vec<String> {
        self.pictures.of_face().to_vec()
    }

    /// Draws if something changed; returns whether another frame is needed. `timeMs` is the time that
    /// `requestAnimationFrame` passes.
    ///
    /// # Errors
    /// `device-lost`, or the error of a failed upload.
    pub fn draw(&mut self, #[wasm_bindgen(js_name = timeMs)] time_ms: f64) -> Result<bool, JsValue> {
        if self.pending_change > Changed::Nothing {
            self.show(self.pending_change)?;
            self.pending_change = Changed::Nothing;
        }
        self.show_photo()?;
        Ok(self.viewport.draw(self.session.stage_mut(), time_ms).map_err(FacadeError::from)?)
    }
}

/// A distance beyond the influence radius of any edit, in influence radii.
const BEYOND_INFLUENCE: f64 = 1e3;

impl Studio {
    pub(crate) fn new(viewport: Viewport) -> Self {
        let session = Session::new((js_sys::Math::random() * SEEDS) as u64);
        Self {
            session,
            viewport,
            pictures: Pictures::default(),
            photo_shown: PhotoShown::default(),
            camera_stream: None,
            pieces: None,
            print: None,
            panel: Vec::new(),
            pending_change: Changed::Nothing,
        }
    }

    /// Uploads a change to the GPU. If the upload fails, the intent still succeeds; the next frame uploads everything
    /// again and reports the error.
    pub(crate) fn show_soon(&mut self, changed: Changed) {
        if self.show(changed).is_err() {
            self.show_later();
        }
    }

    pub(crate) fn show_later(&mut self) {
        self.pending_change = Changed::Mesh;
        self.session.stage_mut().request_frame();
    }

    /// The open face.
    pub(crate) fn face(&self) -> Result<&OpenFace> {
        self.session.face().ok_or_else(FacadeError::no_face)
    }

    /// Uploads a change to the GPU.
    pub(crate) fn show(&mut self, changed: Changed) -> Result<()> {
        let changed = if self.drop_outdated_print() { Changed::Mesh } else { changed };
        // A resting pointer hovers in each frame; its intent must not ask for another one.
        if changed == Changed::Nothing {
            return Ok(());
        }
        if self.camera_stream.is_some() {
            return self.show_live_preview(changed);
        }
        if let Some(print) = &self.print {
            if changed >= Changed::Mesh {
                print.show(&mut self.viewport)?;
                self.pieces = None;
            }
            self.mark_photo_due(changed);
            self.session.stage_mut().request_frame();
            return Ok(());
        }
        let is_split = self.session.face().is_some_and(OpenFace::shows_expression);
        if changed >= Changed::Mesh {
            self.show_mesh()?;
            self.show_photo_as_taken();
        } else if self.pieces.is_some() != is_split {
            self.show_mesh()?;
        }
        if changed >= Changed::Document {
            self.show_shape()?;
        }
        if changed >= Changed::Tick {
            self.show_tick()?;
        }
        self.mark_photo_due(changed);
        self.session.stage_mut().request_frame();
        Ok(())
    }

    pub(crate) fn show_mesh(&mut self) -> Result<()> {
        let is_whole = self.session.shows_texture();
        let picture = if is_whole { self.pictures.texture.as_ref() } else { self.pictures.lead(&self.session) };
        let picture = picture.map(|picture| &picture.on_gpu);
        // The mesh of the live preview is not split.
        let split = self.session.face().filter(|face| self.camera_stream.is_none() && face.shows_expression());
        self.pieces = split.map(Pieces::of);
        let Some(face) = self.session.face() else { return show_canonical(&mut self.viewport) };
        let uvs = if is_whole { face.texture_uvs() } else { face.uvs() };
        match &self.pieces {
            Some(pieces) => pieces.show(&mut self.viewport, face, &uvs, picture),
            None => show_face(&mut self.viewport, face, &uvs, picture),
        }
    }

    /// Uploads the positions from which the edit in progress starts, and its influence fields.
    fn show_shape(&mut self) -> Result<()> {
        let Some(face) = self.session.face() else { return Ok(()) };
        let (fields, influence_distances) = (face.influence_fields(), face.document().influence_distances());
        let Some(pieces) = &mut self.pieces else {
            self.viewport.set_positions(face.document().committed())?;
            return Ok(self.viewport.set_fields(fields, influence_distances.as_deref())?);
        };
        pieces.update(face);
        self.viewport.set_positions(&pieces.positions_m(face.document().committed()))?;
        let [a, b] = fields.map(|field| field.map(|field| pieces.values(field, 0.0)));
        let influence_distances = influence_distances.map(|distances| pieces.values(&distances, BEYOND_INFLUENCE));
        Ok(self.viewport.set_fields([a.as_deref(), b.as_deref()], influence_distances.as_deref())?)
    }

    /// Uploads a tick: only the stage's offsets, unless details rotate, an expression moves or the stretch is
    /// displayed.
    fn show_tick(&mut self) -> Result<()> {
        let Some(face) = self.session.face() else { return Ok(()) };
        if face.turns_details() || face.expression().is_some() {
            let positions_m = face.document().positions();
            match &self.pieces {
                Some(pieces) => self.viewport.set_positions(&pieces.positions_m(positions_m))?,
                None => self.viewport.set_positions(positions_m)?,
            }
        }
        if self.session.stage().render_settings().shading == ShadingMode::Distortion {
            let stretch = face.stretch();
            let stretch = self.pieces.as_ref().map(|pieces| pieces.values(&stretch, 0.0)).unwrap_or(stretch);
            self.viewport.set_scalars(&stretch)?;
        }
        Ok(())
    }
}

fn show_face(viewport: &mut Viewport, face: &OpenFace, uvs: &[DVec2], picture: Option<&PictureOnGpu>) -> Result<()> {
    viewport.show(&MeshInput {
        topology: face.document().topology(),
        positions_m: face.document().committed(),
        colours_srgb: &face.colours_srgb(),
        uvs,
        picture,
    })?;
    Ok(viewport.set_before(face.document().rest())?)
}

fn show_canonical(viewport: &mut Viewport) -> Result<()> {
    Ok(viewport.show(&MeshInput {
        topology: &Triangulation::Canonical.topology(),
        positions_m: &canonical_positions_m(),
        colours_srgb: &[],
        uvs: &[],
        picture: None,
    })?)
}
