//! Table of the file formats: media type, supported options and writer.

mod mesh_json;
mod obj;
mod ply;
mod stl;
mod three_mf;
mod usdz;

pub use mesh_json::{JsonMesh, Units, mesh_json};
pub use obj::obj;
pub use ply::ply;
pub use stl::stl;
pub use three_mf::three_mf;
pub use usdz::usdz;

use std::fmt::{self, Write};

use glam::DVec3;

use crate::model::MM_PER_M;
use crate::texture;
use crate::zip::{NamedFile, stored};
use crate::{BaseColour, ExportError, GlbOptions, Model, Solid, SolidFacts, about, glb, gltf};

rosto_mesh::named! {
    /// A mesh file format; its id is the file extension.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Format {
        /// Binary glTF 2.0.
        Glb = "glb",
        /// glTF 2.0 as text.
        Gltf = "gltf",
        /// Wavefront OBJ.
        Obj = "obj",
        /// Binary PLY.
        Ply = "ply",
        /// Binary STL.
        Stl = "stl",
        /// 3MF, for colour printing.
        ThreeMf = "3mf",
        /// USDZ, for augmented reality.
        Usdz = "usdz",
        /// The face's picture, as PNG.
        Png = "png",
        /// Positions, colours and triangles as JSON.
        Json = "json",
    }
}

/// An option that some formats support.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExportOption {
    /// Source of the face's colours, and the size of its texture.
    BaseColour,
    /// Material, morph targets, and the data for reopening the file: [`GlbOptions`].
    Material,
    /// Unit of the positions.
    Units,
    /// Printable body made from the face.
    Solid,
    /// Whether eyes and mouth are separate pieces.
    Eyes,
}

rosto_mesh::named! {
    /// Content of the eye and mouth openings, if the mesh fills them.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Eyes {
        /// The skin continues across them, as photographed.
        #[default]
        Skin = "skin",
        /// Separate pieces behind lids and lips, with round eyeballs, textured from the photo.
        Pieces = "pieces",
    }
}

/// Input of [`Format::write`]; a format uses the parts that it supports.
#[derive(Debug, Clone, Copy)]
pub struct Content<'a> {
    /// The displayed mesh.
    pub model: Model<'a>,
    /// Rest positions of the morph targets, in metres.
    pub rest_m: &'a [DVec3],
    /// glTF options; the colour source applies to all formats that support it.
    pub gltf: GlbOptions<'a>,
    /// The printable body.
    pub solid: Solid,
    /// File name without extension, also used for sidecar files.
    pub name: &'a str,
    /// Positions in MediaPipe's normalised coordinates for JSON, or `None` for millimetres.
    pub positions_image: Option<&'a [DVec3]>,
}

/// An exported file with its sidecar files.
#[derive(Debug, Clone, PartialEq)]
pub struct ExportedFile {
    /// Bytes of the main file.
    pub bytes: Vec<u8>,
    /// Files that the main file refers to, in the same folder; empty for most formats.
    pub sidecars: Vec<NamedFile>,
    /// Measurements of the printable body, if one was made.
    pub solid: Option<SolidFacts>,
}

impl<B: Into<Vec<u8>>> From<B> for ExportedFile {
    fn from(bytes: B) -> Self {
        Self { bytes: bytes.into(), sidecars: Vec::new(), solid: None }
    }
}

impl ExportedFile {
    /// Returns a single file: the main file or, if there are sidecar files, a zip archive of all of them.
    pub fn bundled(self, name: &str, format: Format) -> Vec<u8> {
        if self.sidecars.is_empty() {
            return self.bytes;
        }
        let mut files = vec![NamedFile { name: format!("{name}.{}", format.id()), bytes: self.bytes }];
        files.extend(self.sidecars);
        stored(&files, 1)
    }
}

struct Definition {
    media_type: &'static str,
    choosable: &'static [ExportOption],
    write: fn(&Content<'_>) -> Result<ExportedFile, ExportError>,
}

impl Format {
    /// Media type of the format.
    pub fn media_type(self) -> &'static str {
        self.definition().media_type
    }

    /// Whether the format supports an option.
    pub fn supports(self, what: ExportOption) -> bool {
        self.definition().choosable.contains(&what)
    }

    /// Names of the sidecar files of a main file called `name` (without extension).
    pub fn sidecar_names(self, base_colour: BaseColour, name: &str) -> Vec<String> {
        match self {
            Self::Obj if base_colour != BaseColour::VertexColours => obj::sidecar_names(name).to_vec(),
            _ => Vec::new(),
        }
    }

    /// Whether the contents, in the order of [`Format::sidecar_names`], are unmodified sidecar files that Rosto wrote
    /// for `name`. `None` means a missing file.
    pub fn wrote_sidecars(self, name: &str, contents: &[Option<Vec<u8>>]) -> bool {
        match self {
            Self::Obj => obj::wrote_sidecars(name, contents),
            _ => contents.is_empty(),
        }
    }

    /// Extension of the file that [`ExportedFile::bundled`] returns: `zip` if there are sidecar files.
    pub fn bundle_extension(self, base_colour: BaseColour) -> &'static str {
        if self.sidecar_names(base_colour, "").is_empty() { self.id() } else { "zip" }
    }

    /// Exports the content.
    ///
    /// # Errors
    /// [`ExportError`] if a length does not match, a position is not finite, the mesh is empty, or the requested
    /// picture or body is not available. For glTF, see also [`glb`].
    pub fn write(self, content: &Content<'_>) -> Result<ExportedFile, ExportError> {
        (self.definition().write)(content)
    }

    #[rustfmt::skip]
    fn definition(self) -> Definition {
        use ExportOption::{BaseColour, Eyes, Material, Solid, Units};
        match self {
            Self::Glb => Definition { media_type: "model/gltf-binary", choosable: &[BaseColour, Material, Eyes], write: |c| Ok(glb(&c.moved_by_morphs(), &c.gltf)?.into()) },
            Self::Gltf => Definition { media_type: "model/gltf+json", choosable: &[BaseColour, Material, Eyes], write: |c| Ok(gltf(&c.moved_by_morphs(), &c.gltf)?.into()) },
            Self::Obj => Definition { media_type: "model/obj", choosable: &[BaseColour, Eyes], write: |c| obj::painted(&c.model, c.gltf.base_colour, c.gltf.max_texture_px, c.name) },
            Self::Ply => Definition { media_type: "application/octet-stream", choosable: &[Eyes], write: |c| Ok(ply(&c.model)?.into()) },
            Self::Stl => Definition { media_type: "model/stl", choosable: &[Solid], write: |c| c.stl() },
            Self::ThreeMf => Definition { media_type: "model/3mf", choosable: &[Solid], write: |c| c.three_mf() },
            Self::Usdz => Definition { media_type: "model/vnd.usdz+zip", choosable: &[BaseColour, Eyes], write: |c| Ok(usdz(&c.model, c.gltf.base_colour, c.gltf.max_texture_px)?.into()) },
            Self::Png => Definition { media_type: "image/png", choosable: &[BaseColour], write: |c| c.png() },
            Self::Json => Definition { media_type: "application/json", choosable: &[Units], write: |c| Ok(c.json().into()) },
        }
    }
}

impl<'a> Content<'a> {
    /// The model at rest if morph targets reach the displayed shape, otherwise the displayed model.
    fn moved_by_morphs(&self) -> Model<'a> {
        if self.gltf.morphs.is_empty() { self.model } else { self.model.at(self.rest_m) }
    }

    fn json(&self) -> String {
        let positions_mm: Vec<DVec3> = self.model.positions_m.iter().map(|&position| position * MM_PER_M).collect();
        let (units, positions) = match self.positions_image {
            Some(positions) => (Units::Image, positions),
            None => (Units::Mm, positions_mm.as_slice()),
        };
        let about = self.gltf.source.map(|source| about(source.face, self.model.positions_m));
        let triangles = self.model.topology.triangles();
        mesh_json(&JsonMesh { units, positions, colours_srgb: self.model.colours_srgb, triangles, about })
    }

    fn stl(&self) -> Result<ExportedFile, ExportError> {
        Ok(match self.solid.body(&self.model)? {
            Some(body) => ExportedFile {
                solid: Some(SolidFacts::of(&body)),
                ..stl::stl_of(body.topology().triangles(), body.positions_m()).into()
            },
            None => stl(&self.model)?.into(),
        })
    }

    fn three_mf(&self) -> Result<ExportedFile, ExportError> {
        let body = self.solid.body(&self.model)?.ok_or(ExportError::NoBody)?;
        Ok(ExportedFile { solid: Some(SolidFacts::of(&body)), ..three_mf(&self.model, &body)?.into() })
    }

    fn png(&self) -> Result<ExportedFile, ExportError> {
        self.model.check()?;
        let texture = texture::of(&self.model, self.gltf.base_colour, self.gltf.max_texture_px)?;
        Ok(texture::png(&texture.ok_or(ExportError::NoPicture)?.pixels)?.into())
    }
}

fn push(text: &mut String, part: fmt::Arguments<'_>) {
    text.write_fmt(part).expect("invariant: writing to a string cannot fail");
}
