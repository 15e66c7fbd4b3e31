//! The formats as one table: what each is called, what it is served as, what it has a place for, and what writes it.

mod mesh_json;
mod obj;
mod ply;
mod stl;

pub use mesh_json::{JsonMesh, mesh_json};
pub use obj::obj;
pub use ply::ply;
pub use stl::stl;

use glam::DVec3;

use crate::{ExportError, GlbOptions, Model, about, glb, gltf};

rosto_named::named! {
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
        /// Positions, colours and triangles as JSON.
        Json = "json",
    }
}

/// What can be chosen about a format's files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choosable {
    /// Nothing: they hold what the format has a place for.
    Nothing,
    /// The base colour, the material, morph targets: [`GlbOptions`].
    Material,
    /// The unit of the positions.
    Unit,
}

/// All that there is to write; each format takes what it has a place for.
#[derive(Debug, Clone, Copy)]
pub struct Content<'a> {
    /// The mesh as it is shown.
    pub model: Model<'a>,
    /// The positions in metres that morph targets lead away from.
    pub rest_m: &'a [DVec3],
    /// What is chosen about glTF.
    pub gltf: GlbOptions<'a>,
    /// The positions, and the id of their unit, for formats that let it be chosen.
    pub positions: (&'a str, &'a [DVec3]),
}

struct Definition {
    media_type: &'static str,
    choosable: Choosable,
    write: fn(&Content<'_>) -> Result<Vec<u8>, ExportError>,
}

impl Format {
    /// The media type that its files are served as.
    pub fn media_type(self) -> &'static str {
        self.definition().media_type
    }

    /// What can be chosen about its files.
    pub fn choosable(self) -> Choosable {
        self.definition().choosable
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// [`ExportError`] if a length does not fit, a position is not finite, or there is no triangle; for glTF also as
    /// [`glb`].
    pub fn write(self, content: &Content<'_>) -> Result<Vec<u8>, ExportError> {
        (self.definition().write)(content)
    }

    #[rustfmt::skip]
    fn definition(self) -> Definition {
        use Choosable::{Material, Nothing, Unit};
        match self {
            Self::Glb => Definition { media_type: "model/gltf-binary", choosable: Material, write: |c| glb(&c.moved_by_morphs(), &c.gltf) },
            Self::Gltf => Definition { media_type: "model/gltf+json", choosable: Material, write: |c| Ok(gltf(&c.moved_by_morphs(), &c.gltf)?.into_bytes()) },
            Self::Obj => Definition { media_type: "model/obj", choosable: Nothing, write: |c| Ok(obj(&c.model)?.into_bytes()) },
            Self::Ply => Definition { media_type: "application/octet-stream", choosable: Nothing, write: |c| ply(&c.model) },
            Self::Stl => Definition { media_type: "model/stl", choosable: Nothing, write: |c| stl(&c.model) },
            Self::Json => Definition { media_type: "application/json", choosable: Unit, write: |c| Ok(mesh_json(&c.listed()).into_bytes()) },
        }
    }
}

impl<'a> Content<'a> {
    /// The mesh that morph targets, if there are any, move to where it is shown.
    fn moved_by_morphs(&self) -> Model<'a> {
        if self.gltf.morphs.is_empty() { self.model } else { self.model.at(self.rest_m) }
    }

    fn listed(&self) -> JsonMesh<'a> {
        let (units, positions) = self.positions;
        let about = self.gltf.source.map(|source| about(source.face, self.model.positions_m));
        let triangles = self.model.topology.triangles();
        JsonMesh { units, positions, colours_srgb: self.model.colours_srgb, triangles, about }
    }
}
