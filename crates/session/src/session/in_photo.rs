use glam::{DVec2, DVec3};
use rosto_face::{Camera, DISTANCES_M};
use rosto_stage::{NamedView, PicturePlane, Pinhole, Scene};
use rosto_studio::FALLOFF_BAND_SHARES;
use rosto_warp::Dab;

use super::{Result, Session};
use crate::error::within;
use crate::gesture::Gesture;
use crate::open_face::OpenFace;
use crate::strokes::Strokes;
use crate::{Changed, Motion, SessionError};

/// The brush is no finer and no coarser than this, in CSS px.
pub const BRUSH_PX: [f64; 2] = [4.0, 120.0];

/// How far to the side a face is turned to show how deep an edit goes, in radians.
const ASIDE: f64 = 0.9;

/// The photo on the stage, and what is done to it alone.
impl Session {
    /// The photo's camera, in whose view mesh and photo coincide, and where it has the photo lie.
    pub(super) fn show_pinhole(&mut self) {
        // What the mirror shows comes with each frame.
        if self.live_preview.is_some() {
            return;
        }
        let seen_by = self.face.as_ref().map(OpenFace::seen_by);
        self.stage
            .camera_mut()
            .set_pinhole(seen_by.map(|camera| Pinhole { camera_from_model: camera.camera_from_model }));
        let centre_m = self.stage.camera().centre_m();
        self.stage.set_picture(
            self.face.as_ref().and_then(|face| plane(&face.seen_by(), face.model().photo_size_px(), centre_m)),
        );
    }

    pub(super) fn set_scene(&mut self, scene: Scene) -> Changed {
        self.view.scene = scene;
        if scene == Scene::Solid {
            self.brush_px = None;
        }
        self.show_scene();
        Changed::Document
    }

    pub(super) fn show_scene(&mut self) {
        if self.face.is_some() {
            self.stage.show(self.view.scene);
        }
        self.end_scene_change();
    }

    fn end_scene_change(&mut self) {
        if self.view.motion == Motion::Reduced {
            self.stage.settle_picture();
        }
        self.keep_in_frame();
    }

    /// Who turns the photo turns the face out of it.
    pub(super) fn leave_photo(&mut self) -> Changed {
        if self.face.is_some() && self.view.scene == Scene::Picture {
            (self.view.scene, self.brush_px) = (Scene::Solid, None);
            self.stage.turn_out_of_picture();
            self.end_scene_change();
            return Changed::Document;
        }
        Changed::Nothing
    }

    pub(super) fn set_falloff_band(&mut self, falloff_band: f64) -> Result {
        self.view.falloff_band =
            within("the falloff band's share", falloff_band, *FALLOFF_BAND_SHARES.start(), *FALLOFF_BAND_SHARES.end())?;
        if let Some(face) = &mut self.face {
            face.set_falloff_band(falloff_band);
        }
        Ok(Changed::Document)
    }

    pub(super) fn set_seen_from(&mut self, distance_m: Option<f64>) -> Result {
        let [nearest_m, farthest_m] = [*DISTANCES_M.start(), *DISTANCES_M.end()];
        let checked = distance_m.map(|value| within("the distance in m", value, nearest_m, farthest_m));
        let distance_m = checked.transpose()?;
        self.face.as_mut().ok_or(SessionError::NoFace)?.set_seen_from(distance_m);
        self.show_pinhole();
        Ok(Changed::Document)
    }

    /// The brush paints on the photo alone.
    pub(super) fn set_brush(&mut self, radius_px: Option<f64>) -> Result {
        // In a mirror nothing stays where it was painted.
        let radius_px = radius_px.filter(|_| self.live_preview.is_none());
        self.brush_px = radius_px.map(|px| within("the brush in px", px, BRUSH_PX[0], BRUSH_PX[1])).transpose()?;
        if self.brush_px.is_some() && self.view.scene != Scene::Picture {
            self.set_scene(Scene::Picture);
        }
        self.hover(None);
        Ok(Changed::Document)
    }

    /// Begins a stroke, if the place is on the photo: the brush takes hold of nothing else.
    pub(super) fn paint(&mut self, place_px: DVec2, brush_px: f64) -> Changed {
        self.gesture = Gesture::Idle;
        let dab = self.dab(place_px, brush_px * self.stage.pixel_ratio());
        if let (Some(face), Some(dab)) = (&mut self.face, dab) {
            self.gesture = Gesture::Painting;
            face.change_strokes(|strokes| strokes.begin(dab));
        }
        Changed::View
    }

    /// What a brush of that radius, in px of the canvas, covers of the photo at a place of the canvas.
    fn dab(&self, place_px: DVec2, radius_px: f64) -> Option<Dab> {
        let centre_px = self.stage.picture_px(place_px)?;
        Some(Dab { centre_px, radius_px: radius_px / self.stage.px_per_picture_px(centre_px)? })
    }

    pub(super) fn go_on_painting(&mut self, place_px: DVec2) -> Changed {
        let place = self.stage.picture_px(place_px);
        if let (Some(face), Some(place)) = (&mut self.face, place) {
            face.change_strokes(|strokes| strokes.go_on(place));
        }
        Changed::View
    }

    pub(super) fn change_strokes(&mut self, change: impl FnOnce(&mut Strokes)) -> Result {
        self.gesture = Gesture::Idle;
        self.face.as_mut().ok_or(SessionError::NoFace)?.change_strokes(change);
        Ok(Changed::Document)
    }

    /// Out of the photo and to the side, from where an edit in depth is seen.
    pub(super) fn show_depth(&mut self) -> Result {
        self.open_face()?;
        self.set_scene(Scene::Solid);
        let camera = self.stage.camera_mut();
        camera.look(NamedView::Front);
        camera.turn_towards(ASIDE);
        Ok(Changed::Document)
    }

    /// The brush in hand: its radius in CSS px.
    pub fn brush_px(&self) -> Option<f64> {
        self.brush_px
    }

    /// Lets the photo follow the edits, as [`OpenFace::follow_in_photo`] says; whoever shows the photo asks for it.
    pub fn follow_in_photo(&mut self) {
        if let Some(face) = &mut self.face {
            face.follow_in_photo();
        }
    }

    /// Middles and radii, in px of the canvas, of what of the photo is kept.
    pub fn kept_on_canvas(&self) -> Vec<[f64; 3]> {
        let circle = |dab: &Dab| {
            let middle = self.stage.place_of(dab.centre_px)?;
            Some([middle.x, middle.y, dab.radius_px * self.stage.px_per_picture_px(dab.centre_px)?])
        };
        let face = self.face.as_ref();
        face.map(|face| face.photo().strokes().dabs().filter_map(circle).collect()).unwrap_or_default()
    }
}

/// Where a photo lies in the model, on the plane through the middle of the face that its camera's axis meets at right angles.
pub(super) fn plane(camera: &Camera, photo_size_px: [u32; 2], centre_m: DVec3) -> Option<PicturePlane> {
    const STEP_M: f64 = 0.01;
    let model_from_camera = camera.camera_from_model.matrix3.transpose();
    let (right, up) = (model_from_camera.x_axis, model_from_camera.y_axis);
    let centre_px = camera.project(centre_m)?;
    let px_per_m = (camera.project(centre_m + right * STEP_M)?.x - centre_px.x) / STEP_M;
    let (right_m, down_m) = (right / px_per_m, -up / px_per_m);
    let origin_m = centre_m - right_m * centre_px.x - down_m * centre_px.y;
    let size_px = DVec2::from(photo_size_px.map(f64::from));
    (px_per_m > 0.0 && origin_m.is_finite()).then_some(PicturePlane { origin_m, right_m, down_m, size_px })
}
