use glam::DVec3;
use serde_json::{Value, json};

rosto_mesh::named! {
    /// The coordinates that positions are in.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Units {
        /// MediaPipe's normalised coordinates.
        Image = "image",
        /// Millimetres of the model.
        #[default]
        Mm = "mm",
    }
}

/// What [`mesh_json`] writes.
#[derive(Debug, Clone)]
pub struct JsonMesh<'a> {
    /// The unit of the positions.
    pub units: Units,
    /// Positions in that unit.
    pub positions: &'a [DVec3],
    /// An sRGB colour for each vertex.
    pub colours_srgb: &'a [[u8; 3]],
    /// Triangles, counter-clockwise from outside.
    pub triangles: &'a [[u32; 3]],
    /// What is known of the face, as a JSON object; none of a mesh that is no face from a photo.
    pub about: Option<Value>,
}

/// The mesh as JSON, `{"units","positions","colors","triangles","about"}`, before any rounding to 32 bits: every number reads
/// back as the same `f64`. Colours are sRGB, 0 to 255. Coordinates that are not finite become `null`.
pub fn mesh_json(mesh: &JsonMesh<'_>) -> String {
    let positions: Vec<[f64; 3]> = mesh.positions.iter().map(|position| position.to_array()).collect();
    let [positions, colours, triangles] = [json!(positions), json!(mesh.colours_srgb), json!(mesh.triangles)];
    let about = mesh.about.as_ref().map(|about| format!(r#","about":{about}"#)).unwrap_or_default();
    let units = mesh.units.id();
    format!(r#"{{"units":"{units}","positions":{positions},"colors":{colours},"triangles":{triangles}{about}}}"#)
}
