use glam::{DVec2, DVec3};
use rosto_face::{FaceInput, FaceModel, LANDMARK_COUNT, Triangulation, canonical_positions_m};
use rosto_studio::Mirror;
use rosto_viewport::{Background, Mark, MarkKind, MeshInput, MirrorPlane, Paint, PictureOnGpu, Viewport, Wireframe};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;

use crate::choices::{AnchorChoice, Choices};
use crate::drag::Drag;
use crate::hand::{Hand, Selection};
use crate::picture::{IncomingPicture, OpenPicture};
use crate::renderer::Renderer;
use crate::session::Session;
use crate::trouble::{Outcome, Trouble};

/// How often a mesh is subdivided at most.
pub(crate) const MAX_DENSITY: u32 = 3;
/// How fast the empty state turns.
const IDLE_TURN_DEG_PER_S: f64 = 14.0;
/// How strongly the response glows over the face while a landmark moves.
const GLOW: f64 = 0.75;
/// Radius in CSS px of the ring around what is in hand, as a pointer needs it.
const RING_PX: f64 = 9.0;

/// The document and its view.
#[wasm_bindgen]
pub struct Studio {
    pub(crate) viewport: Viewport,
    pub(crate) session: Option<Session>,
    /// Of the open face.
    picture: Option<OpenPicture>,
    /// Of the face to be opened next.
    next_picture: Option<OpenPicture>,
    incoming_picture: Option<IncomingPicture>,
    pub(crate) choices: Choices,
    pub(crate) hand: Hand,
    /// What the pointer rests on and would take.
    pub(crate) pointed: Option<Selection>,
    pub(crate) drag: Option<Drag>,
    pub(crate) wishes: Wishes,
}

/// What the page asked for that only a face shows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wishes {
    pub paint: Paint,
    pub wireframe: Wireframe,
    pub background: Background,
    pub turntable_deg_per_s: f64,
    pub triangulation: Triangulation,
    pub density: u32,
    pub motion: Motion,
}

/// Whether things move by themselves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Motion {
    Usual,
    Reduced,
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

    /// Continues on a new GPU after `device-lost`; document and view stay.
    ///
    /// # Errors
    /// `device-lost`, if that one is gone too.
    #[wasm_bindgen(js_name = useRenderer)]
    pub fn use_renderer(&mut self, renderer: Renderer) -> Result<(), JsValue> {
        let stage = self.viewport.stage().clone();
        self.viewport = renderer.into_viewport();
        self.viewport.set_stage(stage);
        self.incoming_picture = None;
        for picture in [&mut self.picture, &mut self.next_picture].into_iter().flatten() {
            *picture = picture.on(&self.viewport)?;
        }
        Ok(self.show_mesh()?)
    }

    /// Makes room for an upright picture, perhaps scaled down, whose rows are to follow. What is open stays.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openPicture)]
    pub fn open_picture(&mut self, width: u32, height: u32) -> Result<(), JsValue> {
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
        let incoming = self.incoming_picture.take().ok_or_else(Trouble::no_picture)?;
        match incoming.add(&self.viewport, rgba)? {
            Ok(whole) => self.next_picture = Some(whole),
            Err(part) => self.incoming_picture = Some(part),
        }
        Ok(())
    }

    /// Opens a face of the picture that was opened last: MediaPipe's normalised landmarks (468 × 3) found in a photo of
    /// `width` × `height` px, and the colour under each landmark (468 × 3, sRGB). What was open before is kept if this
    /// one cannot be opened.
    ///
    /// # Errors
    /// `bad-face`.
    #[wasm_bindgen(js_name = openFace)]
    pub fn open_face(&mut self, landmarks: &[f32], width: u32, height: u32, colours: &[u8]) -> Result<(), JsValue> {
        let picture = self.next_picture.clone().ok_or_else(Trouble::no_picture)?;
        let input = FaceInput {
            landmarks: landmarks.as_chunks::<3>().0,
            width,
            height,
            colours: colours.as_chunks::<3>().0,
            picture: picture.photo.clone(),
        };
        Ok(self.open(input, picture)?)
    }

    /// Shows the empty state: the canonical face as a slowly turning wireframe.
    ///
    /// # Errors
    /// `device-lost`.
    #[wasm_bindgen(js_name = showCanonical)]
    pub fn show_canonical(&mut self) -> Result<(), JsValue> {
        self.session = None;
        self.picture = None;
        self.drag = None;
        self.pointed = None;
        self.show_mesh()?;
        self.viewport.stage_mut().frame(&canonical_positions_m());
        self.viewport.stage_mut().camera_mut().turn(-0.5);
        Ok(())
    }

    /// The canvas' size in device pixels, and how many of them make a CSS pixel.
    pub fn resize(
        &mut self,
        #[wasm_bindgen(js_name = widthPx)] width_px: u32,
        #[wasm_bindgen(js_name = heightPx)] height_px: u32,
        #[wasm_bindgen(js_name = pixelRatio)] pixel_ratio: Option<f64>,
    ) {
        self.viewport.resize(width_px, height_px);
        let ratio = pixel_ratio.filter(|ratio| ratio.is_finite() && *ratio > 0.0);
        self.viewport.stage_mut().set_pixel_ratio(ratio.unwrap_or(1.0));
    }

    /// Draws if something changed; true asks for another frame. `timeMs` is what `requestAnimationFrame` tells.
    ///
    /// # Errors
    /// `device-lost`.
    pub fn draw(&mut self, #[wasm_bindgen(js_name = timeMs)] time_ms: f64) -> Result<bool, JsValue> {
        Ok(self.viewport.draw(time_ms).map_err(Trouble::from)?)
    }
}

impl Studio {
    pub(crate) fn new(viewport: Viewport) -> Self {
        Self {
            viewport,
            session: None,
            picture: None,
            next_picture: None,
            incoming_picture: None,
            choices: Choices::default(),
            hand: Hand::default(),
            pointed: None,
            drag: None,
            wishes: Wishes {
                paint: Paint::default(),
                wireframe: Wireframe::default(),
                background: Background::default(),
                turntable_deg_per_s: 0.0,
                triangulation: Triangulation::Tessellation,
                density: 0,
                motion: Motion::Usual,
            },
        }
    }

    /// The open face.
    pub(crate) fn session(&self) -> Outcome<&Session> {
        self.session.as_ref().ok_or_else(Trouble::no_face)
    }

    /// The open face, with the choices that its edits depend on.
    pub(crate) fn session_mut(&mut self) -> Outcome<(&mut Session, &mut Choices)> {
        let session = self.session.as_mut().ok_or_else(Trouble::no_face)?;
        Ok((session, &mut self.choices))
    }

    fn open(&mut self, input: FaceInput<'_>, picture: OpenPicture) -> Outcome<()> {
        let face = FaceModel::new(input, self.wishes.triangulation)?;
        let mut session = Session::new(face)?;
        if self.wishes.density > 0 {
            session.set_density(self.wishes.density, self.hand, &self.choices)?;
            session.prepare(self.hand, &self.choices)?;
        }
        self.choices.pins.clear();
        self.session = Some(session);
        self.picture = Some(picture);
        self.drag = None;
        self.pointed = None;
        self.show_mesh()?;
        let (viewport, session) = (&mut self.viewport, self.session.as_ref().ok_or_else(Trouble::no_face)?);
        viewport.stage_mut().frame(session.document.positions());
        if self.wishes.motion == Motion::Usual {
            viewport.arrive_from(&flat(session))?;
        }
        Ok(())
    }

    /// Gives the viewport the mesh that is to be seen, after the mesh itself has changed.
    pub(crate) fn show_mesh(&mut self) -> Outcome<()> {
        match &self.session {
            Some(session) => {
                let picture = self.picture.as_ref().map(|picture| &picture.on_gpu);
                show_session(&mut self.viewport, session, picture)?;
            }
            None => {
                let topology = Triangulation::Canonical.topology();
                let positions_m = canonical_positions_m();
                self.viewport.show(&MeshInput {
                    topology: &topology,
                    positions_m: &positions_m,
                    colours_srgb: &[],
                    uvs: &[],
                    picture: None,
                })?;
            }
        }
        self.show_wishes();
        self.show_shape()
    }

    /// Follows what the page asked for: the empty state has a look of its own.
    pub(crate) fn show_wishes(&mut self) {
        let wishes = self.wishes;
        let is_empty = self.session.is_none();
        let stage = self.viewport.stage_mut();
        let idle_turn = if wishes.motion == Motion::Usual { IDLE_TURN_DEG_PER_S } else { 0.0 };
        stage.set_turntable(if is_empty { idle_turn } else { wishes.turntable_deg_per_s });
        let look = stage.look_mut();
        look.background = if is_empty { Background::Transparent } else { wishes.background };
        look.paint = if is_empty { Paint::Bare } else { wishes.paint };
        look.wireframe = if is_empty { Wireframe::Shown } else { wishes.wireframe };
    }

    /// Follows the document after an entry of its history, or what is held, has changed.
    pub(crate) fn show_shape(&mut self) -> Outcome<()> {
        if let Some(session) = &self.session {
            self.viewport.set_positions(session.document.committed())?;
            self.viewport.set_fields(session.follow_fields())?;
        }
        self.show_marks();
        self.show_offset()
    }

    /// Follows one tick of an edit: three numbers go to the GPU, unless details turn.
    pub(crate) fn show_offset(&mut self) -> Outcome<()> {
        let is_moving = self.session.as_ref().is_some_and(Session::is_moving);
        let turning = self.session.as_ref().filter(|session| is_moving && session.turns_details());
        let offsets_m = match (turning, &self.session) {
            (None, Some(session)) => session.follow_offsets_m(),
            _ => [DVec3::ZERO; 2],
        };
        if let Some(session) = turning {
            self.viewport.set_positions(session.document.positions())?;
        }
        self.viewport.stage_mut().set_offsets_m(offsets_m);
        let glow = if is_moving { GLOW } else { 0.0 };
        if self.viewport.stage().look().glow != glow {
            self.viewport.stage_mut().look_mut().glow = glow;
        }
        match &self.session {
            Some(session) if self.wishes.paint == Paint::Scalar => Ok(self.viewport.set_scalars(&session.stretch())?),
            _ => Ok(()),
        }
    }

    pub(crate) fn show_marks(&mut self) {
        let stage = self.viewport.stage_mut();
        let Some(session) = &self.session else {
            stage.set_marks(Vec::new());
            stage.set_gizmo(None);
            stage.set_hovered(None);
            return;
        };
        // A slider has its own handles and anchors, and shows by its glow alone.
        let selection = session.selection().filter(|_| session.slider().is_none());
        let anchors = if selection.is_some() { session.document.anchors() } else { &[] };
        let pins = match self.choices.anchors {
            AnchorChoice::Explicit(_) => &[],
            _ => self.choices.pins.as_slice(),
        };
        let regions = selection.iter().chain(&self.pointed).filter_map(|selection| match selection {
            Selection::Region(region) => Some(region.vertices()),
            Selection::Landmark(_) | Selection::Point { .. } => None,
        });
        let region: Vec<u32> = regions.flatten().collect();
        let middle = selection.map(Selection::middle);
        let mark = |kind| move |&vertex: &u32| Mark { vertex, kind };
        let anchors = anchors.iter().filter(|anchor| !pins.contains(anchor)).map(mark(MarkKind::Square));
        let shown = |pin: &&u32| (**pin as usize) < session.document.rest().len();
        let marks = anchors
            .chain(pins.iter().filter(shown).map(mark(MarkKind::Pin)))
            .chain(region.iter().map(mark(MarkKind::Speck)));
        stage.set_marks(marks.chain(middle.iter().map(mark(MarkKind::Ring))).collect());
        stage.set_gizmo(middle);
        let is_mirrored = middle.is_some() && self.choices.mirror == Mirror::On && session.can_mirror();
        let mirror_plane = if is_mirrored { MirrorPlane::Shown } else { MirrorPlane::Hidden };
        if stage.look().mirror_plane != mirror_plane {
            stage.look_mut().mirror_plane = mirror_plane;
        }
    }

    /// Whether it is landmarks that a click or a drag takes, alone or with their region.
    pub(crate) fn takes_landmarks(&self) -> bool {
        let density = self.session.as_ref().map_or(0, |session| session.document.density());
        self.hand != Hand::Point || density == 0
    }

    /// What a click or a drag takes at a place on the canvas.
    pub(crate) fn vertex_at(&self, place_px: DVec2) -> Option<u32> {
        let positions_m = self.session.as_ref()?.document.positions();
        let vertex = self.viewport.pick(place_px, positions_m)?;
        if !self.takes_landmarks() {
            return Some(vertex);
        }
        let at_m = positions_m[vertex as usize];
        let landmarks = positions_m.iter().take(LANDMARK_COUNT).zip(0..);
        landmarks.min_by(|(one, _), (other, _)| at_m.distance(**one).total_cmp(&at_m.distance(**other))).map(|(_, v)| v)
    }
}

impl Studio {
    /// The point in hand, if a place on the canvas where the mesh shows `vertex` is within its ring: on a dense mesh, its
    /// neighbours are there, too.
    pub(crate) fn point_beside(&self, vertex: u32, place_px: DVec2) -> Option<u32> {
        let session = self.session.as_ref()?;
        let Some(Selection::Point { vertex: held, .. }) = session.selection() else { return None };
        let stage = self.viewport.stage();
        let [held_m, vertex_m] = [held, vertex].map(|v| session.document.committed().get(v as usize).copied());
        let (held_m, vertex_m, camera) = (held_m?, vertex_m?, stage.camera());
        let reach_px = RING_PX * stage.pixel_ratio();
        let is_near = camera.project(held_m)?.distance(place_px) <= reach_px;
        // On the other side of the face, it would only seem to be near.
        let depth_m = (camera.eye_m() - held_m).dot(camera.back());
        let is_beside = held_m.distance(vertex_m) <= 2.0 * reach_px * camera.m_per_px_at_distance(depth_m);
        (is_near && is_beside).then_some(held)
    }
}

fn show_session(viewport: &mut Viewport, session: &Session, picture: Option<&PictureOnGpu>) -> Outcome<()> {
    let uvs = session.uvs();
    viewport.show(&MeshInput {
        topology: session.document.topology(),
        positions_m: session.document.committed(),
        colours_srgb: &session.colours_srgb(&uvs),
        uvs: &uvs,
        picture,
    })?;
    Ok(viewport.set_before(session.document.rest())?)
}

/// The landmarks as they lie on the photo: in one plane, as large as the face and where it is.
fn flat(session: &Session) -> Vec<DVec3> {
    let image = session.document.from_cage(session.face.positions_image());
    let [width, height] = session.face.photo_size_px().map(f64::from);
    let aspect = height / width;
    let upright = |p: &DVec3| DVec2::new(p.x, -p.y * aspect);
    let middle = |sum: DVec3| sum / image.len() as f64;
    let image_middle = upright(&middle(image.iter().copied().sum()));
    let model_middle = middle(session.document.positions().iter().copied().sum());
    let spread = |sum: f64| (sum / image.len() as f64).sqrt();
    let image_spread = spread(image.iter().map(|p| upright(p).distance_squared(image_middle)).sum());
    let model_spread =
        spread(session.document.positions().iter().map(|p| (*p - model_middle).truncate().length_squared()).sum());
    let scale = model_spread / image_spread.max(f64::MIN_POSITIVE);
    image.iter().map(|p| model_middle + ((upright(p) - image_middle) * scale).extend(0.0)).collect()
}
