use rosto_face::PoseFit;
use rosto_stage::{Pinhole, Sides};

use super::Session;
use super::in_photo::plane;
use crate::live_preview::pose_fit;
use crate::{LivePreview, SessionError};

/// The live preview: the open face's edits on a camera stream. Frames are no intents: they come by themselves, as time does, and change only what
/// is seen.
impl Session {
    /// What the live preview shows, while it does.
    pub fn live_preview(&self) -> Option<&LivePreview> {
        self.live_preview.as_ref()
    }

    /// Shows the next frame of a camera stream, of `size_px`, with the edits: 468 or 478 landmarks in MediaPipe's normalised convention, or
    /// none where no face is in it. The first frame begins the live preview. Sides are swapped in what is seen alone: the subject's left
    /// stays the subject's left.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] while none is open, [`SessionError::Face`] for landmarks that make none; the frame before stays.
    pub fn preview_frame(&mut self, landmarks: Option<&[[f32; 3]]>, size_px: [u32; 2]) -> Result<(), SessionError> {
        let face = self.open_face()?;
        if let Some(landmarks) = landmarks {
            rosto_face::check_landmarks(landmarks, size_px[0], size_px[1])?;
        }
        let pose_fit = pose_fit(face, landmarks, size_px)?;
        self.live_preview.get_or_insert_default().take(landmarks, size_px);
        self.show_live_preview(pose_fit);
        Ok(())
    }

    /// Brings edits that have changed to the frame that is shown.
    ///
    /// # Errors
    /// As [`Self::preview_frame`].
    pub fn follow_live_preview(&mut self) -> Result<(), SessionError> {
        let (Some(live_preview), Some(face)) = (&self.live_preview, &self.face) else { return Ok(()) };
        let pose_fit = live_preview.pose_fit(face)?;
        self.show_live_preview(pose_fit);
        Ok(())
    }

    fn show_live_preview(&mut self, pose_fit: Option<PoseFit>) {
        let (Some(live_preview), Some(face)) = (&mut self.live_preview, &self.face) else { return };
        live_preview.follow(pose_fit, face, &self.view);
        let camera = live_preview.camera();
        let pinhole = Pinhole { camera_from_model: camera.camera_from_model };
        let stage = &mut self.stage;
        stage.camera_mut().set_sides(Sides::Swapped);
        if let Some(plane) = plane(&camera, live_preview.size_px(), stage.camera().centre_m()) {
            stage.change_picture(plane, pinhole);
        }
    }

    /// Ends the live preview: the photo is there again.
    pub fn end_live_preview(&mut self) {
        if self.live_preview.take().is_some() {
            self.stage.camera_mut().set_sides(Sides::True);
            self.show_pinhole();
        }
    }
}
