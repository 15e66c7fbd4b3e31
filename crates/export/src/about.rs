//! Facts about a face in addition to its mesh, as JSON.

use glam::DVec3;
use rosto_face::{FaceModel, Measure, iris_id};
use serde_json::{Map, Value, json};

use crate::model::MM_PER_M;

/// Returns the camera, pose and size of a face as JSON:
/// ```json
/// {"lens": "exif:26", "distance_m": 0.42, "distance_interval_m": [0.39, 0.46], "focal_px": 903.2,
///  "yaw_deg": 1.5, "pitch_deg": -3.0, "roll_deg": 0.2, "size_from": "irises", "size_error": 0.045,
///  "measures_mm": {"face-height": [171.2, 159.0, 183.4]}, "eye_centres_mm": {"right": [-31.2, 25.0, 33.1], "left": [31.0, 25.2, 33.0]},
///  "irises_mm": {"right-iris-middle": [-31.0, 26.1, 38.2]}}
/// ```
/// `size_error` is a relative standard deviation, `distance_interval_m` a 90 % interval. A measure is a length and its 95 %
/// interval, at `positions_m`, whose first 468 entries are the landmarks; measures less certain than the spread between
/// people are omitted.
/// Irises and eye centres are in their detected positions; eye centres do not move with the gaze. An infinite
/// distance is omitted, with its focal length.
pub fn about(face: &FaceModel, positions_m: &[DVec3]) -> Value {
    let (camera, pose, scale) = (face.camera(), face.camera().pose(), face.scale());
    let rounded = |number: f64, digits: i32| (number * 10_f64.powi(digits)).round() / 10_f64.powi(digits);
    let measure = |measure: Measure| {
        let length = measure.length(positions_m, scale)?;
        let [low_m, high_m] = length.interval_m();
        let mm = [length.length_m, low_m, high_m].map(|m| rounded(m * MM_PER_M, 2));
        Some((measure.id().to_owned(), json!(mm)))
    };
    let position_mm =
        |position: DVec3| json!((position * MM_PER_M).to_array().map(|coordinate| rounded(coordinate, 3)));
    let iris = |(point, position): (usize, &DVec3)| (iris_id(point), position_mm(*position));
    let [right, left] = face.eye_centres_m();
    let mut about = json!({
        "lens": camera.lens.to_string(),
        "yaw_deg": rounded(pose.yaw_deg, 2),
        "pitch_deg": rounded(pose.pitch_deg, 2),
        "roll_deg": rounded(pose.roll_deg, 2),
        "size_from": scale.source.id(),
        "size_error": rounded(scale.error, 4),
        "measures_mm": Measure::ALL.into_iter().filter_map(measure).collect::<Map<String, Value>>(),
        "eye_centres_mm": {"right": position_mm(right), "left": position_mm(left)},
    });
    if camera.distance_m.is_finite() {
        about["distance_m"] = json!(rounded(camera.distance_m, 4));
        about["distance_interval_m"] = json!(camera.distance_interval_m.map(|end_m| rounded(end_m, 4)));
        about["focal_px"] = json!(rounded(camera.focal_px, 2));
    }
    if !face.irises_m().is_empty() {
        about["irises_mm"] = face.irises_m().iter().enumerate().map(iris).collect::<Map<String, Value>>().into();
    }
    about
}
