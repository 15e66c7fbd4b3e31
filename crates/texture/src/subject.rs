use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::{MAX_SHOTS, SIDES_PX, TextureError};

/// Mesh to bake a texture for.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Triangles, counter-clockwise seen from outside.
    pub topology: &'a Topology,
    /// Vertex positions, in the unit of [`Eye`].
    pub positions: &'a [DVec3],
    /// Texture coordinates, 0..=1, origin at the top left; triangles must not overlap.
    pub atlas_uvs: &'a [DVec2],
    /// Mirror partner of each vertex; the vertex itself in the plane of symmetry, or if the mesh has no symmetry.
    pub partners: &'a [u32],
    /// Sets of vertices that should each come from a single layer, such as the eyes. They move independently of the
    /// face, so blending photos would show them twice.
    pub features: &'a [Vec<u32>],
}

/// Photo of the mesh.
#[derive(Debug, Clone, Copy)]
pub struct Shot<'a> {
    /// Upright picture.
    pub picture: &'a Photo,
    /// Position of each vertex in the picture, 0..=1, origin at the top left; vertices outside are not visible.
    /// Explicit coordinates, rather than a camera, make several photos coincide at the vertices.
    pub uvs: &'a [DVec2],
    /// Viewpoint.
    pub eye: Eye,
}

/// Camera position, in the frame of the vertex positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Eye {
    /// At a point.
    At(DVec3),
    /// Infinitely far away in a direction of any length.
    Towards(DVec3),
}

impl Eye {
    /// Unit vector from a point towards the eye.
    pub(crate) fn from(self, position: DVec3) -> DVec3 {
        let direction = match self {
            Self::At(eye) => eye - position,
            Self::Towards(direction) => direction,
        };
        direction.normalize_or_zero()
    }

    /// Nearness to the eye; along a ray, the larger value occludes the smaller.
    pub(crate) fn nearness(self, position: DVec3) -> f64 {
        match self {
            Self::At(eye) => -position.distance(eye),
            Self::Towards(direction) => position.dot(direction.normalize_or_zero()),
        }
    }
}

/// Validates a mesh and its photos.
pub(crate) fn check(subject: &Subject<'_>, shots: &[Shot<'_>], side_px: u32) -> Result<(), TextureError> {
    if !(SIDES_PX.contains(&side_px) && side_px.is_power_of_two()) {
        return Err(TextureError::Side { side_px });
    }
    if !(1..=MAX_SHOTS).contains(&shots.len()) {
        return Err(TextureError::ShotCount { found: shots.len() });
    }
    let vertex_count = subject.topology.vertex_count();
    check_values("positions", subject.positions, vertex_count, |position| position.is_finite())?;
    check_values("texture coordinates", subject.atlas_uvs, vertex_count, |position| position.is_finite())?;
    check_values("partners", subject.partners, vertex_count, |_| true)?;
    check_vertices("partners", subject.partners, vertex_count)?;
    subject.features.iter().try_for_each(|feature| check_vertices("features", feature, vertex_count))?;
    let of_photos = shots.iter().map(|shot| shot.uvs);
    of_photos
        .into_iter()
        .try_for_each(|uvs| check_values("positions in a photo", uvs, vertex_count, |uv| uv.is_finite()))
}

fn check_values<T>(
    what: &'static str,
    values: &[T],
    expected: usize,
    is_finite: fn(&T) -> bool,
) -> Result<(), TextureError> {
    let found = values.len();
    if found != expected {
        return Err(TextureError::WrongLength { what, expected, found });
    }
    match values.iter().position(|value| !is_finite(value)) {
        Some(vertex) => Err(TextureError::NotFinite { what, vertex }),
        None => Ok(()),
    }
}

fn check_vertices(what: &'static str, vertices: &[u32], vertex_count: usize) -> Result<(), TextureError> {
    match vertices.iter().find(|&&vertex| vertex as usize >= vertex_count) {
        Some(&vertex) => Err(TextureError::VertexOutOfRange { what, vertex, vertex_count }),
        None => Ok(()),
    }
}
