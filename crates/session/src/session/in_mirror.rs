use rosto_face::PoseFit;
use rosto_stage::{Pinhole, Sides};

use super::Session;
use super::in_photo::plane;
use crate::mirror::pose_fit;
use crate::{Mirror, SessionError};

/// The mirror: the open face's edits on a film. Frames are no intents: they come by themselves, as time does, and change only what
/// is seen.
impl Session {
    /// What the mirror shows, while it does.
    pub fn mirror(&self) -> Option<&Mirror> {
        self.mirror.as_ref()
    }

    /// Shows the next frame of a film, of `size_px`, with the edits: 468 or 478 landmarks in MediaPipe's normalised convention, or
    /// none where no face is in it. The first frame begins the mirror. Sides are swapped in what is seen alone: the subject's left
    /// stays the subject's left.
    ///
    /// # Errors
    /// [`SessionError::NoFace`] while none is open, [`SessionError::Face`] for landmarks that make none; the frame before stays.
    pub fn mirror_frame(&mut self, landmarks: Option<&[[f32; 3]]>, size_px: [u32; 2]) -> Result<(), SessionError> {
        let face = self.open_face()?;
        if let Some(landmarks) = landmarks {
            rosto_face::check_landmarks(landmarks, size_px[0], size_px[1])?;
        }
        let pose_fit = pose_fit(face, landmarks, size_px)?;
        self.mirror.get_or_insert_default().take(landmarks, size_px);
        self.show_in_mirror(pose_fit);
        Ok(())
    }

    /// Brings edits that have changed to the frame that is shown.
    ///
    /// # Errors
    /// As [`Self::mirror_frame`].
    pub fn follow_in_mirror(&mut self) -> Result<(), SessionError> {
        let (Some(mirror), Some(face)) = (&self.mirror, &self.face) else { return Ok(()) };
        let pose_fit = mirror.pose_fit(face)?;
        self.show_in_mirror(pose_fit);
        Ok(())
    }

    fn show_in_mirror(&mut self, pose_fit: Option<PoseFit>) {
        let (Some(mirror), Some(face)) = (&mut self.mirror, &self.face) else { return };
        mirror.follow(pose_fit, face, &self.view);
        let camera = mirror.camera();
        let pinhole = Pinhole { camera_from_model: camera.camera_from_model };
        let stage = &mut self.stage;
        stage.camera_mut().set_sides(Sides::Swapped);
        if let Some(plane) = plane(&camera, mirror.size_px(), stage.camera().centre_m()) {
            stage.change_picture(plane, pinhole);
        }
    }

    /// Ends the mirror: the photo is there again.
    pub fn end_mirror(&mut self) {
        if self.mirror.take().is_some() {
            self.stage.camera_mut().set_sides(Sides::True);
            self.show_pinhole();
        }
    }
}
