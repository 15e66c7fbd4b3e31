use glam::DVec2;
use rosto_session::{BRUSH_PX, Changed, Intent, OpenFace};
use rosto_studio::{DEFAULT_FALLOFF_BAND, FALLOFF_BAND_SHARES};
use rosto_viewport::PhotoLayerInput;
use rosto_warp::WarpMesh;
use wasm_bindgen::prelude::*;

use crate::Studio;
use crate::error::Result;
use crate::modes::ChangeName;
use crate::picture::OpenPicture;
use crate::state::StudioRange;

/// What moves in the photo, for whoever draws all of it.
#[wasm_bindgen(getter_with_clone)]
pub struct PhotoWarp {
    /// Where its points are in the upright photo, x and y in turn, in px.
    #[wasm_bindgen(readonly, js_name = fromPx)]
    pub from_px: Vec<f64>,
    /// Where they go.
    #[wasm_bindgen(readonly, js_name = toPx)]
    pub to_px: Vec<f64>,
    /// Its triangles, three points each.
    #[wasm_bindgen(readonly)]
    pub triangles: Vec<u32>,
}

/// The face in its photo.
#[wasm_bindgen]
impl Studio {
    /// How far around the face the photo gives way, as a share of the face's longer side.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setFalloffBand)]
    pub fn set_falloff_band(&mut self, share: f64) -> Result<ChangeName, JsValue> {
        self.act(Intent::FalloffBand(share))
    }

    /// Between which shares that is.
    #[wasm_bindgen(getter, js_name = falloffBandRange)]
    pub fn falloff_band_range(&self) -> StudioRange {
        StudioRange {
            min: *FALLOFF_BAND_SHARES.start(),
            max: *FALLOFF_BAND_SHARES.end(),
            step: 0.01,
            neutral: DEFAULT_FALLOFF_BAND,
        }
    }

    /// Shows the face in its photo as seen from so many metres; undefined as it was taken.
    ///
    /// # Errors
    /// `no-face` or `bad-number`.
    #[wasm_bindgen(js_name = setSeenFrom)]
    pub fn set_seen_from(&mut self, distance_m: Option<f64>) -> Result<ChangeName, JsValue> {
        self.act(Intent::SeenFrom(distance_m))
    }

    /// Takes the brush that keeps parts of the photo in hand, by its radius in CSS px, or puts it down.
    ///
    /// # Errors
    /// `bad-number`.
    #[wasm_bindgen(js_name = setBrush)]
    pub fn set_brush(&mut self, radius_px: Option<f64>) -> Result<ChangeName, JsValue> {
        self.act(Intent::Brush(radius_px))
    }

    /// How fine and how coarse the brush can be, in CSS px.
    #[wasm_bindgen(getter, js_name = brushRange)]
    pub fn brush_range(&self) -> StudioRange {
        StudioRange { min: BRUSH_PX[0], max: BRUSH_PX[1], step: 1.0, neutral: 28.0 }
    }

    /// Takes all strokes of the brush away.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = keepNothing)]
    pub fn keep_nothing(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::ClearStrokes)
    }

    /// Turns the face to where an edit in depth is seen.
    ///
    /// # Errors
    /// `no-face`.
    #[wasm_bindgen(js_name = showDepth)]
    pub fn show_depth(&mut self) -> Result<ChangeName, JsValue> {
        self.act(Intent::ShowDepth)
    }

    /// Data of the photo alone, as text for `openWork`; undefined while no face is open.
    #[wasm_bindgen(getter, js_name = photoEdit)]
    pub fn photo_edit(&self) -> Option<String> {
        self.session.face().map(|face| face.photo_json())
    }

    /// Middles and radii of what of the photo is kept, in device pixels of the canvas: x, y and radius in turn.
    #[wasm_bindgen(js_name = keptOnCanvas)]
    pub fn protected_on_canvas(&self) -> Vec<f32> {
        self.session.protected_on_canvas().into_iter().flatten().map(|px| px as f32).collect()
    }

    /// Whether the photo waits for `followPhoto`: on the stage it follows by itself, but for what asks for a factorisation, which
    /// takes a task of its own.
    #[wasm_bindgen(getter, js_name = photoIsDue)]
    pub fn photo_is_due(&self) -> bool {
        self.photo_shown.is_due || self.photo_waits()
    }

    /// Lets the photo follow the edits, and shows it so.
    ///
    /// # Errors
    /// `device-lost`.
    #[wasm_bindgen(js_name = followPhoto)]
    pub fn follow_photo(&mut self) -> Result<(), JsValue> {
        self.catch_up_photo()?;
        self.session.stage_mut().request_frame();
        Ok(())
    }

    /// By how much the photo stays behind the edits at most, in px of the photo, so that nothing in it folds.
    #[wasm_bindgen(getter, js_name = photoLimitedPx)]
    pub fn photo_limited_px(&self) -> f64 {
        self.session.face().map_or(0.0, |face| face.photo().limited_px())
    }

    /// Width and height of the upright photo in px; empty while no face is open.
    #[wasm_bindgen(getter, js_name = photoSize)]
    pub fn photo_size(&self) -> Vec<u32> {
        self.session.face().map(|face| face.model().photo_size_px().to_vec()).unwrap_or_default()
    }

    /// Where the edits have taken the landmarks, and the irises if they were found, on the photo: x and y in turn, in shares of its
    /// size; undefined while no face is open.
    #[wasm_bindgen(js_name = photoLandmarks)]
    pub fn photo_landmarks(&self) -> Option<Vec<f32>> {
        let places = self.session.face()?.landmarks_in_edited_photo();
        Some(places.into_iter().flat_map(|place| place.as_vec2().to_array()).collect())
    }

    /// What moves in the photo; undefined where nothing does.
    #[wasm_bindgen(js_name = photoWarp)]
    pub fn photo_warp(&mut self) -> Option<PhotoWarp> {
        self.session.update_photo_warp();
        let (warp_mesh, _) = self.session.face()?.photo().warp_mesh()?;
        let flat = |places: &[DVec2]| places.iter().flat_map(|place| place.to_array()).collect();
        Some(PhotoWarp {
            from_px: flat(&warp_mesh.from_px),
            to_px: flat(&warp_mesh.to_px),
            triangles: warp_mesh.triangles.as_flattened().to_vec(),
        })
    }
}

impl Studio {
    /// The photo as it was taken, for a face that has just come.
    pub(crate) fn show_photo_as_taken(&mut self) {
        self.photo_shown.version = None;
        let still = WarpMesh::default();
        let face_and_picture = self.session.face().zip(self.picture.as_ref());
        self.viewport
            .show_photo_layer(face_and_picture.map(|(face, picture)| photo_layer(face, picture, &still)).as_ref());
    }

    /// The photo is to follow what has changed, once a frame at most.
    pub(crate) fn note_for_photo(&mut self, changed: Changed) {
        self.photo_shown.is_due |= changed >= Changed::Tick && self.session.face().is_some();
    }

    /// What is about to be drawn shows where the photo's places are now, unless that asks for a factorisation first.
    pub(crate) fn show_photo(&mut self) -> Result<()> {
        let is_seen = self.session.stage().picture_share() > 0.0;
        if self.photo_shown.is_due && is_seen && !self.photo_waits() { self.catch_up_photo() } else { Ok(()) }
    }

    fn photo_waits(&self) -> bool {
        self.session.face().is_some_and(|face| face.photo().needs_factorisation())
    }

    fn catch_up_photo(&mut self) -> Result<()> {
        self.photo_shown.is_due = false;
        self.session.update_photo_warp();
        self.show_photo_layer()
    }

    fn show_photo_layer(&mut self) -> Result<()> {
        let (Some(face), Some(picture)) = (self.session.face(), &self.picture) else { return Ok(()) };
        // The mirror's camera stream lies where the photo does.
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
