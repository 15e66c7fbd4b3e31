use glam::Vec2;
use rosto_face::LANDMARK_COUNT;
use serde_json::{Map, Value, json};

use crate::placed::placement;
use crate::saved::{self, Pictures, Source};
use crate::texture::{self, BaseColour, Crop, Texture};
use crate::{ExportError, Model};

mod attributes;
mod container;

use container::Builder;

/// Version of the extras that is written and read.
pub(crate) const VERSION: u64 = 1;

rosto_mesh::named! {
    /// Longest side of a texture, at most.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum TextureSize {
        /// 1024 px.
        Px1024 = "1024",
        /// 2048 px.
        #[default]
        Px2048 = "2048",
        /// 4096 px.
        Px4096 = "4096",
    }
}

impl TextureSize {
    /// Returns the size in px.
    pub fn px(self) -> u32 {
        match self {
            Self::Px1024 => 1024,
            Self::Px2048 => 2048,
            Self::Px4096 => 4096,
        }
    }
}

rosto_mesh::named! {
    /// Response of the face to light.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Material {
        /// Physically based and matt.
        #[default]
        Lit = "lit",
        /// As photographed, by `KHR_materials_unlit`.
        Unlit = "unlit",
    }
}

/// A named displacement that viewers can blend in: a glTF morph target.
#[derive(Debug, Clone, Copy)]
pub struct Morph<'a> {
    /// Name in `mesh.extras.targetNames`.
    pub name: &'a str,
    /// Displacement of each vertex at weight 1, in metres.
    pub displacements_m: &'a [glam::DVec3],
    /// Initial weight.
    pub weight: f64,
}

/// Options for [`glb`] and [`gltf`].
#[derive(Debug, Clone, Copy)]
pub struct GlbOptions<'a> {
    /// Source of the face's colours.
    pub base_colour: BaseColour,
    /// Response to light.
    pub material: Material,
    /// Name of the node and the mesh.
    pub name: &'a str,
    /// Morph targets; none by default.
    pub morphs: &'a [Morph<'a>],
    /// Data from which [`reopen`](crate::reopen) restores the face, written to the scene's `extras`; none by default.
    pub source: Option<Source<'a>>,
    /// Maximum side of the texture in px; a photo crop uses the next lower power of two.
    pub max_texture_px: u32,
}

impl Default for GlbOptions<'_> {
    fn default() -> Self {
        Self {
            base_colour: BaseColour::default(),
            material: Material::default(),
            name: "face",
            morphs: &[],
            source: None,
            max_texture_px: TextureSize::default().px(),
        }
    }
}

/// Exports a binary glTF 2.0 file (`model/gltf-binary`): metres, +Y up, front +Z.
///
/// The vertices keep the landmarks' order. The custom attribute `_LANDMARK_ID` gives each vertex's landmark, or −1 for
/// vertices added by subdivision.
///
/// # Errors
/// [`ExportError`] if a length does not match, a position is not finite, the mesh is empty, the history is not a JSON
/// object, the texture cannot be encoded, or the requested whole-face texture is missing.
pub fn glb(model: &Model<'_>, options: &GlbOptions<'_>) -> Result<Vec<u8>, ExportError> {
    let (builder, root) = build(model, options)?;
    Ok(builder.finish_binary(root))
}

/// Exports the same data as glTF text (`model/gltf+json`), with the binary data embedded as base64.
///
/// # Errors
/// As [`glb`].
pub fn gltf(model: &Model<'_>, options: &GlbOptions<'_>) -> Result<String, ExportError> {
    let (builder, root) = build(model, options)?;
    Ok(builder.finish_text(root))
}

fn build(model: &Model<'_>, options: &GlbOptions<'_>) -> Result<(Builder, Map<String, Value>), ExportError> {
    model.check()?;
    let mut builder = Builder::default();
    let mut attributes = attributes::geometry(&mut builder, model);
    let mut root = Map::new();
    let painted = paint(&mut builder, model, options, &mut attributes, &mut root)?;
    let extras = options.source.as_ref().map(|source| extras(source, model, &painted, options)).transpose()?;
    attributes.insert("_LANDMARK_ID".into(), builder.scalars(&landmark_ids(model)).into());
    let indices = builder.indices(model.topology);
    let mut mesh = json!({
        "name": options.name,
        "primitives": [{"attributes": attributes, "indices": indices, "material": 0}],
    });
    attributes::morphs(&mut builder, model, options.morphs, options.material, &mut mesh)?;
    let mut scene = json!({"name": options.name, "nodes": [0]});
    if let Some(extras) = extras {
        scene["extras"] = extras;
    }
    root.insert("asset".into(), json!({"version": "2.0", "generator": concat!("Rosto ", env!("CARGO_PKG_VERSION"))}));
    root.insert("scene".into(), 0.into());
    root.insert("scenes".into(), json!([scene]));
    root.insert("nodes".into(), json!([{"name": options.name, "mesh": 0}]));
    root.insert("meshes".into(), json!([mesh]));
    Ok((builder, root))
}

/// The scene's extras: the [`Source`] with `"rosto": "face"`, the version, and `positions_fnv1a`, the hash of the
/// `POSITION` bytes, by which changes by other programs are detected.
fn extras(
    source: &Source<'_>,
    model: &Model<'_>,
    painted: &Painted,
    options: &GlbOptions<'_>,
) -> Result<Value, ExportError> {
    let lead = match (painted, &model.photo) {
        (Painted::Photo(crop), _) => Some(placement(crop)),
        (Painted::Whole, Some(photo)) => Some(saved::part_of(photo, options.max_texture_px)?),
        _ => None,
    };
    let holds_photos = !matches!(painted, Painted::Colours);
    let others = if holds_photos { Pictures::UpTo(options.max_texture_px) } else { Pictures::Left };
    let mut extras = saved::fields(source, lead, others)?;
    let positions = model.positions_m.iter().flat_map(|p| p.as_vec3().to_array());
    extras["positions_fnv1a"] = fingerprint(positions.flat_map(f32::to_le_bytes)).into();
    extras["rosto"] = "face".into();
    extras["version"] = VERSION.into();
    Ok(extras)
}

/// 64-bit FNV-1a hash, as sixteen hexadecimal digits.
pub(crate) fn fingerprint(bytes: impl IntoIterator<Item = u8>) -> String {
    const BASIS: u64 = 0xCBF2_9CE4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01B3;
    let hash = bytes.into_iter().fold(BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    format!("{hash:016x}")
}

fn landmark_ids(model: &Model<'_>) -> Vec<f32> {
    let id = |vertex: usize| if vertex < LANDMARK_COUNT { vertex as f32 } else { -1.0 };
    (0..model.topology.vertex_count()).map(id).collect()
}

/// Colours that were written to the file.
enum Painted {
    /// The texture is a crop of the photo.
    Photo(Crop),
    /// The texture is the whole-face texture.
    Whole,
    /// Vertex colours, no texture.
    Colours,
}

/// Adds the colours or the texture, and the material.
fn paint(
    builder: &mut Builder,
    model: &Model<'_>,
    options: &GlbOptions<'_>,
    attributes: &mut Map<String, Value>,
    root: &mut Map<String, Value>,
) -> Result<Painted, ExportError> {
    let (painted, texture) = match options.base_colour {
        BaseColour::Photo => {
            let photo = model.photo.as_ref().ok_or(ExportError::NoPicture)?;
            let (texture, crop) = texture::crop(photo, options.max_texture_px)?;
            (Painted::Photo(crop), Some(texture))
        }
        BaseColour::Whole => (Painted::Whole, texture::of(model, options.base_colour, options.max_texture_px)?),
        BaseColour::VertexColours => (Painted::Colours, None),
    };
    let mut surface = json!({"metallicFactor": 0.0, "roughnessFactor": 0.9});
    match texture {
        Some(texture) => {
            attributes.insert("TEXCOORD_0".into(), builder.vectors2(&rounded(&texture)).into());
            let view = builder.image(&texture::jpeg(&texture.pixels)?);
            root.insert(
                "images".into(),
                json!([{"name": options.base_colour.id(), "bufferView": view, "mimeType": "image/jpeg"}]),
            );
            root.insert("samplers".into(), json!([CLAMPED_MIPMAPPED.object()]));
            root.insert("textures".into(), json!([{"source": 0, "sampler": 0}]));
            surface["baseColorTexture"] = json!({"index": 0});
        }
        None => {
            attributes.insert("COLOR_0".into(), builder.colours(&attributes::linear_colours(model)).into());
        }
    }
    let mut material = json!({"name": "skin", "doubleSided": true, "pbrMetallicRoughness": surface});
    if options.material == Material::Unlit {
        material["extensions"] = json!({"KHR_materials_unlit": {}});
        root.insert("extensionsUsed".into(), json!(["KHR_materials_unlit"]));
    }
    root.insert("materials".into(), json!([material]));
    Ok(painted)
}

fn rounded(texture: &Texture<'_>) -> Vec<Vec2> {
    texture.uvs.iter().map(|uv| uv.as_vec2()).collect()
}

/// A glTF sampler, in OpenGL's constants.
struct Sampler {
    magnify: u32,
    minify: u32,
    wrap: u32,
}

/// Trilinear and clamped to the edge, since a landmark may lie outside the picture.
const CLAMPED_MIPMAPPED: Sampler = Sampler { magnify: 9729, minify: 9987, wrap: 33071 };

impl Sampler {
    fn object(&self) -> Value {
        json!({"magFilter": self.magnify, "minFilter": self.minify, "wrapS": self.wrap, "wrapT": self.wrap})
    }
}
