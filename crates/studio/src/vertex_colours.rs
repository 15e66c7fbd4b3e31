use glam::DVec3;
use rosto_face::FaceModel;

use crate::Document;

/// sRGB colour of each displayed vertex: the landmarks' own colours; between them the picture's or, without one, those
/// interpolated from the landmarks.
pub fn vertex_colours(face: &FaceModel, document: &Document) -> Vec<[u8; 3]> {
    let sampled = face.colours_under(&document.from_cage(face.uvs()));
    sampled.unwrap_or_else(|| {
        let landmarks: Vec<DVec3> =
            face.colours_srgb().iter().map(|colour| DVec3::from(colour.map(f64::from))).collect();
        let byte = |channel: f64| channel.round().clamp(0.0, 255.0) as u8;
        document.from_cage(&landmarks).into_iter().map(|colour| colour.to_array().map(byte)).collect()
    })
}
