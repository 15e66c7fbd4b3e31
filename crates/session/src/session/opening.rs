use rosto::SavedFace;
use rosto_face::canonical_positions_m;
use rosto_stage::{Scene, Visibility};

use super::{Result, Session, preferences};
use crate::gesture::{Gesture, Hovered};
use crate::open_face::OpenFace;
use crate::saved;
use crate::{Changed, EditOptions, Motion, Selection, SelectionMode, SessionError};

/// Opening and closing faces.
impl Session {
    pub(super) fn open(&mut self, face: SavedFace) -> Result {
        let mut face = saved::opened(face, (self.view.triangulation, self.view.density))?;
        face.set_falloff_band(self.view.falloff_band);
        prepare(&mut face, self.mode, &self.edit_options, self.seeds.peek());
        self.face = Some(face);
        self.textures.restart();
        (self.gesture, self.hovered, self.brush_px, self.card_px) = (Gesture::Idle, Hovered::default(), None, None);
        self.panel = self.panel.for_another_face();
        self.view.print = Visibility::Hidden;
        self.view.show_on(&mut self.stage, false);
        self.show_backdrop();
        self.see_as_edited();
        self.frame_in_photo();
        self.stage.show(self.view.scene);
        self.stage.settle_picture();
        if self.view.motion == Motion::Usual && self.view.scene == Scene::Solid && self.live_preview.is_none() {
            self.stage.start_arrival();
        }
        Ok(Changed::Mesh)
    }

    /// Frames the face with the photo's camera: the photo's plane depends on the framed centre, and framing depends on
    /// the photo's camera.
    fn frame_in_photo(&mut self) {
        self.stage.camera_mut().set_pinhole(None);
        self.frame();
        self.show_pinhole();
        self.frame();
    }

    /// Adds or removes a photo of the open face; shows the leading one if it changed.
    pub(super) fn change_photos(
        &mut self,
        change: impl FnOnce(&mut OpenFace, &EditOptions) -> std::result::Result<bool, SessionError>,
    ) -> Result {
        let face = self.face.as_mut().ok_or(SessionError::NoFace)?;
        let is_another = change(face, &self.edit_options)?;
        self.new_mesh();
        self.textures.restart();
        match is_another {
            true => self.frame_in_photo(),
            false => self.show_pinhole(),
        }
        Ok(Changed::Mesh)
    }

    pub(super) fn close(&mut self) -> Result {
        (self.face, self.brush_px, self.card_px, self.view.print) = (None, None, None, Visibility::Hidden);
        self.end_live_preview();
        self.see_as_edited();
        (self.gesture, self.hovered) = (Gesture::Idle, Hovered::default());
        self.show_empty();
        Ok(Changed::Mesh)
    }

    /// Ends a comparison, which belongs to the previous face.
    fn see_as_edited(&mut self) {
        let settings = self.stage.render_settings_mut();
        (settings.before, settings.wipe) = (0.0, None);
    }

    pub(super) fn show_empty(&mut self) {
        self.stage.camera_mut().set_pinhole(None);
        self.stage.set_picture(None);
        self.stage.settle_picture();
        self.view.show_on(&mut self.stage, true);
        self.stage.frame(&canonical_positions_m());
        self.stage.camera_mut().turn(-0.5);
    }

    pub(super) fn frame(&mut self) {
        // Frame the unedited face, so that a reopened face is framed as before.
        if let Some(face) = &self.face {
            self.stage.frame(face.document().rest());
        }
    }

    /// Replaces settings and view with those in the text.
    pub(super) fn prefer(&mut self, text: &str) -> Result {
        let preferences = preferences::read(text, &self.view)?;
        self.finish(OpenFace::commit)?;
        (self.mode, self.edit_options, self.view) = (preferences.mode, preferences.edit_options, preferences.view);
        let look = self.stage.render_settings_mut();
        (look.light, look.dots) = (preferences.light, preferences.dots);
        (look.shading, look.picture_light) = (preferences.shading, preferences.picture_light);
        self.stage.camera_mut().set_lens(preferences.lens);
        self.view.show_on(&mut self.stage, self.face.is_none());
        self.show_scene();
        // The open face keeps its mesh; the preference applies to the next one.
        let Some(face) = &mut self.face else { return Ok(Changed::Document) };
        face.set_falloff_band(self.view.falloff_band);
        let wanted = face.selection_in(self.mode);
        face.select(wanted, &self.edit_options, self.seeds.draw());
        Ok(Changed::Document)
    }
}

/// Builds the factorisation that all points share, so that selecting the first one is fast.
pub(super) fn prepare(face: &mut OpenFace, mode: SelectionMode, edit_options: &EditOptions, seed: u64) {
    let level = face.document().density();
    if mode == SelectionMode::Point && level > 0 {
        let any = Selection::Point { level, vertex: 0 };
        let spec = edit_options.spec(any, face.pins(), seed, face.document());
        // An error is reported when a point is selected.
        let _ = face.document_mut().prepare(spec);
        face.prepare(edit_options);
    }
}
