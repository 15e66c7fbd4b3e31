use glam::{DVec2, DVec3};
use rosto_mesh::vertex_normals;

use super::{ExportedFile, push};
use crate::texture::{self, Texture};
use crate::zip::NamedFile;
use crate::{BaseColour, ExportError, Model};

/// Exports a Wavefront OBJ file: metres, +Y up, with sRGB colours (0 to 1) after each position, a common extension.
///
/// Positions are rounded to `f32`: further digits depend on the machine, and the same face should give the same file.
///
/// # Errors
/// [`ExportError`] if a length does not match, a position is not finite, or the mesh is empty.
pub fn obj(model: &Model<'_>) -> Result<String, ExportError> {
    model.check()?;
    Ok(text(model, None))
}

/// Exports a textured OBJ file with two sidecar files: the material `NAME.mtl` and its picture `NAME.png`.
///
/// Texture coordinates have their origin at the bottom left, as OBJ requires.
///
/// # Errors
/// As [`obj`]; also if the picture is missing or cannot be encoded.
pub(super) fn painted(
    model: &Model<'_>,
    base_colour: BaseColour,
    max_px: u32,
    name: &str,
) -> Result<ExportedFile, ExportError> {
    model.check()?;
    let Some(texture) = texture::of(model, base_colour, max_px)? else { return Ok(text(model, None).into()) };
    let [material_name, picture_name] = sidecar_names(name);
    let text = text(model, Some((&texture, &material_name)));
    let picture = texture::png(&texture.pixels)?;
    let material = material(name, &picture_name, &picture);
    let sidecars = vec![NamedFile::new(material_name, material), NamedFile::new(picture_name, picture)];
    Ok(ExportedFile { sidecars, ..text.into() })
}

/// Names of the material and the picture of an OBJ file. Whitespace is replaced, because OBJ readers end a name at a
/// blank.
pub(super) fn sidecar_names(name: &str) -> [String; 2] {
    let name: String = name.chars().map(|letter| if letter.is_whitespace() { '_' } else { letter }).collect();
    ["mtl", "png"].map(|ending| format!("{name}.{ending}"))
}

/// Whether the contents are an unmodified material and picture that Rosto wrote for `name`.
pub(super) fn wrote_sidecars(name: &str, contents: &[Option<Vec<u8>>]) -> bool {
    let [_, picture_name] = sidecar_names(name);
    match contents {
        [Some(found), Some(picture)] => *found == material(name, &picture_name, picture).as_bytes(),
        _ => false,
    }
}

const TITLE: &str = "# Rosto; metres, +Y up, +Z out of the face\n";

/// OBJ text with vertex colours or, if textured, with texture coordinates and the material's name.
fn text(model: &Model<'_>, painted: Option<(&Texture<'_>, &str)>) -> String {
    let mut text = String::from(TITLE);
    if let Some((_, material_name)) = painted {
        push(&mut text, format_args!("mtllib {material_name}\n"));
    }
    text.push_str("o face\n");
    for (p, colour) in model.positions_m.iter().map(|p| p.as_vec3()).zip(model.colours_srgb) {
        push(&mut text, format_args!("v {} {} {}", p.x, p.y, p.z));
        if painted.is_none() {
            let [r, g, b] = colour.map(|channel| f64::from(channel) / 255.0);
            push(&mut text, format_args!(" {r:.4} {g:.4} {b:.4}"));
        }
        text.push('\n');
    }
    for &DVec2 { x, y } in painted.iter().flat_map(|(texture, _)| texture.uvs.iter()) {
        push(&mut text, format_args!("vt {x:.7} {:.7}\n", 1.0 - y));
    }
    for DVec3 { x, y, z } in vertex_normals(model.topology, model.positions_m) {
        push(&mut text, format_args!("vn {x:.6} {y:.6} {z:.6}\n"));
    }
    text.push_str(if painted.is_some() { "usemtl skin\n" } else { "" });
    for corners in model.topology.triangles() {
        let [a, b, c] = corners.map(|corner| corner + 1);
        match painted {
            Some(_) => push(&mut text, format_args!("f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}\n")),
            None => push(&mut text, format_args!("f {a}//{a} {b}//{b} {c}//{c}\n")),
        }
    }
    text
}

/// A matt material with the picture as its colour. The checksum covers the OBJ's name and the picture, because
/// different OBJ names can share a sidecar name.
fn material(name: &str, picture_name: &str, picture: &[u8]) -> String {
    let mut checksum = crc32fast::Hasher::new();
    [name.as_bytes(), &[0], picture].into_iter().for_each(|bytes| checksum.update(bytes));
    let checksum = checksum.finalize();
    format!("# Rosto {checksum:08x}\nnewmtl skin\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nd 1\nillum 1\nmap_Kd {picture_name}\n")
}
