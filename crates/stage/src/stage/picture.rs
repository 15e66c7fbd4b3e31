use glam::DVec2;

use super::Stage;
use crate::{PicturePlane, Pinhole, Scene};

/// How long the picture takes to come or go.
const FADE_MS: f64 = 300.0;

/// The picture that was taken of the mesh.
impl Stage {
    /// The picture that was taken of the mesh, and where it lies; none takes it off the stage.
    pub fn set_picture(&mut self, picture: Option<PicturePlane>) {
        if self.picture != picture {
            self.picture = picture;
            self.changed = true;
            match picture {
                Some(plane) if self.scene == Scene::Picture => self.camera.frame_picture(plane),
                _ => self.show(Scene::Solid),
            }
        }
    }

    /// The next picture of a camera stream, at once in the place of the one before ([`change_picture`](crate::Camera::change_picture)).
    pub fn change_picture(&mut self, picture: PicturePlane, pinhole: Pinhole) {
        self.picture = Some(picture);
        self.camera_mut().change_picture(picture, pinhole);
    }

    /// What is on the stage.
    pub fn scene(&self) -> Scene {
        self.scene
    }

    /// Puts the picture on the stage, or takes it off and shows the mesh as at first: the camera glides there, and the picture
    /// comes or goes. Nothing comes without a picture.
    pub fn show(&mut self, scene: Scene) {
        match self.picture.filter(|_| scene == Scene::Picture) {
            Some(picture) => {
                self.scene = scene;
                self.camera_mut().frame_picture(picture);
            }
            None => {
                self.scene = Scene::Solid;
                self.camera_mut().leave_picture();
            }
        }
    }

    /// Takes the picture off the stage while the mesh stays as it faces the viewer.
    pub fn turn_out_of_picture(&mut self) {
        self.scene = Scene::Solid;
        self.camera_mut().turn_out_of_picture();
    }

    /// How much of the picture is seen, 0..1.
    pub fn picture_share(&self) -> f64 {
        self.picture_share
    }

    /// The place in the picture, in its px, that is seen at a place on the canvas; none beside it.
    pub fn picture_px(&self, place_px: DVec2) -> Option<DVec2> {
        let picture = self.picture?;
        let place = picture.px_under(&self.camera.ray(place_px))?;
        (place.cmpge(DVec2::ZERO).all() && place.cmple(picture.size_px).all()).then_some(place)
    }

    /// How many px of the canvas one of the picture has, at a place of the picture; none where it is not seen.
    pub fn px_per_picture_px(&self, picture_px: DVec2) -> Option<f64> {
        let place = self.place_of(picture_px)?;
        self.place_of(picture_px + DVec2::X).map(|beside| beside.distance(place))
    }

    /// Where a place in the picture is seen, in px of the canvas.
    pub fn place_of(&self, picture_px: DVec2) -> Option<DVec2> {
        self.camera.project(self.picture?.at(picture_px))
    }

    /// Is where it is going at once: the picture is there, or gone.
    pub fn settle_picture(&mut self) {
        self.picture_share = f64::from(u8::from(self.scene == Scene::Picture));
        self.changed = true;
    }

    /// The picture comes or goes, and is drawn while it does.
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
