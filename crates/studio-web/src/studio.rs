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

/// Seeds stay exact as JavaScript's numbers.
const SEEDS: f64 = 9_007_199_254_740_992.0;

/// A visitor's session and the GPU that it is drawn with. What is done to the session is done by [`Studio::act`] alone.
#[wasm_bindgen]
pub struct Studio {
    pub(crate) session: Session,
    pub(crate) viewport: Viewport,
    /// Of the open face.
    pub(crate) picture: Option<OpenPicture>,
    /// Of the face to be opened next.
    pub(crate) next_picture: Option<OpenPicture>,
    /// The photos of that face before that one, if it is in several.
    pub(crate) next_photos: Vec<(FurtherPhoto, OpenPicture)>,
    incoming_picture: Option<IncomingPicture>,
    /// Of the whole of the open face.
    pub(crate) texture: Option<OpenPicture>,
    pub(crate) incoming_texture: Option<IncomingPicture>,
    pub(crate) photo_shown: PhotoShown,
    /// While the mirror shows one.
    pub(crate) camera_stream: Option<CameraStream>,
    /// What the mesh on the GPU is parted into, while the face shows an expression.
    pub(crate) pieces: Option<Pieces>,
    /// What has changed and could not be brought to the GPU yet: the next frame tries again.
    unshown: Changed,
}

#[wasm_bindgen]
impl Studio {
    /// Resolves when the GPU is gone, as far as WebGPU tells: WebGL2's end is an event of the canvas.
    #[wasm_bindgen(js_name = gpuLost, unchecked_return_type = "Promise<void>")]
    pub fn gpu_lost(&self) -> js_sys::Promise {
        let lost = self.viewport.lost();
        future_to_promise(async move {
            lost.await;
            Ok(JsValue::UNDEFINED)
        })
    }

    /// Continues on a new GPU after `device-lost`; the session stays.
    ///
    /// # Errors
    /// `device-lost`, if that one is gone too.
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
        // The next frame brings another.
        self.camera_stream = None;
        self.show_soon(Changed::Mesh);
        Ok(())
    }

    /// Makes room for an upright picture, perhaps scaled down, whose rows are to follow. What is open stays. `place` says which
    /// of the photos of the next face it is, from 0: the first, unless `keepPhoto` has taken those before it.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openPicture)]
    pub fn open_picture(&mut self, width: u32, height: u32, place: Option<u32>) -> Result<(), JsValue> {
        // What is left of a face that was not opened after all is none of this one's.
        self.next_photos.truncate(place.unwrap_or(0) as usize);
        self.next_picture = None;
        self.incoming_picture = None;
        self.incoming_picture = Some(IncomingPicture::new(&self.viewport, width, height)?);
        Ok(())
    }

    /// Takes the next rows of that picture, RGBA. Once it is whole, `openFace` opens a face in it.
    ///
    /// # Errors
    /// `bad-face` for a part of a row or more rows than there are; the picture is then to be opened anew.
    #[wasm_bindgen(js_name = addPictureRows)]
    pub fn add_picture_rows(&mut self, rgba: &[u8]) -> Result<(), JsValue> {
        let incoming = self.incoming_picture.take().ok_or_else(FacadeError::no_picture)?;
        match incoming.add(&self.viewport, rgba)? {
            Ok(whole) => self.next_picture = Some(whole),
            Err(part) => self.incoming_picture = Some(part),
        }
        Ok(())
    }

    /// Opens a face of the picture that was opened last: MediaPipe's normalised landmarks (468 × 3, or 478 × 3 with
    /// the irises) found in a photo of `width` × `height` px, the colour under each landmark (468 × 3, sRGB), and what is known
    /// of the photo's lens, as `setPhotoLens` takes it. It is seen in the photos that `keepPhoto` has taken, too. What was open
    /// before is kept if this one cannot be opened.
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

    /// The same with the work that was done to it before: how the landmarks were joined, how often the mesh was
    /// subdivided, the edits as versioned JSON, and what the photo alone holds. Everything is checked before anything is replaced.
    ///
    /// # Errors
    /// `bad-face`, `bad-history` or `other-version`.
    #[wasm_bindgen(js_name = openWork)]
    #[expect(clippy::too_many_arguments, reason = "JavaScript names them in the object that it takes them from")]
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
            triangulation: FacadeError::unless(Triangulation::from_id(triangulation))?,
            density,
            history: edits,
            photo,
        };
        Ok(self.open(landmarks, [width, height], colours, lens, Some(work))?)
    }

    /// Shows the empty state: the canonical face as a slowly turning wireframe.
    ///
    /// # Errors
    /// `device-lost`.
    #[wasm_bindgen(js_name = showCanonical)]
    pub fn show_canonical(&mut self) -> Result<ChangeName, JsValue> {
        let changed = self.act(Intent::Close)?;
        self.picture = None;
        Ok(changed)
    }

    /// The canvas' size in device pixels, and how many of them make a CSS pixel.
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

    /// Draws if something changed; true asks for another frame. `timeMs` is what `requestAnimationFrame` tells.
    ///
    /// # Errors
    /// `device-lost`, or what keeps a change from the GPU.
    pub fn draw(&mut self, #[wasm_bindgen(js_name = timeMs)] time_ms: f64) -> Result<bool, JsValue> {
        if self.unshown > Changed::Nothing {
            self.show_lead(None)?;
            self.show(self.unshown)?;
            self.unshown = Changed::Nothing;
        }
        self.show_photo()?;
        Ok(self.viewport.draw(self.session.stage_mut(), time_ms).map_err(FacadeError::from)?)
    }

    /// Choices and view as text, for `prefer`: the page need not understand it to keep it.
    pub fn preferences(&self) -> String {
        self.session.preferences()
    }

    /// Puts choices and view as an earlier session's `preferences` tell.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn prefer(&mut self, preferences: String) -> Result<ChangeName, JsValue> {
        self.act(Intent::RestorePreferences(preferences))
    }
}

/// Far beyond where any edit ends.
const OUT_OF_REACH: f64 = 1e3;

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
            unshown: Changed::Nothing,
        }
    }

    /// The one door for everything that changes the session: carries an intent out and shows what it has changed.
    pub(crate) fn act(&mut self, intent: Intent) -> Result<ChangeName, JsValue> {
        let changed = self.session.apply(intent).map_err(FacadeError::from)?;
        self.show_soon(changed);
        Ok(changed.into())
    }

    /// Brings to the GPU what has changed. An intent that was carried out is no failure because it cannot be shown: the next frame
    /// brings all of it once more, and says what is in the way.
    pub(crate) fn show_soon(&mut self, changed: Changed) {
        if self.show(changed).is_err() {
            self.show_later();
        }
    }

    pub(crate) fn show_later(&mut self) {
        self.unshown = Changed::Mesh;
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
        let last = self.photo_found(landmarks, photo_size_px, colours, lens)?;
        let mut photos = std::mem::take(&mut self.next_photos);
        photos.push(last);
        let mut found = photos.iter().map(|(photo, _)| photo.clone());
        let first = found.next().ok_or_else(FacadeError::no_picture)?;
        let incoming = Incoming {
            landmarks: first.landmarks,
            photo_size_px: first.photo_size_px,
            colours_srgb: first.colours_srgb,
            picture: first.picture,
            lens: first.lens,
            further: found.collect(),
            work,
        };
        let changed = self.session.apply(Intent::Open(Box::new(incoming)))?;
        let lead = self.face()?.model().views()[0].photo;
        self.picture = Some(photos.swap_remove(lead).1);
        self.show_soon(changed);
        Ok(changed.into())
    }

    /// Brings to the GPU what has changed.
    pub(crate) fn show(&mut self, changed: Changed) -> Result<()> {
        if self.camera_stream.is_some() {
            return self.show_live_preview(changed);
        }
        let is_parted = self.session.face().is_some_and(OpenFace::shows_expression);
        if changed >= Changed::Mesh {
            self.show_mesh()?;
            self.show_photo_as_taken();
        } else if self.pieces.is_some() != is_parted {
            self.show_mesh()?;
        }
        if changed >= Changed::Document {
            self.show_shape()?;
        }
        if changed >= Changed::Tick {
            self.show_tick()?;
        }
        self.note_for_photo(changed);
        self.session.stage_mut().request_frame();
        Ok(())
    }

    pub(crate) fn show_mesh(&mut self) -> Result<()> {
        let is_whole = self.session.shows_texture();
        let picture = if is_whole { &self.texture } else { &self.picture };
        let picture = picture.as_ref().map(|picture| &picture.on_gpu);
        // What comes with the camera's frames is whole.
        let parted = self.session.face().filter(|face| self.camera_stream.is_none() && face.shows_expression());
        self.pieces = parted.map(Pieces::of);
        let Some(face) = self.session.face() else { return show_canonical(&mut self.viewport) };
        let uvs = if is_whole { face.texture_uvs() } else { face.uvs() };
        match &self.pieces {
            Some(pieces) => pieces.show(&mut self.viewport, face, &uvs, picture),
            None => show_face(&mut self.viewport, face, &uvs, picture),
        }
    }

    /// The shape that the edit in progress starts from, and how it is going to be followed.
    fn show_shape(&mut self) -> Result<()> {
        let Some(face) = self.session.face() else { return Ok(()) };
        let (fields, influence_distances) = (face.influence_fields(), face.document().influence_distances());
        let Some(pieces) = &mut self.pieces else {
            self.viewport.set_positions(face.document().committed())?;
            return Ok(self.viewport.set_fields(fields, influence_distances.as_deref())?);
        };
        pieces.settle(face);
        self.viewport.set_positions(&pieces.positions_m(face.document().committed()))?;
        let [a, b] = fields.map(|field| field.map(|field| pieces.values(field, 0.0)));
        let influence_distances = influence_distances.map(|distances| pieces.values(&distances, OUT_OF_REACH));
        Ok(self.viewport.set_fields([a.as_deref(), b.as_deref()], influence_distances.as_deref())?)
    }

    /// Three numbers of the stage, unless details turn, the face's expression changes or distortion is painted.
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
