use std::fmt::Write;

use glam::DVec3;
use serde_json::Value;

rosto_named::named! {
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
    let mut text = String::with_capacity(64 * mesh.positions.len() + 16 * mesh.triangles.len() + 64);
    text.push_str("{\"units\":\"");
    text.push_str(mesh.units.id());
    text.push_str("\",\"positions\":");
    push_rows(&mut text, mesh.positions.iter().map(|p| p.to_array()), push_number);
    text.push_str(",\"colors\":");
    push_rows(&mut text, mesh.colours_srgb.iter().copied(), |text, channel| push_integer(text, channel.into()));
    text.push_str(",\"triangles\":");
    push_rows(&mut text, mesh.triangles.iter().copied(), push_integer);
    if let Some(about) = &mesh.about {
        text.push_str(",\"about\":");
        text.push_str(&about.to_string());
    }
    text.push('}');
    text
}

fn push_rows<T: Copy>(text: &mut String, rows: impl Iterator<Item = [T; 3]>, push: impl Fn(&mut String, T)) {
    text.push('[');
    for (index, [a, b, c]) in rows.enumerate() {
        text.push_str(if index == 0 { "[" } else { ",[" });
        push(text, a);
        text.push(',');
        push(text, b);
        text.push(',');
        push(text, c);
        text.push(']');
    }
    text.push(']');
}

/// The shortest digits that read back as the same `f64`.
fn push_number(text: &mut String, number: f64) {
    let written = if number.is_finite() { write!(text, "{number:?}") } else { write!(text, "null") };
    written.expect("invariant: writing to a string does not fail");
}

fn push_integer(text: &mut String, number: u32) {
    write!(text, "{number}").expect("invariant: writing to a string does not fail");
}
