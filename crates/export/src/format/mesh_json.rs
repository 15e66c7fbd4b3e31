use glam::DVec3;
use serde_json::{Value, json};

rosto_mesh::named! {
    /// Coordinate system of exported positions.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Units {
        /// MediaPipe's normalised coordinates.
        Image = "image",
        /// Millimetres in model space.
        #[default]
        Mm = "mm",
    }
}

/// Input of [`mesh_json`].
#[derive(Debug, Clone)]
pub struct JsonMesh<'a> {
    /// Unit of the positions.
    pub units: Units,
    /// Positions in that unit.
    pub positions: &'a [DVec3],
    /// One sRGB colour per vertex.
    pub colours_srgb: &'a [[u8; 3]],
    /// Triangles, counter-clockwise from outside.
    pub triangles: &'a [[u32; 3]],
    /// [`about`](crate::about) the face; `None` for a mesh that is not a photographed face.
    pub about: Option<Value>,
}

/// Returns the mesh as JSON: `{"units","positions","colours","triangles","about"}`.
///
/// Numbers round-trip to the same `f64`; non-finite coordinates become `null`. Colours are sRGB, 0 to 255.
pub fn mesh_json(mesh: &JsonMesh<'_>) -> String {
    let positions: Vec<[f64; 3]> = mesh.positions.iter().map(|position| position.to_array()).collect();
    let [positions, colours, triangles] = [json!(positions), json!(mesh.colours_srgb), json!(mesh.triangles)];
    let about = mesh.about.as_ref().map(|about| format!(r#","about":{about}"#)).unwrap_or_default();
    let units = mesh.units.id();
    format!(r#"{{"units":"{units}","positions":{positions},"colours":{colours},"triangles":{triangles}{about}}}"#)
}
