//! The formats as one table: what each is called, what it is served as, what it has a place for, and what writes it.

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
    /// A format that a mesh is written in; its id is how the names of its files end.
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
        /// 3MF, for printing in colour.
        ThreeMf = "3mf",
        /// USDZ, for augmented reality.
        Usdz = "usdz",
        /// The picture that paints the face, as PNG.
        Png = "png",
        /// Positions, colours and triangles as JSON.
        Json = "json",
    }
}

/// Something that can be chosen about a format's files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choosable {
    /// What paints the face, and how large its picture is.
    BaseColour,
    /// The material, morph targets, and what opens the file again: [`GlbOptions`].
    Material,
    /// The unit of the positions.
    Units,
    /// What body is made of the face.
    Solid,
    /// Whether eyes and mouth are pieces of their own.
    Eyes,
}

rosto_mesh::named! {
    /// What fills the openings of the eyes and the mouth, where the mesh fills them.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Eyes {
        /// The skin goes on through them, as it was photographed.
        #[default]
        Skin = "skin",
        /// Pieces of their own behind lids and lips, the eyes round as balls are, painted as the photo shows them.
        Pieces = "pieces",
    }
}

/// All that there is to write; each format takes what it has a place for.
#[derive(Debug, Clone, Copy)]
pub struct Content<'a> {
    /// The mesh as it is shown.
    pub model: Model<'a>,
    /// The positions in metres that morph targets lead away from.
    pub rest_m: &'a [DVec3],
    /// What is chosen about glTF; what paints the face is chosen here for all formats that have a place for it.
    pub gltf: GlbOptions<'a>,
    /// The body that is made of it for printing.
    pub solid: Solid,
    /// What the file is called, without its ending: files that lie beside it are called so, too.
    pub name: &'a str,
    /// The positions in MediaPipe's normalised coordinates, if those are chosen; otherwise JSON is in millimetres.
    pub positions_image: Option<&'a [DVec3]>,
}

/// What a format makes of a face: a file, and what lies beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct ExportedFile {
    /// The file.
    pub bytes: Vec<u8>,
    /// Files that it names, without folders; none in most formats.
    pub beside: Vec<NamedFile>,
    /// What the body measures, if one was made.
    pub solid: Option<SolidFacts>,
}

impl<B: Into<Vec<u8>>> From<B> for ExportedFile {
    fn from(bytes: B) -> Self {
        Self { bytes: bytes.into(), beside: Vec::new(), solid: None }
    }
}

impl ExportedFile {
    /// One file for whoever can save only one: the file itself or, with what lies beside it, a zip archive.
    pub fn bundled(self, name: &str, format: Format) -> Vec<u8> {
        if self.beside.is_empty() {
            return self.bytes;
        }
        let mut files = vec![NamedFile { name: format!("{name}.{}", format.id()), bytes: self.bytes }];
        files.extend(self.beside);
        stored(&files, 1)
    }
}

struct Definition {
    media_type: &'static str,
    choosable: &'static [Choosable],
    write: fn(&Content<'_>) -> Result<ExportedFile, ExportError>,
}

impl Format {
    /// The media type that its files are served as.
    pub fn media_type(self) -> &'static str {
        self.definition().media_type
    }

    /// Whether that can be chosen about its files.
    pub fn lets_choose(self, what: Choosable) -> bool {
        self.definition().choosable.contains(&what)
    }

    /// What the files are called that lie beside one of that name, given without its ending, painted so.
    pub fn names_beside(self, base_colour: BaseColour, name: &str) -> Vec<String> {
        match self {
            Self::Obj if base_colour != BaseColour::VertexColours => obj::names_beside(name).to_vec(),
            _ => Vec::new(),
        }
    }

    /// Whether files with these contents, in the order of [`Format::names_beside`], are those that were written beside one of that
    /// name, unchanged since. `None` is a file that is missing.
    pub fn wrote_beside(self, name: &str, contents: &[Option<Vec<u8>>]) -> bool {
        match self {
            Self::Obj => obj::wrote_beside(name, contents),
            _ => contents.is_empty(),
        }
    }

    /// How the name of the one file ends that [`ExportedFile::bundled`] makes: `zip` where there are several.
    pub fn bundle_ending(self, base_colour: BaseColour) -> &'static str {
        if self.names_beside(base_colour, "").is_empty() { self.id() } else { "zip" }
    }

    /// The bytes of a file, and of those beside it.
    ///
    /// # Errors
    /// [`ExportError`] if a length does not fit, a position is not finite, there is no triangle, no such picture, or no
    /// such body; for glTF also as [`glb`].
    pub fn write(self, content: &Content<'_>) -> Result<ExportedFile, ExportError> {
        (self.definition().write)(content)
    }

    #[rustfmt::skip]
    fn definition(self) -> Definition {
        use Choosable::{BaseColour, Eyes, Material, Solid, Units};
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
    /// The mesh that morph targets, if there are any, move to where it is shown.
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
    text.write_fmt(part).expect("invariant: writing to a string does not fail");
}
