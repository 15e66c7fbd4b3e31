use glam::{DVec2, DVec3};
use rosto_face::{Camera, DISTANCES_M};
use rosto_stage::{Background, NamedView, PicturePlane, Pinhole, Scene, Visibility};
use rosto_studio::{DEFAULT_FALLOFF_BAND, FALLOFF_BAND_SHARES};
use rosto_warp::Dab;

use super::{Result, Session};
use crate::error::within;
use crate::gesture::Gesture;
use crate::open_face::OpenFace;
use crate::range::Range;
use crate::strokes::Strokes;
use crate::{Changed, Motion, SessionError};

/// Range of the brush's radius, in CSS px.
pub const BRUSH_PX: Range = Range { min: 4.0, max: 120.0, step: 1.0, neutral: 28.0 };

/// Range of the falloff band, as a share of the face's longer side.
pub const FALLOFF_BAND: Range = Range {
    min: *FALLOFF_BAND_SHARES.start(),
    max: *FALLOFF_BAND_SHARES.end(),
    step: 0.01,
    neutral: DEFAULT_FALLOFF_BAND,
};

/// Angle by which the view is turned to show edits in depth, in radians.
const ASIDE: f64 = 0.9;

/// The photo on the stage, and edits of the photo alone.
impl Session {
    /// Shows the photo's camera and plane, in which the mesh matches the photo.
    pub(super) fn show_pinhole(&mut self) {
        // The live preview sets them with each frame.
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
        match scene {
            Scene::Solid => (self.brush_px, self.card_px) = (None, None),
            Scene::Picture => self.show_print(Visibility::Hidden),
        }
        self.show_scene();
        Changed::Document
    }

    pub(super) fn show_scene(&mut self) {
        if self.face.is_some() {
            self.stage.show(self.view.scene);
        }
        if self.view.motion == Motion::Reduced {
            self.stage.settle_picture();
        }
    }

    /// Switches from the photo to the 3D face.
    pub(super) fn leave_photo(&mut self) -> Changed {
        match self.view.scene {
            Scene::Picture if self.face.is_some() => self.set_scene(Scene::Solid),
            _ => Changed::Nothing,
        }
    }

    /// Shows the photo behind the 3D face, unless the background has a colour or a camera stream replaces the photo.
    pub(super) fn show_backdrop(&mut self) {
        let is_free = self.view.background == Background::Ground && self.live_preview.is_none();
        self.stage.set_backdrop(if is_free { self.view.backdrop } else { Visibility::Hidden });
    }

    pub(super) fn set_falloff_band(&mut self, falloff_band: f64) -> Result {
        self.view.falloff_band = within("the falloff band's share", falloff_band, FALLOFF_BAND.min, FALLOFF_BAND.max)?;
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

    /// Sets the brush, which paints only on the photo.
    pub(super) fn set_brush(&mut self, radius_px: Option<f64>) -> Result {
        // Strokes cannot be placed on a camera stream.
        let radius_px = radius_px.filter(|_| self.live_preview.is_none());
        self.card_px = None;
        self.brush_px = radius_px.map(|px| within("the brush in px", px, BRUSH_PX.min, BRUSH_PX.max)).transpose()?;
        if self.brush_px.is_some() && self.view.scene != Scene::Picture {
            self.set_scene(Scene::Picture);
        }
        self.hover(None);
        Ok(Changed::Document)
    }

    /// Begins a stroke if the position is on the photo; the brush grabs nothing else.
    pub(super) fn paint(&mut self, position_px: DVec2, brush_px: f64) -> Changed {
        self.gesture = Gesture::Idle;
        let dab = self.dab(position_px, brush_px * self.stage.pixel_ratio());
        if let (Some(face), Some(dab)) = (&mut self.face, dab) {
            self.gesture = Gesture::Painting;
            face.change_strokes(|strokes| strokes.begin(dab));
        }
        Changed::View
    }

    /// The part of the photo that a brush covers, for a position and radius in px of the canvas.
    fn dab(&self, position_px: DVec2, radius_px: f64) -> Option<Dab> {
        let centre_px = self.stage.picture_px(position_px)?;
        Some(Dab { centre_px, radius_px: radius_px / self.stage.px_per_picture_px(centre_px)? })
    }

    pub(super) fn continue_stroke(&mut self, position_px: DVec2) -> Changed {
        let photo_px = self.stage.picture_px(position_px);
        if let (Some(face), Some(photo_px)) = (&mut self.face, photo_px) {
            face.change_strokes(|strokes| strokes.extend(photo_px));
        }
        Changed::View
    }

    pub(super) fn change_strokes(&mut self, change: impl FnOnce(&mut Strokes)) -> Result {
        self.gesture = Gesture::Idle;
        self.face.as_mut().ok_or(SessionError::NoFace)?.change_strokes(change);
        Ok(Changed::Document)
    }

    /// Leaves the photo and turns to the side, so that edits in depth are visible.
    pub(super) fn show_depth(&mut self) -> Result {
        self.open_face()?;
        self.set_scene(Scene::Solid);
        let camera = self.stage.camera_mut();
        camera.look(NamedView::Front);
        camera.turn_towards(ASIDE);
        Ok(Changed::Document)
    }

    /// Radius of the brush in CSS px, if it is in use.
    pub fn brush_px(&self) -> Option<f64> {
        self.brush_px
    }

    /// Updates the photo's warp; see [`OpenFace::update_photo_warp`]. Called when the photo is displayed.
    pub fn update_photo_warp(&mut self) {
        if let Some(face) = &mut self.face {
            face.update_photo_warp();
        }
    }

    /// Centres and radii of the protected dabs, in px of the canvas; of a card's corners while it is being marked.
    pub fn protected_on_canvas(&self) -> Vec<[f64; 3]> {
        if self.card_px.is_some() {
            return self.marks_on_canvas().collect();
        }
        let circle = |dab: &Dab| {
            let centre = self.stage.canvas_px(dab.centre_px)?;
            Some([centre.x, centre.y, dab.radius_px * self.stage.px_per_picture_px(dab.centre_px)?])
        };
        let face = self.face.as_ref();
        face.map(|face| face.photo().strokes().dabs().filter_map(circle).collect()).unwrap_or_default()
    }
}

/// Plane of a photo in the model: through the centre of the face, perpendicular to the camera's axis.
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
