//! Faces to open.

use rosto::{SavedEdits, SavedFace};
use rosto_face::{LANDMARK_COUNT, Observation, PhotoLens, Triangulation, canonical_positions_m};
use rosto_session::{Intent, Session};

pub const SIZE_PX: [u32; 2] = [800, 600];

/// An asymmetric face as detected in a photo of 64 × 64 px.
pub fn detected() -> Observation {
    let landmark = |(vertex, p): (usize, &glam::DVec3)| {
        let tilt = 0.004 * (vertex as f64).sin();
        [0.5 + 3.0 * p.x + tilt, 0.5 - 3.0 * p.y, -3.0 * p.z + tilt].map(|coordinate| coordinate as f32)
    };
    Observation {
        landmarks: canonical_positions_m().iter().enumerate().map(landmark).collect(),
        photo_size_px: [64, 64],
        colours_srgb: vec![[180, 120, 90]; LANDMARK_COUNT],
        found_lens: PhotoLens::Estimated,
        card: None,
        lens: PhotoLens::Parallel,
        picture: None,
    }
}

/// A newly found face in one photo.
pub fn found(photo: Observation) -> SavedFace {
    SavedFace { photos: vec![photo], edits: None }
}

/// A face with earlier edits.
pub fn with_history(history: &str, triangulation: Triangulation, density: u32) -> SavedFace {
    let edits = SavedEdits { triangulation, density, history: Some(history.to_owned()), photo_edit: None };
    SavedFace { photos: vec![detected()], edits: Some(edits) }
}

/// A session with a face, on a canvas of 800 × 600 px, with reduced motion, that selects landmarks.
pub fn session() -> Session {
    let mut session = Session::new(7);
    session.apply(Intent::Mode(rosto_session::SelectionMode::Landmark)).unwrap();
    session.apply(Intent::Motion(rosto_session::Motion::Reduced)).unwrap();
    session.apply(Intent::Resize(SIZE_PX, 1.0)).unwrap();
    open(&mut session, found(detected()));
    session
}

pub fn open(session: &mut Session, face: SavedFace) {
    session.apply(Intent::Open(Box::new(face))).unwrap();
}

/// The open face as it is saved.
pub fn saved(session: &Session) -> SavedFace {
    let face = session.face().unwrap();
    SavedFace::from_json(&face.saved_photos(), Some(&face.saved_edits())).unwrap()
}

/// Bits of the positions, for exact comparison.
pub fn bits(positions: &[glam::DVec3]) -> Vec<[u64; 3]> {
    positions.iter().map(|p| p.to_array().map(f64::to_bits)).collect()
}
