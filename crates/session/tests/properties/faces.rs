//! Faces to open.

use rosto_face::{LANDMARK_COUNT, Photo, PhotoLens, Triangulation, canonical_positions_m};
use rosto_session::{Incoming, Intent, Session, Work};

pub const SIZE_PX: [u32; 2] = [800, 600];

/// An asymmetric face as detected in a photo of 64 × 64 px.
pub fn detected() -> Incoming {
    let landmark = |(vertex, p): (usize, &glam::DVec3)| {
        let tilt = 0.004 * (vertex as f64).sin();
        [0.5 + 3.0 * p.x + tilt, 0.5 - 3.0 * p.y, -3.0 * p.z + tilt].map(|coordinate| coordinate as f32)
    };
    Incoming {
        landmarks: canonical_positions_m().iter().enumerate().map(landmark).collect(),
        photo_size_px: [64, 64],
        colours_srgb: vec![[180, 120, 90]; LANDMARK_COUNT],
        picture: Photo::from_rgb(1, 1, vec![180, 120, 90]).unwrap(),
        lens: PhotoLens::Parallel,
        further: Vec::new(),
        work: None,
    }
}

/// A face with earlier edits.
pub fn with_history(history: &str, triangulation: Triangulation, density: u32) -> Incoming {
    Incoming { work: Some(Work { triangulation, density, history: history.to_owned(), photo: None }), ..detected() }
}

/// A session with a face, on a canvas of 800 × 600 px, with reduced motion.
pub fn session() -> Session {
    let mut session = Session::new(7);
    session.apply(Intent::Motion(rosto_session::Motion::Reduced)).unwrap();
    session.apply(Intent::Resize(SIZE_PX, 1.0)).unwrap();
    open(&mut session, detected());
    session
}

pub fn open(session: &mut Session, incoming: Incoming) {
    session.apply(Intent::Open(Box::new(incoming))).unwrap();
}

/// Bits of the positions, for exact comparison.
pub fn bits(positions: &[glam::DVec3]) -> Vec<[u64; 3]> {
    positions.iter().map(|p| p.to_array().map(f64::to_bits)).collect()
}
