use glam::{DVec2, DVec3, Vec3};
use rosto_mesh::vertex_normals;

use super::push;
use crate::texture::{self, Texture};
use crate::zip::{NamedFile, stored};
use crate::{BaseColour, ExportError, Model, linear_from_srgb};

/// Required alignment of each file in a USDZ package, in bytes.
const ALIGNMENT: usize = 64;

const PICTURE: &str = "face.jpg";

/// Exports a USDZ package for augmented reality: the scene as text (`face.usda`) and its picture, uncompressed and
/// aligned.
///
/// Metres, +Y up; the lowest point is at y = 0. Vertex colours are written as `displayColor` in linear light, which not
/// all viewers show.
///
/// # Errors
/// [`ExportError`] if a length does not match, a position is not finite, the mesh is empty, or the picture is missing
/// or cannot be encoded.
pub fn usdz(model: &Model<'_>, base_colour: BaseColour, max_texture_px: u32) -> Result<Vec<u8>, ExportError> {
    model.check()?;
    let texture = texture::of(model, base_colour, max_texture_px)?;
    let mut files = vec![NamedFile::new("face.usda", scene(model, texture.as_ref()))];
    if let Some(texture) = &texture {
        files.push(NamedFile::new(PICTURE, texture::jpeg(&texture.pixels)?));
    }
    Ok(stored(&files, ALIGNMENT))
}

fn scene(model: &Model<'_>, texture: Option<&Texture<'_>>) -> String {
    let positions: Vec<Vec3> = model.positions_m.iter().map(|position| position.as_vec3()).collect();
    let low = positions.iter().copied().reduce(Vec3::min).unwrap_or_default();
    let high = positions.iter().copied().reduce(Vec3::max).unwrap_or_default();
    let mut text = String::with_capacity(160 * positions.len());
    push(&mut text, format_args!("{HEADER}    double3 xformOp:translate = (0, {}, 0)\n{MESH}", -low.y));
    push(
        &mut text,
        format_args!(
            "        float3[] extent = [({}, {}, {}), ({}, {}, {})]\n",
            low.x, low.y, low.z, high.x, high.y, high.z
        ),
    );
    let triangles = model.topology.triangles();
    push_list(&mut text, "int[] faceVertexCounts", triangles.iter().map(|_| "3"));
    push_list(&mut text, "int[] faceVertexIndices", triangles.iter().flatten());
    push_list(&mut text, "point3f[] points", positions.iter().map(|p| format!("({}, {}, {})", p.x, p.y, p.z)));
    let normals = vertex_normals(model.topology, model.positions_m);
    let normal = |n: DVec3| format!("({:.6}, {:.6}, {:.6})", n.x, n.y, n.z);
    push_vertices(&mut text, "normal3f[] normals", normals.into_iter().map(normal));
    match texture {
        Some(texture) => {
            // USD has the origin at the bottom left.
            let uv = |uv: &DVec2| format!("({:.7}, {:.7})", uv.x, 1.0 - uv.y);
            push_vertices(&mut text, "texCoord2f[] primvars:st", texture.uvs.iter().map(uv));
        }
        None => {
            let colour = |colour: &[u8; 3]| {
                let [r, g, b] = colour.map(linear_from_srgb);
                format!("({r:.5}, {g:.5}, {b:.5})")
            };
            push_vertices(&mut text, "color3f[] primvars:displayColor", model.colours_srgb.iter().map(colour));
        }
    }
    let (output, colour) = if texture.is_some() { ("rgb", TEXTURED) } else { ("result", COLOURED) };
    text.push_str(&MATERIAL.replace("OUTPUT", output));
    text.push_str(colour);
    text.push_str("    }\n}\n");
    text
}

const HEADER: &str = r#"#usda 1.0
(
    defaultPrim = "face"
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "face" (
    kind = "component"
)
{
"#;

const MESH: &str = r#"    uniform token[] xformOpOrder = ["xformOp:translate"]

    def Mesh "mesh" (
        prepend apiSchemas = ["MaterialBindingAPI"]
    )
    {
        uniform bool doubleSided = 1
        rel material:binding = </face/skin>
        uniform token subdivisionScheme = "none"
"#;

const MATERIAL: &str = r#"    }

    def Material "skin"
    {
        token outputs:surface.connect = </face/skin/surface.outputs:surface>

        def Shader "surface"
        {
            uniform token info:id = "UsdPreviewSurface"
            color3f inputs:diffuseColor.connect = </face/skin/colour.outputs:OUTPUT>
            float inputs:metallic = 0
            float inputs:roughness = 0.9
            token outputs:surface
        }
"#;

const TEXTURED: &str = r#"
        def Shader "colour"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @face.jpg@
            token inputs:sourceColorSpace = "sRGB"
            float2 inputs:st.connect = </face/skin/place.outputs:result>
            token inputs:wrapS = "clamp"
            token inputs:wrapT = "clamp"
            float3 outputs:rgb
        }

        def Shader "place"
        {
            uniform token info:id = "UsdPrimvarReader_float2"
            string inputs:varname = "st"
            float2 outputs:result
        }
"#;

const COLOURED: &str = r#"
        def Shader "colour"
        {
            uniform token info:id = "UsdPrimvarReader_float3"
            string inputs:varname = "displayColor"
            float3 outputs:result
        }
"#;

/// Appends a list with one value per vertex.
fn push_vertices(text: &mut String, name: &str, values: impl Iterator<Item = String>) {
    push_list(text, name, values);
    text.truncate(text.trim_end().len());
    text.push_str(" (\n            interpolation = \"vertex\"\n        )\n");
}

fn push_list<T: std::fmt::Display>(text: &mut String, name: &str, values: impl Iterator<Item = T>) {
    push(text, format_args!("        {name} = ["));
    for (at, value) in values.enumerate() {
        push(text, format_args!("{}{value}", if at == 0 { "" } else { ", " }));
    }
    text.push_str("]\n");
}
