use glam::DVec2;
use rosto_face::{Triangulation, canonical_positions_m};
use rosto_session::{Changed, FurtherPhoto, Incoming, Intent, OpenFace, Session, Work};
use rosto_stage::ShadingMode;
use rosto_viewport::{MeshInput, PictureOnGpu, Viewport};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::error::{FacadeError, Result};
use crate::modes::ChangeName;
use crate::picture::{IncomingPicture, OpenPicture};
use crate::pieces::Pieces;
use crate::renderer::Renderer;
use crate::shown::{CameraStream, PhotoShown};

/// Number of seeds that a JavaScript number represents exactly.
const SEEDS: f64 = 9_007_199_254_740_992.0;

/// A user's session and its viewport. [`Studio::act`] is the single mutation entry point of the session.
#[wasm_bindgen]
pub struct Studio {
    pub(crate) session: Session,
    pub(crate) viewport: Viewport,
    /// Picture of the open face.
    pub(crate) picture: Option<OpenPicture>,
    /// Picture of the face to be opened next.
    pub(crate) next_picture: Option<OpenPicture>,
    /// Earlier photos of the face to be opened next, if it has several.
    pub(crate) next_photos: Vec<(FurtherPhoto, OpenPicture)>,
    incoming_picture: Option<IncomingPicture>,
    /// Whole-face texture of the open face.
    pub(crate) texture: Option<OpenPicture>,
    pub(crate) incoming_texture: Option<IncomingPicture>,
    pub(crate) photo_shown: PhotoShown,
    /// The camera stream, during the live preview.
    pub(crate) camera_stream: Option<CameraStream>,
    /// The pieces of the mesh on the GPU, while the face shows an expression.
    pub(crate) pieces: Option<Pieces>,
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
        let on = |picture: &Option<OpenPicture>| picture.as_ref().map(|one| one.on(&viewport)).transpose();
        let (picture, next, texture) = (on(&self.picture)?, on(&self.next_picture)?, on(&self.texture)?);
        let next_photos = self.next_photos.iter().map(|(_, picture)| picture.on(&viewport));
        let next_photos = next_photos.collect::<Result<Vec<_>>>()?;
        self.viewport = viewport;
        (self.picture, self.next_picture, self.texture) = (picture, next, texture);
        self.next_photos.iter_mut().zip(next_photos).for_each(|((_, picture), on_gpu)| *picture = on_gpu);
        let size = self.session.stage().camera().size_px().to_array().map(|side| side as u32);
        self.viewport.resize(size[0], size[1]);
        (self.incoming_picture, self.incoming_texture) = (None, None);
        // The next frame creates another one.
        self.camera_stream = None;
        self.show_soon(Changed::Mesh);
        Ok(())
    }

    /// Prepares for the rows of an upright picture, which can be scaled down. The open face stays. `place` is the
    /// picture's index among the photos of the next face: 0, or more after calls of `keepPhoto`.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openPicture)]
    pub fn open_picture(&mut self, width: u32, height: u32, place: Option<u32>) -> Result<(), JsValue> {
        // Drop photos of a face that was not opened in the end.
        self.next_photos.truncate(place.unwrap_or(0) as usize);
        self.next_picture = None;
        self.incoming_picture = None;
        self.incoming_picture = Some(IncomingPicture::new(&self.viewport, width, height)?);
        Ok(())
    }

    /// Adds the next rows of the picture, RGBA. Once it is complete, `openFace` can open a face in it.
    ///
    /// # Errors
    /// `bad-face` for partial or surplus rows; open the picture again then.
    #[wasm_bindgen(js_name = addPictureRows)]
    pub fn add_picture_rows(&mut self, rgba: &[u8]) -> Result<(), JsValue> {
        let incoming = self.incoming_picture.take().ok_or_else(FacadeError::no_picture)?;
        match incoming.add(&self.viewport, rgba)? {
            Ok(picture) => self.next_picture = Some(picture),
            Err(part) => self.incoming_picture = Some(part),
        }
        Ok(())
    }

    /// Opens a face in the last opened picture and in the photos added by `keepPhoto`. Takes MediaPipe's normalised
    /// landmarks (468 × 3, or 478 × 3 with the irises) found in a photo of `width` × `height` px, the colour at each
    /// landmark (468 × 3, sRGB), and the photo's lens as for `setPhotoLens`. If the face cannot be opened, the current
    /// one stays.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openFace)]
    pub fn open_face(
        &mut self,
        landmarks: &[f32],
        width: u32,
        height: u32,
        colours: &[u8],
        lens: &str,
    ) -> Result<ChangeName, JsValue> {
        Ok(self.open(landmarks, [width, height], colours, lens, None)?)
    }

    /// Opens a face with its earlier edits: the triangulation, the density, the history as versioned JSON, and the
    /// photo-edit data. Everything is checked before anything is replaced.
    ///
    /// # Errors
    /// `bad-face`, `bad-history` or `other-version`.
    #[wasm_bindgen(js_name = openWork)]
    #[expect(clippy::too_many_arguments, reason = "each is a parameter of the JavaScript function")]
    pub fn open_work(
        &mut self,
        landmarks: &[f32],
        width: u32,
        height: u32,
        colours: &[u8],
        lens: &str,
        triangulation: &str,
        density: u32,
        edits: String,
        photo: Option<String>,
    ) -> Result<ChangeName, JsValue> {
        let work = Work {
            triangulation: FacadeError::require(Triangulation::from_id(triangulation))?,
            density,
            history: edits,
            photo,
        };
        Ok(self.open(landmarks, [width, height], colours, lens, Some(work))?)
    }

    /// Shows the empty state: the canonical face as a slowly rotating wireframe.
    ///
    /// # Errors
    /// `device-lost`.
    #[wasm_bindgen(js_name = showCanonical)]
    pub fn show_canonical(&mut self) -> Result<ChangeName, JsValue> {
        let changed = self.act(Intent::Close)?;
        self.picture = None;
        Ok(changed)
    }

    /// Resizes the canvas to a size in device pixels, at a device-pixel ratio.
    ///
    /// # Errors
    /// `bad-number`.
    pub fn resize(
        &mut self,
        #[wasm_bindgen(js_name = widthPx)] width_px: u32,
        #[wasm_bindgen(js_name = heightPx)] height_px: u32,
        #[wasm_bindgen(js_name = pixelRatio)] pixel_ratio: f64,
    ) -> Result<ChangeName, JsValue> {
        let changed = self.act(Intent::Resize(self.viewport.fitting(width_px, height_px), pixel_ratio))?;
        self.viewport.resize(width_px, height_px);
        Ok(changed)
    }

    /// Draws if something changed; returns whether another frame is needed. `timeMs` is the time that
    /// `requestAnimationFrame` passes.
    ///
    /// # Errors
    /// `device-lost`, or the error of a failed upload.
    pub fn draw(&mut self, #[wasm_bindgen(js_name = timeMs)] time_ms: f64) -> Result<bool, JsValue> {
        if self.pending_change > Changed::Nothing {
            self.show_lead(None)?;
            self.show(self.pending_change)?;
            self.pending_change = Changed::Nothing;
        }
        self.show_photo()?;
        Ok(self.viewport.draw(self.session.stage_mut(), time_ms).map_err(FacadeError::from)?)
    }

    /// Settings and view as text for `restorePreferences`; the format is opaque to the page.
    pub fn preferences(&self) -> String {
        self.session.preferences()
    }

    /// Restores settings and view from the text of `preferences`.
    ///
    /// # Errors
    /// `bad-choice`.
    #[wasm_bindgen(js_name = restorePreferences)]
    pub fn restore_preferences(&mut self, preferences: String) -> Result<ChangeName, JsValue> {
        self.act(Intent::RestorePreferences(preferences))
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
            picture: None,
            next_picture: None,
            next_photos: Vec::new(),
            incoming_picture: None,
            texture: None,
            incoming_texture: None,
            photo_shown: PhotoShown::default(),
            camera_stream: None,
            pieces: None,
            pending_change: Changed::Nothing,
        }
    }

    /// Single mutation entry point: applies an intent and shows its change.
    pub(crate) fn act(&mut self, intent: Intent) -> Result<ChangeName, JsValue> {
        let changed = self.session.apply(intent).map_err(FacadeError::from)?;
        self.show_soon(changed);
        Ok(changed.into())
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

    fn open(
        &mut self,
        landmarks: &[f32],
        photo_size_px: [u32; 2],
        colours: &[u8],
        lens: &str,
        work: Option<Work>,
    ) -> Result<ChangeName> {
        let last = self.detected_photo(landmarks, photo_size_px, colours, lens)?;
        let mut photos = std::mem::take(&mut self.next_photos);
        photos.push(last);
        let mut detections = photos.iter().map(|(photo, _)| photo.clone());
        let first = detections.next().ok_or_else(FacadeError::no_picture)?;
        let incoming = Incoming {
            landmarks: first.landmarks,
            photo_size_px: first.photo_size_px,
            colours_srgb: first.colours_srgb,
            picture: first.picture,
            lens: first.lens,
            further: detections.collect(),
            work,
        };
        let changed = self.session.apply(Intent::Open(Box::new(incoming)))?;
        let lead = self.face()?.model().views()[0].photo;
        self.picture = Some(photos.swap_remove(lead).1);
        self.show_soon(changed);
        Ok(changed.into())
    }

    /// Uploads a change to the GPU.
    pub(crate) fn show(&mut self, changed: Changed) -> Result<()> {
        if self.camera_stream.is_some() {
            return self.show_live_preview(changed);
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
        let picture = if is_whole { &self.texture } else { &self.picture };
        let picture = picture.as_ref().map(|picture| &picture.on_gpu);
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
        if self.session.view().shading == ShadingMode::Distortion {
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
        colours_srgb: &face.colours_srgb(&face.uvs()),
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
