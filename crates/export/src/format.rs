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
use crate::{BaseColour, ExportError, GlbOptions, Model, Print, PrintedBody, SolidFacts, about, glb};

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

rosto_mesh::named! {
    /// An option that some formats support.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum ExportOption {
        /// Source of the face's colours.
        BaseColour = "base-colour",
        /// Longest side of the texture.
        TextureSize = "texture-size",
        /// Response to light.
        Material = "material",
        /// Edits as morph targets.
        Edits = "edits",
        /// Expressions as morph targets.
        Expressions = "expressions",
        /// Whether eyes and mouth are separate pieces.
        Eyes = "eyes",
        /// Unit of the positions.
        Units = "units",
        /// Printable body made from the face.
        Solid = "solid",
        /// Height of the printable body.
        Height = "height-mm",
    }
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
    pub print: Print,
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

impl Format {
    /// Media type of the format.
    pub fn media_type(self) -> &'static str {
        self.definition().0
    }

    /// Whether the format supports an option.
    pub fn supports(self, what: ExportOption) -> bool {
        self.definition().1.contains(&what)
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
        let Content { model, gltf, name, .. } = content;
        let (base_colour, max_texture_px) = (gltf.base_colour, gltf.max_texture_px);
        match self {
            Self::Glb => Ok(glb(&content.moved_by_morphs(), gltf)?.into()),
            Self::Gltf => Ok(crate::gltf(&content.moved_by_morphs(), gltf)?.into()),
            Self::Obj => obj::painted(model, base_colour, max_texture_px, name),
            Self::Ply => Ok(ply(model)?.into()),
            Self::Stl => content.stl(),
            Self::ThreeMf => content.three_mf(),
            Self::Usdz => Ok(usdz(model, base_colour, max_texture_px)?.into()),
            Self::Png => content.png(),
            Self::Json => Ok(content.json().into()),
        }
    }

    /// Media type and supported options. Separate from the writers, which the page's module does not link.
    fn definition(self) -> (&'static str, &'static [ExportOption]) {
        use ExportOption::{BaseColour, Edits, Expressions, Eyes, Height, Material, Solid, TextureSize, Units};
        const GLTF: &[ExportOption] = &[BaseColour, TextureSize, Material, Edits, Expressions, Eyes];
        match self {
            Self::Glb => ("model/gltf-binary", GLTF),
            Self::Gltf => ("model/gltf+json", GLTF),
            Self::Obj => ("model/obj", &[BaseColour, TextureSize, Eyes]),
            Self::Ply => ("application/octet-stream", &[Eyes]),
            Self::Stl => ("model/stl", &[Solid, Height]),
            Self::ThreeMf => ("model/3mf", &[Solid, Height]),
            Self::Usdz => ("model/vnd.usdz+zip", &[BaseColour, TextureSize, Eyes]),
            Self::Png => ("image/png", &[BaseColour, TextureSize]),
            Self::Json => ("application/json", &[Units]),
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
        Ok(match self.print.body(&self.model)? {
            Some(PrintedBody { body, .. }) => ExportedFile {
                solid: Some(SolidFacts::of(&body, self.print.solid)),
                ..stl::stl_of(body.topology().triangles(), body.positions_m()).into()
            },
            None => stl(&self.model)?.into(),
        })
    }

    fn three_mf(&self) -> Result<ExportedFile, ExportError> {
        let printed = self.print.body(&self.model)?.ok_or(ExportError::NoBody)?;
        let solid = Some(SolidFacts::of(&printed.body, self.print.solid));
        Ok(ExportedFile { solid, ..three_mf(&printed).into() })
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
