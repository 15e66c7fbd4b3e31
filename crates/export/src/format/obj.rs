use glam::{DVec2, DVec3};
use rosto_mesh::vertex_normals;

use super::{ExportedFile, push};
use crate::texture::{self, Texture};
use crate::zip::NamedFile;
use crate::{BaseColour, ExportError, Model};

/// A Wavefront OBJ file: metres, +Y up, with the custom of sRGB colours (0 to 1) after each vertex's position.
///
/// Positions have the digits that they need to read back as the same `f32`: further digits depend on the machine that they
/// were reckoned on, and the same face is to be the same file.
///
/// # Errors
/// [`ExportError`] if a length does not fit, a position is not finite, or there is no triangle.
pub fn obj(model: &Model<'_>) -> Result<String, ExportError> {
    model.check()?;
    Ok(text(model, None))
}

/// The same mesh painted with a picture: an OBJ file that names its material, `NAME.mtl`, which names its picture, `NAME.png`.
/// Both lie beside it. Texture coordinates have their origin at the bottom left, as OBJ wants it.
///
/// # Errors
/// As [`obj`]; also if the picture cannot be encoded or is not there.
pub(super) fn painted(
    model: &Model<'_>,
    base_colour: BaseColour,
    max_px: u32,
    name: &str,
) -> Result<ExportedFile, ExportError> {
    model.check()?;
    let Some(texture) = texture::of(model, base_colour, max_px)? else { return Ok(text(model, None).into()) };
    let [material_name, picture_name] = names_beside(name);
    let text = text(model, Some((&texture, &material_name)));
    let picture = texture::png(&texture.pixels)?;
    let material = material(name, &picture_name, &picture);
    let beside = vec![NamedFile::new(material_name, material), NamedFile::new(picture_name, picture)];
    Ok(ExportedFile { beside, ..text.into() })
}

/// What the material and the picture are called beside an OBJ file of that name. Readers take what is between blanks for a
/// name, so that none has any.
pub(super) fn names_beside(name: &str) -> [String; 2] {
    let name: String = name.chars().map(|letter| if letter.is_whitespace() { '_' } else { letter }).collect();
    ["mtl", "png"].map(|ending| format!("{name}.{ending}"))
}

/// Whether a material and a picture are those that were written beside an OBJ file of that name, unchanged since.
pub(super) fn wrote_beside(name: &str, contents: &[Option<Vec<u8>>]) -> bool {
    let [_, picture_name] = names_beside(name);
    match contents {
        [Some(found), Some(picture)] => *found == material(name, &picture_name, picture).as_bytes(),
        _ => false,
    }
}

const TITLE: &str = "# Rosto; metres, +Y up, +Z out of the face\n";

/// With colours or, painted, with the picture's places and the name of its material.
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

/// Matt, in the picture's colours. The checksum says for which OBJ and with which picture it was written: names beside an OBJ
/// may be those beside another.
fn material(name: &str, picture_name: &str, picture: &[u8]) -> String {
    let mut checksum = crc32fast::Hasher::new();
    [name.as_bytes(), &[0], picture].into_iter().for_each(|bytes| checksum.update(bytes));
    let checksum = checksum.finalize();
    format!("# Rosto {checksum:08x}\nnewmtl skin\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nd 1\nillum 1\nmap_Kd {picture_name}\n")
}
