//! Faces to edit.

use glam::DVec3;
use rosto_face::*;
use rosto_studio::*;
use serde_json::Value;

pub const MIRROR: DVec3 = DVec3::new(-1.0, 1.0, 1.0);

/// The canonical face in metres; exactly symmetric.
pub fn canonical(triangulation: Triangulation) -> Rest {
    Rest::of_landmarks(triangulation.topology(), canonical_positions_m(), CoordinateFrame::Model)
}

/// The sample portrait's face in metres, with natural asymmetry.
pub fn portrait(triangulation: Triangulation) -> Rest {
    let observation = observed(portrait_landmarks(), 512, PhotoLens::Parallel);
    Rest::of_face(&FaceModel::new(observation, triangulation).unwrap())
}

/// Black landmarks in a square photo without pixels.
pub fn observed(landmarks: Vec<[f32; 3]>, side_px: u32, lens: PhotoLens) -> Observation {
    let (photo_size_px, colours_srgb) = ([side_px; 2], vec![[0; 3]; LANDMARK_COUNT]);
    Observation { landmarks, photo_size_px, colours_srgb, found_lens: lens, lens, card: None, picture: None }
}

/// The sample portrait's face in normalised image coordinates.
pub fn portrait_image() -> Vec<DVec3> {
    portrait_landmarks().into_iter().map(|landmark| DVec3::from(landmark.map(f64::from))).collect()
}

pub fn portrait_landmarks() -> Vec<[f32; 3]> {
    let text = include_str!("../../../../tests/golden/portrait_landmarks.json");
    let json: Value = serde_json::from_str(text).unwrap();
    let rows = json["landmarks"].as_array().unwrap().iter();
    rows.map(|p| [0, 1, 2].map(|axis| p[axis].as_f64().unwrap() as f32)).collect()
}

/// A mirrored, hard-constrained spec of one vertex.
pub fn mirrored_spec(vertex: u32) -> EditSpec {
    let settings = Settings { mirror: Mirror::On, constraint: ConstraintKind::Hard, ..Settings::default() };
    EditSpec { level: 0, handles: vec![vertex], settings }
}

pub fn single_move(vertex: u32, offset: DVec3) -> Command {
    Command::Move {
        spec: EditSpec { level: 0, handles: vec![vertex], settings: Settings::default() },
        offsets: vec![offset],
    }
}

/// Bits of the positions, for exact comparison.
pub fn bits(positions: &[DVec3]) -> Vec<[u64; 3]> {
    positions.iter().map(|p| p.to_array().map(f64::to_bits)).collect()
}
