use glam::DVec2;

use super::Stage;
use crate::{NamedView, PicturePlane, Pinhole, Scene, Visibility};

/// Duration of the picture's fade.
const FADE_MS: f64 = 300.0;

/// Opacity of the picture behind the mesh.
pub(super) const BACKDROP_OPACITY: f64 = 0.45;

/// The picture taken of the mesh.
impl Stage {
    /// Sets or removes the picture and its position in the model.
    pub fn set_picture(&mut self, picture: Option<PicturePlane>) {
        if self.picture != picture {
            self.picture = picture;
            self.changed = true;
            self.show(if picture.is_some() { self.scene } else { Scene::Solid });
        }
    }

    /// Shows the picture behind the mesh, dimmed, while the mesh is near the pinhole's pose; frames them together.
    pub fn set_backdrop(&mut self, backdrop: Visibility) {
        if self.backdrop != backdrop {
            self.backdrop = backdrop;
            self.show(self.scene);
        }
    }

    /// Replaces the picture by the next frame of a camera stream ([`change_picture`](crate::Camera::change_picture)).
    pub fn change_picture(&mut self, picture: PicturePlane, pinhole: Pinhole) {
        self.picture = Some(picture);
        self.camera_mut().change_picture(picture, pinhole);
    }

    /// Content of the stage.
    pub fn scene(&self) -> Scene {
        self.scene
    }

    /// Shows the picture or the mesh in its initial view, with a glide and a fade. Without a picture, shows the mesh.
    pub fn show(&mut self, scene: Scene) {
        let is_another = self.scene != scene;
        self.scene = if self.picture.is_some() { scene } else { Scene::Solid };
        let framed = self.picture.filter(|_| self.scene == Scene::Picture || self.backdrop == Visibility::Shown);
        self.camera_mut().frame_picture(framed);
        // The picture has one direction, whichever the mesh was seen from.
        if is_another {
            self.camera.look(NamedView::Reset);
        }
    }

    /// Share of the picture over the mesh, 0..1.
    pub fn picture_share(&self) -> f64 {
        self.picture_share
    }

    /// Opacity of the picture, over the mesh or behind it, 0..1.
    pub fn picture_opacity(&self) -> f64 {
        self.picture_share + (1.0 - self.picture_share) * BACKDROP_OPACITY * self.backdrop_share()
    }

    /// Visibility of the picture behind the mesh, 0..1.
    pub(super) fn backdrop_share(&self) -> f64 {
        let is_shown = self.backdrop == Visibility::Shown && self.picture.is_some();
        if is_shown { 1.0 - self.camera.turned_out() } else { 0.0 }
    }

    /// Position in the picture under a position on the canvas, in px; `None` outside the picture.
    pub fn picture_px(&self, position_px: DVec2) -> Option<DVec2> {
        let picture = self.picture?;
        let position = picture.px_under(&self.camera.ray(position_px))?;
        (position.cmpge(DVec2::ZERO).all() && position.cmple(picture.size_px).all()).then_some(position)
    }

    /// Scale from picture px to canvas px at a position of the picture.
    pub fn px_per_picture_px(&self, picture_px: DVec2) -> Option<f64> {
        let position = self.canvas_px(picture_px)?;
        self.canvas_px(picture_px + DVec2::X).map(|neighbour| neighbour.distance(position))
    }

    /// Position of a point of the picture on the canvas, in px.
    pub fn canvas_px(&self, picture_px: DVec2) -> Option<DVec2> {
        self.camera.project(self.picture?.at(picture_px))
    }

    /// Ends the fade at once.
    pub fn settle_picture(&mut self) {
        self.picture_share = f64::from(u8::from(self.scene == Scene::Picture));
        self.changed = true;
    }

    /// Advances the fade; returns whether it is running.
    pub(super) fn advance_picture(&mut self, seconds: f64) -> bool {
        let goal = f64::from(u8::from(self.scene == Scene::Picture));
        if self.is_arriving() || self.picture_share == goal {
            return false;
        }
        let step = if self.camera.glides() { 1e3 * seconds / FADE_MS } else { 1.0 };
        self.picture_share += (goal - self.picture_share).clamp(-step, step);
        true
    }
}
