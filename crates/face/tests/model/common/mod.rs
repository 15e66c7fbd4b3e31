use rosto_face::*;

/// A face in a photo without pixels; its landmarks have one colour.
pub fn observed(landmarks: &[[f32; 3]], photo_size_px: [u32; 2], lens: PhotoLens) -> Observation {
    let (landmarks, colours_srgb) = (landmarks.to_vec(), vec![[1, 2, 3]; LANDMARK_COUNT]);
    Observation { landmarks, photo_size_px, colours_srgb, found_lens: lens, lens, card: None, picture: None }
}
