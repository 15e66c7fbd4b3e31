use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::{MOST_SHOTS, SIDES_PX, TextureError};

/// The mesh that a texture is made for.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// How its vertices are joined; triangles wind counter-clockwise as seen from outside.
    pub topology: &'a Topology,
    /// Where each vertex is, in any unit; that of [`Eye`].
    pub positions: &'a [DVec3],
    /// Where each vertex is in the texture, 0..=1, origin at the top left; no two triangles lie on each other.
    pub atlas_uvs: &'a [DVec2],
    /// The vertex on the other side that each one is the mirror image of; its own in the plane of symmetry. Where nothing is
    /// mirrored, each is its own.
    pub partners: &'a [u32],
    /// Sets of vertices that must each come from one photo, and one side of it, as far as that shows them: what moves by
    /// itself, such as an eye, would else be seen twice.
    pub wholes: &'a [Vec<u32>],
}

/// A photo of the mesh.
#[derive(Debug, Clone, Copy)]
pub struct Shot<'a> {
    /// The upright picture.
    pub picture: &'a Photo,
    /// Where each vertex is seen in it, 0..=1, origin at the top left; outside of that it is not seen. Colours are read by
    /// these and not through a camera, so that what several photos show coincides to the vertex.
    pub uvs: &'a [DVec2],
    /// Where it was taken from.
    pub eye: Eye,
}

/// Where a camera stands, in the frame of the positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Eye {
    /// In a place.
    At(DVec3),
    /// Infinitely far away in a direction, of any length.
    Towards(DVec3),
}

impl Eye {
    /// The direction in which a place sees it, of length 1.
    pub(crate) fn from(self, place: DVec3) -> DVec3 {
        let way = match self {
            Self::At(eye) => eye - place,
            Self::Towards(direction) => direction,
        };
        way.normalize_or_zero()
    }

    /// How near a place is: of two places on one ray, larger for the one that hides the other.
    pub(crate) fn nearness(self, place: DVec3) -> f64 {
        match self {
            Self::At(eye) => -place.distance(eye),
            Self::Towards(direction) => place.dot(direction.normalize_or_zero()),
        }
    }
}

/// Refuses what is no mesh with its photos.
pub(crate) fn check(subject: &Subject<'_>, shots: &[Shot<'_>], side_px: u32) -> Result<(), TextureError> {
    if !(SIDES_PX.contains(&side_px) && side_px.is_power_of_two()) {
        return Err(TextureError::Side { side_px });
    }
    if !(1..=MOST_SHOTS).contains(&shots.len()) {
        return Err(TextureError::ShotCount { found: shots.len() });
    }
    let vertex_count = subject.topology.vertex_count();
    check_values("positions", subject.positions, vertex_count, |place| place.is_finite())?;
    check_values("texture coordinates", subject.atlas_uvs, vertex_count, |place| place.is_finite())?;
    check_values("partners", subject.partners, vertex_count, |_| true)?;
    check_vertices("partners", subject.partners, vertex_count)?;
    subject.wholes.iter().try_for_each(|whole| check_vertices("wholes", whole, vertex_count))?;
    let of_photos = shots.iter().map(|shot| shot.uvs);
    of_photos.into_iter().try_for_each(|uvs| check_values("places in a photo", uvs, vertex_count, |uv| uv.is_finite()))
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
