use std::fmt::Write;

use glam::DVec3;
use rosto_mesh::vertex_normals;

use crate::{ExportError, Model};

/// A Wavefront OBJ file: metres, +Y up, with the custom of sRGB colours (0 to 1) after each vertex's position.
///
/// Every number has the digits it needs to read back as the same `f64`.
///
/// # Errors
/// [`ExportError`] if a length does not fit, a position is not finite, or there is no triangle.
pub fn obj(model: &Model<'_>) -> Result<String, ExportError> {
    model.check()?;
    let mut text = String::from("# Rosto; metres, +Y up, +Z out of the face\no face\n");
    for (p, colour) in model.positions_m.iter().zip(model.colours_srgb) {
        let [r, g, b] = colour.map(|channel| f64::from(channel) / 255.0);
        push(&mut text, format_args!("v {} {} {} {r:.4} {g:.4} {b:.4}\n", p.x, p.y, p.z));
    }
    for normal in vertex_normals(model.topology, model.positions_m) {
        let DVec3 { x, y, z } = normal;
        push(&mut text, format_args!("vn {x:.6} {y:.6} {z:.6}\n"));
    }
    for corners in model.topology.triangles() {
        let [a, b, c] = corners.map(|corner| corner + 1);
        push(&mut text, format_args!("f {a}//{a} {b}//{b} {c}//{c}\n"));
    }
    Ok(text)
}

fn push(text: &mut String, line: std::fmt::Arguments<'_>) {
    text.write_fmt(line).expect("invariant: writing to a string does not fail");
}
