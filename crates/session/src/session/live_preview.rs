use rosto_face::PoseFit;
use rosto_stage::{Pinhole, Sides, Visibility};

use super::Session;
use super::photo::plane;
use crate::live_preview::pose_fit;
use crate::{LivePreview, SessionError};

/// The live preview: the edits of the open face on a camera stream. Frames are not intents; they arrive over time and
/// change only the view.
impl Session {
    /// The live preview, if it is on.
    pub fn live_preview(&self) -> Option<&LivePreview> {
        self.live_preview.as_ref()
    }

    /// Shows the next frame of a camera stream, of `size_px`, with the edits. `landmarks` are 468 or 478 in MediaPipe's
    /// normalised convention, or `None` if the frame contains no face. The first frame starts the live preview. Only
    /// the displayed picture is mirrored; left and right remain the subject's.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] without an open face, [`SessionError::Face`] for invalid landmarks; the previous frame
    /// remains.
    pub fn preview_frame(&mut self, landmarks: Option<&[[f32; 3]]>, size_px: [u32; 2]) -> Result<(), SessionError> {
        let face = self.open_face()?;
        if let Some(landmarks) = landmarks {
            rosto_face::check_landmarks(landmarks, size_px[0], size_px[1])?;
        }
        let pose_fit = pose_fit(face, landmarks, size_px)?;
        self.show_print(Visibility::Hidden);
        self.live_preview.get_or_insert_default().set_frame(landmarks, size_px);
        self.show_backdrop();
        self.show_live_preview(pose_fit);
        Ok(())
    }

    /// Applies changed edits to the current frame.
    ///
    /// # Errors
    /// See [`Self::preview_frame`].
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

    /// Ends the live preview and shows the photo again.
    pub fn end_live_preview(&mut self) {
        if self.live_preview.take().is_some() {
            self.stage.camera_mut().set_sides(Sides::True);
            self.show_backdrop();
            self.show_pinhole();
        }
    }
}
